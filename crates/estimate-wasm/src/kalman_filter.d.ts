/** A sensor y = H x + w, Cov w = W, for one call. */
export interface LinearSensor {
  /** What the sensor reads of the state, p × n. */
  H: Rows
  /** The covariance of its noise, p × p. */
  W: Rows
}
