/** How far the errors of the robot and of each landmark go together, two by two, as shades. */

import { pixel } from '../../draw/path.js'
import { widthOf } from '../../draw/labels.js'
import { pairOf } from './pair.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */

const SHADES = 10
/** How large a tick's letters are, in letters of a label. */
const TICK = 12 / 13

/** @param {import('../../figure/shell.js').Panel} panel @param {Frame} frame */
export function drawHeat({ pen, width, height }, frame) {
  const { correlation, map, landmarks } = frame
  const top = 46
  const side = Math.min(width - 40, height - top - 26)
  const box = { left: 32, top, right: 32 + side, bottom: top + side }
  const n = correlation.length
  // There is room for the map that most runs end with, framed from the start; a map with ghosts gets smaller cells.
  const cell = side / Math.max(n, landmarks.length + 1)
  const shades = Array.from({ length: SHADES }, () => '')
  let below = ''
  for (const [i, row] of correlation.entries()) {
    const y = pixel(box.top + i * cell)
    const shade = row.map((value) => Math.round(Math.abs(value) * SHADES))
    // Neighbours of one shade are one rectangle.
    for (let from = 0, to = 0; from < n; from = to) {
      while (to < n && shade[to] === shade[from]) to += 1
      if (shade[from] > 0)
        shades[shade[from] - 1] +=
          `M${pixel(box.left + from * cell)} ${y}H${pixel(box.left + to * cell)}` +
          `v${pixel(cell)}H${pixel(box.left + from * cell)}z`
    }
    for (const [j, value] of row.entries()) {
      if (value < 0 && shade[j] > 0)
        below += `M${pixel(box.left + (j + 0.25) * cell)} ${pixel(y + cell / 2)}h${pixel(cell / 2)}`
    }
  }
  pen.draw(() => {
    pen.text('title', { class: 'plot-title', x: 2, y: 17 }, 'correlation of the errors')
    pen.mark('rect', 'frame', { class: 'heat-frame', x: box.left, y: box.top, width: side, height: side })
    for (const [i, d] of shades.entries())
      pen.mark('path', `shade${i}`, { class: 'heat', 'fill-opacity': Math.round(100 * ((i + 1) / SHADES)) / 100, d })
    pen.mark('path', 'below', { class: 'heat-below', d: below })
    const pair = pairOf(frame)
    const cells = pair
      ? [
          [pair.moved.at, pair.by.at],
          [pair.by.at, pair.moved.at],
        ]
      : []
    const around = cells.map(([i, j]) => square(box.left + j * cell, box.top + i * cell, cell)).join('')
    pen.mark('path', 'pair', { class: 'heat-pair', d: around })
    // Where the cells are small every other one has a name, or fewer.
    const [rows, columns] = [Math.ceil(15 / cell), Math.ceil((TICK * widthOf('15') + 1) / cell)]
    for (let i = 0; i < n; i += 1) {
      const words = i === 0 ? 'R' : String(map.landmarks[i - 1].truth + 1)
      const middle = (i + 0.5) * cell
      if (i % rows === 0)
        pen.text(`row${i}`, { class: 'tick', x: box.left - 4, y: box.top + middle + 4, 'text-anchor': 'end' }, words)
      if (i % columns === 0)
        pen.text(`column${i}`, { class: 'tick', x: box.left + middle, y: box.top - 5, 'text-anchor': 'middle' }, words)
    }
    pen.text('key', { class: 'tick', x: 2, y: box.bottom + 18 }, 'R: the robot; full 1, blank 0, dash < 0')
  })
}

/** @param {number} x @param {number} y @param {number} side */
const square = (x, y, side) => `M${pixel(x)} ${pixel(y)}h${pixel(side)}v${pixel(side)}h${pixel(-side)}z`
