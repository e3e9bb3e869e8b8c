/** What the figure of tuned noise says: each sentence follows from the numbers of the frame. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').TuneFrame} Frame */

/** A noise level that is given by its decimal logarithm, to two digits. @param {number} log */
export function level(log) {
  const value = 10 ** log
  return value >= 9.95
    ? fixed(value, 0)
    : value >= 0.995
      ? fixed(value, 1)
      : value >= 0.0995
        ? fixed(value, 2)
        : fixed(value, 3)
}

/** The factor between two noise levels, as a number from 1 on. @param {number} logs their difference */
export const factor = (logs) => fixed(10 ** Math.abs(logs), Math.abs(logs) < 1 ? 2 : 0)

/** @param {Frame} frame */
export function verdict(frame) {
  return [nisOf(frame), lagOf(frame), fitOf(frame), truthOf(frame)].filter(Boolean).join(' ')
}

/** The last mean of NIS and its band. @param {Frame} frame */
export function last({ meanNis, meanNisBand }) {
  const { low, high } = meanNisBand[meanNisBand.length - 1]
  return { mean: meanNis[meanNis.length - 1], low, high }
}

/** @param {Frame} frame */
function nisOf(frame) {
  const { mean, low, high } = last(frame)
  const band = `its band from ${fixed(low, 2)} to ${fixed(high, 2)}`
  // Beside the truth nobody needs the signs of it.
  if (frame.verdict)
    return `The mean NIS is ${fixed(mean, 2)}, ${mean > high ? 'above' : mean < low ? 'below' : 'within'} ${band}.`
  if (mean > high)
    return (
      `The mean NIS is ${fixed(mean, 2)}, above ${band}: the innovations are larger than the ` +
      'filter expects, so its noise as a whole is too small.'
    )
  if (mean < low)
    return (
      `The mean NIS is ${fixed(mean, 2)}, below ${band}: the innovations are smaller than the ` +
      'filter expects, so its noise as a whole is too large.'
    )
  return `The mean NIS is ${fixed(mean, 2)}, within ${band}.`
}

/** @param {Frame} frame */
function lagOf({ autocorrelation: [first], autocorrelationBand: band, verdict: truth }) {
  if (truth) return ''
  const beyond = `${fixed(first, 2)}, beyond ±${fixed(band, 2)}`
  if (first > band)
    return (
      `Neighbouring innovations tend to the same side (${beyond}): the filter trusts its motion ` +
      'too much, a sign of too small a *q*/{W}.'
    )
  if (first < -band)
    return (
      `Neighbouring innovations tend to opposite sides (${beyond}): the filter trusts its sensor ` +
      'too much, a sign of too large a *q*/{W}.'
    )
  return `Neighbouring innovations are uncorrelated, within ±${fixed(band, 2)}.`
}

/** @param {Frame} frame */
function fitOf({ fit, verdict: truth }) {
  if (!fit) return ''
  const less = `The log-likelihood is ${fixed(fit.lacking / 2, 1)} below its maximum`
  const inside = fit.lacking <= fit.limit ? 'inside' : 'outside'
  const held = fit.held.some(Boolean) ? ' The likeliest noise lies at the end of a range, and may lie beyond.' : ''
  const sealed = truth ? '' : ' The truth is still sealed.'
  return `${less}, ${inside} the 95 % region, which ends at ${fixed(fit.limit / 2, 1)}.${held}${sealed}`
}

/** @param {Frame} frame */
function truthOf({ params, fit, verdict: truth }) {
  if (!truth || !fit) return ''
  const [q, w] = [params.logQ - truth.logQ, params.logW - truth.logW]
  const off =
    `The true *q* is ${level(truth.logQ)} and the true sensor noise ${level(truth.logW)} m²: ` +
    `yours are off by the factors ${factor(q)} and ${factor(w)}.`
  const tells = fit.sigma
    ? ` By its likelihood this log tells them to factors of ${factor(fit.sigma[0])} and ` +
      `${factor(fit.sigma[1])} (one σ).`
    : ' How well this log tells them cannot be said at the end of a range.'
  const nees = ` The mean NEES of your filter is ${fixed(truth.meanNees, 1)}; 2 is expected.`
  return `${off}${tells}${nees}`
}
