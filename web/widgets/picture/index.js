/**
 * The picture: a prediction with its ellipse, the line of states that explain a reading, and the two ways of stepping
 * onto it. Drag the prediction, the axes of its ellipse and the reading; turn the sensor and its noise.
 */

import { fixed } from '../../draw/numbers.js'
import { drawAxis } from './axis.js'
import { GROWN } from './handles.js'
import { drawPlane } from './plane.js'
import { describe, share, verdict } from './words.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */

// State: what a reader can change. The axes are those of the first hand-checked step's predicted covariance.

const start = { params: {}, step: 0 }

// Model: the lab `Picture` in the module. What is said and drawn only reads its frame.

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
  const [byRuler, byMetric] = ['⟨*a*, Δ*x*⟩, ruler', '⟨*a*, Δ*x*⟩, metric of {P}']
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
    { key: 'likely', label: '{y}^{∗}', value: answer(fixed(mostLikelyOutput, 3)), kin: 'measurement' },
    {
      key: 'weights',
      label: 'Weights 1/*σ*^{2}: expected + reading = product',
      value: `${weight(expectedVariance)} + ${weight(noise)}${sealed ? '' : ` = ${weight(mostLikelyVariance)}`}`,
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
    { key: 'share', label: 'Part of {innov} taken over', value: answer(fixed(taken, 3)), kin: 'posterior' },
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
    // What a button adds comes below it.
    narrow: ['plane', 'verdict', 'tries', 'grow', 'axis', 'controls', 'readouts'],
    medium: ['plane verdict', 'plane axis', 'plane tries', 'controls controls', 'readouts readouts'],
    columns: { medium: '8fr 5fr' },
  },
  stages: {
    panels: { axis: 2 },
    hand: { tilt: 3, readouts: 3, tools: 3 },
    grow: ['Show the two opinions', 'Show the whole figure'],
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
