/**
 * Tune the filter on one log: its innovations, the log's likelihood over all noise levels, and the truth, which stays
 * sealed until the reader commits.
 */

import { fixed } from '../../draw/numbers.js'
import { drawCorrelation, drawInnovations, drawNees, drawNis } from './history.js'
import { likelihood } from './likelihood.js'
import { drawMap } from './map.js'
import { last, level, verdict } from './words.js'

/** @typedef {import('estimate-wasm').TuneFrame} Frame */

// State: the chapter's V and 1 m² on a log of 200 readings. It has no steps.

const start = { params: {}, step: 0 }

// Model: the lab `Tune`. What follows only reads its frame.

/** @param {Frame} frame */
function describe(frame) {
  const { params, beyond, autocorrelation, autocorrelationBand, innovations, fit, verdict: truth } = frame
  const { mean, low, high } = last(frame)
  const place = (/** @type {{ logQ: number, logW: number }} */ { logQ, logW }) =>
    `q ${level(logQ)} and sensor noise ${level(logW)} m²`
  const outside = autocorrelation.filter((value) => Math.abs(value) > autocorrelationBand).length
  return {
    map:
      `Map of the log-likelihood over q and the sensor noise: yours are ${place(params)}` +
      `${fit ? `, the likeliest are ${place(fit)}` : ''}${truth ? `, the true ones are ${place(truth)}` : ''}.`,
    innovations:
      `Innovations of ${innovations.length} readings: ${percent(beyond)} lie beyond ±2√S, where ` +
      '4.6 % are expected.',
    correlation:
      `Autocorrelation of the innovations at ${autocorrelation.length} lags: ${outside} outside ` +
      `the band of ±${fixed(autocorrelationBand, 3)}.`,
    nis:
      `NIS and its running mean, which ends at ${fixed(mean, 2)}; its band there is from ` +
      `${fixed(low, 2)} to ${fixed(high, 2)}.`,
    nees: truth
      ? `NEES of the two states: its mean is ${fixed(truth.meanNees, 1)}; 2 is expected.`
      : 'NEES of the two states, sealed until you commit.',
  }
}

const percent = (/** @type {number} */ share) => `${fixed(100 * share, 1)} %`

// View: five panels, in the folder's files, and the numbers beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { logLikelihood, params, beyond, autocorrelation, fit, verdict: truth } = frame
  /**
   * A level with the factor of its standard deviation.
   * @param {number | undefined} log
   * @param {number | undefined} sigma
   */
  const known = (log, sigma) =>
    log === undefined ? '–' : `${level(log)}${sigma === undefined ? '' : ` ×÷ ${fixed(10 ** sigma, 2)}`}`
  return [
    { key: 'likelihood', label: 'Log-likelihood', value: fixed(logLikelihood, 1), headline: true },
    { key: 'lacking', label: 'below its maximum', value: fixed(fit && fit.lacking / 2, 1) },
    { key: 'nis', label: 'Mean NIS', value: fixed(last(frame).mean, 2), kin: 'measurement' },
    { key: 'beyond', label: 'Beyond ±2√*S*', value: percent(beyond), kin: 'measurement' },
    { key: 'lag1', label: 'Lag 1', value: fixed(autocorrelation[0], 2), kin: 'measurement' },
    { key: 'fit-q', label: 'Likeliest *q*', value: known(fit?.logQ, fit?.sigma?.[0]), kin: 'posterior' },
    {
      key: 'fit-w',
      label: 'Likeliest {W}',
      value: known(fit?.logW, fit?.sigma?.[1]),
      unit: fit ? 'm²' : undefined,
      kin: 'posterior',
    },
    { key: 'true-q', label: 'True *q*', value: truth ? level(truth.logQ) : 'sealed', kin: 'truth' },
    { key: 'true-w', label: 'True {W}', value: truth ? `${level(truth.logW)} m²` : 'sealed', kin: 'truth' },
    { key: 'nees', label: 'Mean NEES', value: truth ? fixed(truth.meanNees, 1) : 'sealed', kin: 'truth' },
    {
      key: 'truth-lacks',
      label: 'The truth below the maximum',
      value: fixed(truth && truth.lacking / 2, 1),
      kin: 'truth',
      more: true,
    },
    { key: 'q', label: '*q*', value: level(params.logQ), more: true },
    { key: 'w', label: '{W}', value: level(params.logW), unit: 'm²', more: true },
  ]
}

// Controls.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  { kind: 'range', name: 'logQ', label: '*q*, with {V} = *q*{V}_0', words: level },
  { kind: 'range', name: 'logW', label: '{W} of the filter', words: (value) => `${level(value)} m²` },
  // Who has committed sees the likeliest beside the truth.
  {
    kind: 'toggle',
    name: 'fit',
    label: 'show the likeliest',
    get: ({ fit, committed }) => fit || committed,
    enabled: ({ committed }) => !committed,
  },
  { kind: 'toggle', name: 'committed', label: 'commit: open the truth' },
  { kind: 'range', name: 'length', label: 'Readings of the log', words: (value) => String(value) },
  { kind: 'whole', name: 'seed', label: 'Log number', set: (seed) => ({ seed, ...sealed }) },
]

const sealed = { fit: false, committed: false }
const STEP = 0.02

/** The likeliest noise, as near as the sliders can be set. @param {Frame} _ @param {any} lab */
function likeliest(_, lab) {
  const state = lab.state()
  const other = lab.constructor.from({ ...state, params: { ...state.params, fit: true } })
  const { logQ, logW } = other.frame().fit
  other.free()
  const near = (/** @type {number} */ value) => Number((Math.round(value / STEP) * STEP).toFixed(2))
  return { fit: true, logQ: near(logQ), logW: near(logW) }
}

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'motion', label: 'Trust the motion', change: () => ({ logQ: -1.5, logW: 0.5 }) },
  { name: 'sensor', label: 'Trust the sensor', change: () => ({ logQ: 0.5, logW: -1.5 }) },
  { name: 'fit', label: 'Fit the noise', change: likeliest },
  {
    name: 'next',
    label: 'Another log',
    change: ({ params }) => ({ seed: (params.seed + 1) % 2 ** 32, logQ: 0, logW: 0, ...sealed }),
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  aside: likelihood,
  start,
  seeded: false,
  timeless: true,
  slow: true,
  panels: [
    { name: 'map', width: 460, height: 470, handles: true, aside: true, draw: drawMap },
    { name: 'innovations', width: 460, height: 220, draw: drawInnovations },
    { name: 'correlation', width: 460, height: 220, draw: drawCorrelation },
    { name: 'nis', width: 460, height: 220, draw: drawNis },
    { name: 'nees', width: 460, height: 220, draw: drawNees },
  ],
  layout: {
    // The sentence is longer or shorter with what is shown: it goes along below what a finger is on.
    along: 'tries',
    narrow: ['map', 'tries', 'controls', 'verdict', 'innovations', 'correlation', 'readouts', 'nis', 'nees'],
    medium: [
      'map map map map innovations innovations innovations',
      'map map map map correlation correlation correlation',
      'map map map map nis nis nis',
      'verdict verdict verdict verdict nees nees nees',
    ],
    wide: ['map innovations', 'map correlation', 'verdict verdict', 'nis nees'],
    columns: { medium: Array(7).fill('1fr').join(' '), wide: '1fr 1fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: verdict,
  series: ({ innovations, twoSigma, nis, meanNis, verdict: truth }) => ({
    innovation: innovations,
    twoSigma,
    nis,
    meanNis,
    ...(truth ? { nees: truth.nees } : {}),
  }),
}
