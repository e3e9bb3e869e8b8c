/** What the figure of the car says: each sentence follows from the numbers of the frame. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').CarFrame} Frame */

const percent = (/** @type {number} */ part, decimals = 1) => `${fixed(100 * part, decimals)} %`

/** @param {Frame} frame */
export function verdict(frame) {
  return [ofTheFixes(frame), ofTheLearned(frame), ofTheTunnel(frame)].filter(Boolean).join(' ')
}

/** @param {Frame} frame */
function ofTheFixes({ reckonedOff, used, refusals, nis, logLikelihood }) {
  if (nis === null || logLikelihood === null)
    return `Speeds and turn rates alone are off a fix by ${fixed(reckonedOff, 0)} m at worst.`
  const judged =
    nis > 1.2
      ? ', above 1: the fixes look worse than σ says'
      : nis < 0.8
        ? ', below 1: they look better than σ says'
        : ''
  const gone = refusals > 0 ? `, and ${refusals} are refused` : ''
  return (
    `${used} fixes are used${gone}. Their NIS is ${fixed(nis, 2)} for each output${judged}. ` +
    `Their log-likelihood is ${fixed(logLikelihood, 1)}.`
  )
}

/** @param {Frame} frame */
function ofTheLearned({ learned }) {
  if (!learned) return ''
  // It drives so many times what is read: what is read is the inverse of it.
  const driven = 1 + learned.speedScale
  const [off, sigma] = [1 / driven - 1, learned.speedScaleSigma / driven ** 2]
  return `The speed reads ${percent(Math.abs(off))} ${off > 0 ? 'high' : 'low'} (±${percent(sigma)}).`
}

/** @param {Frame} frame */
function ofTheTunnel({ tunnel }) {
  if (!tunnel) return ''
  const later = tunnel.worstSmoothed === null ? '' : `, the track afterwards by ${fixed(tunnel.worstSmoothed, 0)} m`
  return `In the tunnel the filter is off by up to ${fixed(tunnel.worst, 0)} m${later}.`
}

/** @param {Frame} frame */
export function describe(frame) {
  const { params, fixes, refused, withheld, reckonedOff, along, logLikelihood } = frame
  const beyond = along.filter((value) => Math.abs(value) > 2).length
  return {
    map:
      `The drive from above: ${fixes.x.length} fixes drawn, ${refused.x.length} refused, ` +
      `${withheld.x.length} withheld; ` +
      `the course by speeds and turn rates alone is off by ${fixed(reckonedOff, 0)} metres at worst.`,
    curve:
      `Log-likelihood of the fixes against the delay of the speed: at ${fixed(params.delay, 2)} seconds it is ` +
      `${logLikelihood === null ? 'none' : fixed(logLikelihood, 1)}.`,
    along: `Normalized innovations along the track: ${beyond} of ${along.length} lie beyond 2.`,
  }
}
