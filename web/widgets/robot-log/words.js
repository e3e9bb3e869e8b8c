/** What the figure of a log says: each sentence follows from the numbers of the frame. */

import { fixed, metres } from '../../draw/numbers.js'
import { mayBeCourse, named } from './named.js'
import { unsettledWords } from './unsettled.js'
import { ranked } from './verdict.js'

/**
 * @typedef {import('estimate-wasm').LogFrame & {
 *   judgement?: import('estimate-wasm').LogJudgement, judging?: boolean, log?: import('./looks.js').Log | null,
 *   known?: import('estimate-wasm').Parameter[],
 * }} Frame with the verdict on the log, once it has come, whether it is being looked for, and what can be set
 */

/** A mean this far from 0, in σ, is called a bias: a radio off by a fifth of its own noise. */
export const BIAS = 0.2
/** Two RMS errors nearer than this, as a ratio, are called alike. */
export const ALIKE = 0.05

/** @param {number} share */
export function percent(share) {
  const value = 100 * share
  if (value > 0 && value < 0.095) return `${fixed(value, 2)} %`
  return `${fixed(value, value < 9.95 && value !== 0 ? 1 : 0)} %`
}

/** Seconds as minutes and seconds. @param {number} seconds */
export function clock(seconds) {
  const whole = Math.floor(seconds)
  return `${Math.floor(whole / 60)}\u00a0min ${whole % 60}\u00a0s`
}

/** Whether a sensor that the log has corrects the estimate. @param {Frame} frame */
export function listens({ params, summary: { sensors } }) {
  const { fix, heading, range, bearing } = sensors
  const ranges = range || bearing || !(fix || heading)
  return Boolean((params.sightings && ranges) || (params.fixes && fix) || (params.headings && heading))
}

/** Whether the log has any reading that could correct the estimate. @param {Frame} frame */
const readable = ({ summary: { sensors } }) =>
  Boolean(sensors.fix || sensors.heading || sensors.range || sensors.bearing)

/** What a reading of the log is called. @param {Frame} frame */
function noun({ summary: { sensors } }) {
  return sensors.fix || sensors.heading ? 'reading' : 'range'
}

/** Why a panel of readings has none to show. @param {Frame} frame */
export function unread(frame) {
  const { used, refused } = frame.summary
  if (!readable(frame)) return 'the log has no reading'
  if (!listens(frame)) return `switch the ${noun(frame)}s on`
  if (used + refused === 0) return 'no reading so far'
  return used === 0 ? 'every reading is refused' : 'too few readings so far'
}

/**
 * What a panel that waits for the first reading will be judged by; one panel alone says what to do.
 * @param {Frame} frame
 * @param {string} expected
 */
export const expecting = (frame, expected) => (listens(frame) ? unread(frame) : expected)

const COURSE =
  ' The headings are courses of the antenna: where it stands off the point about which the robot turns, that looks ' +
  'the same. Without them the positions tell which it is.'

/** @param {Frame} frame */
export function verdict(frame) {
  const { step, summary } = frame
  if (step === 0) return 'Before the first row of the log.'
  const { used, refused } = summary
  if (!readable(frame))
    return `Dead reckoning: the log has no reading that could correct the estimate.${errorOf(frame, false)}`
  if (!listens(frame)) return `Dead reckoning: odometry alone, no ${noun(frame)} is used.${errorOf(frame, false)}`
  if (used + refused === 0) return `No ${noun(frame)} has been read yet.${errorOf(frame, false)}`
  if (used === 0)
    return `The gate has refused every ${noun(frame)} so far: this is dead reckoning.${errorOf(frame, false)}`
  const { judgement, judging, rows, truth, params, known = [] } = frame
  const told = judgement
    ? [
        ` ${ranked(judgement, { rows, truth: Boolean(truth), log: frame.log })}`,
        unsettledWords(judgement, params, known),
        mayBeCourse(named(judgement, frame.log), params, frame.log ?? null) ? COURSE : '',
      ]
    : judging
      ? [' Still looking for what may be wrong …']
      : [meanOf(frame), nisOf(frame), lagOf(frame)]
  return [errorOf(frame, true), gateOf(frame), learnedOf(frame), ...told].join('').trim()
}

/** @param {Frame} frame @param {boolean} compared */
function errorOf({ summary, reckonedRmse }, compared) {
  if (summary.rmse === null) return compared ? '' : ' There is no truth to hold it against.'
  const rmse = ` The RMS error of the position is ${metres(summary.rmse)} m`
  if (!compared || reckonedRmse === null) return `${rmse}.`
  const ratio = summary.rmse / reckonedRmse
  const than = `${metres(reckonedRmse)} m of dead reckoning`
  if (!(Math.abs(ratio - 1) > ALIKE)) return `${rmse}, about the ${than}.`
  return `${rmse}, ${ratio > 1 ? 'worse' : 'better'} than the ${than}.`
}

/** @param {Frame} frame */
function gateOf({ params, summary: { used, refused } }) {
  if (params.gate === null) return ''
  // Gates that each sensor has of its own expect no one share.
  if (typeof params.gate !== 'number')
    return refused === 0 ? '' : ` The gates have refused ${percent(refused / (used + refused))} of the readings.`
  const [share, expected] = [refused / (used + refused), 1 - params.gate]
  // Five times as many as expected, and more than chance explains where few are expected.
  const many = share > 5 * expected && refused > 5 * expected * (used + refused) + 5
  return (
    ` The gate has refused ${percent(share)} of the readings, where ${percent(expected)} is ` +
    `expected${many ? ': there are outliers, or it hides a fault of the model' : ''}.`
  )
}

/** @param {Frame} frame */
function learnedOf({ summary: { epsilon, epsilonSigma } }) {
  if (epsilon === null) return ''
  return ` The learned scale is ${fixed(100 * epsilon, 2)} ± ${fixed(100 * (epsilonSigma ?? NaN), 2)} %.`
}

/** @param {Frame} frame */
function meanOf({ summary: { meanInnovation: mean }, bands }) {
  if (mean === null || !bands || Math.abs(mean) < BIAS || Math.abs(mean) <= bands.mean) return ''
  return ` The innovations’ mean is ${fixed(mean, 1)} of their σ: a bias, not noise.`
}

/** @param {Frame} frame */
function nisOf({ summary: { nis }, bands }) {
  if (nis === null || !bands) return ''
  const [low, high] = bands.nis
  const band = `its band from ${fixed(low, 2)} to ${fixed(high, 2)}`
  if (nis > high) return ` NIS is ${fixed(nis, 2)}, above ${band}: the filter claims more than its readings bear out.`
  if (nis < low) return ` NIS is ${fixed(nis, 2)}, below ${band}: the readings are better than claimed.`
  return ` NIS is ${fixed(nis, 2)}, within ${band}.`
}

/** @param {Frame} frame */
function lagOf({ summary: { lag1 }, correlation }) {
  if (lag1 === null || Math.abs(lag1) <= correlation.band) return ''
  const most = correlation.values.reduce((far, value, i, all) => (Math.abs(value) > Math.abs(all[far]) ? i : far), 0)
  const further = most === 0 ? '' : `; those ${most + 1} apart more so (${fixed(correlation.values[most], 2)})`
  return ` Neighbouring innovations are correlated (${fixed(lag1, 2)})${further}.`
}
