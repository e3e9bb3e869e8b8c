/**
 * Late readings: a robot on a rail with a fast and coarse sensor, a slow and fine one, and one that is fine and late.
 * What comes late is taken as if it were new, dropped, or put where it was measured.
 */

import { fixed } from '../../draw/numbers.js'
import { drawCosts } from './bars.js'
import { costs } from './costs.js'
import { drawInnovations } from './innovations.js'
import { drawLine } from './line.js'
import { CAMERA, WAYS } from './sensors.js'
import { describe, mean, verdict } from './words.js'

/** @typedef {import('estimate-wasm').LateFrame} Frame */

// State: the camera is 0.6 s late, and its readings are taken as if they were new. It has no steps.

const start = { params: {}, step: 0 }

// Model: the lab `LateReadings`. What follows only reads its frame.

// View: three panels, in the folder's files, and the numbers beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { params, ways, lag, travelled, sensors, gap } = frame
  const own = ways[WAYS.findIndex(({ value }) => value === params.way)]
  const metres = (/** @type {number | null | undefined} */ value) => (value == null ? '–' : fixed(value, 2))
  const innovation = (/** @type {number} */ i) => ({
    value: mean(sensors[i]).replace(' m', ''),
    unit: sensors[i].mean === null ? undefined : 'm',
  })
  return [
    { key: 'rms', label: 'Error (RMS)', value: metres(own.rms), unit: 'm', headline: true },
    { key: 'lag', label: 'behind, in the mean', value: metres(lag), unit: 'm', kin: 'posterior' },
    { key: 'travelled', label: 'driven in the delay, *vτ*', value: metres(travelled), unit: 'm', kin: 'truth' },
    { key: 'camera', label: 'mean {innov}, camera', ...innovation(CAMERA), kin: 'measurement' },
    { key: 'nees', label: 'NEES, 2 expected', value: fixed(own.nees, 1), kin: 'posterior' },
    { key: 'sonar', label: 'mean {innov}, sonar', ...innovation(0), kin: 'measurement', more: true },
    { key: 'laser', label: 'mean {innov}, laser', ...innovation(1), kin: 'measurement', more: true },
    { key: 'nis', label: 'NIS, camera', value: fixed(sensors[CAMERA].nis, 2), kin: 'measurement', more: true },
    { key: 'before', label: '*σ* before the gap', value: metres(gap?.sigmaBefore), unit: 'm', more: true },
    { key: 'after', label: '*σ* at its end', value: metres(gap?.sigmaAfter), unit: 'm', more: true },
    { key: 'later', label: 'most of it afterwards', value: metres(gap?.sigmaSmoothed), unit: 'm', more: true },
  ]
}

// Controls: the way and the delay; the rest waits.

const rate = (/** @type {number} */ value) => (value === 0 ? 'none' : `${value} a second`)

/** A gap as it opens, from when to when, seconds. */
const GAP = [8, 13]

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  { kind: 'choice', name: 'way', label: 'What is late is taken', options: WAYS },
  {
    kind: 'range',
    name: 'delay',
    label: 'The camera is late by *τ*',
    ends: [0, 1.5],
    words: (value) => `${fixed(value, 2)} s`,
  },
  { kind: 'range', name: 'sonarRate', label: 'Sonar (*σ* 0.5 m)', words: rate, more: true },
  { kind: 'range', name: 'laserRate', label: 'Laser (*σ* 0.05 m)', words: rate, more: true },
  { kind: 'range', name: 'cameraRate', label: 'Camera (*σ* 0.05 m)', words: rate, more: true },
  {
    kind: 'choice',
    name: 'course',
    label: 'The robot drives',
    options: [
      { value: 'steady', label: 'Steadily' },
      { value: 'to-and-fro', label: 'To and fro' },
    ],
    more: true,
  },
  {
    kind: 'toggle',
    name: 'gap',
    label: 'a gap, in which nothing is read',
    get: ({ gap }) => gap !== null,
    set: (on) => ({ gap: on ? GAP : null }),
    more: true,
  },
  { kind: 'toggle', name: 'smooth', label: 'the best track afterwards', more: true },
  { kind: 'whole', name: 'seed', label: 'Seed', more: true },
]

/** As the figure opens, but for what is late and how it is taken. */
const usual = {
  sonarRate: 5,
  laserRate: 0.5,
  cameraRate: 1,
  gap: null,
  picked: 9,
  ownDelay: null,
  removed: false,
  course: 'steady',
  smooth: false,
}

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  {
    name: 'alone',
    label: 'The camera alone',
    change: () => ({ ...usual, way: 'as-new', delay: 0.6, sonarRate: 0, laserRate: 0 }),
  },
  {
    name: 'drop',
    label: 'Drop what is late',
    change: () => ({ ...usual, way: 'drop', delay: 0.6 }),
  },
  {
    name: 'one',
    label: 'One reading 3 s late',
    change: () => ({ ...usual, way: 'as-new', delay: 0, ownDelay: 3 }),
  },
  {
    name: 'gap',
    label: 'A gap, and the track afterwards',
    // In hand is a reading from before the gap.
    change: () => ({ ...usual, way: 'go-back', delay: 0.6, gap: GAP, picked: 4, smooth: true }),
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  aside: costs,
  start,
  seeded: false,
  timeless: true,
  slow: true,
  panels: [
    { name: 'line', width: 560, height: 490, handles: true, draw: drawLine },
    { name: 'innovations', width: 380, height: 310, draw: drawInnovations },
    { name: 'costs', width: 380, height: 180, aside: true, draw: drawCosts },
  ],
  layout: {
    narrow: ['line', 'controls', 'tries', 'verdict', 'innovations', 'costs', 'readouts'],
    along: 'controls',
    medium: ['line line', 'controls controls', 'tries tries', 'innovations costs', 'innovations verdict'],
    wide: ['line innovations', 'line costs', 'controls controls', 'tries verdict'],
    columns: { medium: '1fr 1fr', wide: '3fr 2fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: verdict,
  series: ({ time, position, speed, error, twoSigma }) => ({ time, position, speed, error, twoSigma }),
}
