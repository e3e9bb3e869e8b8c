/** At most 10 000 entries are read of any array. */
export type Vector = number[]
/** A reading, of which a part that is null was not made. */
export type PartialVector = (number | null)[]
/** An array of rows. */
export type Matrix = number[][]
/** A matrix as an argument: an array of rows, each an array or a Float64Array; at most 16 rows and 16 columns. */
export type Rows = (Vector | Float64Array)[]
/** N(x, P). */
export interface Belief {
  x: Vector
  P: Matrix
}
/** A `Belief` as an argument. */
export interface GivenBelief {
  /** The mean. */
  x: Vector | Float64Array
  /** The covariance, n × n. */
  P: Rows
}
/** Why a call was refused. Everything it could have changed is as it was. A method called after `free()`, or on what is
    no object of this module, throws wasm-bindgen's own error instead.

    A call so deep in the caller's own recursion that the engine runs out of stack ends in the engine's `RangeError`.
    The object it was made on may then refuse every further call as "in the middle of a call": make another, a lab by
    `from` of a state kept before, a filter from a belief kept before. Each such call costs the module a part of its own
    stack for good: after some hundreds, load the module anew.

    A fault of the module itself throws a `WebAssembly.RuntimeError` that says in which call it was. Every later call
    throws one with the same message, and `free()` does nothing: load the module anew. */
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
