/**
 * Two bells on a beam: two opinions about one velocity, and the point where they balance. Drag the middle of a bell, or
 * its flank.
 */

import { fixed } from '../../draw/numbers.js'
import { usual } from '../../figure/defaults.js'
import { drawBells } from './bells.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').TwoBellsFrame} Frame */

// State: the two opinions of the first hand-checked step.

const start = { params: {}, step: 0 }

// Model: the lab `TwoBells` in the module.

// View: one panel, in `bells.js`.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ params, likely, variance, weights: [expected, read, both] }) {
  return [
    { key: 'expected', label: 'Prediction', value: fixed(params.expected), unit: 'm/s', kin: 'prediction' },
    { key: 'read', label: 'Reading {y}', value: fixed(params.reading), unit: 'm/s', kin: 'measurement' },
    { key: 'likely', label: '{y}^{∗}', value: fixed(likely), unit: 'm/s', kin: 'measurement' },
    {
      key: 'weights',
      label: 'Weights 1/*σ*^{2}: prediction + reading = both',
      value: `${fixed(expected)} + ${fixed(read)} = ${fixed(both)}`,
      wide: true,
    },
    { key: 'sigma', label: '*σ* of both', value: fixed(Math.sqrt(variance)), unit: 'm/s', kin: 'posterior' },
  ]
}

// Controls: the handles in the drawing.

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  {
    name: 'equal',
    label: 'Two equal opinions',
    change: (/** @type {Frame} */ { params }) => ({ noise: params.expectedVariance }),
  },
  // A sensor is poor beside the prediction of step 1.
  { name: 'noisy', label: 'A poor sensor', change: (_, lab) => ({ ...usual(lab, 'expectedVariance'), noise: 4 }) },
  { name: 'step', label: 'As in step 1', change: (_, lab) => usual(lab) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  timeless: true,
  panels: [{ name: 'bells', width: 500, height: 310, handles: true, draw: drawBells }],
  layout: {
    narrow: ['bells', 'verdict', 'tries', 'controls', 'readouts'],
    medium: ['bells verdict', 'bells tries', 'controls controls', 'readouts readouts'],
    columns: { medium: '7fr 6fr' },
  },
  tries,
  describe,
  controls: [],
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: ({ params, likely, variance }) => ({
    mean: [params.expected, params.reading, likely],
    variance: [params.expectedVariance, params.noise, variance],
  }),
}
