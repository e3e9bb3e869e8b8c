/** A sensor of a time line, y = H x + w, Cov w = W; at most 8 outputs. */
export interface TimelineSensor {
  /** What the sensor reads of the state, p × n. */
  H: Rows
  /** The covariance of its noise, p × p. */
  W: Rows
  /** What is stamped t was measured at t − delay; in seconds, at most 10 either way, 0 when left out. */
  delay?: number
  /** A reading whose χ² is greater is not used; null, or absent, for none. */
  gate?: number | null
}
export interface TimelineOptions {
  /** The time of the belief, in seconds of any clock; 0 when left out. */
  time?: number
  /** How much older than the latest another reading may be, in seconds; more than 0. */
  window: number
  /** How many inputs and readings within the window are kept: at most 10 000, 1000 when left out. It bounds the work of
      a call: what comes late has all that are later replayed, of two states some 1.5 µs each, of 16 states
      and 8 outputs a hundred times that. So n that come in reversed order have n²/2 replayed in all: 10 000 of two
      states take one to two minutes, in calls of at most 15 ms. */
  capacity?: number
  /** The sensors by name, from 1 to 64. As in any object of JavaScript, names that are whole numbers come first. */
  sensors: Record<string, AnyTimelineSensor>
}
export interface TimelineInput {
  /** As of a reading. */
  outcome: 'accepted' | 'too-late' | 'ahead' | 'duplicate' | 'full'
}
export interface TimelineReading {
  /** "accepted": it has corrected the belief at its time. "rejected": it is kept, and lies beyond the gate; what comes
      late may change that. The others are not kept, and change nothing. "too-late": measured before the window, or
      before the start. "ahead": measured more than 1 000 000 s after everything else. "duplicate": there is one of this
      sensor with this time and id. "full": there is no room for another within the window. */
  outcome: 'accepted' | 'rejected' | 'too-late' | 'ahead' | 'duplicate' | 'full'
  /** y − H x, of the parts that were read; null where the reading is not kept. */
  innovation: Vector | null
  /** H P Hᵀ + W. */
  S: Matrix | null
  /** νᵀS⁻¹ν; null also where S is too near to singular. */
  chi2: number | null
}
/** What became of the readings of a sensor of a `Timeline`. */
export interface SensorStatistics {
  /** How many have corrected the belief. */
  used: number
  /** How many lie beyond the gate. */
  refused: number
  /** The mean of νᵀS⁻¹ν over the parts of the readings used: 1 is expected. Null where none was used. */
  nis: number | null
  /** The mean innovation of each output over the readings used, null where it was never read: 0 is expected. */
  meanInnovation: PartialVector
}
