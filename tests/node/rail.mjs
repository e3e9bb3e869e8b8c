// A cart on a rail, half a second a step, of which the position is read; and what a refused call looks like.
import assert from 'node:assert/strict'

export const rail = {
  F: [
    [1, 0.5],
    [0, 1],
  ],
  G: [[0], [0.5]],
  H: [[1, 0]],
  V: [
    [0.2, 0.05],
    [0.05, 0.1],
  ],
  W: [[0.5]],
}
export const belief = {
  x: [2, 4],
  P: [
    [1, 0],
    [0, 2],
  ],
}

/** A message is short, whatever was handed in: nothing of it is repeated without end. */
const SHORT = /^.{1,399}$/s

/**
 * @param {() => unknown} call
 * @param {string} code
 * @param {string | undefined} argument to blame, in the caller's words
 * @param {RegExp} message
 */
export const refused = (call, code, argument, message = SHORT) =>
  assert.throws(call, (/** @type {any} */ error) => {
    assert.deepEqual([error.name, error.code, error.argument], ['EstimateError', code, argument], error.message)
    assert.match(error.message, message)
    return true
  })
