/** A sensor y = H x + w, Cov w = W, for one call. */
export interface LinearSensor {
  /** What the sensor reads of the state, p × n. */
  H: Matrix
  /** The covariance of its noise, p × p. */
  W: Matrix
}
/** A system in filterpy's letters: B is the matrix of the inputs, Q the process noise, R the noise of the reading. */
export interface FilterpySystem {
  letters: 'filterpy'
  F: Matrix
  B?: Matrix
  H: Matrix
  Q: Matrix
  R: Matrix
}
/** What a `KalmanFilter` holds. */
export interface KalmanFilterState {
  version: 1
  system: System
  belief: Belief
  logLikelihood: number | null
  /** What the last reading has told; null where none was read. */
  last: { innovation: Vector; S: Matrix; R: Matrix; nis: number | null } | null
  conditioned: boolean
  /** What rounding may have left in P, by which `conditioned` is judged from now on. */
  rounding: Matrix | 'entries' | null
}
