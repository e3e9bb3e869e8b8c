/**
 * What the plots of a filter's consistency share: bands, lines of reference, and the autocorrelation of the
 * innovations.
 */

import { axes, meaning, plane as planeOf } from './plot.js'
import { rounded } from './scale.js'

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./plot.js').Plane} Plane */

/** @param {Pen} pen @param {Plane} plane @param {number} low @param {number} high */
export function band(pen, { box, y }, low, high) {
  const [top, bottom] = [Math.max(box.top, y(high)), Math.min(box.bottom, y(low))]
  pen.mark('rect', 'band', {
    class: 'band',
    x: box.left,
    y: top,
    width: box.right - box.left,
    height: Math.max(0, bottom - top),
  })
}

/** A horizontal line of reference. @param {Pen} pen @param {Plane} plane @param {string} key @param {number} at */
export function rule(pen, { box, y }, key, at) {
  pen.mark('line', `rule-${key}`, { ...meaning('rule'), x1: box.left, x2: box.right, y1: y(at), y2: y(at) })
}

/**
 * Says why a plot has nothing to show, above a line through its middle.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {string} words
 */
export function empty(pen, { box }, words) {
  pen.text(
    'empty',
    { class: 'label', x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 - 10, 'text-anchor': 'middle' },
    words,
  )
}

/**
 * The autocorrelation of the innovations at the lags 1, 2, …, and the band that 95 % of white noise lie in.
 * @param {import('../figure/shell.js').Panel} panel
 * @param {{ values: number[], band: number, kept?: number[] }} correlation with those of another run, drawn pale
 * @param {{ title: import('./words.js').Words, lag: import('./words.js').Words, none: string }} words
 * @param {number} margin right of the plot, pixels: that of the plots above and below it
 */
export function drawLags({ pen, width, height }, { values, band: half, kept = [] }, words, margin) {
  const box = { left: 40, top: 26, right: width - margin, bottom: height - 38 }
  const [low, high] = [Math.min(-0.3, ...values, ...kept), Math.max(0.5, ...values, ...kept)]
  const plane = planeOf(box, [0, 21], rounded(low, high, 4))
  pen.draw(() => {
    axes(pen, plane, { title: words.title, x: words.lag, ticks: [5, 4], zero: true })
    if (values.length === 0) return empty(pen, plane, words.none)
    band(pen, plane, -half, half)
    for (const [i, value] of kept.entries())
      pen.mark('circle', `kept${i}`, { class: 'mark end pale', cx: plane.x(i + 1), cy: plane.y(value), r: 3 })
    for (const [i, value] of values.entries()) {
      const x = plane.x(i + 1)
      pen.mark('line', `lag${i}`, {
        ...meaning('lag', 'measurement'),
        x1: x,
        x2: x,
        y1: plane.y(0),
        y2: plane.y(value),
      })
      pen.mark('circle', `tip${i}`, { ...meaning('end', 'measurement'), cx: x, cy: plane.y(value), r: 3 })
    }
  })
}
