/** At most 10 000 entries are read of any array. */
export type Vector = number[]
/** An array of rows; as an argument at most 16 rows and 16 columns. */
export type Matrix = number[][]
/** N(x, P). */
export interface Belief {
  x: Vector
  P: Matrix
}
/** Why a call was refused. Everything it could have changed is as it was. A method called after `free()`, or on what is
    no object of this module, throws wasm-bindgen's own error instead.

    A call so deep in the caller's own recursion that the engine runs out of stack ends in the engine's `RangeError`. The
    object it was made on may then refuse every further call as "in the middle of a call": make another, a lab by `from` of a
    state kept before, a filter from a belief kept before. Each such call costs the module a part of its own stack for good:
    after some hundreds, load the module anew. */
export interface EstimateError extends Error {
  name: 'EstimateError'
  code:
    | 'not-finite'
    | 'shape'
    | 'not-symmetric'
    | 'not-positive-semidefinite'
    | 'innovation-not-positive-definite'
    | 'unobservable'
    | 'poles'
    | 'tolerance'
    | 'index'
    | 'at-landmark'
    | 'not-placeable'
    | 'limit'
    | 'type'
    | 'did-not-converge'
    | 'log'
  /** The argument to blame, as a path: "y", "system.F", "state.params.gain". */
  argument: string
}
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
   * A hash of what the run has recorded at every step (truth, readings, estimates, covariances and their comparison), bit for bit, in
   * hexadecimal.
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
