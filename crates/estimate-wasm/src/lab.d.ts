/** All it takes to find a lab again, to the last digit. */
export interface LabState<Params> {
  version: 1
  lab: string
  params: Params
  step: number
}
/** What every lab can do. */
export interface Lab<Params, Frame> {
  /** Changes the parameters given, and replays the run to the present step. */
  set(params: Partial<Params>): void
  /** One step. */
  step(): void
  /** `n` steps, at most to the last step. */
  run(n: number): void
  /** What there is to draw. */
  frame(): Frame
  /** Parameters and step: all it takes to find this lab again. */
  state(): LabState<Params>
  /**
   * A hash of what the run has recorded at every step (truth, readings, estimates, covariances and their comparison),
   * bit for bit, in hexadecimal.
   */
  digest(): string
  free(): void
  [Symbol.dispose](): void
}
/** What is known of one parameter of a lab. */
export interface Parameter {
  name: string
  /** Empty for none. */
  unit: string
  /** The least and the greatest number it may hold, and the step in which a reader changes it; not for words. */
  least: number
  greatest: number
  step: number
  default: unknown
  /** The words it may be; null where it is none. */
  words: string[] | null
}
