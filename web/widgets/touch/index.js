/**
 * The touch: the reader drags a dot onto the line, where the growing ellipse will touch it first, and lets it grow. The
 * drawing is the question.
 */

import { fixed } from '../../draw/numbers.js'
import { drawPlane } from './plane.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').TouchFrame} Frame */

// State: nothing has grown, and the dot is nowhere near.

const start = { params: {}, step: 0 }

// Model: the lab `Touch` in the module.

// View: one panel, in `plane.js`. Nothing tells where the ellipse touches before it has grown.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ params: { grown }, touchRadius, guessRadius, off, times }) {
  /** @param {string} value */
  const answer = (value) => (grown ? value : '–')
  return [
    { key: 'off', label: 'Your dot − purple foot', value: answer(fixed(off)), unit: 'm', kin: 'measurement' },
    { key: 'touch', label: 'Purple foot at', value: answer(fixed(touchRadius)), unit: 'σ', kin: 'posterior' },
    { key: 'guess', label: 'Your dot at', value: answer(fixed(guessRadius)), unit: 'σ', kin: 'measurement' },
    { key: 'times', label: 'Density, foot over dot', value: answer(times < 1000 ? fixed(times) : '> 999') },
  ]
}

// Controls. The dot is a handle in the drawing.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [{ kind: 'action', name: 'grow', label: 'Grow', change: () => ({ grown: true }) }]

/** @param {number} covariance */
const leaning = (covariance) => () => ({ covariance, grown: false })

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'step', label: 'As in step 1', change: leaning(1.05) },
  { name: 'other', label: 'Lean it the other way', change: leaning(-1.05) },
  { name: 'none', label: 'No lean', change: leaning(0) },
  { name: 'more', label: 'Lean it more', change: leaning(1.7) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  timeless: true,
  panels: [{ name: 'plane', width: 500, height: 360, handles: true, draw: drawPlane }],
  layout: {
    narrow: ['plane', 'controls', 'verdict', 'tries', 'readouts'],
    medium: ['plane verdict', 'plane controls', 'plane tries', 'readouts readouts'],
    columns: { medium: '7fr 6fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  // Where it touches is the figure's question.
  series: ({ params: { grown }, mean, guess, touch, below }) => {
    const points = [mean, guess, ...(grown ? [touch, below] : [])]
    return { x1: points.map(([x]) => x), x2: points.map(([, v]) => v) }
  },
}
