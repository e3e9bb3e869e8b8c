/** What a `KalmanFilter` holds. */
export interface KalmanFilterState {
  version: 1
  system: Record<'F' | 'G' | 'H' | 'V' | 'W', Matrix>
  belief: Belief
  logLikelihood: number | null
  /** What the last reading has told; null where none was read. */
  last: { innovation: Vector; S: Matrix; R: Matrix; nis: number | null } | null
  conditioned: boolean
  /** What rounding may have left in P, by which `conditioned` is judged from now on. */
  rounding: Matrix | 'entries' | null
}
