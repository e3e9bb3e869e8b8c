/**
 * The line of time: above, how far the estimate is off the truth, with the band that the filter claims and the readings
 * where the filter takes them to be; below, a row of ticks for each sensor. A tick of the camera is where a reading was
 * measured, and a line leads from it to when it came. One reading is in hand: it is picked, dragged and removed there.
 */

import { drawLabels } from '../../draw/labels.js'
import { polyline } from '../../draw/path.js'
import { axes, meaning, scaleLinear, seriesPath } from '../../draw/plot.js'
import { rounded } from '../../draw/scale.js'
import { handlesOf } from './handles.js'
import { CAMERA, SENSORS, drawReadings } from './sensors.js'

/** @typedef {import('estimate-wasm').LateFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** From the foot of the drawing, pixels: the rows of sonar and laser, and of the camera as measured and as it came. */
const ROWS = { sonar: 122, laser: 102, measured: 80, came: 44 }

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawLine({ pen, width, height }, frame, view) {
  const box = { left: 58, top: 26, right: width - 12, bottom: height - 24 }
  const foot = height - ROWS.sonar - 14
  const plane = { box, x: scaleLinear([0, frame.end], [box.left, box.right]), y: upright(frame, foot, box.top) }
  pen.draw(() => {
    axes(pen, plane, { title: 'estimate less truth (m), and ±2*σ*', ticks: [10, 5], drop: 17 })
    const plot = { ...box, bottom: foot }
    gap(pen, plane, frame)
    pen.window('curves', plot, (to) => curves(to, plane, frame))
    readings(pen, plane, [box.top, foot], frame)
    pen.text('unit', { class: 'axis-name', x: box.right, y: box.bottom - 5, 'text-anchor': 'end' }, 's')
    rows(pen, plane, height, frame)
    names(pen, plane, plot, frame)
    const grips = handlesOf(frame, view.limits, plane, { ...ROWS, height })
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(grips)) view.handle(to, key, grip)
    })
  })
}

/**
 * The curves in sight with their bands, and the fine sensors' readings; a sonar's are cut.
 * @param {Frame} frame @param {number} foot @param {number} top
 */
function upright({ error, twoSigma, sensors }, foot, top) {
  let most = 0.4
  error.forEach((value, i) => (most = Math.max(most, Math.abs(value) + twoSigma[i])))
  for (const { off } of sensors.slice(1)) for (const value of off) most = Math.max(most, Math.abs(value) + 0.05)
  // A reading that comes after seconds would press the rest flat.
  const [low, high] = rounded(-Math.min(most, 4), Math.min(most, 4), 4)
  return scaleLinear([low, high], [foot, top])
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function gap(pen, { x, box }, { gap }) {
  if (!gap) return
  const [left, right] = [x(gap.from), x(gap.to)]
  pen.mark('rect', 'gap', { class: 'band', x: left, y: box.top, width: right - left, height: box.bottom - box.top })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function curves(pen, plane, { time, error, twoSigma, smoothed, smoothedTwoSigma }) {
  const later = time.slice(1)
  const around = (/** @type {number[]} */ times, /** @type {number[]} */ middle, /** @type {number[]} */ half) => {
    const up = middle.map((value, i) => value + half[i])
    const down = middle.map((value, i) => value - half[i])
    const all = [...up, ...down.reverse()]
    return `${polyline(all.length, plane.x, [...times, ...[...times].reverse()], plane.y, all)}Z`
  }
  pen.mark('path', 'band', { ...meaning('area', 'posterior'), d: around(time, error, twoSigma) })
  pen.mark('line', 'truth', {
    ...meaning('track', 'truth'),
    x1: plane.box.left,
    x2: plane.box.right,
    y1: plane.y(0),
    y2: plane.y(0),
  })
  pen.mark('path', 'estimate', { ...meaning('curve', 'posterior'), d: seriesPath(plane, time, error) })
  if (smoothed.length === 0) return
  pen.mark('path', 'smoothed-band', {
    ...meaning('thin dashed', 'posterior'),
    d: around(later, smoothed, smoothedTwoSigma),
  })
  pen.mark('path', 'smoothed', { ...meaning('thin', 'posterior'), d: seriesPath(plane, later, smoothed) })
}

/** @param {Pen} pen @param {Plane} plane @param {[number, number]} edges @param {Frame} frame */
function readings(pen, plane, edges, { sensors }) {
  for (const [i, { taken, off, used }] of sensors.entries()) {
    const all = taken.map((time, k) => /** @type {[number, number]} */ ([time, off[k]]))
    drawReadings(
      pen,
      `read-${SENSORS[i]}`,
      plane,
      edges,
      i,
      all.filter((_, k) => used[k]),
    )
  }
}

/** @param {Pen} pen @param {Plane} plane @param {number} height @param {Frame} frame */
function rows(pen, { x, box }, height, { sensors, end }) {
  const row = (
    /** @type {string} */ key,
    /** @type {number} */ up,
    /** @type {number[]} */ times,
    /** @type {string} */ name,
  ) => {
    const y = height - up
    const inside = times.filter((time) => time <= end)
    pen.mark('path', `row-${key}`, {
      ...meaning('lag', 'measurement'),
      d: inside.map((time) => `M${x(time).toFixed(1)} ${y - 5}v10`).join(''),
    })
    pen.text(`row-name-${key}`, { class: 'tick', x: box.left - 6, y: y + 4, 'text-anchor': 'end' }, name)
  }
  row('sonar', ROWS.sonar, sensors[0].measured, 'sonar')
  row('laser', ROWS.laser, sensors[1].measured, 'laser')
  const camera = sensors[CAMERA]
  row('measured', ROWS.measured, camera.measured, 'camera')
  row('came', ROWS.came, camera.came, 'it came')
  const way = (/** @type {number} */ measured, /** @type {number} */ i) =>
    `M${x(measured).toFixed(1)} ${height - ROWS.measured + 5}L${x(camera.came[i]).toFixed(1)} ${height - ROWS.came - 5}`
  pen.mark('path', 'ways', { ...meaning('thin', 'measurement'), d: camera.measured.map(way).join('') })
}

/** @param {Pen} pen @param {Plane} plane @param {import('../../draw/plot.js').Box} plot @param {Frame} frame */
function names(pen, { x, y }, plot, { time, error, smoothed, sensors, params, gap }) {
  const within = (/** @type {number} */ value) => Math.max(plot.top + 8, Math.min(plot.bottom - 8, y(value)))
  const at = Math.round(time.length * 0.86)
  /** @type {import('../../draw/labels.js').Label[]} */
  const labels = [
    {
      key: 'estimate-name',
      words: 'estimate',
      at: [x(time[at]), within(error[at])],
      kin: 'posterior',
      sides: ['below'],
    },
    { key: 'truth-name', words: 'truth', at: [x(0.6), y(0)], kin: 'truth', sides: ['above-right', 'below-right'] },
  ]
  const camera = sensors[CAMERA]
  if (camera.used.some(Boolean)) {
    const i = Math.floor(camera.used.length * 0.35)
    labels.push({
      key: 'camera-name',
      words: params.way === 'as-new' && params.delay > 0 ? 'camera, as if new' : 'camera',
      at: [x(camera.taken[i]), within(camera.off[i])],
      kin: 'measurement',
      sides: ['below', 'above'],
    })
  }
  if (smoothed.length > 0) {
    const i = Math.round(smoothed.length * (gap ? (gap.from + gap.to) / 2 / time[time.length - 1] : 0.6))
    labels.push({
      key: 'smoothed-name',
      words: 'afterwards',
      at: [x(time[Math.min(i, smoothed.length - 1) + 1]), within(smoothed[Math.min(i, smoothed.length - 1)])],
      kin: 'posterior',
      sides: ['above', 'below'],
    })
  }
  drawLabels(pen, plot, labels, [])
}
