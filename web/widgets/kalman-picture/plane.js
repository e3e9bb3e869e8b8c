/**
 * The plane of position and velocity, one scale on both axes: here a right angle looks like one. Prediction, the two axes
 * of its ellipse and the reading are handles.
 */

import { axes, clipLine, dot, ellipseLevel, ellipsePath, evenPlane, meaning, segment } from '../../core/plot.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */
/** @typedef {import('../../core/pen.js').Pen} Pen */
/** @typedef {import('../../core/plot.js').Plane} Plane */

const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) => Math.max(low, Math.min(high, value))

/**
 * @param {import('../../core/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../core/spec.js').View} view
 */
export function drawPlane({ pen, width, height }, frame, view) {
  const box = { left: 44, top: 30, right: width - 14, bottom: height - 42 }
  const plane = evenPlane(box, [3.7, 3.7], 3)
  pen.draw(() => {
    axes(pen, plane, { x: 'position (m)', y: 'velocity (m/s)', ticks: [6, 6] })
    pen.window('scene', box, (to) => drawScene(to, plane, frame))
    names(pen, plane, frame)
    ellipseLevel(pen, box.left, box.bottom + 32)
    pen.group('handles', {}, (to) => handles(to, plane, frame, view))
  })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawScene(pen, plane, frame) {
  const { mean, reading } = frame.params
  const { euclideanFoot: gray, mahalanobisFoot: purple, update, predicted, posterior } = frame
  const lines = { likely: ['line dashed', frame.mostLikelyOutput], omega: ['line', reading] }
  for (const [key, [shape, output]] of Object.entries(lines)) {
    const ends = clipLine(frame.H, /** @type {number} */ (output), plane)
    if (ends) segment(pen, key, plane, ...ends, meaning(/** @type {string} */ (shape), 'measurement'))
  }
  pen.mark('path', 'predicted', { ...meaning('outline', 'prediction'), d: ellipsePath(predicted.ellipse, mean, plane) })
  // Ellipses of equal probability grow until one touches the line, and that is where the purple foot stands.
  for (const part of [1 / 3, 2 / 3, 1]) {
    pen.mark('path', `equal${part}`, { ...meaning(part === 1 ? 'curve' : 'curve thin', 'prediction'), d: ellipsePath(purple.ellipse, mean, plane, part) })
  }
  pen.mark('path', 'posterior', { ...meaning('outline', 'posterior'), d: ellipsePath(posterior.ellipse, posterior.x, plane) })
  segment(pen, 'gray', plane, mean, gray.at, meaning('way dashed', 'truth'))
  segment(pen, 'purple', plane, mean, purple.at, meaning('way', 'posterior'))
  squareCorner(pen, plane, frame)
  dot(pen, 'gray-foot', plane, gray.at, { ...meaning('foot', 'truth'), r: 4 })
  dot(pen, 'purple-foot', plane, purple.at, { ...meaning('foot', 'posterior'), r: 4 })
  dot(pen, 'update', plane, update.at, meaning('full', 'posterior'))
}

/** The mark of a right angle at the gray foot. @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function squareCorner(pen, { x, y }, { params, euclideanFoot, H, along }) {
  const [px, py] = [x(euclideanFoot.at[0]), y(euclideanFoot.at[1])]
  const back = Math.sign(params.mean[0] * H[0] + params.mean[1] * H[1] - params.reading) || 1
  const [ux, uy, vx, vy] = [9 * along[0], -9 * along[1], 9 * back * H[0], -9 * back * H[1]]
  pen.mark('path', 'corner', { ...meaning('way', 'truth'), d: `M${px + ux} ${py + uy}L${px + ux + vx} ${py + uy + vy}L${px + vx} ${py + vy}` })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function names(pen, plane, frame) {
  const { box, x, y } = plane
  const beside = (/** @type {string} */ key, /** @type {number[]} */ at, /** @type {string} */ kin, /** @type {import('../../core/words.js').Words} */ words, dx = 9, dy = 16) =>
    pen.text(key, { class: `mark-name ${kin}`, x: clamp(x(at[0]) + dx, box.left + 4, box.right - 60), y: clamp(y(at[1]) + dy, box.top + 12, box.bottom - 6) }, words)
  const lefter = frame.mahalanobisFoot.at[0] < frame.euclideanFoot.at[0]
  beside('gray-name', frame.euclideanFoot.at, 'truth', 'gray foot', lefter ? 10 : -66, 18)
  beside('purple-name', frame.mahalanobisFoot.at, 'posterior', 'purple foot', lefter ? -84 : 10, 18)
  beside('update-name', frame.update.at, 'posterior', 'update', lefter ? -56 : 10, -8)
  const upper = frame.params.reading > frame.mostLikelyOutput ? -1 : 1
  const line = (/** @type {string} */ key, /** @type {number} */ output, /** @type {import('../../core/words.js').Words} */ words, /** @type {number} */ side) => {
    const end = clipLine(frame.H, output, plane)?.reduce((a, b) => (b[0] > a[0] ? b : a))
    if (end) pen.text(key, { class: 'mark-name measurement', x: clamp(x(end[0]) - 6, box.left + 70, box.right - 6), y: clamp(y(end[1]) + (side > 0 ? 15 : -7), box.top + 14, box.bottom - 6), 'text-anchor': 'end' }, words)
  }
  line('omega-name', frame.params.reading, { choset: 'Ω: *Hx* = *y*', thrun: 'Ω: *Cx* = *z*' }, upper)
  if (frame.params.noise > 0) line('likely-name', frame.mostLikelyOutput, 'Ω^{∗}', -upper)
}

/** A place on the reading's line to hold it by; where no part of the line is in the drawing, the one nearest to its middle.
 * @param {Plane} plane @param {Frame} frame */
function onLine(plane, { H, params: { reading } }) {
  const ends = clipLine(H, reading, plane)
  if (ends) {
    const [from, to] = ends[0][0] <= ends[1][0] ? ends : [ends[1], ends[0]]
    return from.map((value, i) => value + 0.12 * (to[i] - value))
  }
  const { box, x, y } = plane
  const middle = [x.invert((box.left + box.right) / 2), y.invert((box.top + box.bottom) / 2)]
  const away = reading - H[0] * middle[0] - H[1] * middle[1]
  return middle.map((value, i) => value + away * H[i])
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {import('../../core/spec.js').View} view */
function handles(pen, plane, frame, view) {
  const { box, x, y } = plane
  const { mean, semiMajor, semiMinor, angle, reading } = frame.params
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  const words = (/** @type {number} */ value) => value.toFixed(2)
  const inside = (/** @type {number[]} */ [px, py]) => /** @type {[number, number]} */ ([clamp(px, box.left + 8, box.right - 8), clamp(py, box.top + 8, box.bottom - 8)])
  const data = (/** @type {number} */ px, /** @type {number} */ py) => {
    const at = inside([px, py])
    return [x.invert(at[0]), y.invert(at[1])]
  }
  const held = (/** @type {number[]} */ at) => data(x(at[0]), y(at[1]))
  const axis = view.limits.semiMajor
  const length = (/** @type {number} */ value) => clamp(value, axis.least, axis.greatest)

  view.handle(pen, 'mean', {
    at: [x(mean[0]), y(mean[1])], label: 'Prediction', name: 'prediction', kin: 'prediction',
    value: `at ${words(mean[0])} metres, ${words(mean[1])} metres a second`,
    now: mean[0], min: x.invert(box.left + 8), max: x.invert(box.right - 8),
    move: (px, py) => ({ mean: data(px, py) }),
    nudge: (dx, dy) => ({ mean: held([mean[0] + 0.05 * dx, mean[1] + 0.05 * dy]) }),
    jump: (end) => ({ mean: data(end === 'home' ? box.left : box.right, y(mean[1])) }),
  })
  view.handle(pen, 'major', {
    at: inside([x(mean[0] + semiMajor * c), y(mean[1] + semiMajor * s)]), label: 'First axis of the ellipse', name: 'turn, stretch', kin: 'prediction',
    value: `${words(semiMajor)} long, at ${Math.round((angle * 180) / Math.PI)} degrees`, now: semiMajor, min: axis.least, max: axis.greatest,
    move: (px, py) => {
      const [dx, dy] = [x.invert(px) - mean[0], y.invert(py) - mean[1]]
      return { semiMajor: length(Math.hypot(dx, dy)), angle: Math.atan2(dy, dx) }
    },
    nudge: (dx, dy) => ({ angle: angle + (dx * Math.PI) / 180, semiMajor: length(semiMajor + 0.05 * dy) }),
    jump: (end) => ({ semiMajor: end === 'home' ? axis.least : axis.greatest }),
  })
  view.handle(pen, 'minor', {
    at: inside([x(mean[0] - semiMinor * s), y(mean[1] + semiMinor * c)]), label: 'Second axis of the ellipse', name: 'stretch', kin: 'prediction',
    value: `${words(semiMinor)} long`, now: semiMinor, min: axis.least, max: axis.greatest,
    move: (px, py) => ({ semiMinor: length(Math.abs(-(x.invert(px) - mean[0]) * s + (y.invert(py) - mean[1]) * c)) }),
    nudge: (dx, dy) => ({ semiMinor: length(semiMinor + 0.05 * (dx + dy)) }),
    jump: (end) => ({ semiMinor: end === 'home' ? axis.least : axis.greatest }),
  })
  const at = onLine(plane, frame)
  const { least, greatest } = view.limits.reading
  const output = (/** @type {number[]} */ point) => clamp(frame.H[0] * point[0] + frame.H[1] * point[1], least, greatest)
  view.handle(pen, 'reading', {
    at: inside([x(at[0]), y(at[1])]), label: 'Reading', name: { choset: '*y*', thrun: '*z*' }, kin: 'measurement',
    value: words(reading), now: reading, min: least, max: greatest,
    move: (px, py) => ({ reading: output(data(px, py)) }),
    nudge: (dx, dy) => ({ reading: clamp(reading + 0.05 * (Math.abs(frame.H[1]) > 0.5 ? dy || dx : dx || dy), least, greatest) }),
    jump: (end) => ({ reading: end === 'home' ? least : greatest }),
  })
}
