/**
 * A car that really drove: speeds, turn rates and position fixes, each at its own time. The speed is half a second
 * late, and the reader finds that out.
 */

import { fixed } from '../../draw/numbers.js'
import { curve, drawCurve } from './curve.js'
import { drawAlong, drawMap } from './map.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').CarFrame} Frame */

// State: one fix a second, and no sensor late. It has no steps.

const start = { params: {}, step: 0 }

// Model: the lab `CarLog` in the module, on the log that is fetched with it. What follows only reads its frame.

/** @type {import('../../figure/spec.js').Widget['open']} */
const open = async (id, given, spec) => (await import('./open.js')).open(id, given, spec)

// View: three panels, in the folder's files, and the numbers beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ logLikelihood, nis, lag1, used, refusals, learned, tunnel, reckonedOff }) {
  return [
    { key: 'likelihood', label: 'Log-likelihood', value: fixed(logLikelihood, 1), headline: true },
    { key: 'nis', label: 'NIS for each output', value: fixed(nis, 2), kin: 'measurement' },
    { key: 'lag1', label: 'Lag 1', value: fixed(lag1, 2), kin: 'measurement' },
    { key: 'used', label: 'Fixes used', value: String(used), kin: 'measurement' },
    { key: 'refused', label: 'refused', value: String(refusals), kin: 'measurement' },
    {
      key: 'scale',
      label: 'Scale of the speed',
      value: learned ? `${fixed(100 * learned.speedScale, 2)} %` : '–',
      more: true,
    },
    { key: 'bias', label: 'Bias of the turn rate', value: fixed(learned?.turnBias, 4), unit: 'rad/s', more: true },
    {
      key: 'alone',
      label: 'Off without fixes',
      value: fixed(reckonedOff, 0),
      unit: 'm',
      kin: 'prediction',
      more: true,
    },
    { key: 'worst', label: 'Off in the tunnel', value: fixed(tunnel?.worst, 1), unit: 'm', more: true },
    { key: 'later', label: 'Off afterwards', value: fixed(tunnel?.worstSmoothed, 1), unit: 'm', more: true },
  ]
}

// Controls: the delay; the rest waits.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  {
    kind: 'range',
    name: 'delay',
    label: 'The speed is late by',
    // As far as the curve.
    ends: [-0.5, 1.5],
    words: (value) => `${fixed(value, 2)} s`,
  },
  {
    kind: 'choice',
    name: 'fixes',
    label: 'Fixes',
    options: [
      { value: 'second', label: 'One a second' },
      { value: 'all', label: 'All, ten a second' },
      { value: 'none', label: 'None' },
    ],
  },
  { kind: 'toggle', name: 'learn', label: 'learn the speed’s scale and the turn rate’s bias', more: true },
  { kind: 'toggle', name: 'tunnel', label: 'a tunnel of 30 s', more: true },
  { kind: 'toggle', name: 'gate', label: 'a gate of 99.9 %', more: true },
]

const usual = { fixes: 'second', delay: 0, learn: false, tunnel: false, gate: false }
/** Where the likelihood is greatest, as the slider goes. */
const late = 0.58

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'none', label: 'Without fixes', change: () => ({ ...usual, fixes: 'none' }) },
  { name: 'all', label: 'All fixes', change: () => ({ ...usual, fixes: 'all' }) },
  { name: 'second', label: 'One a second', change: () => usual },
  { name: 'learn', label: 'Learn scale and bias', change: () => ({ ...usual, delay: late, learn: true }) },
  { name: 'tunnel', label: 'A tunnel', change: () => ({ ...usual, tunnel: true }) },
  { name: 'gate', label: 'A gate', change: () => ({ ...usual, delay: late, learn: true, gate: true }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  aside: curve,
  log: 'content/logs/car.csv',
  start,
  open,
  seeded: false,
  timeless: true,
  slow: true,
  panels: [
    { name: 'map', width: 500, height: 420, draw: drawMap },
    { name: 'curve', width: 400, height: 260, handles: true, aside: true, draw: drawCurve },
    { name: 'along', width: 400, height: 190, draw: drawAlong },
  ],
  layout: {
    narrow: ['map', 'curve', 'tries', 'controls', 'verdict', 'along', 'readouts'],
    along: 'tries',
    medium: ['map map', 'curve along', 'verdict verdict', 'tries tries'],
    wide: ['map curve', 'map along', 'verdict verdict', 'tries tries'],
    columns: { medium: '1fr 1fr', wide: '5fr 4fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: verdict,
  series: ({ time, along }) => ({ time, along }),
}
