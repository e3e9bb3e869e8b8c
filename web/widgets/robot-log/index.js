/**
 * A robot that really drove: its log, filtered with the noise, the gate and the calibration that the reader chooses.
 * The ranges read seven per cent long; the reader finds that out.
 */

import { fixed, metres } from '../../draw/numbers.js'
import { controls, mapped } from './controls.js'
import { describe } from './describe.js'
import { drawBearings, drawErrors, drawInnovations, drawNis } from './history.js'
import { drawMap } from './map.js'
import { series } from './series.js'
import { drawCorrelation, drawHistogram, drawInner, drawRanges } from './statistics.js'
import { clock, percent, verdict } from './words.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */

// State: the whole drive, by odometry alone.

const start = { params: { sightings: false }, step: 13_186 }

// Model: the lab `RobotLog` in the module, which a worker runs. What follows only reads its frame.

/** @param {string} id @param {string | undefined} given @param {import('../../figure/spec.js').FigureSpec} spec */
async function open(id, given, spec) {
  const [{ openRun }, { default: log }] = await Promise.all([
    import('./open.js'),
    import('../../../content/logs/plaza1.csv'),
  ])
  return openRun(log, spec, id, given)
}

/** @param {Frame} frame @param {Frame} before */
function announce(frame, before) {
  return `${frame.step === before.step ? '' : `After ${clock(frame.time)} of the log: `}${verdict(frame)}`
}

// View: nine panels, in the folder's files, and what is said beside them.

/** Whether it is known where the robot really was. @param {Frame} frame */
const known = ({ hasTruth }) => hasTruth

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { summary, rangeLine, reckonedRmse } = frame
  const { used, refused } = summary
  const shown = known(frame)
  const share = used + refused === 0 ? '–' : percent(refused / (used + refused))
  return [
    { key: 'rmse', label: 'RMS error', value: metres(summary.rmse), unit: 'm', kin: 'truth', headline: true, shown },
    { key: 'reckoned', label: 'of dead reckoning', value: metres(reckonedRmse), unit: 'm', kin: 'prediction', shown },
    { key: 'refused', label: 'Readings refused', value: share },
    { key: 'nis', label: 'NIS for each output', value: fixed(summary.nis, 2), kin: 'measurement' },
    { key: 'mean', label: 'Mean of {innov}/√*S*', value: fixed(summary.meanInnovation, 2), kin: 'measurement' },
    { key: 'lag1', label: 'Lag 1', value: fixed(summary.lag1, 2), kin: 'measurement' },
    {
      key: 'epsilon',
      label: 'Learned *ε*',
      value:
        summary.epsilon === null
          ? '–'
          : `${fixed(100 * summary.epsilon, 2)} ± ${fixed(100 * (summary.epsilonSigma ?? NaN), 2)} %`,
      kin: 'posterior',
    },
    { key: 'worst', label: 'Worst error', value: metres(summary.worst), unit: 'm', kin: 'truth', more: true, shown },
    { key: 'used', label: 'Readings used', value: String(used), more: true },
    {
      key: 'slope',
      label: 'Slope of the range’s error',
      value: fixed(rangeLine?.slope, 3),
      kin: 'measurement',
      more: true,
    },
    {
      key: 'offset',
      label: 'Its value at 0',
      value: fixed(rangeLine?.offset, 2),
      unit: 'm',
      kin: 'measurement',
      more: true,
    },
    { key: 'r2', label: 'Its *R*^{2}', value: fixed(rangeLine?.r2, 2), kin: 'measurement', more: true },
    { key: 'time', label: 'Time', value: clock(frame.time), more: true },
    {
      key: 'step',
      label: 'Rows replayed, without the truth and the landmarks',
      value: frame.step.toLocaleString('en'),
      more: true,
    },
  ]
}

// Controls.

// What the lab has at first, of all that stands in the figure: a phrase leads to the text's numbers from any state.
const noise = { sigmaRange: 0.6, sigmaDistance: 0.05, sigmaTurn: 0.02 }
const usual = { sightings: true, gate: null, scale: 0, offset: 0, learn: false, ...noise }

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'raw', label: 'Switch the ranges on', change: () => usual },
  { name: 'gate', label: 'Gate them', change: () => ({ ...usual, gate: 0.999 }) },
  { name: 'offset', label: 'Take an offset off', change: () => ({ ...usual, offset: 2.4 }) },
  {
    name: 'scale',
    label: 'Scale them',
    change: ({ rangeLine }) => ({ ...usual, scale: Number((rangeLine?.slope ?? 0).toFixed(3)) }),
  },
  { name: 'learn', label: 'Let the filter learn the scale', change: () => ({ ...usual, learn: true }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  log: 'content/logs/plaza1.csv',
  start,
  open,
  seeded: false,
  slow: true,
  pace: 220,
  stride: 100,
  panels: [
    { name: 'map', width: 580, height: 500, handles: true, draw: drawMap },
    { name: 'innovations', width: 360, height: 235, draw: drawInnovations },
    { name: 'errors', width: 360, height: 235, shown: known, draw: drawErrors },
    { name: 'ranges', width: 312, height: 220, shown: mapped, draw: drawRanges },
    { name: 'inner', width: 312, height: 220, shown: mapped, draw: drawInner },
    { name: 'histogram', width: 312, height: 220, draw: drawHistogram },
    { name: 'correlation', width: 470, height: 200, draw: drawCorrelation },
    { name: 'nis', width: 470, height: 200, draw: drawNis },
    // On the page log/ alone, whose style sheet says where it stands: the mower has no bearings.
    { name: 'bearings', width: 470, height: 200, shown: ({ bearings }) => bearings, draw: drawBearings },
  ],
  layout: {
    // What the hand moves stands right below the innovations, which tell what came of it and stay in sight, as does the
    // sentence; what explains them is further down.
    narrow: [
      'map',
      'tries',
      'innovations',
      'controls',
      'verdict',
      'readouts',
      'ranges',
      'inner',
      'histogram',
      'correlation',
      'nis',
      'errors',
    ],
    pin: 'innovations',
    along: 'innovations',
    medium: [
      'map map map map map map map innovations innovations innovations innovations innovations',
      'map map map map map map map errors errors errors errors errors',
      'verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict',
      'tries tries tries tries tries tries tries tries tries tries tries tries',
      'controls controls controls controls controls controls controls controls controls controls controls controls',
      'ranges ranges ranges ranges ranges ranges inner inner inner inner inner inner',
      'correlation correlation correlation correlation correlation correlation nis nis nis nis nis nis',
      'readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts',
      'histogram histogram histogram histogram histogram histogram . . . . . .',
    ],
    wide: [
      'map map map map map map map innovations innovations innovations innovations innovations',
      'map map map map map map map errors errors errors errors errors',
      'verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict',
      'tries tries tries tries tries tries tries tries tries tries tries tries',
      'controls controls controls controls controls controls controls controls controls controls controls controls',
      'readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts readouts',
      'ranges ranges ranges ranges inner inner inner inner histogram histogram histogram histogram',
      'correlation correlation correlation correlation correlation correlation nis nis nis nis nis nis',
    ],
    columns: { medium: Array(12).fill('1fr').join(' ') },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series,
}
