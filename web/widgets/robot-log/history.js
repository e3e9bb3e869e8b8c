/** Innovations, errors and NIS over the minutes of the drive. */

import { axes, meaning, plane as planeOf, seriesPath } from '../../core/plot.js'
import { drawCrosses, drawPoints } from '../../core/points.js'
import { rounded } from '../../core/scale.js'
import { band, empty, rule } from '../../core/statistics.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {import('../../core/shell.js').Panel} Panel */
/** @typedef {import('../../core/pen.js').Pen} Pen */
/** @typedef {import('../../core/plot.js').Plane} Plane */

const minutes = (/** @type {number[]} */ seconds) => seconds.map((value) => value / 60)

/** Innovations reach from −this to this at least, in σ; at most three times as far. */
const LEAST = 4

/** @param {Panel} panel @param {Frame} frame */
export function drawInnovations(panel, frame) {
  const { time, normalized, used } = frame.innovations
  const most = Math.min(3 * LEAST, normalized.reduce((sum, value) => Math.max(sum, Math.abs(value)), LEAST))
  draw(panel, frame, [-most, most], `innovations {innov}/√*S*${frame.every > 1 ? `, every ${ordinal(frame.every)}` : ''}`, (pen, plane) => {
    band(pen, plane, -2, 2)
    rule(pen, plane, 'high', 2)
    rule(pen, plane, 'low', -2)
    if (time.length === 0) return empty(pen, plane, 'no range is used')
    drawPoints(pen, 'used', plane, minutes(time), normalized, 'measurement', (i) => used[i])
    drawCrosses(pen, 'refused', plane, minutes(time), normalized, (i) => !used[i])
    if (used.includes(false)) pen.text('refused-name', { class: 'tick', x: plane.box.right, y: plane.box.top - 9, 'text-anchor': 'end' }, '× refused')
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, frame) {
  const { time, error, bound } = frame.errors
  const most = Math.max(0.5, ...error, Math.min(bound.reduce((sum, value) => Math.max(sum, value), 0), 3 * Math.max(0.5, ...error)))
  draw(panel, frame, [0, most], 'error and claimed 2 *σ* (m)', (pen, plane) => {
    const kin = frame.params.sightings ? 'posterior' : 'prediction'
    pen.window('curves', plane.box, (to) => {
      to.mark('path', 'bound', { ...meaning(frame.params.sightings ? 'curve' : 'curve dashed', kin), d: seriesPath(plane, minutes(time), bound) })
      to.mark('path', 'error', { ...meaning('curve', 'truth'), d: seriesPath(plane, minutes(time), error) })
    })
    if (error.length === 0) empty(pen, plane, 'there is no truth')
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawNis(panel, frame) {
  const { time, mean, low, high } = frame.nis
  const most = Math.max(2, ...mean, ...high)
  draw(panel, frame, [0, most], 'NIS for each output, and its 95 % band', (pen, plane) => {
    if (mean.length === 0) return empty(pen, plane, 'too few ranges are used')
    band(pen, plane, Math.min(...low), Math.max(...high))
    rule(pen, plane, 'one', 1)
    pen.mark('path', 'nis', { ...meaning('curve', 'measurement'), d: seriesPath(plane, minutes(time), mean) })
    drawPoints(pen, 'blocks', plane, minutes(time), mean, 'measurement')
  })
}

/** @param {Panel} panel @param {Frame} frame @param {[number, number]} up @param {string} title @param {(pen: Pen, plane: Plane) => void} paint */
function draw({ pen, width, height }, frame, [low, high], title, paint) {
  // The unit stands behind the last tick.
  const box = { left: 40, top: 26, right: width - 32, bottom: height - 24 }
  const plane = planeOf(box, [0, Math.max(frame.duration / 60, 1e-3)], rounded(low, high + (high - low) * 0.02, 4))
  pen.draw(() => {
    axes(pen, plane, { title, ticks: [5, 4], zero: low < 0 })
    pen.text('unit', { class: 'axis-name', x: width - 2, y: box.bottom + 15, 'text-anchor': 'end' }, 'min')
    paint(pen, plane)
  })
}

/** @param {number} n */
function ordinal(n) {
  const tail = n % 100 > 10 && n % 100 < 14 ? 'th' : (['th', 'st', 'nd', 'rd'][n % 10] ?? 'th')
  return `${n}${tail}`
}
