/**
 * The picture: a prediction with its ellipse, the line of states that explain a reading, and the two ways of stepping
 * onto it. Drag the prediction, the axes of its ellipse and the reading; turn the sensor and its noise.
 */

import { fixed } from '../core/numbers.js'
import { drawPlane } from './kalman-picture/plane.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */

// State: what a reader can change. The axes are those of the first hand-checked step's predicted covariance.

const start = { params: {}, step: 0 }

// Model: the lab `Picture` in the module. What follows only reads its frame.

/** @param {Frame} frame */
function verdict(frame) {
  return frame.params.noise === 0 ? `${ofTheFeet(frame)} The sensor is perfect: Ω and Ω* are one line.` : ofTheFeet(frame)
}

/** @param {Frame} frame */
function ofTheFeet({ params, innovation, euclideanFoot: gray, mahalanobisFoot: purple }) {
  if (Math.abs(innovation) < 5e-4) return 'The reading is the one expected: there is nothing to correct.'
  if (Math.abs(params.semiMajor - params.semiMinor) < 1e-9) return 'The ellipse is a circle: both metrics agree, and the two feet are one point.'
  if (Math.hypot(gray.at[0] - purple.at[0], gray.at[1] - purple.at[1]) < 5e-3) return 'The two feet are one point here, to two decimals.'
  return `The gray foot is ${fixed(gray.distance, 2)} standard deviations away, the purple one ${fixed(purple.distance, 2)}.`
}

/** @param {Frame} frame */
function describe(frame) {
  const point = (/** @type {number[]} */ [x, v]) => `${fixed(x, 2)} metres and ${fixed(v, 2)} metres a second`
  return {
    plane: `Plane of position and velocity: a prediction at ${point(frame.params.mean)} with its ellipse; the line of states that explain the reading ${fixed(frame.params.reading, 2)}; the perpendicular foot at ${point(frame.euclideanFoot.at)}, the Mahalanobis foot at ${point(frame.mahalanobisFoot.at)}; on the line of the most likely output ${fixed(frame.mostLikelyOutput, 2)} the Kalman update at ${point(frame.posterior.x)}.`,
  }
}

// View: one panel, in kalman-picture/plane.js.

/** @param {Frame} frame @returns {import('../core/shell.js').Readout[]} */
function readouts({ innovation, mostLikelyOutput, R, euclideanFoot: gray, mahalanobisFoot: purple, update }) {
  /** Rounding leaves a last digit of either sign; what is printed is zero. */
  const zero = (/** @type {number} */ value) => fixed(Math.abs(value) < 5e-4 ? 0 : value, 3)
  const [byRuler, byMetric] = ['by the ruler', { choset: 'in the metric of *P*', thrun: 'in the metric of Σ' }]
  /** ⟨a, Δx⟩ of a foot. @param {string} key @param {import('../core/words.js').Words} label @param {number} value @param {string} foot @param {import('../core/words.js').Words} metric @param {'truth' | 'posterior'} kin @returns {import('../core/shell.js').Readout} */
  const cell = (key, label, value, foot, metric, kin) => ({ key, label, value: zero(value), zero: Math.abs(value) < 5e-4, cell: [foot, metric], kin })
  return [
    cell('gray-euclid', 'Gray ⟨*a*, Δ*x*⟩, ruler', gray.euclidean, 'gray foot', byRuler, 'truth'),
    cell('gray-mahalanobis', { choset: 'Gray ⟨*a*, Δ*x*⟩, metric of *P*', thrun: 'Gray ⟨*a*, Δ*x*⟩, metric of Σ' }, gray.mahalanobis, 'gray foot', byMetric, 'truth'),
    cell('purple-euclid', 'Purple ⟨*a*, Δ*x*⟩, ruler', purple.euclidean, 'purple foot', byRuler, 'posterior'),
    cell('purple-mahalanobis', { choset: 'Purple ⟨*a*, Δ*x*⟩, metric of *P*', thrun: 'Purple ⟨*a*, Δ*x*⟩, metric of Σ' }, purple.mahalanobis, 'purple foot', byMetric, 'posterior'),
    { key: 'innovation', label: 'Innovation *ν*', value: fixed(innovation, 3), kin: 'measurement' },
    { key: 'likely', label: { choset: '*y*^{∗}', thrun: '*z*^{∗}' }, value: fixed(mostLikelyOutput, 3), kin: 'measurement' },
    { key: 'gain', label: { choset: 'Gain *R* (Thrun *K*)', thrun: 'Gain *K* (Choset *R*)' }, value: `[${fixed(R[0], 3)}, ${fixed(R[1], 3)}]`, kin: 'posterior' },
    { key: 'update', label: 'Update', value: `[${fixed(update.at[0], 3)}, ${fixed(update.at[1], 3)}]`, kin: 'posterior' },
    { key: 'residual', label: { choset: '*H*Δ*x* − *ν* of both', thrun: '*C*Δ*x* − *ν* of both' }, value: `${zero(gray.residual)}, ${zero(purple.residual)}`, kin: 'measurement', more: true },
  ]
}

// Controls. Prediction, axes and reading are handles in the drawing.

const degree = Math.PI / 180

/** @param {any} lab @returns {Record<string, unknown>} */
const defaults = (lab) => Object.fromEntries(lab.constructor.parameters().map((/** @type {import('estimate-wasm').Parameter} */ parameter) => [parameter.name, parameter.default]))

/** @type {import('../core/controls.js').Control[]} */
const controls = [
  {
    kind: 'range', name: 'noise', label: { choset: 'Sensor noise *W* (Thrun *Q*)', thrun: 'Sensor noise *Q* (Choset *W*)' },
    words: (value) => fixed(value, 2),
    notches: () => [{ at: 0, name: '0' }, { at: 0.5, name: 'step 1' }],
  },
  {
    kind: 'range', name: 'tilt', label: 'Turn of the sensor, degrees', ends: [-90, 0],
    words: (value) => `${fixed(value, 0)}°`,
    notches: () => [{ at: -90, name: 'position' }, { at: 0, name: 'velocity' }],
    scale: (value) => value / degree,
    set: (value) => ({ tilt: value * degree }),
  },
]

/** @type {import('../core/spec.js').Try[]} */
const tries = [
  { name: 'perfect', label: 'Sensor noise to zero', change: () => ({ noise: 0 }) },
  { name: 'round', label: 'Make it a circle', change: (/** @type {Frame} */ { params }) => ({ semiMajor: params.semiMinor }) },
  { name: 'position', label: 'Measure the position', change: () => ({ tilt: -90 * degree }) },
  { name: 'again', label: 'As in step 1', change: (_, lab) => defaults(lab) },
]

/** @type {import('../core/spec.js').FigureSpec} */
export const kalmanPicture = {
  tag: 'kalman-picture',
  lab: 'Picture',
  name: 'picture',
  start,
  seeded: false,
  timeless: true,
  panels: [{ name: 'plane', width: 600, height: 500, handles: true, draw: drawPlane }],
  layout: {
    narrow: ['plane', 'verdict', 'readouts'],
    medium: ['plane verdict', 'plane readouts'],
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
