/** Points by the hundred, in one path each. */

import { pixel } from './path.js'
import { meaning } from './plot.js'

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./plot.js').Plane} Plane */

/**
 * Draws a point for each pair: a line of no length with round ends. A point outside the plot stands at its edge.
 * @param {Pen} pen @param {string} key @param {Plane} plane @param {number[]} xs @param {number[]} ys
 * @param {import('./plot.js').Kin} kin @param {(i: number) => boolean} [which] all if not given
 */
export function drawPoints(pen, key, plane, xs, ys, kin, which = () => true) {
  pen.mark('path', key, { ...meaning('points', kin), d: path(plane, xs, ys, which, 'h0') })
}

/**
 * The same as crosses.
 * @param {Pen} pen
 * @param {string} key
 * @param {Plane} plane
 * @param {number[]} xs
 * @param {number[]} ys
 * @param {(i: number) => boolean} which
 */
export function drawCrosses(pen, key, plane, xs, ys, which) {
  pen.mark('path', key, { class: 'mark refused', d: path(plane, xs, ys, which, 'm-2.5-2.5l5 5m0-5l-5 5') })
}

/**
 * @param {Plane} plane
 * @param {number[]} xs
 * @param {number[]} ys
 * @param {(i: number) => boolean} which
 * @param {string} stroke
 */
function path({ x, y, box }, xs, ys, which, stroke) {
  let d = ''
  for (let i = 0; i < xs.length; i += 1) {
    if (!which(i) || !Number.isFinite(ys[i])) continue
    const [px, py] = [pixel(x(xs[i])), pixel(Math.max(box.top, Math.min(box.bottom, y(ys[i]))))]
    if (px >= box.left - 1 && px <= box.right + 1) d += `M${px} ${py}${stroke}`
  }
  return d
}
