/**
 * Close the loop: SLAM around the corridor with a sensor of short reach. What the far end of the map knows of its
 * beginning is in the cross-covariances, and a switch drops them.
 */

import { fixed } from '../../draw/numbers.js'
import { usual } from '../../figure/defaults.js'
import { drawHeat } from './correlation.js'
import { drawErrors, drawNees } from './history.js'
import { drawMap } from './map.js'
import { drawThresholds } from './thresholds.js'
import { verdict } from './words.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */

// State: the start of the first lap, with the chapter's thresholds.

const start = { params: {}, step: 0 }

/** Steps of a lap. */
const LAP = 128

// Model: the lab `LoopClosure`. What follows only reads its frame.

/** @param {Frame} frame */
function describe({ step, map, gates, sightings, correlation, params, series, error, P, nees, neesBand }) {
  const others = correlation.slice(1).flatMap((row, i) => row.slice(1, i + 1))
  const strong = others.filter((value) => Math.abs(value) > 0.5).length
  const last = (/** @type {number[]} */ values) => fixed(values[values.length - 1], 2)
  return {
    map:
      `Map of the corridor at step ${step}: the map has ${map.landmarks.length} landmarks, ` +
      `${map.spurious} of them ghosts; this step has ${sightings.length} sightings and ${gates.length} gates.`,
    heat:
      `Correlations of the errors of the robot and ${map.landmarks.length} landmarks: ` +
      `of ${others.length} pairs of landmarks ${strong} are above one half in size.`,
    thresholds:
      `Axis of χ² with the gate at ${fixed(params.gate, 2)} and the threshold for founding at ` +
      `${fixed(params.found, 2)}: ${map.matched} sightings matched, ${map.rejected} not used, ` +
      `${map.founded} founded a landmark.`,
    nees:
      `NEES of the pose over the steps: ${nees === null ? 'none at this step' : `now ${fixed(nees, 1)}`}; ` +
      `95 % of single values lie between ${fixed(neesBand[0], 2)} and ${fixed(neesBand[1], 2)}.`,
    errors:
      `Error of the position over the steps: now ${fixed(Math.hypot(error[0], error[1]), 2)} metres, ` +
      `where one σ is ${fixed(Math.sqrt((P[0][0] + P[1][1]) / 2), 2)}; ` +
      `the landmarks’ mean σ is ${last(series.mapSigma)}.`,
  }
}

/** @param {Frame} frame @param {Frame} before */
function announce(frame, before) {
  return `${frame.step === before.step ? '' : `Step ${frame.step}: `}${verdict(frame)}`
}

// View: five panels, in the folder's files, and the numbers beside them.

const percent = (/** @type {number} */ share) => `${fixed(100 * share, share > 0.0995 ? 0 : 1)} %`

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ step, nees, meanNees, error, series, map, thresholds, closure }) {
  const last = (/** @type {number[]} */ values) => values[values.length - 1]
  return [
    { key: 'mean-nees', label: 'Mean NEES', value: fixed(meanNees, 1), kin: 'truth', headline: true },
    { key: 'error', label: 'Error', value: fixed(Math.hypot(error[0], error[1]), 2), unit: 'm', kin: 'truth' },
    { key: 'sigma', label: 'Claimed *σ*', value: fixed(last(series.sigma), 3), unit: 'm', kin: 'posterior' },
    {
      key: 'map-sigma',
      label: 'Mean *σ* of the map',
      value: fixed(last(series.mapSigma), 3),
      unit: 'm',
      kin: 'posterior',
    },
    { key: 'landmarks', label: 'Landmarks', value: String(map.landmarks.length), kin: 'posterior' },
    { key: 'ghosts', label: 'Ghosts', value: String(map.spurious), kin: 'truth' },
    { key: 'wrong', label: 'Wrong matches', value: String(map.wrong), kin: 'truth' },
    { key: 'nees', label: 'NEES now', value: fixed(nees, 1), kin: 'truth', more: true },
    { key: 'matched', label: 'Sightings matched', value: `${map.matched} of ${map.sightings}`, more: true },
    { key: 'passes', label: 'Right sightings that pass the gate', value: percent(thresholds.passes), more: true },
    { key: 'strays', label: 'Right sightings that would found a ghost', value: percent(thresholds.ghosts), more: true },
    { key: 'worst', label: 'Worst landmark', value: fixed(map.worst?.error, 2), unit: 'm', kin: 'truth', more: true },
    { key: 'closed', label: 'Loop closed at step', value: closure ? String(closure.step) : '–', more: true },
    { key: 'step', label: 'Step', value: String(step), more: true },
  ]
}

// Controls.

// The two thresholds are handles on their axis.
/** @type {import('../../figure/controls.js').Control[]} */
const controls = [{ kind: 'toggle', name: 'correlated', label: 'keep the cross-covariances' }]

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  {
    name: 'before',
    label: 'Stop just before the loop closes',
    change: (_, lab) => ({ ...usual(lab, 'gate', 'found', 'correlated'), step: 112 }),
  },
  {
    name: 'close',
    label: 'Close it',
    change: (_, lab) => ({ ...usual(lab, 'gate', 'found', 'correlated'), step: 113 }),
  },
  {
    name: 'apart',
    label: 'Drop the cross-covariances',
    change: (_, lab) => ({ ...usual(lab, 'gate', 'found'), correlated: false, step: LAP }),
  },
  {
    name: 'crossed',
    label: 'Let the thresholds cross',
    change: () => ({ gate: 12, found: 8, correlated: true, step: LAP }),
  },
  { name: 'again', label: 'As at first', change: (_, lab) => ({ ...usual(lab), step: LAP }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  still: LAP,
  invite: 'Drive a lap',
  lap: LAP,
  pace: 10,
  seeded: true,
  panels: [
    { name: 'map', width: 560, height: 400, draw: drawMap },
    { name: 'heat', width: 340, height: 380, draw: drawHeat },
    { name: 'thresholds', width: 460, height: 215, handles: true, draw: drawThresholds },
    { name: 'nees', width: 460, height: 215, draw: drawNees },
    { name: 'errors', width: 460, height: 215, draw: drawErrors },
  ],
  layout: {
    // The matrix stands right below the words that change it.
    narrow: ['map', 'thresholds', 'controls', 'tries', 'heat', 'verdict', 'readouts', 'nees', 'errors'],
    along: 'thresholds',
    medium: [
      'map map map map heat heat',
      'verdict verdict verdict verdict heat heat',
      'thresholds thresholds thresholds nees nees nees',
      'errors errors errors tries tries tries',
    ],
    wide: [
      'map map map map heat heat',
      'verdict verdict verdict verdict heat heat',
      'thresholds thresholds nees nees errors errors',
    ],
    columns: { medium: Array(6).fill('1fr').join(' ') },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series: ({ series: { step, nees, error, sigma, mapSigma } }) => ({ step, nees, error, sigma, mapSigma }),
}
