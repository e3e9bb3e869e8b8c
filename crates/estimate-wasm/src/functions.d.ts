/** x(k+1) = F x(k) + G u(k) + v, y(k) = H x(k) + w; at most 16 states, 8 inputs, 8 outputs. */
export interface System {
  /** How the state moves in a step, n × n. */
  F: Rows
  /** What an input adds to it, n × m; left out where there are no inputs. */
  G?: Rows
  /** What the sensor reads of it, p × n. */
  H: Rows
  /** The covariance of the motion's noise v, n × n (Thrun: R, filterpy: Q). */
  V: Rows
  /** The covariance of the reading's noise w, p × p (Thrun: Q, filterpy: R). */
  W: Rows
}
/** A system in filterpy's letters: B is the matrix of the inputs, Q the process noise, R the noise of the reading. */
export interface FilterpySystem {
  letters: 'filterpy'
  /** How the state moves in a step, n × n. */
  F: Rows
  /** What an input adds to it, n × m; left out where there are no inputs. */
  B?: Rows
  /** What the sensor reads of it, p × n. */
  H: Rows
  /** The covariance of the process noise, n × n. */
  Q: Rows
  /** The covariance of the reading's noise, p × p. */
  R: Rows
}
/** x' = A x + B u + noise; at most 16 states, 8 inputs. */
export interface ContinuousSystem {
  /** How fast the state changes by itself, n × n. */
  A: Rows
  /** What an input adds to that, n × m; left out where there are no inputs. */
  B?: Rows
  /** The density of the noise: over a short time h it adds Q h to the covariance, n × n. */
  Q: Rows
}
/** x(t + dt) = F x(t) + G u + v, Cov v = V, for an input that is held. */
export interface DiscreteSystem {
  /** e^{A dt}, n × n. */
  F: Matrix
  /** ∫ e^{As} B ds, n × m. */
  G: Matrix
  /** ∫ e^{As} Q e^{Aᵀs} ds, n × n. */
  V: Matrix
}
/** x(k+1) = F x(k) + G u(k) + v for one step: what `discretize` answers, or matrices of one's own. */
export interface GivenStep {
  /** How the state moves in the step, n × n. */
  F: Rows
  /** What an input adds to it, n × m; left out where there are no inputs. */
  G?: Rows
  /** The covariance of the motion's noise v, n × n. */
  V: Rows
}
export interface KalmanStep {
  /** x(k+1 | k), P(k+1 | k) */
  predicted: Belief
  /** y − H x(k+1 | k) */
  innovation: Vector
  /** H P(k+1 | k) Hᵀ + W */
  S: Matrix
  /** The Kalman gain P Hᵀ S⁻¹ (Thrun: K) */
  R: Matrix
  /** x(k+1 | k+1) */
  x: Vector
  /** P(k+1 | k+1) */
  P: Matrix
  /** Whether S, P and x are right to 10⁻⁶ of their largest entries, where the belief was; x to that part of the largest
      standard deviation where this is more. False where the scales of P, V and W are too far apart for doubles. */
  conditioned: boolean
}
export interface KalmanReplay {
  /** x(k | k) after each step, row by row. */
  x: Float64Array
  /** The diagonal of P(k | k), in the same order. */
  variances: Float64Array
  /** P(k | k) after the last step. */
  P: Matrix
  /** Whether S, P and x of every step are right, as in `KalmanStep`. */
  conditioned: boolean
  /** Σ −½(ln det 2πS + νᵀS⁻¹ν) over the steps; null where they are not `conditioned`, an S is too near to singular, or
      the sum too large for a number. */
  logLikelihood: number | null
}
export interface Observability {
  rank: number
  n: number
  singularValues: Vector
  nullspace: Vector[]
}
export interface SteadyState {
  /** The limit of the gain, or the last one. */
  R: Matrix
  /** P(k+1 | k). */
  P: Matrix
  /** Whether P has a limit from this start. */
  converged: boolean
  /** Whether R has. */
  gainConverged: boolean
  /** Steps until neither changed any more; found by doubling, a power of two and a few more. */
  iterations: number
  /** Whether a larger start would lead P to another limit; absent where single steps were asked for. */
  dependsOnStart?: boolean
}
export interface LocalizerOptions {
  /** Noise covariance of a reading: 2×2 for range and bearing, 1×1 for a range alone. */
  W: Rows
  /** A reading whose χ² is greater is left aside; null, or absent, for none. */
  gate?: number | null
  /** Default "range-bearing". */
  sensor?: 'range-bearing' | 'range'
}
/** The bearing is measured from the landmark: atan2(y_r − y_ℓ, x_r − x_ℓ) − θ_r. Left out, the landmark is
    associated. */
export interface LandmarkReading {
  range: number
  bearing?: number
  landmark?: number
}
export interface LandmarkUpdate {
  outcome: 'accepted' | 'rejected'
  landmark: number
  innovation: Vector
  S: Matrix
  chi2: number
}
export interface SlamOptions {
  /** Noise covariance of a sighting, 2×2. */
  W: Rows
  /** A sighting whose χ² is greater is not used; null, or absent, for none. */
  gate?: number | null
  /** A sighting whose χ² is greater for every landmark founds a new one; at least the gate, better far above it. */
  found: number
}
/** The bearing is measured from the landmark. Left out, the landmark is associated, or founded. */
export interface SlamSighting {
  range: number
  bearing: number
  landmark?: number
}
export interface SlamUpdate {
  outcome: 'matched' | 'founded' | 'rejected'
  /** The landmark matched, founded, or (when rejected) nearest. */
  landmark: number | null
  /** Against it, at the prediction; null for a new one. */
  innovation: Vector | null
  S: Matrix | null
  chi2: number | null
}
export interface MappedLandmark {
  id: number
  x: number
  y: number
  P: Matrix
}
