/**
 * Names of marks, put where they hide nothing: each name tries the places around its mark, near ones first, and takes
 * the first that lies in the drawing and on no other name and no mark that must stay free. A name far from its mark is
 * led to it by a line.
 *
 * The width of a text is reckoned from its letters and not measured, so that a still drawn in Node has its names where
 * the living figure has them.
 */

import { turns } from './ellipse.js'
import { readings, unmarked } from './words.js'

/** @typedef {import('./plot.js').Box} Box */
/**
 * @typedef {'right' | 'left' | 'above' | 'below' | 'above-right' | 'above-left' | 'below-right' | 'below-left'} Side
 */
/**
 * @typedef {object} Label
 * @property {string} key
 * @property {import('./words.js').Words} words
 * @property {[number, number]} at the mark's middle, pixels
 * @property {string} [name] its classes; `mark-name` if not given
 * @property {string} [kin]
 * @property {number} [gap] from the mark's middle to the text, 10 pixels if not given
 * @property {Side[]} [sides] to be tried first; the others follow
 */

const HEIGHT = 15
/** A name that stands farther from its mark than this, pixels, is led to it. */
const FAR = 20
const SIDES = /** @type {Record<Side, [number, number]>} */ ({
  right: [1, 0],
  left: [-1, 0],
  above: [0, -1],
  below: [0, 1],
  'above-right': [0.75, -0.75],
  'above-left': [-0.75, -0.75],
  'below-right': [0.75, 0.75],
  'below-left': [-0.75, 0.75],
})
const NARROW = /[ijltfrI.,:;'|!()[\] ]/
const BROAD = /[mwMWΩ–—%]/

/** About how wide a text is at 13 pixels. @param {import('./words.js').Words} words */
export function widthOf(words) {
  const wide = (/** @type {string} */ text) =>
    [...text].reduce(
      (sum, letter) => sum + (NARROW.test(letter) ? 4.4 : BROAD.test(letter) ? 11.5 : /[A-Z]/.test(letter) ? 8.4 : 7.1),
      0,
    )
  return Math.max(...readings(words).map((reading) => wide(unmarked(reading)))) + 2
}

/** A disc that names keep clear of. @param {number[]} at @param {number} r @returns {Box} */
export const clear = ([x, y], r) => ({ left: x - r, top: y - r, right: x + r, bottom: y + r })

/** A line that names keep clear of. @param {number[][]} points along it */
export const along = (points) => points.map((at) => clear(at, 2))

/** The line of a circle that names keep clear of. @param {number[]} at its middle @param {number} r */
export const rim = ([x, y], r) => along(turns(120).map(([u, v]) => [x + r * u, y + r * v]))

/**
 * @param {import('./pen.js').Pen} pen
 * @param {Box} box within which names stay
 * @param {Label[]} labels the first has the choice
 * @param {Box[]} [taken] what is to stay free
 */
export function drawLabels(pen, box, labels, taken = []) {
  /** @type {Box[]} */
  const names = []
  for (const label of labels) {
    const width = widthOf(label.words)
    const place = placeOf(label, width, box, names, taken)
    names.push(place.box)
    if (place.away > FAR) {
      const [x, y] = nearest(place.box, label.at)
      pen.mark('line', `${label.key}-lead`, {
        class: `leader ${label.kin ?? ''}`.trim(),
        x1: label.at[0],
        y1: label.at[1],
        x2: x,
        y2: y,
      })
    }
    pen.text(
      label.key,
      {
        class: label.name ?? `mark-name ${label.kin ?? ''}`.trim(),
        x: place.x,
        y: place.box.top + 11.5,
        'text-anchor': place.anchor,
      },
      label.words,
    )
  }
}

/** @param {Label} label @param {number} width @param {Box} box @param {Box[]} names @param {Box[]} taken */
function placeOf({ at: [x, y], gap = 10, sides = [] }, width, box, names, taken) {
  const order = [...sides, .../** @type {Side[]} */ (Object.keys(SIDES)).filter((side) => !sides.includes(side))]
  let best = null
  let least = Infinity
  for (const away of [gap, gap + 12, gap + 26, gap + 44, gap + 66]) {
    for (const side of order) {
      const [dx, dy] = SIDES[side]
      const anchor = dx > 0 ? 'start' : dx < 0 ? 'end' : 'middle'
      const px = x + dx * away
      const left = anchor === 'start' ? px : anchor === 'end' ? px - width : px - width / 2
      const top = y + dy * (away + (dx === 0 ? HEIGHT / 2 - 2 : 0)) - HEIGHT / 2
      const there = { left, top, right: left + width, bottom: top + HEIGHT }
      const on = (/** @type {Box[]} */ others) => others.reduce((sum, other) => sum + shared(there, other), 0)
      // A name over a line can be read, one over another name or an edge cannot.
      const cost = 3 * outside(there, box) + 3 * on(names) + on(taken)
      if (cost < least) [best, least] = [{ box: there, x: px, anchor, away: away - gap }, cost]
      if (cost === 0) return /** @type {NonNullable<typeof best>} */ (best)
    }
  }
  const place = /** @type {NonNullable<typeof best>} */ (best)
  // Nothing is free: better on another mark than cut by the edge.
  const shift = [
    Math.max(0, box.left - place.box.left) - Math.max(0, place.box.right - box.right),
    Math.max(0, box.top - place.box.top) - Math.max(0, place.box.bottom - box.bottom),
  ]
  return {
    ...place,
    x: place.x + shift[0],
    box: {
      left: place.box.left + shift[0],
      right: place.box.right + shift[0],
      top: place.box.top + shift[1],
      bottom: place.box.bottom + shift[1],
    },
  }
}

/** @param {Box} a @param {Box} b */
function shared(a, b) {
  return (
    Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left)) *
    Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top))
  )
}

/** @param {Box} a @param {Box} box */
function outside(a, box) {
  return (a.right - a.left) * (a.bottom - a.top) - shared(a, box)
}

/** @param {Box} box @param {number[]} at */
function nearest({ left, top, right, bottom }, [x, y]) {
  return [Math.max(left, Math.min(right, x)), Math.max(top, Math.min(bottom, y))]
}
