/**
 * A cart and its copy: what an observer is, before anything of it is computed. Both drive, the reader compares the two
 * speedometers, and the copy is nudged. Drag the copy, or the needle of its speed.
 */

import { fixed } from '../../draw/numbers.js'
import { drawRail } from './rail.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').CartCopyFrame} Frame */

// State: the copy is a metre behind, at the right speed; both are under way.

const start = { params: {}, step: 4 }

// Model: the lab `CartCopy` in the module.

// View: one panel, in `rail.js`.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ innovation, nudge, error, step, K }) {
  return [
    { key: 'innovation', label: 'Innovation {innov}', value: fixed(innovation, 2), unit: 'm/s', kin: 'measurement' },
    {
      key: 'nudge',
      label: 'Nudge {K}{innov}',
      value: `${fixed(nudge[0])} m, ${fixed(nudge[1])} m/s`,
      wide: true,
      kin: 'posterior',
    },
    { key: 'position', label: 'Copy − cart', value: fixed(error[0]), unit: 'm', kin: 'truth' },
    { key: 'speed', label: 'Copy − cart, speed', value: fixed(error[1]), unit: 'm/s', kin: 'truth' },
    { key: 'gain', label: 'Gain {K}', value: `${fixed(K[0])} s, ${fixed(K[1])}` },
    { key: 'step', label: 'Step', value: String(step) },
  ]
}

// Controls. The copy's position and speed are handles in the drawing.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  {
    kind: 'range',
    name: 'gain',
    label: 'Gain: how much the copy is nudged',
    words: (value) => fixed(value, 2),
    notches: () => [
      { at: 0, name: '0' },
      { at: 1, name: '1' },
    ],
  },
]

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'position', label: 'Wrong by a metre', change: () => ({ position: -1, speed: 0, phase: 0, step: 4 }) },
  { name: 'speed', label: 'The speed wrong instead', change: () => ({ position: 0, speed: 1, phase: 4, step: 0 }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  beats: true,
  panels: [{ name: 'rail', width: 500, height: 385, handles: true, draw: drawRail }],
  layout: {
    narrow: ['rail', 'verdict', 'controls', 'tries', 'readouts'],
    medium: ['rail verdict', 'rail controls', 'rail tries', 'readouts readouts'],
    columns: { medium: '7fr 6fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame, before) => `${frame.step === before.step ? '' : `Step ${frame.step}. `}${verdict(frame)}`,
  series: ({ truth, copy, innovation }) => ({
    cart: truth,
    copy,
    innovation: [innovation],
  }),
}
