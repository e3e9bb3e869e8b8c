/** The sizes of a fault in words: a number with the digits that its uncertainty leaves it. */

import { decimal, fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */

/** So many decimals that the uncertainty has two digits. @param {Size} size @param {number} times */
function decimals({ value, sigma, end }, times) {
  const told = ((!end && sigma) || Math.abs(value) || 1) * times
  return Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(told))))
}

/** @param {Size} size @param {number} [times] */
export const digits = (size, times = 1) => decimal(size.value * times, decimals(size, times))

/** The number that those digits are, in the size's own unit. @param {Size} size @param {number} [times] */
export const rounded = (size, times = 1) => Number((size.value * times).toFixed(decimals(size, times)))

/**
 * A size and how well it is known; of one at the end of what was tried, that it is beyond.
 * @param {Size} size @param {number} [times] @param {string} [beyond]
 */
export function plusMinus(size, times = 1, beyond = 'more than') {
  const value = digits(size, times)
  if (size.end) return `${beyond} ${value}`
  return size.sigma === null ? `about ${value}` : `${value} ± ${fixed(size.sigma * times, decimals(size, times))}`
}

/**
 * Whether a delay is told from one row of motion to the next and no finer; where the readings tell it less well than
 * that, its ± says how well.
 * @param {[number, number] | null | undefined} flat @param {number | null} sigma
 */
export const isStair = (flat, sigma) => Boolean(flat) && !(sigma !== null && flat && sigma > (flat[1] - flat[0]) / 2)

/** A σ as it is set. @param {number} value */
export const claimed = (value) => String(Number(value.toPrecision(3)))

/** A time, with the digits that matter. @param {number} seconds */
export const brief = (seconds) => String(Number(seconds.toPrecision(2)))

/**
 * What of a delay the motion model may have as its own, in words.
 * @param {{ period: number, ownDelay: number }} found seconds between rows of motion, and of that delay
 */
export const ownStep = ({ period, ownDelay }) =>
  `${ownDelay < period ? 'half a step' : 'a step'} between rows of motion, ${brief(ownDelay)} s`

/** What a turn is told beside: nothing, or an offset that is set. @param {Size} size */
export const besideSet = ({ now }) => (now === 0 ? '' : ', beside the offset that is set')
