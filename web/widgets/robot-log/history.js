/** Innovations, errors and NIS over the minutes of the drive. */

import { axes, meaning, plane as planeOf, scaleLog, seriesPath } from '../../draw/plot.js'
import { drawCrosses, drawPoints } from '../../draw/points.js'
import { rounded } from '../../draw/scale.js'
import { band, empty, rule } from '../../draw/statistics.js'
import { apart } from '../../draw/time-plot.js'
import { expecting, unread } from './words.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/**
 * @typedef {{ key: string, name: string, kin: import('../../draw/plot.js').Kin, shape: string, values: number[] }}
 * Curve
 */

const minutes = (/** @type {number[]} */ seconds) => seconds.map((value) => value / 60)

/** Innovations reach from −this to this at least, in σ; at most three times as far. */
const LEAST = 4

/** @param {Panel} panel @param {Frame} frame */
export function drawInnovations(panel, frame) {
  const { time, normalized, used } = frame.innovations
  const most = Math.min(
    3 * LEAST,
    normalized.reduce((sum, value) => Math.max(sum, Math.abs(value)), LEAST),
  )
  draw(
    panel,
    frame,
    [-most, most],
    `innovations {innov}/√*S*${frame.every > 1 ? `, every ${ordinal(frame.every)}` : ''}`,
    (pen, plane) => {
      band(pen, plane, -2, 2)
      rule(pen, plane, 'high', 2)
      rule(pen, plane, 'low', -2)
      if (time.length === 0) return empty(pen, plane, unread(frame))
      drawPoints(pen, 'used', plane, minutes(time), normalized, 'measurement', (i) => used[i])
      drawCrosses(pen, 'refused', plane, minutes(time), normalized, (i) => !used[i])
      if (used.includes(false))
        pen.text(
          'refused-name',
          { class: 'tick', x: plane.box.right, y: plane.box.top - 9, 'text-anchor': 'end' },
          '× refused',
        )
    },
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, frame) {
  const { time, error, bound } = frame.errors
  draw(
    panel,
    frame,
    decades(error, bound),
    'error *e* and claimed 2 *σ* (m)',
    (pen, plane) => {
      const kin = frame.params.sightings ? 'posterior' : 'prediction'
      const held = (/** @type {number[]} */ values) => values.map((value) => Math.max(plane.y.domain[0], value))
      const curves = /** @type {Curve[]} */ ([
        {
          key: 'bound',
          name: '2 *σ*',
          kin,
          shape: frame.params.sightings ? 'curve' : 'curve dashed',
          values: held(bound),
        },
        { key: 'error', name: '*e*', kin: 'truth', shape: 'curve', values: held(error) },
      ]).filter(({ values }) => values.length > 0)
      if (curves.length === 0) return empty(pen, plane, 'nothing is driven yet')
      pen.window('curves', plane.box, (to) => {
        for (const { key, shape, kin, values } of curves)
          to.mark('path', key, { ...meaning(shape, kin), d: seriesPath(plane, minutes(time), values) })
      })
      const at = apart(
        curves.map(({ values }) => plane.y(values[values.length - 1])),
        14,
        plane.box.top + 4,
        plane.box.bottom - 8,
      )
      for (const [i, { key, name, kin, values }] of curves.entries()) {
        pen.text(
          `${key}-name`,
          { class: `curve-name ${kin}`, x: plane.x(time[values.length - 1] / 60) + 5, y: at[i] + 4 },
          name,
        )
      }
      if (error.length === 0) empty(pen, plane, 'there is no truth')
    },
    true,
  )
}

/**
 * Whole powers of ten about both curves, since a claim may be a hundred times the error. What is far smaller than
 * usual, as the error at the start, stands at the lower edge.
 * @param {number[]} error @param {number[]} bound @returns {[number, number]}
 */
function decades(error, bound) {
  const usual = [error, bound]
    .filter(({ length }) => length > 0)
    .map((values) => [...values].sort((a, b) => a - b)[values.length >> 1])
  const most = [...error, ...bound].reduce((sum, value) => (Number.isFinite(value) ? Math.max(sum, value) : sum), 0)
  const [low, high] = [Math.min(...usual, 1) / 2, most].map((value) => Math.log10(Math.max(1e-6, value)))
  const top = Math.max(0, Math.ceil(high))
  return [10 ** Math.min(-1, top - 2, Math.floor(low)), 10 ** top]
}

/** @param {Panel} panel @param {Frame} frame */
export function drawNis(panel, frame) {
  const { time, mean, low, high } = frame.nis
  const most = Math.max(2, ...mean, ...high)
  draw(panel, frame, [0, most], 'NIS for each output, and its 95 % band', (pen, plane) => {
    if (mean.length === 0) {
      rule(pen, plane, 'one', 1)
      return empty(pen, plane, expecting(frame, 'about 1 if the model is right'))
    }
    band(pen, plane, Math.min(...low), Math.max(...high))
    rule(pen, plane, 'one', 1)
    pen.mark('path', 'nis', { ...meaning('curve', 'measurement'), d: seriesPath(plane, minutes(time), mean) })
    drawPoints(pen, 'blocks', plane, minutes(time), mean, 'measurement')
  })
}

/**
 * @param {Panel} panel
 * @param {Frame} frame
 * @param {[number, number]} up
 * @param {string} title
 * @param {(pen: Pen, plane: Plane) => void} paint
 * @param {boolean} [log]
 */
function draw({ pen, width, height }, frame, [low, high], title, paint, log = false) {
  // The unit stands behind the last tick.
  const box = { left: 40, top: 26, right: width - 32, bottom: height - 24 }
  const flat = planeOf(box, [0, Math.max(frame.duration / 60, 1e-3)], rounded(low, high + (high - low) * 0.02, 4))
  const plane = log ? { ...flat, y: scaleLog([low, high], [box.bottom, box.top]) } : flat
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
