/**
 * The phase plane, seen from the truth: where prediction, the reading's line and the estimate stand against the true
 * state. Both sensors measure along an axis, so each axis may have its own scale and the gray foot still looks square.
 */

import { Span, between } from '../../core/motion.js'
import { axes, clipLine, dot, ellipseLevel, ellipsePath, halves, meaning, plane as planeOf, segment } from '../../core/plot.js'

/** @typedef {import('estimate-wasm').BenchFrame} Frame */
/** @typedef {import('../../core/pen.js').Pen} Pen */
/** @typedef {import('../../core/plot.js').Plane} Plane */

/**
 * @param {import('../../core/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../core/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawPhase({ pen, width, height }, frame, view) {
  const scene = stage(frame, view)
  const [across, up] = (view.memory.phase ??= [new Span(), new Span()])
  const moving = [across.follow(...scene.across, view.elapsed), up.follow(...scene.up, view.elapsed)].includes(true)
  const plane = planeOf({ left: 48, top: 30, right: width - 14, bottom: height - 42 }, across.now, up.now)
  pen.draw(() => {
    axes(pen, plane, { x: 'position − truth (m)', y: 'velocity − truth (m/s)', ticks: [7, 5], zero: true })
    pen.window('scene', plane.box, (to) => drawScene(to, plane, frame, scene))
    legend(pen, plane, frame, scene)
    ellipseLevel(pen, plane.box.left, plane.box.bottom + 32)
  })
  return moving
}

/**
 * What the panel shows at this moment of the step, relative to the truth.
 * @param {Frame} frame
 * @param {import('../../core/spec.js').View} view
 */
function stage(frame, { beat, previous }) {
  const from = (/** @type {Frame} */ at, /** @type {import('estimate-wasm').BenchBelief} */ belief) => ({
    x: belief.x.map((value, i) => value - at.truth[i]),
    ellipse: belief.ellipse,
  })
  const predicted = from(frame, frame.predicted)
  const posterior = from(frame, frame.posterior)
  const before = previous ? from(previous, previous.posterior) : predicted
  const orange = beat.name === 'predict' ? between(before, predicted, beat.t) : predicted
  const purple = beat.name === 'rest' ? posterior : beat.name === 'update' ? between(predicted, posterior, beat.t) : null
  const shown = purple ? [orange, purple] : [orange, before]
  const reach = (/** @type {0 | 1} */ axis, /** @type {number} */ least) => {
    const ends = shown.flatMap(({ x, ellipse }) => [x[axis] - halves(ellipse)[axis], x[axis] + halves(ellipse)[axis]])
    return /** @type {[number, number]} */ ([Math.min(-least, ...ends), Math.max(least, ...ends)])
  }
  return { orange, purple, across: reach(0, 0.5), up: reach(1, 0.25), reading: frame.feet !== null && beat.name !== 'predict' }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {ReturnType<typeof stage>} scene */
function drawScene(pen, plane, frame, { orange, purple, reading }) {
  const relative = (/** @type {number} */ output) => output - (frame.H[0] * frame.truth[0] + frame.H[1] * frame.truth[1])
  const { feet } = frame
  if (reading && feet && frame.reading !== null && frame.mostLikelyOutput !== null) {
    const omega = clipLine(frame.H, relative(frame.reading), plane)
    const likely = clipLine(frame.H, relative(frame.mostLikelyOutput), plane)
    if (likely) segment(pen, 'likely', plane, ...likely, meaning('line dashed', 'measurement'))
    if (omega) segment(pen, 'omega', plane, ...omega, meaning('line', 'measurement'))
  }
  pen.mark('path', 'predicted', { ...meaning('outline', 'prediction'), d: ellipsePath(orange.ellipse, orange.x, plane) })
  if (purple) pen.mark('path', 'posterior', { ...meaning('outline', 'posterior'), d: ellipsePath(purple.ellipse, purple.x, plane) })
  if (reading && feet) {
    const foot = (/** @type {number[]} */ at) => at.map((value, i) => value - frame.truth[i])
    segment(pen, 'euclid', plane, orange.x, foot(feet.euclidean), meaning('way dashed', 'truth'))
    segment(pen, 'mahalanobis', plane, orange.x, foot(feet.mahalanobis), meaning('way', 'posterior'))
    dot(pen, 'foot-euclid', plane, foot(feet.euclidean), { ...meaning('foot', 'truth'), r: 3.5 })
    dot(pen, 'foot-mahalanobis', plane, foot(feet.mahalanobis), { ...meaning('foot', 'posterior'), r: 3.5 })
  }
  const [x, y] = [plane.x(0), plane.y(0)]
  pen.mark('path', 'truth', { ...meaning('cross', 'truth'), d: `M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}` })
  dot(pen, 'prediction-mean', plane, orange.x, meaning('hollow', 'prediction'))
  if (purple) dot(pen, 'posterior-mean', plane, purple.x, meaning('full', 'posterior'))
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {ReturnType<typeof stage>} scene */
function legend(pen, { box, x, y }, frame, { orange, purple, reading }) {
  const clamp = (/** @type {number} */ at, /** @type {number} */ low, /** @type {number} */ high) => Math.max(low, Math.min(high, at))
  pen.text('truth-name', { class: 'mark-name truth', x: x(0) + 10, y: y(0) + 16 }, 'truth')
  const beside = (/** @type {string} */ key, /** @type {number[]} */ at, /** @type {string} */ kin, /** @type {string} */ words, /** @type {number} */ side) => {
    const px = clamp(x(at[0]) + side * 11, box.left + (side < 0 ? 70 : 8), box.right - (side < 0 ? 8 : 70))
    pen.text(key, { class: `mark-name ${kin}`, x: px, y: clamp(y(at[1]) + 4.5, box.top + 12, box.bottom - 6), 'text-anchor': side < 0 ? 'end' : 'start' }, words)
  }
  const side = purple && purple.x[0] < orange.x[0] ? 1 : -1
  beside('prediction-name', orange.x, 'prediction', 'prediction', side)
  if (purple) beside('posterior-name', purple.x, 'posterior', 'estimate', -side)
  if (!reading || frame.reading === null || frame.mostLikelyOutput === null) return
  const line = (/** @type {string} */ key, /** @type {number} */ output, /** @type {import('../../core/words.js').Words} */ words, /** @type {number} */ side) => {
    const at = output - (frame.H[0] * frame.truth[0] + frame.H[1] * frame.truth[1])
    const flat = frame.H[0] === 0
    const where = flat ? { x: box.right - 6, y: y(at / frame.H[1]) + side, 'text-anchor': 'end' } : { x: x(at / frame.H[0]) + (side < 0 ? 5 : -5), y: box.top + 14, 'text-anchor': side < 0 ? 'start' : 'end' }
    const within = flat ? where.y > box.top + 6 && where.y < box.bottom - 2 : where.x > box.left && where.x < box.right
    if (within) pen.text(key, { class: 'mark-name measurement', ...where }, words)
  }
  const upper = (frame.reading > frame.mostLikelyOutput) === (frame.H[0] === 0)
  line('omega-name', frame.reading, { choset: 'Ω: *Hx* = *y*', thrun: 'Ω: *Cx* = *z*' }, upper ? -6 : 14)
  line('likely-name', frame.mostLikelyOutput, 'Ω^{∗}', upper ? 14 : -6)
}
