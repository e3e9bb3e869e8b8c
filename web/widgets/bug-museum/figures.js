/** The autocorrelation of the innovations, and the figures of the run on a right filter's bands. */

import { widthOf } from '../../draw/labels.js'
import { axes, meaning, plane as planeOf } from '../../draw/plot.js'
import { pixel } from '../../draw/path.js'
import { rounded } from '../../draw/scale.js'
import { band } from '../../draw/statistics.js'
import { FIGURES, outside, shown } from './words.js'

/** @typedef {import('estimate-wasm').MuseumFrame} Frame */
/** @typedef {import('estimate-wasm').MuseumFigure} Figure */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** How wide a share is, with the dot beside it, pixels. */
const SHARE = 38
/** A row that is no higher than this has no room for words over its bars, pixels. */
const ROOM = 16

/**
 * The autocorrelation of range and bearing at each lag, beside each other.
 * @param {Panel} panel
 * @param {Frame} frame
 */
export function drawCorrelation({ pen, width, height }, { correlationRange, correlationBearing, correlationBand }) {
  const box = { left: 46, top: 26, right: width - 30, bottom: height - 38 }
  const all = [...correlationRange, ...correlationBearing]
  const plane = planeOf(box, [0, 11], rounded(Math.min(-0.3, ...all), Math.max(0.6, ...all), 4))
  pen.draw(() => {
    axes(pen, plane, { title: 'autocorrelation; bearings hollow', x: 'lag, used readings', ticks: [5, 4], zero: true })
    if (correlationBand !== null) band(pen, plane, -correlationBand, correlationBand)
    for (const [shape, values, shift] of /** @type {const} */ ([
      ['full', correlationRange, -0.15],
      ['hollow', correlationBearing, 0.15],
    ])) {
      for (const [i, value] of values.entries()) {
        const x = plane.x(i + 1 + shift)
        pen.mark('line', `${shape}${i}`, {
          ...meaning('lag', 'measurement'),
          x1: x,
          x2: x,
          y1: plane.y(0),
          y2: plane.y(value),
        })
        pen.mark('circle', `${shape}-tip${i}`, { ...meaning(shape, 'measurement'), cx: x, cy: plane.y(value), r: 3 })
      }
    }
  })
}

/**
 * A row for each figure, on the lab's scale: the right filter's 95 % band and, lighter, its 99 % band, the run's value,
 * and the runs of the seeds as bars, with how many of them lie to either side.
 * @param {Panel} panel @param {Frame} frame
 */
export function drawFigures({ pen, width, height }, frame) {
  const { figures, seeds, driven, steps } = frame
  const [top, row] = [24, (height - 28) / figures.length]
  const [left, right] = [Math.max(...FIGURES.map(({ label }) => widthOf(label))) + 6, width - 78]
  const third = (right - left) / 3
  const done = driven >= steps
  pen.draw(() => {
    pen.text(
      'title',
      { class: 'plot-title', x: left + 1.5 * third, y: 14, 'text-anchor': 'middle' },
      'a right filter’s 95 % and 99 % bands',
    )
    pen.mark('rect', 'band', { class: 'band', x: left + third, y: top, width: third, height: row * figures.length })
    for (const [i, figure] of figures.entries()) {
      const y = top + (i + 0.5) * row
      const [least, greatest] = figure.widePlace
      pen.mark('rect', `wide${i}`, {
        class: 'band',
        x: left + third * least,
        y: y - row / 2,
        width: third * (greatest - least),
        height: row,
      })
      pen.text(`name${i}`, { class: 'tick', x: 0, y: y + 4 }, FIGURES[i].label)
      pen.mark('line', `line${i}`, { class: 'grid', x1: left, x2: right, y1: y, y2: y })
      const [below, above] = figure.beyond
      const at = Math.max(left + 4, Math.min(right - 4, left + third * figure.place))
      if (seeds > 0) {
        pen.mark('path', `bars${i}`, {
          ...meaning('area bars', 'posterior'),
          d: bars(figure.counts, left, right, y + row / 2 - 1, row / 2 - 1),
        })
        // On a phone there is no room for both: the bars say it there. Beside the run's own value, where that lies at
        // an end, and above the bars, as far as the row goes.
        const said = y + 4 - Math.min(5, row - ROOM)
        if (below > 0 && row > ROOM)
          pen.text(`below${i}`, { class: 'rule-name', x: at < left + SHARE ? at + 7 : left, y: said }, percent(below))
        if (above > 0 && row > ROOM)
          pen.text(
            `above${i}`,
            { class: 'rule-name', x: at > right - SHARE ? at - 7 : right, y: said, 'text-anchor': 'end' },
            percent(above),
          )
      }
      const far = done && outside(figure)
      if (driven > 0)
        pen.mark('circle', `dot${i}`, {
          class: far ? 'mark eigenvalue outside' : 'mark full posterior',
          cx: at,
          cy: y,
          r: 4,
        })
      pen.text(`value${i}`, { class: 'tick', x: width, y: y + 4, 'text-anchor': 'end' }, shown(i, figure.value))
    }
  })
}

/**
 * A bar for each part of a scale, on one base; the highest is as high as there is room.
 * @param {number[]} counts
 * @param {number} left
 * @param {number} right
 * @param {number} base
 * @param {number} high
 */
function bars(counts, left, right, base, high) {
  const [wide, most] = [(right - left) / counts.length, Math.max(...counts)]
  const bar = (/** @type {number} */ count, /** @type {number} */ i) =>
    count === 0
      ? ''
      : `M${pixel(left + i * wide)} ${pixel(base)}v${pixel(-Math.max(1, (high * count) / most))}` +
        `h${pixel(wide - 0.5)}V${pixel(base)}z`
  return counts.map(bar).join('')
}

/** @param {number} part */
const percent = (part) => `${Math.max(1, Math.round(100 * part))} %`
