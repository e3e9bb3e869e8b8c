/**
 * Scales from data to pixels, linear and logarithmic, with round ticks. The ticks are those of d3-scale; the rest of
 * d3-scale the figures do not need.
 */

import { power } from './numbers.js'

/**
 * @typedef {((value: number) => number) & {
 *   domain: [number, number], log: boolean, invert: (pixel: number) => number,
 *   all: (values: ArrayLike<number>, count: number, into: Float64Array) => void,
 *   ticks: (count: number) => number[], words: (count: number) => (value: number) => string,
 * }} Scale
 */

/**
 * @param {[number, number]} domain
 * @param {[number, number]} range pixels
 * @returns {Scale}
 */
export function scaleLinear(domain, [from, to]) {
  const [low, high] = domain
  const slope = (to - from) / (high - low)
  return Object.assign((/** @type {number} */ value) => from + (value - low) * slope, {
    domain,
    log: false,
    all: (/** @type {ArrayLike<number>} */ values, /** @type {number} */ count, /** @type {Float64Array} */ into) => {
      for (let i = 0; i < count; i += 1) into[i] = from + (values[i] - low) * slope
    },
    invert: (/** @type {number} */ pixel) => low + (pixel - from) / slope,
    ticks: (/** @type {number} */ count) => ticks(low, high, count),
    words: (/** @type {number} */ count) => inWords(low, high, count),
  })
}

/**
 * @param {[number, number]} domain positive
 * @param {[number, number]} range pixels
 * @returns {Scale}
 */
export function scaleLog(domain, [from, to]) {
  const low = Math.log(domain[0])
  const slope = (to - from) / (Math.log(domain[1]) - low)
  return Object.assign((/** @type {number} */ value) => from + (Math.log(value) - low) * slope, {
    domain,
    log: true,
    all: (/** @type {ArrayLike<number>} */ values, /** @type {number} */ count, /** @type {Float64Array} */ into) => {
      for (let i = 0; i < count; i += 1) into[i] = from + (Math.log(values[i]) - low) * slope
    },
    invert: (/** @type {number} */ pixel) => Math.exp(low + (pixel - from) / slope),
    ticks: (/** @type {number} */ count) => logTicks(domain[0], domain[1], count),
    words: () => (/** @type {number} */ value) => (value >= 1e4 || value < 1e-3 ? power(value, '·') : String(value)),
  })
}

/**
 * The step of about `count` ticks: 1, 2 or 5 times a power of ten.
 * @param {number} low
 * @param {number} high
 * @param {number} count
 */
function stepOf(low, high, count) {
  const least = (high - low) / Math.max(1, count)
  const power = Math.floor(Math.log10(least))
  const over = least / 10 ** power
  return { factor: over >= Math.sqrt(50) ? 10 : over >= Math.sqrt(10) ? 5 : over >= Math.SQRT2 ? 2 : 1, power }
}

/**
 * Widens a domain to the next quarter of a tick's step, so that an axis seldom changes while its values move a little.
 * @param {number} low @param {number} high @param {number} count
 * @returns {[number, number]}
 */
export function rounded(low, high, count) {
  const { factor, power } = stepOf(low, high, count)
  const step = (factor * 10 ** power) / 4
  return [Math.floor(low / step) * step, Math.ceil(high / step) * step]
}

/** @param {number} low @param {number} high @param {number} count */
function ticks(low, high, count) {
  if (!(high > low)) return [low]
  const { factor, power } = stepOf(low, high, count)
  // A power of ten below one is divided by, so that 0.3 is 3 / 10 and prints as such.
  const at = (/** @type {number} */ n) => (power < 0 ? (n * factor) / 10 ** -power : n * factor * 10 ** power)
  let first = Math.round(low / at(1))
  let last = Math.round(high / at(1))
  if (at(first) < low) first += 1
  if (at(last) > high) last -= 1
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => at(first + i))
}

/** @param {number} low @param {number} high @param {number} count */
function logTicks(low, high, count) {
  const [first, last] = [Math.log10(low), Math.log10(high)]
  if (last - first >= count) return ticks(first, last, Math.min(last - first, count)).map((power) => 10 ** power)
  const found = []
  for (let power = Math.floor(first); power <= Math.ceil(last); power += 1) {
    for (let digit = 1; digit < 10; digit += 1) {
      const at = power < 0 ? digit / 10 ** -power : digit * 10 ** power
      if (at >= low && at <= high) found.push(at)
    }
  }
  return found.length * 2 < count ? ticks(low, high, count) : found
}

/**
 * Ticks with the decimals of their step, a true minus and thousands apart.
 * @param {number} low
 * @param {number} high
 * @param {number} count
 */
function inWords(low, high, count) {
  const { factor, power: tens } = stepOf(low, high, count)
  const decimals = Math.max(0, -Math.floor(tens + Math.log10(factor)))
  const large = Math.max(Math.abs(low), Math.abs(high)) >= 1e4
  return (/** @type {number} */ value) => {
    const text = large
      ? inTens(Math.abs(value))
      : Math.abs(value)
          .toFixed(decimals)
          .replace(/\B(?=(\d{3})+(?!\d))(?<!\.\d*)/g, ',')
    return value < 0 && Number(text.replace(',', '')) !== 0 ? `\u2212${text}` : text
  }
}

/** A large tick: `1.5·10⁵`. @param {number} value */
function inTens(value) {
  if (value === 0) return '0'
  const exponent = Math.floor(Math.log10(value) + 1e-9)
  const lead = Number((value / 10 ** exponent).toFixed(2))
  return `${lead === 1 ? '' : `${lead}·`}${power(10 ** exponent)}`
}
