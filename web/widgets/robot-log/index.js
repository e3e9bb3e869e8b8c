/**
 * A robot that really drove: its log, filtered with the noise, the gate and the calibration that the reader chooses.
 * The ranges read seven per cent long; the reader finds that out.
 */

import { fixed } from '../../draw/numbers.js'
import { drawErrors, drawInnovations, drawNis } from './history.js'
import { drawMap } from './map.js'
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

/** @param {Frame} frame */
function describe(frame) {
  const { summary, correlation, histogram, innovations, rangeLine, innovationLine, landmarks, nis, truth } = frame
  const known = truth ? 'true' : 'dead-reckoned'
  const error =
    summary.rmse === null
      ? 'how far off the estimate is nobody knows'
      : `the RMS error of the position so far is ${fixed(summary.rmse, 2)} metres, that of dead ` +
        `reckoning ${fixed(frame.reckonedRmse, 2)} metres`
  const none = 'no reading has been used'
  const outside = (/** @type {number[]} */ values, /** @type {number} */ band) =>
    values.filter((value) => Math.abs(value) > band).length
  const { time, normalized, used } = innovations
  const drawn =
    `${outside(normalized, 2)} of the ${time.length} drawn lie outside ±2 σ, ` +
    `${used.filter((one) => !one).length} were refused`
  const line = (/** @type {{ slope: number, offset: number, r2: number }} */ { slope, offset, r2 }) =>
    `a line of slope ${fixed(slope, 3)} and offset ${fixed(offset, 2)} metres explains ${percent(r2)} of it`
  const inner = (/** @type {{ slope: number, r2: number }} */ { slope, r2 }) =>
    `slope ${fixed(slope, 3)}, which explains ${percent(r2)}`
  const { values, band } = correlation
  const beyond = nis.mean.filter((mean, i) => mean < nis.low[i] || mean > nis.high[i]).length
  return {
    map:
      `Map of the drive after ${clock(frame.time)} of ${clock(frame.duration)}: ${landmarks.length} ` +
      `${landmarks.length === 1 ? 'landmark' : 'landmarks'}, ${truth ? 'the true track, ' : ''}the ` +
      `dead-reckoned track and the estimate; ${error}.`,
    innovations: `Normalized innovations over time: ${time.length === 0 ? none : drawn}.`,
    errors: `Error of the position over time: ${errorNow(frame.errors)}.`,
    ranges: !mapped(frame)
      ? ''
      : `Read less ${known} range, against the ${known} range: ` + `${rangeLine ? line(rangeLine) : 'no line yet'}.`,
    inner: !mapped(frame)
      ? ''
      : 'The filter’s own innovations against the range it expected: ' +
        `${innovationLine ? inner(innovationLine) : none}.`,
    histogram:
      'Histogram of the normalized innovations beside the standard normal density: ' +
      `${summary.meanInnovation === null ? none : spread(summary.meanInnovation, histogram.beyond)}.`,
    correlation:
      `Autocorrelation of the innovations at ${values.length} lags: ` +
      `${values.length === 0 ? none : `${outside(values, band)} outside the band of ±${fixed(band, 3)}`}.`,
    nis:
      `Normalized innovations squared, averaged over blocks of ${nis.block} readings: ` +
      `${nis.mean.length === 0 ? 'no block is full yet' : `${beyond} of ${nis.mean.length} outside the band`}.`,
  }
}

/** @param {Frame['errors']} errors */
function errorNow({ time, error, bound }) {
  if (time.length === 0) return 'nothing is driven yet'
  if (error.length === 0) return 'there is no truth, so only the claimed 2 σ is drawn'
  const last = (/** @type {number[]} */ values) => fixed(values[values.length - 1], 2)
  return `now ${last(error)} metres against a claimed 2 σ of ${last(bound)}`
}

/** @param {number} mean @param {number} beyond */
function spread(mean, beyond) {
  return `their mean is ${fixed(mean, 2)}, and ${percent(beyond)} lie beyond five σ`
}

/** @param {Frame} frame @param {Frame} before */
function announce(frame, before) {
  return `${frame.step === before.step ? '' : `After ${clock(frame.time)}: `}${verdict(frame)}`
}

// View: eight panels, in the folder's files, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { summary, rangeLine, reckonedRmse } = frame
  const { used, refused } = summary
  const share = used + refused === 0 ? '–' : percent(refused / (used + refused))
  return [
    { key: 'rmse', label: 'RMS error', value: fixed(summary.rmse, 2), unit: 'm', kin: 'truth', headline: true },
    { key: 'reckoned', label: 'of dead reckoning', value: fixed(reckonedRmse, 2), unit: 'm', kin: 'prediction' },
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
    { key: 'worst', label: 'Worst error', value: fixed(summary.worst, 2), unit: 'm', kin: 'truth', more: true },
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

/**
 * A slider over powers of ten: its numbers are the logarithms.
 * @param {string} name
 * @param {import('../../draw/words.js').Words} label
 * @param {[number, number]} ends
 * @param {string} unit
 * @param {number} decimals
 */
function logarithmic(name, label, ends, unit, decimals) {
  const [least] = ends.map((end) => 10 ** end)
  return {
    kind: /** @type {const} */ ('range'),
    name,
    label,
    ends,
    step: 0.02,
    scale: (/** @type {number} */ value) => Math.log10(Math.max(value, least)),
    set: (/** @type {number} */ value) => ({ [name]: Number((10 ** value).toPrecision(3)) }),
    words: (/** @type {number} */ _, /** @type {Frame} */ frame) =>
      `${fixed(frame.params[/** @type {'sigmaRange'} */ (name)], decimals)} ${unit}`,
  }
}

const GATES = [null, 0.95, 0.99, 0.999]

/** Whether there may be ranges. @param {Frame} frame */
const mapped = ({ landmarks }) => landmarks.length > 0
/** Whether ranges are the readings of the log. @param {Frame} frame */
const ranged = ({ landmarks, summary: { sensors } }) => landmarks.length > 0 || !(sensors.fix || sensors.heading)

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  { kind: 'toggle', name: 'sightings', label: 'ranges correct the estimate', shown: ranged },
  { kind: 'toggle', name: 'learn', label: 'learn the scale *ε*', shown: ranged },
  {
    kind: 'choice',
    name: 'gate',
    label: 'Gate',
    options: GATES.map((value) => ({ value, label: value === null ? 'off' : `${fixed(100 * value, 1)} %` })),
  },
  {
    kind: 'range',
    name: 'scale',
    label: 'Scale *ε* of the ranges',
    ends: [-0.2, 0.2],
    step: 0.001,
    words: (value) => `${fixed(100 * value, 1)} %`,
    enabled: ({ learn }) => !learn,
    shown: ranged,
  },
  {
    kind: 'range',
    name: 'offset',
    label: 'Offset of the ranges',
    ends: [-5, 5],
    step: 0.1,
    words: (value) => `${fixed(value, 1)} m`,
    shown: ranged,
  },
  { ...logarithmic('sigmaRange', '*σ*_ρ, of a range', [-1, 1], 'm', 2), shown: ranged },
  {
    ...logarithmic('sigmaBearing', '*σ*_β, of a bearing', [-3, 0], 'rad', 3),
    shown: (/** @type {Frame} */ frame) => frame.bearings,
  },
  logarithmic('sigmaDistance', '*σ*_d, of the distance', [-3, 0], 'm/√s', 3),
  logarithmic('sigmaTurn', '*σ*_θ, of the turn', [-3, 0], 'rad/√s', 3),
]

const usual = { sightings: true, gate: null, scale: 0, offset: 0, learn: false }

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
  pace: 220,
  stride: 100,
  panels: [
    { name: 'map', width: 580, height: 500, handles: true, draw: drawMap },
    { name: 'innovations', width: 360, height: 235, draw: drawInnovations },
    { name: 'errors', width: 360, height: 235, draw: drawErrors },
    { name: 'ranges', width: 312, height: 220, shown: mapped, draw: drawRanges },
    { name: 'inner', width: 312, height: 220, shown: mapped, draw: drawInner },
    { name: 'histogram', width: 312, height: 220, draw: drawHistogram },
    { name: 'correlation', width: 470, height: 200, draw: drawCorrelation },
    { name: 'nis', width: 470, height: 200, draw: drawNis },
  ],
  layout: {
    narrow: [
      'map',
      'verdict',
      'tries',
      'controls',
      'innovations',
      'readouts',
      'ranges',
      'inner',
      'histogram',
      'correlation',
      'nis',
      'errors',
    ],
    medium: [
      'map map map map map map map innovations innovations innovations innovations innovations',
      'map map map map map map map errors errors errors errors errors',
      'verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict',
      'ranges ranges ranges ranges ranges ranges inner inner inner inner inner inner',
      'correlation correlation correlation correlation correlation correlation nis nis nis nis nis nis',
      'histogram histogram histogram histogram histogram histogram tries tries tries tries tries tries',
    ],
    wide: [
      'map map map map map map map innovations innovations innovations innovations innovations',
      'map map map map map map map errors errors errors errors errors',
      'verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict verdict',
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
  series: ({ innovations, ranges }) => ({
    time: ranges.time,
    range: ranges.range,
    residual: ranges.residual,
    ...(innovations.time.length > 0
      ? {
          expected: innovations.expected,
          innovation: innovations.innovation,
          normalized: innovations.normalized,
          used: innovations.used.map(Number),
        }
      : {}),
  }),
}
