/**
 * The phase plane, seen from the truth: where prediction, the reading's line and the estimate stand against the true
 * state. An arrow leads from the prediction to the estimate: the correction, which the knob makes longer or shorter.
 */

import { along, clear, drawLabels, widthOf } from '../../draw/labels.js'
import { Scale, between } from '../../figure/motion.js'
import {
  arrow,
  axes,
  clipLine,
  dot,
  ellipseLevel,
  ellipsePath,
  ellipsePoints,
  halves,
  meaning,
  plane as planeOf,
  segment,
} from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').BenchFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawPhase({ pen, width, height }, frame, view) {
  const scene = stage(frame, view)
  const held = (view.memory.phase ??= { scales: [new Scale(0.5), new Scale(0.25)], sensor: '' })
  /** @type {Scale[]} */
  const scales = held.scales
  // A run is one from its first step on; another sensor has another run. Where one axis comes back, both do: else what
  // is drawn would be flat.
  const small = scales.some((scale, i) => scale.isLoose(scene.reach[i]))
  const anew = small || frame.step === 0 || held.sensor !== frame.params.sensor
  held.sensor = frame.params.sensor
  const moving = scales.map((scale, i) => scale.follow(scene.reach[i], view.elapsed, anew)).includes(true)
  const [across, up] = scales.map(({ now }) => now)
  const plane = planeOf({ left: 48, top: 30, right: width - 14, bottom: height - 42 }, across, up)
  pen.draw(() => {
    axes(pen, plane, {
      x: 'position − truth (m)',
      y: 'velocity − truth (m/s)',
      ticks: [width < 420 ? 4 : 7, 5],
      zero: true,
    })
    pen.window('scene', plane.box, (to) => drawScene(to, plane, frame, scene))
    names(pen, plane, frame, scene)
    ellipseLevel(pen, plane.box.left, plane.box.bottom + 32)
  })
  return moving
}

/**
 * What the panel shows at this moment of the step, relative to the truth.
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
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
  // While the prediction moves the estimate of the step before stays where it was.
  const purple =
    beat.name === 'rest' ? posterior : beat.name === 'update' ? between(predicted, posterior, beat.t) : before
  // The pale ellipse of the first belief stands about the estimate of now: the eye compares the sizes.
  const first = { x: purple.x, ellipse: frame.first.ellipse }
  const reach = [0, 1].map((axis) => {
    const ends = [orange, purple, first].flatMap(({ x, ellipse }) =>
      [-1, 1].map((side) => x[axis] + side * halves(ellipse)[axis]),
    )
    return /** @type {[number, number]} */ ([Math.min(...ends), Math.max(...ends)])
  })
  const reading =
    beat.name === 'predict' || frame.reading === null
      ? null
      : frame.reading - (frame.H[0] * frame.truth[0] + frame.H[1] * frame.truth[1])
  return { orange, purple, first, corrects: beat.name !== 'predict', reach, reading }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {ReturnType<typeof stage>} scene */
function drawScene(pen, plane, frame, { orange, purple, first, corrects, reading }) {
  const line = reading === null ? null : clipLine(frame.H, reading, plane)
  if (line) segment(pen, 'omega', plane, ...line, meaning('line', 'measurement'))
  pen.mark('path', 'first', { ...meaning('curve was', 'posterior'), d: ellipsePath(first.ellipse, first.x, plane) })
  pen.mark('path', 'predicted', {
    ...meaning('outline', 'prediction'),
    d: ellipsePath(orange.ellipse, orange.x, plane),
  })
  pen.mark('path', 'posterior', { ...meaning('outline', 'posterior'), d: ellipsePath(purple.ellipse, purple.x, plane) })
  const [x, y] = [plane.x(0), plane.y(0)]
  pen.mark('path', 'truth', { ...meaning('cross', 'truth'), d: `M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}` })
  dot(pen, 'prediction-mean', plane, orange.x, meaning('hollow', 'prediction'))
  if (corrects) arrow(pen, 'correction', plane, orange.x, purple.x, 'posterior')
  dot(pen, 'posterior-mean', plane, purple.x, meaning('full', 'posterior'))
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {ReturnType<typeof stage>} scene */
function names(pen, plane, frame, { orange, purple, reading }) {
  const { box, x, y } = plane
  const outlines = [orange, purple].flatMap((belief) => ellipsePoints(belief.ellipse, belief.x, plane))
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const lefter = purple.x[0] < orange.x[0]
  /** @type {import('../../draw/labels.js').Label[]} */
  const labels = [
    {
      key: 'prediction-name',
      words: 'prediction',
      at: at(orange.x),
      kin: 'prediction',
      sides: lefter ? ['right', 'below'] : ['left', 'below'],
    },
    {
      key: 'posterior-name',
      words: 'estimate',
      at: at(purple.x),
      kin: 'posterior',
      sides: lefter ? ['left', 'above'] : ['right', 'above'],
    },
    { key: 'truth-name', words: 'truth', at: at([0, 0]), kin: 'truth', sides: ['below-right'] },
  ]
  if (reading !== null) {
    const flat = frame.H[0] === 0
    const words = 'Ω: {H}*x* = {y}'
    const half = widthOf(words) / 2
    const ends = /** @type {[number, number][]} */ (
      flat
        ? [box.right - half - 2, box.left + half + 4].map((px) => [px, y(reading / frame.H[1])])
        : [box.top + 10, box.bottom - 10].map((py) => [x(reading / frame.H[0]), py])
    )
    // At the end that is farther from the ellipses, unless the usual one is clear of them.
    const free = (/** @type {number[]} */ [px, py]) =>
      Math.min(
        ...outlines.map((point) =>
          Math.max(
            Math.abs(point[0] - px) - (flat ? half : 2 * half), //
            Math.abs(point[1] - py) - (flat ? 18 : 8),
          ),
        ),
      )
    const end = free(ends[0]) > 0 || free(ends[0]) >= free(ends[1]) ? ends[0] : ends[1]
    const within = end[0] > box.left && end[0] < box.right && end[1] > box.top && end[1] < box.bottom
    if (within)
      labels.push({
        key: 'omega-name',
        words,
        at: end,
        gap: 4,
        kin: 'measurement',
        sides: flat ? ['above', 'below'] : ['right', 'left'],
      })
  }
  const dots = [clear(at(orange.x), 5), clear(at(purple.x), 5), clear(at([0, 0]), 6)]
  drawLabels(pen, box, labels, [...dots, ...along(outlines)])
}
