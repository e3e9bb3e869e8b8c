/** The bugs in words, the figures of a run in words, and the state of the museum in a sentence. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').MuseumFrame} Frame */
/** @typedef {import('estimate-wasm').MuseumFigure} Figure */

/**
 * Each bug: its name in a list, and why its panels look as they do.
 * @type {Record<string, { name: string, why: string }>}
 */
export const BUGS = {
  none: { name: 'none', why: '' },
  'unwrapped-innovation': {
    name: 'innovation not wrapped',
    why:
      'Near ±π reading and expectation differ by a whole turn. ' +
      'The gate refuses such readings, so the filter stays consistent and loses a part of its readings.',
  },
  'unwrapped-heading': {
    name: 'heading not wrapped',
    why:
      'After two laps the heading is two turns off, and the innovation takes back one. ' +
      'Every bearing is refused from then on, and the robot drives by odometry alone.',
  },
  'frozen-jacobian': {
    name: 'Jacobians computed once',
    why:
      'The Jacobians stay those of the first pose. The corrections go in wrong directions, ' +
      'and the covariance shrinks as if they were right.',
  },
  'wrong-derivative': {
    name: 'wrong derivative of a bearing',
    why:
      'A bearing changes by −1 with the heading. With −1/ρ² in its place the heading is hardly corrected, ' +
      'and the position takes the blame.',
  },
  transposed: {
    name: 'FᵀPF for FPFᵀ',
    why:
      'The heading’s uncertainty does not reach the position, as it does in the world. ' +
      'The ellipse stays too small wherever no landmark is in reach.',
  },
  degrees: {
    name: 'degrees for radians',
    why:
      'The bearing’s σ, given in degrees, is taken as radians. The filter ignores its bearings: ' +
      'their NIS is almost zero, and successive innovations of a bearing are alike.',
  },
  deviation: {
    name: 'σ for σ²',
    why:
      'The noise of a reading is taken far too large. The filter hardly moves: ' +
      'NIS and NEES are far too small, and an innovation of a bearing resembles the one before.',
  },
  'step-length': {
    name: 'V of another step',
    why:
      'The noise of the motion is sixteen times too large. The filter runs after each reading: ' +
      'NIS and NEES are too small, and successive innovations of a bearing tend to have opposite signs.',
  },
  'short-form': {
    name: 'short form, gain by hand',
    why:
      'The short form holds at the optimal gain alone. At a greater one it takes away more than there is: ' +
      'an eigenvalue falls below zero.',
  },
  asymmetric: {
    name: 'P not made symmetric',
    why:
      'Rounding leaves the covariance and its transpose different in the last digits. ' +
      'In double precision nothing else shows here.',
  },
  twice: {
    name: 'readings used twice',
    why:
      'The second use looks like an independent reading. ' +
      'The covariance shrinks too fast, and each innovation is followed by one that is nearly the same.',
  },
  'open-gate': {
    name: 'a gate that refuses nothing',
    why: 'Every outlier is used. No reading is refused, and NIS and error jump.',
  },
  late: {
    name: 'readings two steps late',
    why:
      'Where the robot was half a metre ago is taken for where it is. ' +
      'The estimate lags, the gate refuses most readings, and the rest fit by chance.',
  },
}

export const NAMES = Object.entries(BUGS).map(([value, { name }]) => ({ value, label: name }))

/**
 * The figures of a run, in the order of the frame: name, unit and decimals.
 * @type {{ name: string, label: import('../../draw/words.js').Words, unit?: string, decimals: number, factor?: number
 * }[]}
 */
export const FIGURES = [
  { name: 'rms', label: 'RMS error', unit: 'm', decimals: 3 },
  { name: 'forward', label: 'mean forward error', unit: 'm', decimals: 3 },
  { name: 'beyond', label: 'errors beyond 2 *σ*', unit: '%', decimals: 1, factor: 100 },
  { name: 'nees', label: 'mean NEES', decimals: 2 },
  { name: 'nis', label: 'mean NIS', decimals: 2 },
  { name: 'nisRange', label: 'NIS of ranges', decimals: 2 },
  { name: 'nisBearing', label: 'NIS of bearings', decimals: 2 },
  { name: 'refused', label: 'readings refused', unit: '%', decimals: 1, factor: 100 },
  { name: 'meanRange', label: 'mean {innov}/√*S*, range', decimals: 2 },
  { name: 'meanBearing', label: 'mean {innov}/√*S*, bearing', decimals: 2 },
  { name: 'lagRange', label: 'lag 1, range', decimals: 2 },
  { name: 'lagBearing', label: 'lag 1, bearing', decimals: 2 },
  { name: 'least', label: 'smallest eigenvalue', decimals: 2 },
  { name: 'asymmetry', label: 'asymmetry of {P}', decimals: 1 },
]

/** A figure's value as shown. @param {number} i @param {number | null} value */
export function shown(i, value) {
  const { unit, decimals, factor = 1 } = FIGURES[i]
  if (value === null) return '–'
  if (i === 13)
    return value === 0
      ? '0'
      : value
          .toExponential(0)
          .replace('e-', ' · 10^−')
          .replace(/\^−(\d+)/, (_, digits) => `⁻${[...digits].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('')}`)
  return `${fixed(value * factor, decimals)}${unit ? ` ${unit}` : ''}`
}

/** Whether a figure lies outside the 95 % band of a right filter. @param {Figure} figure */
export const outside = ({ value, band: [low, high] }) => value === null || value < low || value > high

/** @param {string} bug @param {string} second */
function named(bug, second) {
  const names = [bug, second].filter((one) => one !== 'none').map((one) => `“${BUGS[one].name}”`)
  return names.length > 0 ? names.join(' and ') : 'no bug'
}

/** @param {string} bug @param {string} second */
function reasons(bug, second) {
  return [bug, second]
    .map((one) => BUGS[one].why)
    .filter(Boolean)
    .join(' ')
}

/** The state in a sentence. @param {Frame} frame */
export function verdict(frame) {
  const { params, answer } = frame
  const subject =
    params.lot === 0
      ? `The filter has ${named(params.bug, params.second)}.`
      : answer
        ? `${answer.right ? 'Right' : 'No'}: it was ${named(answer.bug, answer.second)}. ` +
          `${reasons(answer.bug, answer.second)}`
        : `${params.pair ? 'Two bugs are' : 'A bug is'} hidden in the filter.`
  return `${subject} ${judged(frame)}`
}

/** What the figures say. @param {Frame} frame */
function judged({ driven, steps, figures, seeds }) {
  if (driven < steps) return `The run is at step ${driven} of ${steps}; its figures are judged at the end.`
  const out = figures.filter(outside).length
  const run =
    `${out === 0 ? 'All' : `${out} of`} ${figures.length} figures of this run ${out === 1 ? 'lies' : 'lie'} ` +
    `${out === 0 ? 'within' : 'outside'} a right filter’s 95 % bands.`
  if (seeds === 0) return run
  return (
    `${run} Of ${seeds} ${seeds === 1 ? 'seed' : 'seeds'}, ` +
    `${Math.round(100 * share(figures[3]))} % have a mean NEES outside its band.`
  )
}

/** @param {Figure} figure */
export const share = ({ beyond: [below, above] }) => below + above
