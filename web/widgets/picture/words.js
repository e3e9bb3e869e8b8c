/**
 * What the Picture says: of its feet, of how reading and expectation weigh, of a guess and of an ellipse that grows.
 */

import { fixed, timesAsProbable } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */

/** @param {Frame} frame */
export function verdict(frame) {
  const { guess, sealed, noise } = frame.params
  const grown = ofTheGrown(frame)
  if (sealed)
    return (
      `The answer is hidden: ${guess === null ? 'drop a guess' : 'drag your guess along the green line'}, ` +
      `then choose “Show the answer”.${grown}`
    )
  const perfect = noise === 0 ? ' The sensor is perfect: Ω and Ω* are one line.' : ''
  return `${ofTheFeet(frame)}${ofTheWeights(frame)}${perfect}${ofTheGuess(frame)}${grown}`
}

/** @param {Frame} frame */
function ofTheGuess({ guess, mahalanobisFoot: purple }) {
  if (!guess) return ''
  const off = Math.hypot(guess.at[0] - purple.at[0], guess.at[1] - purple.at[1])
  if (off < 0.026) return ' Your guess is the purple foot, the most probable point of the line.'
  const times = 1 / guess.density
  return ` The purple foot is ${timesAsProbable(times, 'your guess')}.`
}

/** How the two opinions weigh against each other: each weighs one over its variance. @param {Frame} frame */
function ofTheWeights({ params: { noise }, expectedVariance }) {
  if (noise === 0) return ''
  const times = expectedVariance / noise
  if (Math.abs(times - 1) < 0.005) return ' Reading and expected output weigh the same: y* lies half way.'
  return times > 1
    ? ` The reading weighs ${fixed(times, 2)} times as much as the expected output.`
    : ` The expected output weighs ${fixed(1 / times, 2)} times as much as the reading.`
}

/** A part of the probability in words: no ellipse holds all of it. @param {number} part */
export const share = (part) => (part < 0.995 ? `${fixed(100 * part, 0)} %` : 'more than 99 %')

/** Within half a step of the slider the ellipse touches a line. */
const TOUCHES = 0.026

/** @param {Frame} frame */
function ofTheGrown({ params, inside, mahalanobisFoot, update }) {
  const { radius, noise, sealed } = params
  if (radius === 0) return ''
  const reaches = (/** @type {string} */ line, /** @type {number} */ distance) =>
    `${Math.abs(radius - distance) <= TOUCHES ? 'touches' : radius < distance ? 'does not reach' : 'crosses'} ${line}`
  const both = [
    ...(noise > 0 && !sealed ? [reaches('Ω*', update.distance)] : []),
    reaches('Ω', mahalanobisFoot.distance),
  ]
  return (
    ` Grown to ${fixed(radius, 2)} σ, the ellipse holds ${share(inside)} of the probability; ` +
    `it ${both.join(' and ')}.`
  )
}

/** @param {Frame} frame */
function ofTheFeet({ params, innovation, euclideanFoot: gray, mahalanobisFoot: purple }) {
  if (Math.abs(innovation) < 5e-4) return 'The reading is the one expected: there is nothing to correct.'
  if (Math.abs(params.semiMajor - params.semiMinor) < 1e-9)
    return 'The ellipse is a circle: both metrics agree, and the two feet are one point.'
  if (Math.hypot(gray.at[0] - purple.at[0], gray.at[1] - purple.at[1]) < 5e-3)
    return 'The two feet are one point here, to two decimals.'
  return (
    `The gray foot is ${fixed(gray.distance, 2)} standard deviations away, ` +
    `the purple one ${fixed(purple.distance, 2)}.`
  )
}

/** @param {Frame} frame */
export function describe(frame) {
  const point = (/** @type {number[]} */ [x, v]) => `${fixed(x, 2)} metres and ${fixed(v, 2)} metres a second`
  const { params, expectedOutput, expectedVariance, mostLikelyOutput } = frame
  const answer = params.sealed
    ? 'the answer is hidden'
    : `the perpendicular foot at ${point(frame.euclideanFoot.at)}; ` +
      `the Mahalanobis foot at ${point(frame.mahalanobisFoot.at)}; ` +
      `on the line of the most likely output ${fixed(mostLikelyOutput, 2)} the Kalman update at ` +
      `${point(frame.posterior.x)}`
  const product = params.sealed ? '' : `, and their product about ${fixed(mostLikelyOutput, 2)}`
  return {
    plane:
      `Plane of position and velocity: a prediction at ${point(params.mean)} with its ellipse; ` +
      `the line of states that explain the reading ${fixed(params.reading, 2)}; ${answer}.`,
    axis:
      'Axis of the output: ' +
      `a bell about the expected output ${fixed(expectedOutput, 2)} with a standard deviation ` +
      `of ${fixed(Math.sqrt(expectedVariance), 2)}, one about the reading ${fixed(params.reading, 2)} with ` +
      `${fixed(Math.sqrt(params.noise), 2)}${product}.`,
  }
}
