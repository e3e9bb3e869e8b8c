/**
 * Opinions about a number as bells, and below them as weights on a beam: each is 1/variance heavy, and the beam
 * balances at the mean of their product.
 */

import { meaning } from './plot.js'

/** @typedef {import('./plot.js').Plane} Plane */
/** @typedef {import('./plot.js').Kin} Kin */
/** @typedef {import('./words.js').Words} Words */
/** @typedef {{ key: string, kin: Kin, mean: number, sigma: number, words: Words }} Bell */

/** A bell is drawn at so many points, this far to either side, in standard deviations. */
const POINTS = 41
const FAR = 3.2
const HEAVIEST = 11
/** Room below the axis for the beam. */
export const BEAM = 46

/**
 * The outline of a bell so high.
 * @param {Plane} plane
 * @param {number} mean
 * @param {number} sigma
 * @param {number} high
 */
export function bell({ x, y }, mean, sigma, high) {
  const points = Array.from({ length: POINTS }, (_, i) => FAR * ((2 * i) / (POINTS - 1) - 1))
  return points
    .map((t, i) => `${i ? 'L' : 'M'}${x(mean + t * sigma).toFixed(1)} ${y(high * Math.exp(-0.5 * t * t)).toFixed(1)}`)
    .join('')
}

/**
 * The beam with its two weights, and its point of balance.
 * @param {import('./pen.js').Pen} pen
 * @param {Plane} plane
 * @param {number | null} likely where it balances; null where that is not told
 * @param {Bell[]} bells the first two are the opinions
 */
export function balance(pen, { x, box }, likely, [expected, read]) {
  const y = box.bottom + BEAM
  const held = (/** @type {number} */ at) => Math.max(box.left, Math.min(box.right, x(at)))
  pen.mark('line', 'beam', { class: 'direction', x1: held(expected.mean), x2: held(read.mean), y1: y, y2: y })
  // Areas are as the weights 1/variance are; the heavier one has the largest circle.
  const lightest = Math.max(1e-9, Math.min(expected.sigma, read.sigma))
  for (const { key, kin, mean, sigma } of [expected, read]) {
    const r = Math.max(2, (HEAVIEST * lightest) / Math.max(lightest, sigma))
    pen.mark('circle', `${key}-weight`, { ...meaning('full', kin), cx: held(mean), cy: y - r, r })
  }
  if (likely === null) return
  const at = held(likely)
  pen.mark('path', 'fulcrum', { ...meaning('full', 'measurement'), d: `M${at.toFixed(1)} ${y}l7 13h-14Z` })
  const left = at > box.right - 28
  pen.text(
    'fulcrum-name',
    { class: 'mark-name measurement', x: at + (left ? -11 : 11), y: y + 15, 'text-anchor': left ? 'end' : 'start' },
    '{y}^{∗}',
  )
}
