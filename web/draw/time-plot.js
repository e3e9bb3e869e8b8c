/** Plots of series over steps, each curve named where it ends. */

import { axes, meaning, seriesPath } from './plot.js'
import { rounded, scaleLinear, scaleLog } from './scale.js'

/** A name that stands farther from the end of its curve than this, pixels, is led to it. */
const FAR = 4
/** The handle of a cursor and what keeps clear of it, pixels. */
const HANDLE = 9

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./words.js').Words} Words */
/** @typedef {import('./plot.js').Kin} Kin */
/** @typedef {import('./plot.js').Box} Box */
/** @typedef {import('./plot.js').Plane} Plane */
/** @typedef {import('./scale.js').Scale} Scale */

/**
 * @typedef {object} Line one curve of a time plot
 * @property {string} key
 * @property {number[]} values
 * @property {Words} name written at its end
 * @property {Kin | null} [kin]
 * @property {string} [shape] a class for its dash: `solid`, `dashed`, `thin`
 *
 * @typedef {object} Rule a horizontal line
 * @property {string} key
 * @property {number} at
 * @property {Words} [name]
 * @property {Kin | null} [kin]
 */

/**
 * @typedef {object} Cursor
 * @property {number} step
 * @property {string} label for screen readers
 * @property {string} value in words
 * @property {number} stride of an arrow key, steps
 * @property {import('../figure/spec.js').View} view
 */

/**
 * Draws curves over steps.
 * @param {Pen} pen
 * @param {{ width: number, height: number }} size
 * @param {object} plot
 * @param {Words} plot.title with the unit
 * @param {number[]} plot.steps
 * @param {Line[]} plot.lines
 * @param {Rule[]} [plot.rules]
 * @param {boolean} [plot.log]
 * @param {[number, number]} [plot.include] values that are always in view
 * @param {number} [plot.least] how many steps the axis shows at least
 * @param {Words} [plot.unit] what the horizontal axis counts
 * @param {Cursor} [plot.cursor] the step that the other panels show; by it the reader moves them
 * @returns {Plane}
 */
export function timePlot(pen, size, plot) {
  const box = { left: 44, top: 26, right: size.width - 34, bottom: size.height - 24 }
  const first = plot.steps[0] ?? 0
  const last = Math.max(plot.steps[plot.steps.length - 1] ?? 0, first + (plot.least ?? 20))
  // The handle of a cursor hides neither the numbers of the upright axis nor those below it.
  const [aside, drop] = plot.cursor ? [HANDLE, 19] : [0, 15]
  const plane = { box, x: scaleLinear([first, last], [box.left + aside, box.right]), y: upright(plot, box) }
  axes(pen, plane, { title: plot.title, ticks: [5, 4], zero: !plot.log, drop })
  pen.text(
    'unit',
    { class: 'axis-name', x: size.width - 2, y: box.bottom + drop, 'text-anchor': 'end' },
    plot.unit ?? '*k*',
  )
  for (const rule of plot.rules ?? []) {
    const at = plane.y(rule.at)
    pen.mark('line', `rule-${rule.key}`, { ...meaning('rule', rule.kin), x1: box.left, x2: box.right, y1: at, y2: at })
    if (rule.name) pen.text(`rule-name-${rule.key}`, { class: 'rule-name', x: box.right + 4, y: at + 4 }, rule.name)
  }
  const ends = plot.lines.map(({ values }) => plane.y(values[values.length - 1]))
  const x = plane.x(plot.steps[plot.steps.length - 1])
  const held = plot.cursor && Math.abs(plane.x(plot.cursor.step) - x) < 3 * HANDLE
  const named = plot.lines.flatMap(({ name }, i) => (name && Number.isFinite(ends[i]) ? [i] : []))
  // Above the axis, which would strike a name through, and above the handle; where there is little room, nearer to it
  // and to one another.
  const between = named.length - 1
  const low = held
    ? box.bottom - HANDLE - 4
    : Math.max(box.bottom - 8, Math.min(box.bottom - 2, box.top + 4 + 13 * between))
  const spread = apart(
    named.map((i) => ends[i]),
    Math.max(13, Math.min(15, (low - box.top - 4) / between)),
    box.top + 4,
    low,
  )
  plot.lines.forEach((one, i) => {
    const d = seriesPath(plane, plot.steps, one.values)
    pen.mark('path', `line-${one.key}`, { ...meaning(`curve ${one.shape ?? 'solid'}`, one.kin), d })
    if (!Number.isFinite(ends[i])) return
    pen.mark('circle', `end-${one.key}`, { ...meaning('end', one.kin), cx: x, cy: ends[i], r: 2.5 })
    const y = spread[named.indexOf(i)]
    if (y === undefined) return
    const far = Math.abs(y - ends[i]) > FAR
    if (far)
      pen.mark('line', `lead-${one.key}`, { class: `leader ${one.kin ?? ''}`, x1: x, y1: ends[i], x2: x + 8, y2: y })
    pen.text(`name-${one.key}`, { class: `curve-name ${one.kin ?? ''}`, x: x + (far ? 9 : 6), y: y + 4 }, one.name)
  })
  if (plot.cursor) drawCursor(pen, plane, plot.steps, plot.cursor)
  return plane
}

/** @param {Pen} pen @param {Plane} plane @param {number[]} steps @param {Cursor} cursor */
function drawCursor(pen, { box, x }, steps, { step, label, value, stride, view }) {
  const at = x(step)
  // To the right of the curves it drives on, as far as the axis goes.
  const [first, last] = [steps[0] ?? 0, Math.floor(x.domain[1])]
  const to = (/** @type {number} */ wanted) => ({ step: Math.round(Math.max(first, Math.min(last, wanted))) })
  pen.mark('line', 'cursor', { class: 'cursor', x1: at, x2: at, y1: box.top, y2: box.bottom })
  pen.group('handles', {}, (into) =>
    view.handle(into, 'cursor', {
      at: [at, box.bottom],
      small: true,
      label,
      value,
      now: step,
      min: first,
      max: last,
      move: (px) => to(x.invert(px)),
      nudge: (dx, dy) => to(step + stride * (dx || dy)),
      jump: (end) => to(end === 'home' ? first : last),
    }),
  )
}

/**
 * @param {{ lines: Line[], rules?: Rule[], log?: boolean, include?: number[] }} plot
 * @param {Box} box
 * @returns {Scale}
 */
function upright({ lines, rules = [], include = [], log = false }, box) {
  let [low, high] = [Infinity, -Infinity]
  const see = (/** @type {number} */ value) => {
    if (!Number.isFinite(value) || (log && !(value > 0))) return
    if (value < low) low = value
    if (value > high) high = value
  }
  for (const { values } of lines) values.forEach(see)
  for (const { at } of rules) see(at)
  include.forEach(see)
  if (low > high) [low, high] = log ? [0.1, 1] : [0, 1]
  if (high - low < 1e-9 * Math.abs(high) || high === low) high = low + Math.max(1e-6, Math.abs(low) * 0.1)
  const range = /** @type {[number, number]} */ ([box.bottom, box.top])
  if (log) {
    const [from, to] = rounded(Math.log10(low / 1.1), Math.log10(high * 1.1), 5)
    return scaleLog([10 ** from, 10 ** to], range)
  }
  return scaleLinear(rounded(low - (high - low) * 0.04, high + (high - low) * 0.04, 4), range)
}

/**
 * Moves labels apart so that none covers another.
 * @param {number[]} at
 * @param {number} gap
 * @param {number} low
 * @param {number} high
 */
export function apart(at, gap, low, high) {
  const order = at.map((_, i) => i).sort((i, j) => at[i] - at[j])
  const moved = at.map((y) => Math.max(low, Math.min(high, y)))
  for (let k = 1; k < order.length; k += 1) moved[order[k]] = Math.max(moved[order[k]], moved[order[k - 1]] + gap)
  for (let k = order.length - 1; k >= 0; k -= 1) {
    const ceiling = k === order.length - 1 ? high : moved[order[k + 1]] - gap
    moved[order[k]] = Math.min(moved[order[k]], ceiling)
  }
  return moved
}
