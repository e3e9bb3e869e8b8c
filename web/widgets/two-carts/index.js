/**
 * Two carts and the readings of each: a direction that a sensor does not see, found by hand. Drag the second cart, and
 * its strip stays; switch the sensor, and it does not.
 */

import { fixed } from '../../draw/numbers.js'
import { drawRails } from './rails.js'
import { drawStrips } from './strips.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').TwoCartsFrame} Frame */

// State: a metre apart, and the sensor reads the velocity.

const start = { params: {}, step: 0 }

// Model: the lab `TwoCarts` in the module.

// View: two panels, in the folder's files.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ difference, rank, unseen, params }) {
  return [
    {
      key: 'difference',
      label: 'Largest difference of two readings',
      value: fixed(difference),
      unit: params.sensor === 'velocity' ? 'm/s' : 'm',
      wide: true,
      kin: 'measurement',
    },
    { key: 'rank', label: 'Rank', value: `${rank} of 2` },
    {
      key: 'unseen',
      label: 'Unseen direction',
      value: unseen ? `[${unseen.map((e) => fixed(e, 0)).join(', ')}]` : 'none',
    },
  ]
}

// Controls. The second cart and its speed are handles in the drawing.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  {
    kind: 'choice',
    name: 'sensor',
    label: 'Sensor',
    options: [
      { value: 'velocity', label: 'velocity' },
      { value: 'position', label: 'position' },
    ],
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: false,
  timeless: true,
  panels: [
    { name: 'rails', width: 500, height: 165, handles: true, draw: drawRails },
    { name: 'strips', width: 500, height: 300, draw: drawStrips },
  ],
  layout: {
    narrow: ['rails', 'strips', 'controls', 'verdict', 'readouts'],
    medium: ['rails verdict', 'strips controls', 'strips readouts'],
    columns: { medium: '7fr 5fr' },
  },
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: ({ readings: [first, second] }) => ({ first, second }),
}
