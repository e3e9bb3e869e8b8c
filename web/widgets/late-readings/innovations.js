/** The innovations of each sensor as they were when its readings came, and what the filter expected of them. */

import { polyline } from '../../draw/path.js'
import { axes, meaning, plane as planeOf } from '../../draw/plot.js'
import { rounded } from '../../draw/scale.js'
import { empty } from '../../draw/statistics.js'
import { CAMERA, SENSORS, drawReadings } from './sensors.js'

/** @typedef {import('estimate-wasm').LateFrame} Frame */

/** @param {import('../../figure/shell.js').Panel} panel @param {Frame} frame */
export function drawInnovations({ pen, width, height }, frame) {
  const high = (height - 22) / SENSORS.length
  pen.draw(() =>
    SENSORS.forEach((name, i) =>
      pen.group(name, {}, (to) => {
        const box = { left: 46, top: i * high + 26, right: width - 30, bottom: (i + 1) * high }
        strip(to, frame, i, box, name, width)
      }),
    ),
  )
}

/**
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {Frame} frame
 * @param {number} i
 * @param {import('../../draw/plot.js').Box} box
 * @param {string} name
 * @param {number} width
 */
function strip(pen, { sensors, end, travelled, params }, i, box, name, width) {
  const { came, used, innovation, innovationSigma } = sensors[i]
  const times = came.filter((_, k) => used[k])
  const whole = i === CAMERA && params.way === 'as-new' ? travelled : 0
  const most = [...innovation, ...innovationSigma.map((sigma) => 2 * sigma), 1.2 * whole].reduce(
    (sum, value) => Math.max(sum, Math.abs(value)),
    0.2,
  )
  const plane = planeOf(box, [0, end], rounded(-most, most, 3))
  const last = i === SENSORS.length - 1
  const x = last
    ? plane.x
    : Object.assign((/** @type {number} */ value) => plane.x(value), plane.x, { ticks: () => [] })
  const title = i === 0 ? `{innov} (m) and ±2√*S*: ${name}` : name
  axes(pen, { ...plane, x }, { title, ticks: [5, 3], zero: true })
  if (last) pen.text('unit', { class: 'axis-name', x: width - 2, y: box.bottom + 15, 'text-anchor': 'end' }, 's')
  if (innovation.length === 0) return empty(pen, { ...plane }, 'no reading is used')
  const up = innovationSigma.map((sigma) => 2 * sigma)
  const all = [...up, ...up.map((value) => -value).reverse()]
  pen.window('between', box, (to) =>
    to.mark('path', 'band', {
      class: 'band',
      d: `${polyline(all.length, plane.x, [...times, ...[...times].reverse()], plane.y, all)}Z`,
    }),
  )
  if (whole > 0) {
    const y = plane.y(-whole)
    pen.mark('line', 'whole', { ...meaning('way dashed', 'truth'), x1: box.left, x2: box.right, y1: y, y2: y })
    pen.text('whole-name', { class: 'rule-name', x: box.right + 3, y: y + 4 }, '−*vτ*')
  }
  drawReadings(
    pen,
    'read',
    plane,
    [box.top, box.bottom],
    i,
    times.map((time, k) => [time, innovation[k]]),
  )
}
