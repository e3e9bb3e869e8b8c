/** What the touch says: where the ellipse touches, and how far from there the reader's dot is. */

import { fixed, timesAsProbable } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').TouchFrame} Frame */

/** Within half a step of the dot it is where the ellipse touches. */
const THERE = 0.026

/** Where the purple foot is. @param {number} value m */
const side = (value) =>
  Math.abs(value) < 0.005
    ? 'where the gray foot is too'
    : `${fixed(Math.abs(value))} m to the ${value < 0 ? 'left' : 'right'} of the gray foot`

/** @param {Frame} frame */
export function verdict({ params, touch, below, touchRadius, guessRadius, off, times, reading }) {
  if (!params.grown)
    return (
      `The sensor has read ${fixed(reading, 1)} m/s, without noise: the state is on the green line. ` +
      'Where will the growing ellipse first touch it? Drag the dot there and press Grow.'
    )
  const where = `The ellipse touches at ${fixed(touchRadius)} σ, at the purple foot, ${side(touch[0] - below[0])}.`
  if (Math.abs(off) < THERE) return `${where} Your dot is there.`
  return (
    `${where} Your dot is ${fixed(Math.abs(off))} m away; the ellipse reaches it at ${fixed(guessRadius)} σ, ` +
    `and the purple foot is ${timesAsProbable(times)}.`
  )
}

/** @param {Frame} frame */
export function describe({ params, mean, reading, guess, touch, touchRadius, P }) {
  const point = (/** @type {number[]} */ [x, v]) => `${fixed(x)} metres and ${fixed(v)} metres a second`
  const lean = P[0][1] > 0 ? 'leans to the right' : P[0][1] < 0 ? 'leans to the left' : 'stands upright'
  return {
    plane:
      `Plane of position and velocity: a prediction at ${point(mean)}, whose ellipse ${lean}; below it the line of ` +
      `the states that explain the reading ${fixed(reading, 1)}, and on it your dot at ${point(guess)}; ` +
      (params.grown
        ? `grown to ${fixed(touchRadius)} sigma, the ellipse touches the line at ${point(touch)}.`
        : 'the ellipse has not grown yet.'),
  }
}
