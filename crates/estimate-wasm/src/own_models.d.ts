/** A function from the numbers of a state to those of a state, or of a reading. */
export type Model = (x: Vector) => Vector | Float64Array
/** The Jacobian of a `Model`, an array of rows. */
export type ModelJacobian = (x: Vector) => Rows
export interface OwnStateOptions {
  /** The indices of x, from 0, that are angles: they are kept in (−π, π], and differences go the short way round. */
  angles?: number[]
}
export interface UnscentedOptions extends OwnStateOptions {
  /** The spread of the points about the mean, positive; 1 when left out. One of 0.001, as others
      have it, has weights of a million, and spends six digits. */
  alpha?: number
  /** What is known of the distribution's kurtosis; 2 when left out, which is right for a normal one. */
  beta?: number
  /** A second scale, with n + κ positive; 0 when left out. */
  kappa?: number
}
export interface UnscentedUpdateOptions {
  /** The indices of y, from 0, that are angles. */
  angles?: number[]
  /** A reading whose χ² is greater is not used; null, or absent, for none. */
  gate?: number | null
}
export interface OwnUpdateOptions extends UnscentedUpdateOptions {
  /** ∂h/∂x; by central differences when left out. */
  H?: ModelJacobian
}
export interface OwnUpdate {
  outcome: 'accepted' | 'rejected'
  /** y − h(x), of the parts that were read; with the unscented filter y less the mean of h. */
  innovation: Vector
  /** The innovation's covariance. */
  S: Matrix
  /** νᵀS⁻¹ν; null where S is too near to singular, which is within no gate. */
  chi2: number | null
}
