/**
 * The Observability Probe: Rusty drives a square in room A and localizes itself by landmarks that the reader places.
 * Which directions of its pose do the readings see, frozen at this pose and along the path driven?
 */

import { fixed, power } from '../../draw/numbers.js'
import { drawMap } from './map.js'
import { turns } from './hidden.js'
import { drawConsistency, drawTrace } from './history.js'
import { drawBearings, drawRanges, sketch } from './ghost.js'
import { drawRanks } from './ranks.js'
import { degree, tries } from './tries.js'
import { describe, verdict } from './words.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */

// State: what a reader can change, and where the figure starts: two laps with one landmark.

const start = { params: {}, step: 240 }

// Model: the lab `ObservabilityProbe` in the module. What is said and drawn only reads its frame.

// View: seven panels, each in a file of the folder, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ frozen, alongPath, trace, mean, slam, step, ghost, error }) {
  /** [dx, dy, dθ] with the position's part 1 m long, if it has one. @param {number[] | null | undefined} c */
  const vector = (c) => (c ? `[${c.map((entry) => fixed(entry, 2)).join(', ')}]` : '–')
  const haunted = Boolean(ghost)
  const of = (/** @type {import('estimate-wasm').ProbeRanks} */ { rank, n }) => `${rank} of ${n}`
  const counts = slam ? `${slam.matched} / ${slam.founded} / ${slam.rejected}` : '–'
  return [
    { key: 'path', label: 'Rank, along the path', value: alongPath.steps === 0 ? '–' : of(alongPath), headline: true },
    { key: 'frozen', label: 'Rank, frozen', value: of(frozen) },
    { key: 'trace', label: 'Spread, tr {P}', value: fixed(trace.total, 3), kin: 'posterior' },
    { key: 'reference', label: 'with two, ranges only', value: fixed(trace.reference, 3), kin: 'truth' },
    { key: 'step', label: 'Step', value: String(step) },
    { key: 'path-turns', label: 'Stroke path: the heading turns', value: turns(alongPath), wide: true, row: true },
    { key: 'frozen-turns', label: 'Stroke frozen: the heading turns', value: turns(frozen), wide: true },
    { key: 'by-hand', label: 'Mixed by hand', value: vector(ghost?.byHand), wide: true, shown: haunted },
    {
      key: 'computed',
      label: 'Null vector, along the path',
      value: alongPath.directions.length === 1 ? vector(alongPath.directions[0]) : '–',
      wide: true,
      shown: haunted,
    },
    {
      key: 'range-gap',
      label: 'Ranges differ by',
      value: fixed(ghost?.rangeGap, 3),
      unit: 'm',
      kin: 'measurement',
      shown: haunted,
    },
    {
      key: 'bearing-gap',
      label: 'Bearings differ by',
      value: fixed(ghost && ghost.bearingGap !== null ? (ghost.bearingGap * 180) / Math.PI : null, 1),
      unit: '°',
      kin: 'measurement',
      shown: haunted && ghost?.bearingGap !== null,
    },
    {
      key: 'position',
      label: 'Variance of the position',
      value: fixed(trace.position, 3),
      unit: 'm²',
      kin: 'posterior',
      more: true,
    },
    {
      key: 'heading',
      label: 'Variance of the heading',
      value: fixed(trace.heading, 4),
      unit: 'rad²',
      kin: 'posterior',
      more: true,
    },
    {
      key: 'error',
      label: 'Error of the position',
      value: fixed(Math.hypot(error[0], error[1]), 2),
      unit: 'm',
      kin: 'truth',
      more: true,
    },
    { key: 'nees', label: 'Mean NEES (expected 3)', value: fixed(mean.nees, 2), more: true },
    { key: 'nis', label: 'Mean NIS per output (expected 1)', value: fixed(mean.nisPerDof, 2), more: true },
    { key: 'map', label: 'Matched / founded / rejected', value: counts, kin: 'measurement', more: true },
  ]
}

// Controls. The landmarks are handles on the map.

/**
 * A dial of the ghost, in degrees.
 * @param {string} name
 * @param {import('../../draw/words.js').Words} label
 * @returns {import('../../figure/controls.js').Control}
 */
const dial = (name, label) => ({
  kind: 'range',
  name,
  label,
  shown: ({ ghost }) => Boolean(ghost),
  words: (value) => `${fixed(value, 0)}°`,
  scale: (value) => Math.round(value / degree),
  step: 1,
  set: (value) => ({ [name]: value * degree }),
})

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  // On a phone right below what they move; the tolerance below the plot that has its line.
  dial('ghostAround', 'Ghost, about landmark 1'),
  {
    kind: 'range',
    name: 'ghostShift',
    label: 'Ghost, shifted east',
    words: (value) => `${fixed(value, 2)} m`,
    shown: ({ ghost }) => Boolean(ghost),
  },
  dial('ghostTurn', 'Ghost, on the spot'),
  {
    kind: 'range',
    name: 'tolerance',
    label: 'Relative rank tolerance',
    step: 0.5,
    words: (value) => power(10 ** value),
    notches: () => [
      { at: -6, name: '10^{−6}' },
      { at: 0, name: '1' },
    ],
    // In powers of ten, as far down as the parameter's own step.
    scale: (value, { step }) => Math.log10(Math.max(value, step)),
    set: (value) => ({ tolerance: 10 ** value }),
  },
  {
    kind: 'choice',
    name: 'count',
    label: 'Landmarks',
    options: [
      { value: 1, label: 'one' },
      { value: 2, label: 'two' },
      { value: 3, label: 'three' },
    ],
  },
  {
    kind: 'choice',
    name: 'sensor',
    label: 'Sensor',
    options: [
      { value: 'range', label: 'range only' },
      { value: 'range-bearing', label: 'range and bearing' },
    ],
    // A map is founded on ranges and bearings.
    get: (_, frame) => frame.sensor,
    enabled: (params) => !params.forget,
  },
  {
    kind: 'toggle',
    name: 'stop',
    label: 'stop the robot',
    get: (params) => params.stop !== null,
    set: (on, _, { step }) => ({ stop: on ? step : null }),
  },
  { kind: 'toggle', name: 'forget', label: 'forget the map' },
  {
    kind: 'toggle',
    name: 'ghost',
    label: 'let a ghost drive along (with the map)',
    enabled: (params) => !params.forget,
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: true,
  pace: 20,
  stride: 1,
  panels: [
    { name: 'map', width: 470, height: 470, handles: true, draw: drawMap },
    { name: 'ranks', width: 460, height: 230, draw: drawRanks },
    { name: 'trace', width: 460, height: 200, draw: drawTrace },
    {
      name: 'nees',
      width: 460,
      height: 180,
      draw: (panel, frame) => drawConsistency(panel, frame, 'nees'),
      shown: ({ ghost }) => !ghost,
    },
    {
      name: 'nis',
      width: 460,
      height: 180,
      draw: (panel, frame) => drawConsistency(panel, frame, 'nis'),
      shown: ({ ghost }) => !ghost,
    },
    { name: 'ranges', width: 460, height: 180, draw: drawRanges, shown: ({ ghost }) => Boolean(ghost) },
    {
      name: 'bearings',
      width: 460,
      height: 180,
      draw: drawBearings,
      shown: ({ ghost }) => Boolean(ghost && ghost.bearingGap !== null),
    },
  ],
  layout: {
    narrow: [
      'map',
      'tries',
      'ranks',
      'ranges',
      'bearings',
      'controls',
      'grow',
      'verdict',
      'trace',
      'readouts',
      'nees',
      'nis',
    ],
    along: 'tries',
    // Who turns the world by hand looks at its readings.
    pins: ({ ghost }) => !ghost,
    medium: ['map verdict', 'map ranks', 'ranges bearings', 'trace nees', 'nis tries'],
    wide: ['map verdict', 'map ranks', 'map trace', 'ranges bearings', 'nees nis'],
    columns: { medium: '1fr 1fr' },
  },
  stages: {
    panels: { trace: 2, nees: 3, nis: 3 },
    hand: { stop: 2, tolerance: 2, forget: 3, ghost: 3, readouts: 3, tools: 3, speed: 3, seed: 3 },
    grow: ['Show the trace', 'Show the whole figure'],
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: sketch,
}
