/** A map of a log-likelihood over two numbers: its colours, the line about the likeliest, and what the colours mean. */

import { contours } from 'd3-contour'
import { widthOf } from './labels.js'
import { Outline } from './path.js'

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./plot.js').Box} Box */
/**
 * @typedef {object} Likelihood
 * @property {number} size cells to a side
 * @property {number} rows how many are filled, from the least number upwards on
 * @property {number[]} values by rows
 * @property {number} top the greatest log-likelihood
 * @property {number} limit twice what numbers may lack of it that 95 of 100 true ones do
 */

/** Edges of the colours: how far the log-likelihood lies below its maximum. */
const LEVELS = [1000, 300, 100, 30, 10]
/** The least room for a colour and its number, pixels. */
const LEVEL_WIDTH = 46
/**
 * The closed line is drawn with the likeliest noise, which it would give away.
 * @param {Pen} pen @param {Box} box @param {Likelihood | null} map @param {boolean} found
 */
export function drawLikelihood(pen, box, map, found) {
  // Two rows are the least that has a contour.
  if (!map || map.rows < 2) return
  const { size, rows, values, top } = map
  const contour = contours().size([size, rows])
  const path = (/** @type {number} */ below) => outline(contour.contour(values, top - below), box, size)
  pen.group(
    'colours',
    {},
    (to) => {
      for (const below of LEVELS) to.mark('path', `below${below}`, { class: 'likely', d: path(below) })
    },
    `${map.rows} ${top} ${JSON.stringify(box)}`,
  )
  if (found) drawLimit(pen, box, map)
}

/**
 * The line about the likeliest alone.
 * @param {Pen} pen @param {Box} box @param {Omit<Likelihood, 'rows'>} map that is filled
 */
export function drawLimit(pen, box, { size, values, top, limit }) {
  const contour = contours().size([size, values.length / size])
  const d = outline(contour.contour(values, top - limit / 2), box, size)
  pen.mark('path', 'contour', { class: 'likely contour', d })
}

/**
 * Polygons in cells of the map as one path.
 * @param {{ coordinates: number[][][][] }} polygons
 * @param {Box} box
 * @param {number} size
 */
function outline({ coordinates }, { left, right, top, bottom }, size) {
  const out = new Outline()
  let d = ''
  for (const ring of coordinates.flat()) {
    out.data = ''
    for (const [i, [x, y]] of ring.entries()) {
      const at = /** @type {[number, number]} */ ([
        left + (x / size) * (right - left),
        bottom - (y / size) * (bottom - top),
      ])
      if (i === 0) out.move(...at)
      else out.line(...at)
    }
    d += `${out.data}Z`
  }
  return d
}

/** Which colour stands for what. @param {Pen} pen @param {Box} box @param {number} y */
export function drawLegend(pen, box, y) {
  const said = 'below the maximum:'
  const wide = box.right - box.left - widthOf(said) > LEVEL_WIDTH * LEVELS.length
  // On a narrow map the words stand above.
  pen.text('legend', { class: 'tick', x: box.left, y: wide ? y : y - 17 }, said)
  const from = wide ? box.left + widthOf(said) : box.left
  const step = Math.min(54, (box.right - from) / LEVELS.length)
  for (const [i, below] of LEVELS.entries()) {
    const x = from + i * step
    // As many coats as the map has there.
    for (let coat = 0; coat <= i; coat += 1)
      pen.mark('rect', `swatch${below}-${coat}`, { class: 'likely', x, y: y - 10, width: 10, height: 12 })
    pen.text(`swatch-name${below}`, { class: 'tick', x: x + 13, y }, `${below}`)
  }
}
