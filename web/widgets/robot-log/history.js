/** Innovations, errors and NIS over the minutes of the drive. */

import { axes, meaning, plane as planeOf, scaleLog, seriesPath } from '../../draw/plot.js'
import { drawCrosses, drawPoints } from '../../draw/points.js'
import { rounded } from '../../draw/scale.js'
import { band, empty, rule } from '../../draw/statistics.js'
import { apart } from '../../draw/time-plot.js'
import { belongs, looksOf, nameOf, nearest, numbersOf, spanOf, touchedIn } from './looks.js'
import { drawWithheld } from './withheld.js'
import { clock, expecting, unread } from './words.js'

/** @typedef {import('./looks.js').Frame} Frame */
/** @typedef {import('./looks.js').Source} Source */
/** @typedef {import('../../figure/shell.js').Panel} Panel */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/**
 * @typedef {{ key: string, name: string, kin: import('../../draw/plot.js').Kin, shape: string, values: number[] }}
 * Curve
 */

const minutes = (/** @type {number[]} */ seconds) => seconds.map((value) => value / 60)

/** Left and right of every plot over time, pixels. */
const [LEFT, RIGHT] = [40, 32]
/** Innovations reach from −this to this at least, in σ; at most three times as far. */
const LEAST = 4

/** The time at a place of such a panel, seconds. @param {Frame} frame @param {number} x @param {number} width */
export function timeAt(frame, x, width) {
  const [from, to] = spanOf(frame)
  const share = (x - LEFT) / (width - RIGHT - LEFT)
  return from + Math.max(0, Math.min(1, share)) * (to - from)
}

/**
 * The number of the reading nearest to a place of a panel of innovations; of a panel over time where `y` is null.
 * @param {Frame} frame @param {Source | null} source
 * @param {[number, number | null]} place @param {{ width: number, height: number }} size
 */
export function readingAt(frame, source, [x, y], size) {
  const numbers = numbersOf(frame, source)
  const most = reachOf(frame, numbers, belongs(frame, source))
  const { x: across, y: up, box } = planeIn(frame, size, [-most, most])
  const { time } = frame.innovations
  const shown = (/** @type {number} */ i) => Math.max(box.top, Math.min(box.bottom, up(numbers[i])))
  return nearest(frame, source, (i) => Math.hypot(across(time[i] / 60) - x, y === null ? 0 : shown(i) - y))
}

/** @param {Frame} frame @param {number[]} numbers @param {(i: number) => boolean} mine */
const reachOf = (frame, numbers, mine) =>
  Math.min(
    3 * LEAST,
    frame.innovations.time.reduce(
      (most, _, i) => (mine(i) && Number.isFinite(numbers[i]) ? Math.max(most, Math.abs(numbers[i])) : most),
      LEAST,
    ),
  )

/** @param {Panel} panel @param {Frame} frame @param {import('../../figure/spec.js').View} view */
export function drawInnovations(panel, frame, view) {
  const { source, kept } = looksOf(frame)
  drawReadings(panel, frame, view, source, kept)
}

/**
 * The bearings, beside whatever the panel of the innovations shows.
 * @param {Panel} panel @param {Frame} frame @param {import('../../figure/spec.js').View} view
 */
export function drawBearings(panel, frame, view) {
  const { kept } = looksOf(frame)
  drawReadings(panel, frame, view, { sensor: 'bearing', landmark: null, bearing: true }, kept)
}

/**
 * @param {Panel} panel @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @param {Source | null} source @param {Frame | null} kept
 */
function drawReadings(panel, frame, view, source, kept) {
  const { time, used } = frame.innovations
  const [mine, numbers] = [belongs(frame, source), numbersOf(frame, source)]
  const most = reachOf(frame, numbers, mine)
  const of = source ? ` of ${nameOf(source, frame)}` : ''
  const stride = time.length > 0 ? frame.everyLooked : frame.every
  const every = stride > 1 ? `, every ${ordinal(stride)}` : ''
  draw(panel, frame, [-most, most], `innovations {innov}/√*S*${of}${every}`, (pen, plane) => {
    band(pen, plane, -2, 2)
    rule(pen, plane, 'high', 2)
    rule(pen, plane, 'low', -2)
    if (!time.some((_, i) => mine(i))) return empty(pen, plane, unread(frame))
    if (kept) {
      const old = belongs(kept, source)
      pen.group('kept', { class: 'pale' }, (to) =>
        drawPoints(to, 'used', plane, minutes(kept.innovations.time), numbersOf(kept, source), 'prediction', old),
      )
    }
    drawPoints(pen, 'used', plane, minutes(time), numbers, 'measurement', (i) => mine(i) && used[i])
    drawCrosses(pen, 'refused', plane, minutes(time), numbers, (i) => mine(i) && !used[i])
    if (used.includes(false))
      pen.text(
        'refused-name',
        { class: 'tick', x: plane.box.right, y: plane.box.top - 9, 'text-anchor': 'end' },
        '× refused',
      )
    drawTouched(pen, plane, frame, view, source, numbers)
  })
}

/**
 * The reading that was touched: arrow keys go to its neighbours.
 * @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @param {Source | null} source @param {number[]} numbers
 */
function drawTouched(pen, plane, frame, view, source, numbers) {
  const i = touchedIn(frame)
  const { time } = frame.innovations
  if (i < 0 || !belongs(frame, source)(i) || !Number.isFinite(numbers[i])) return
  const x = plane.x(time[i] / 60)
  if (x < plane.box.left - 1 || x > plane.box.right + 1) return
  const mine = belongs(frame, source)
  /** @param {number} to */
  const look = (to) => ({ look: { touched: time[to] } })
  pen.group('handles', {}, (to) =>
    view.handle(to, 'touched', {
      at: [x, Math.max(plane.box.top, Math.min(plane.box.bottom, plane.y(numbers[i])))],
      small: true,
      label: 'Reading',
      value: `at ${clock(time[i])}, ${numbers[i].toFixed(1)} σ`,
      now: time[i],
      min: 0,
      max: frame.duration,
      move: (px) => {
        const wanted = plane.x.invert(px) * 60
        return look(nearest(frame, source, (at) => Math.abs(time[at] - wanted)))
      },
      nudge: (dx, dy) => {
        const step = Math.sign(dx || dy)
        let at = i
        for (let next = i + step; next >= 0 && next < time.length; next += step)
          if (mine(next) && Number.isFinite(numbers[next]) && time[next] !== time[i]) {
            at = next
            break
          }
        return look(at)
      },
    }),
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, frame) {
  const { time, error, bound } = frame.errors
  const { kept } = looksOf(frame)
  const reach = kept?.errors
  draw(
    panel,
    frame,
    decades([...error, ...(reach?.error ?? [])], [...bound, ...(reach?.bound ?? [])]),
    'error *e* and claimed 2 *σ* (m)',
    (pen, plane) => {
      const held = (/** @type {number[]} */ values) => values.map((value) => Math.max(plane.y.domain[0], value))
      const curves = curvesOf(frame, held)
      if (curves.length === 0) return empty(pen, plane, 'nothing is driven yet')
      pen.window('curves', plane.box, (to) => {
        if (kept)
          to.group('kept', { class: 'pale' }, (old) => {
            for (const { key, shape, kin, values } of curvesOf(kept, held))
              old.mark('path', key, { ...meaning(shape, kin), d: seriesPath(plane, minutes(kept.errors.time), values) })
          })
        for (const { key, shape, kin, values } of curves)
          to.mark('path', key, { ...meaning(shape, kin), d: seriesPath(plane, minutes(time), values) })
      })
      const last = lastWithin(time, plane)
      const at = apart(
        curves.map(({ values }) => plane.y(values[last])),
        14,
        plane.box.top + 4,
        plane.box.bottom - 8,
      )
      for (const [i, { key, name, kin }] of curves.entries()) {
        const x = Math.max(plane.box.left, plane.x(time[last] / 60)) + 5
        pen.text(`${key}-name`, { class: `curve-name ${kin}`, x, y: at[i] + 4 }, name)
      }
    },
    true,
  )
}

/** @param {Frame} frame @param {(values: number[]) => number[]} held @returns {Curve[]} */
function curvesOf({ errors: { error, bound }, params: { sightings } }, held) {
  const curves = /** @type {Curve[]} */ ([
    {
      key: 'bound',
      name: '2 *σ*',
      kin: sightings ? 'posterior' : 'prediction',
      shape: sightings ? 'curve' : 'curve dashed',
      values: held(bound),
    },
    { key: 'error', name: '*e*', kin: 'truth', shape: 'curve', values: held(error) },
  ])
  return curves.filter(({ values }) => values.length > 0)
}

/** The number of the last time that a plot shows. @param {number[]} time @param {Plane} plane */
function lastWithin(time, plane) {
  let last = time.length - 1
  while (last > 0 && plane.x(time[last] / 60) > plane.box.right + 1) last -= 1
  return last
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

/** A gap between two values that is this many times the usual one is no way between them. */
const GAP = 3

/**
 * A series with a break wherever its times leave a gap, as over a stretch whose readings are withheld.
 * @param {number[]} times @param {number[]} values @returns {[number[], number[]]}
 */
export function broken(times, values) {
  const gaps = times.slice(1).map((time, i) => time - times[i])
  const most = GAP * [...gaps].sort((a, b) => a - b)[gaps.length >> 1]
  const far = (/** @type {number} */ i) => i > 0 && gaps[i - 1] > most
  return [
    times.flatMap((time, i) => (far(i) ? [time, time] : [time])),
    values.flatMap((value, i) => (far(i) ? [Number.NaN, value] : [value])),
  ]
}

/** @param {Panel} panel @param {Frame} frame */
export function drawNis(panel, frame) {
  const { time, mean, low, high } = frame.nis
  const { kept } = looksOf(frame)
  const most = Math.max(2, ...mean, ...high, ...(kept?.nis.mean ?? []))
  draw(panel, frame, [0, most], 'NIS for each output, and its 95 % band', (pen, plane) => {
    if (mean.length === 0) {
      rule(pen, plane, 'one', 1)
      return empty(pen, plane, expecting(frame, 'about 1 if the model is right'))
    }
    band(pen, plane, Math.min(...low), Math.max(...high))
    rule(pen, plane, 'one', 1)
    const curve = (/** @type {number[]} */ times, /** @type {number[]} */ values) => ({
      ...meaning('curve', 'measurement'),
      d: seriesPath(plane, ...broken(minutes(times), values)),
    })
    pen.window('curves', plane.box, (to) => {
      if (kept)
        to.group('kept', { class: 'pale' }, (old) => old.mark('path', 'nis', curve(kept.nis.time, kept.nis.mean)))
      to.mark('path', 'nis', curve(time, mean))
    })
    drawPoints(pen, 'blocks', plane, minutes(time), mean, 'measurement')
  })
}

/** @param {Frame} frame @param {{ width: number, height: number }} size @param {[number, number]} up */
function planeIn(frame, { width, height }, [low, high]) {
  // The unit stands behind the last tick.
  const box = { left: LEFT, top: 26, right: width - RIGHT, bottom: height - 24 }
  const [from, to] = minutes(spanOf(frame))
  return planeOf(box, [from, to], rounded(low, high + (high - low) * 0.02, 4))
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
  const flat = planeIn(frame, { width, height }, [low, high])
  const { box } = flat
  const plane = log ? { ...flat, y: scaleLog([low, high], [box.bottom, box.top]) } : flat
  pen.draw(() => {
    axes(pen, plane, { title, ticks: [5, 4], zero: low < 0 })
    pen.text('unit', { class: 'axis-name', x: width - 2, y: box.bottom + 15, 'text-anchor': 'end' }, 'min')
    drawWithheld(pen, plane, frame)
    paint(pen, plane)
  })
}

/** @param {number} n */
function ordinal(n) {
  const tail = n % 100 > 10 && n % 100 < 14 ? 'th' : (['th', 'st', 'nd', 'rd'][n % 10] ?? 'th')
  return `${n}${tail}`
}
