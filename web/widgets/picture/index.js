/**
 * The picture: a prediction with its ellipse, the line of states that explain a reading, and the two ways of stepping
 * onto it. Drag the prediction, the axes of its ellipse and the reading; turn the sensor and its noise.
 */

import { fixed } from '../../draw/numbers.js'
import { drawAxis } from './axis.js'
import { GROWN } from './handles.js'
import { drawPlane } from './plane.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */

// State: what a reader can change. The axes are those of the first hand-checked step's predicted covariance.

const start = { params: {}, step: 0 }

// Model: the lab `Picture` in the module. What follows only reads its frame.

/** @param {Frame} frame */
function verdict(frame) {
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
  return ` The purple foot is ${times < 1000 ? fixed(times, 2) : 'more than 999'} times as probable as your guess.`
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
const share = (part) => (part < 0.995 ? `${fixed(100 * part, 0)} %` : 'more than 99 %')

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
function describe(frame) {
  const point = (/** @type {number[]} */ [x, v]) => `${fixed(x, 2)} metres and ${fixed(v, 2)} metres a second`
  const { params, expectedOutput, expectedVariance, mostLikelyOutput } = frame
  const answer = params.sealed
    ? 'the answer is hidden'
    : `the perpendicular foot at ${point(frame.euclideanFoot.at)}; ` +
      `the Mahalanobis foot at ${point(frame.mahalanobisFoot.at)}; ` +
      `on the line of the most likely output ${fixed(mostLikelyOutput, 2)} the Kalman update at ` +
      `${point(frame.posterior.x)}`
  return {
    plane:
      `Plane of position and velocity: a prediction at ${point(params.mean)} with its ellipse; ` +
      `the line of states that explain the reading ${fixed(params.reading, 2)}; ${answer}.`,
    axis:
      `Axis of the output: a bell about the expected output ${fixed(expectedOutput, 2)} with a standard deviation ` +
      `of ${fixed(Math.sqrt(expectedVariance), 2)}, one about the reading ${fixed(params.reading, 2)} with ` +
      `${fixed(Math.sqrt(params.noise), 2)}, and their product about ${fixed(mostLikelyOutput, 2)}.`,
  }
}

// View: two panels, in the folder's files.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({
  params: { sealed, radius, noise },
  innovation,
  mostLikelyOutput,
  mostLikelyVariance,
  expectedVariance,
  share: taken,
  inside,
  R,
  euclideanFoot: gray,
  mahalanobisFoot: purple,
  update,
}) {
  /** What would tell where the purple foot stands, or the update. @param {string} value */
  const answer = (value) => (sealed ? '–' : value)
  /** Rounding leaves a last digit of either sign; what is printed is zero. */
  const zero = (/** @type {number} */ value) => fixed(Math.abs(value) < 5e-4 ? 0 : value, 3)
  /** One over a variance. @param {number} variance */
  const weight = (variance) => (variance === 0 ? '∞' : fixed(1 / variance, 3))
  const [byRuler, byMetric] = ['by the ruler', 'in the metric of {P}']
  /**
   * ⟨a, Δx⟩ of a foot.
   * @param {string} key
   * @param {import('../../draw/words.js').Words} label
   * @param {number} value
   * @param {string} foot
   * @param {import('../../draw/words.js').Words} metric
   * @param {'truth' | 'posterior'} kin
   * @returns {import('../../figure/shell.js').Readout}
   */
  const cell = (key, label, value, foot, metric, kin) => ({
    key,
    label,
    value: answer(zero(value)),
    zero: !sealed && Math.abs(value) < 5e-4,
    cell: [foot, metric],
    kin,
  })
  return [
    cell('gray-euclid', 'Gray ⟨*a*, Δ*x*⟩, ruler', gray.euclidean, 'gray foot', byRuler, 'truth'),
    cell('gray-mahalanobis', 'Gray ⟨*a*, Δ*x*⟩, metric of {P}', gray.mahalanobis, 'gray foot', byMetric, 'truth'),
    cell('purple-euclid', 'Purple ⟨*a*, Δ*x*⟩, ruler', purple.euclidean, 'purple foot', byRuler, 'posterior'),
    cell(
      'purple-mahalanobis',
      'Purple ⟨*a*, Δ*x*⟩, metric of {P}',
      purple.mahalanobis,
      'purple foot',
      byMetric,
      'posterior',
    ),
    { key: 'innovation', label: 'Innovation {innov}', value: fixed(innovation, 3), kin: 'measurement' },
    { key: 'likely', label: '{y}^{∗}', value: fixed(mostLikelyOutput, 3), kin: 'measurement' },
    {
      key: 'weights',
      label: 'Weights 1/*σ*^{2}: expected + reading = product',
      value: `${weight(expectedVariance)} + ${weight(noise)} = ${weight(mostLikelyVariance)}`,
      wide: true,
      kin: 'measurement',
    },
    { key: 'gain', label: 'Gain {R}', value: answer(`[${fixed(R[0], 3)}, ${fixed(R[1], 3)}]`), kin: 'posterior' },
    {
      key: 'update',
      label: 'Update',
      value: answer(`[${fixed(update.at[0], 3)}, ${fixed(update.at[1], 3)}]`),
      kin: 'posterior',
    },
    { key: 'share', label: 'Part of {innov} taken over', value: fixed(taken, 3), kin: 'posterior' },
    { key: 'inside', label: 'Inside the grown ellipse', value: share(inside), kin: 'prediction', shown: radius > 0 },
    {
      key: 'residual',
      label: '{H}Δ*x* − {innov} of both',
      value: `${zero(gray.residual)}, ${zero(purple.residual)}`,
      kin: 'measurement',
      more: true,
    },
  ]
}

// Controls. Prediction, axes and reading are handles in the drawing.

const degree = Math.PI / 180
/** Where a guess is dropped: on neither foot. */
const GUESS = 1

/** @param {any} lab @returns {Record<string, unknown>} */
const defaults = (lab) =>
  Object.fromEntries(
    lab.constructor
      .parameters()
      .map((/** @type {import('estimate-wasm').Parameter} */ parameter) => [parameter.name, parameter.default]),
  )

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  {
    kind: 'range',
    name: 'noise',
    label: 'Sensor noise {W}',
    words: (value) => fixed(value, 2),
    notches: () => [{ at: 0.5, name: 'step 1' }],
  },
  {
    kind: 'range',
    name: 'radius',
    label: 'Grow an ellipse, in *σ*',
    ends: [0, GROWN],
    words: (value) => fixed(value, 2),
    notches: () => [
      { at: 0, name: '0' },
      { at: 1, name: '1' },
    ],
  },
  {
    kind: 'toggle',
    name: 'sealed',
    label: 'hide the answer',
    set: (on, params) => ({ sealed: on, guess: on ? (params.guess ?? GUESS) : params.guess }),
  },
  {
    kind: 'range',
    name: 'tilt',
    label: 'Turn of the sensor, degrees',
    ends: [-90, 0],
    words: (value) => `${fixed(value, 0)}°`,
    notches: () => [
      { at: -90, name: 'position' },
      { at: 0, name: 'velocity' },
    ],
    scale: (value) => value / degree,
    set: (value) => ({ tilt: value * degree }),
  },
]

/**
 * As noisy a sensor as the expectation is uncertain; an ellipse too large for that shrinks.
 * @param {Frame} frame
 * @param {any} lab
 */
function equalOpinions({ expectedVariance, params: { semiMajor, semiMinor } }, lab) {
  const { greatest } = lab.constructor
    .parameters()
    .find((/** @type {import('estimate-wasm').Parameter} */ { name }) => name === 'noise')
  const shrink = Math.sqrt(Math.min(1, greatest / expectedVariance))
  return { noise: Math.min(greatest, expectedVariance), semiMajor: semiMajor * shrink, semiMinor: semiMinor * shrink }
}

/** The answer is to be seen, and nothing else lies over it. */
const shown = { sealed: false, guess: null, radius: 0 }

/**
 * A guess to be put before the answer shows. Of a circle both feet are one point, and there would be nothing to guess.
 * @param {Frame} frame
 * @param {any} lab
 */
function guessFirst({ params }, lab) {
  const { semiMajor, semiMinor, angle } = Math.abs(params.semiMajor - params.semiMinor) < 1e-9 ? defaults(lab) : params
  return { sealed: true, guess: GUESS, radius: 0, semiMajor, semiMinor, angle }
}

// Each phrase sets all that it speaks of, so that it shows the same after any other.
/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'guess', label: 'Drop a guess first', change: guessFirst },
  { name: 'show', label: 'Show the answer', change: () => ({ sealed: false }) },
  { name: 'perfect', label: 'Sensor noise to zero', change: () => ({ ...shown, noise: 0 }) },
  { name: 'equal', label: 'Two equal opinions', change: (frame, lab) => ({ ...shown, ...equalOpinions(frame, lab) }) },
  {
    name: 'round',
    label: 'Make it a circle',
    change: (/** @type {Frame} */ { params }) => ({ ...shown, semiMajor: params.semiMinor }),
  },
  { name: 'position', label: 'Measure the position', change: () => ({ ...shown, tilt: -90 * degree }) },
  { name: 'again', label: 'As in step 1', change: (_, lab) => defaults(lab) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  timeless: true,
  panels: [
    { name: 'plane', width: 600, height: 500, handles: true, draw: drawPlane },
    { name: 'axis', width: 370, height: 260, handles: true, draw: drawAxis },
  ],
  layout: {
    narrow: ['plane', 'verdict', 'tries', 'axis', 'controls', 'readouts'],
    medium: ['plane verdict', 'plane axis', 'plane tries', 'controls controls', 'readouts readouts'],
    columns: { medium: '8fr 5fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: (frame) => ({
    x1: [frame.params.mean[0], frame.euclideanFoot.at[0], frame.mahalanobisFoot.at[0], frame.update.at[0]],
    x2: [frame.params.mean[1], frame.euclideanFoot.at[1], frame.mahalanobisFoot.at[1], frame.update.at[1]],
  }),
}
