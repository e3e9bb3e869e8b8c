/**
 * The cloud: a covariance as the mean products of two hundred errors. Drag the tilt, and its entries follow; touch an
 * error, and see its product.
 */

import { fixed } from '../../draw/numbers.js'
import { usual } from '../../figure/defaults.js'
import { drawPlane } from './plane.js'
import { isShown } from './reach.js'
import { describe, isLong, verdict } from './words.js'

/** @typedef {import('estimate-wasm').ErrorCloudFrame} Frame */

// State: the predicted covariance of the first hand-checked step.

const start = { params: {}, step: 0 }

// Model: the lab `ErrorCloud` in the module.

// View: one panel, in `plane.js`.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { P, correlation, regression, longAxis } = frame
  const axis = isLong(frame) && Math.abs(longAxis) < 1000 ? fixed(longAxis) : '–'
  /**
   * @param {string} key @param {import('../../draw/words.js').Words} label @param {number} value
   * @param {[import('../../draw/words.js').Words, import('../../draw/words.js').Words]} place
   * @returns {import('../../figure/shell.js').Readout}
   */
  const cell = (key, label, value, place) => ({ key, label, value: fixed(value), cell: place, kin: 'prediction' })
  const [position, velocity] = ['position', 'velocity']
  return [
    cell('p11', '{P}_{11}', P[0][0], [position, position]),
    cell('p12', '{P}_{12}', P[0][1], [position, velocity]),
    cell('p21', '{P}_{21}', P[1][0], [velocity, position]),
    cell('p22', '{P}_{22}', P[1][1], [velocity, velocity]),
    { key: 'regression', label: 'Regression {P}_{12}/{P}_{22}', value: fixed(regression), unit: 's' },
    { key: 'axis', label: 'Long axis', value: axis, unit: 's' },
    { key: 'correlation', label: 'Correlation', value: fixed(correlation) },
  ]
}

// Controls: the handles in the drawing.

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'other', label: 'Lean it the other way', change: leansBack },
  { name: 'upright', label: 'No lean', change: standsUp },
  { name: 'dot', label: 'Touch one that takes away', change: takesAway },
]

/** The same two variances, and no covariance between them. @param {Frame} frame */
function standsUp({ sigma: [position, velocity] }) {
  return { semiMajor: velocity, semiMinor: position, angle: Math.PI / 2 }
}

/**
 * The mirror image of the tilt; of an ellipse that stands upright, that of the usual one.
 * @param {Frame} frame
 * @param {any} lab
 */
function leansBack({ params: { angle } }, lab) {
  const first = /** @type {{ angle: number }} */ (usual(lab, 'angle', 'semiMajor', 'semiMinor'))
  const upright = Math.abs(angle - Math.PI / 2) < 1e-9
  return upright ? { ...first, angle: Math.PI - first.angle } : { angle: Math.PI - angle }
}

/** The error in the drawing whose product takes most away from P₁₂. @param {Frame} frame */
function takesAway({ dots }) {
  const products = dots.map((error) => (isShown(error) ? error[0] * error[1] : Infinity))
  return { dot: products.indexOf(Math.min(...products)) }
}

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  timeless: true,
  panels: [{ name: 'plane', width: 500, height: 410, handles: true, draw: drawPlane }],
  layout: {
    narrow: ['plane', 'readouts', 'verdict', 'tries', 'controls'],
    medium: ['plane readouts', 'plane verdict', 'plane tries', 'controls controls'],
    columns: { medium: '7fr 5fr' },
  },
  tries,
  describe,
  controls: [],
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: (/** @type {Frame} */ { dots }) => ({ position: dots.map(([a]) => a), velocity: dots.map(([, b]) => b) }),
}
