/**
 * The plane of position and velocity, one scale on both axes: here a right angle looks like one. Prediction, the two
 * axes of its ellipse and the reading are handles; so are the reader's guess and the radius of the ellipse that grows.
 * While the answer is sealed, nothing that gives it away is drawn.
 */

import { along, clear, drawLabels } from '../../draw/labels.js'
import { handlesOf, within } from './handles.js'
import {
  axes,
  clipLine,
  dot,
  ellipseLevel,
  ellipsePath,
  ellipsePoints,
  evenPlane,
  meaning,
  segment,
} from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** The middle of the axes, and how far they reach from it: the first that is far enough. */
const CENTRE = /** @type {[number, number]} */ ([3.7, 3.7])
const REACHES = [3, 4.5, 6, 9, 12, 18]

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawPlane({ pen, width, height }, frame, view) {
  const box = { left: 44, top: 30, right: width - 14, bottom: height - 42 }
  const short = Math.min(box.right - box.left, box.bottom - box.top)
  const shape = [(box.right - box.left) / short, (box.bottom - box.top) / short]
  if (!pen.held) view.memory.reach = reachOf(frame, shape)
  const plane = evenPlane(box, CENTRE, view.memory.reach)
  pen.draw(() => {
    axes(pen, plane, { x: 'position (m)', y: 'velocity (m/s)', ticks: [6, 6] })
    pen.window('scene', box, (to) => drawScene(to, plane, frame))
    const grips = handlesOf(plane, frame, view)
    names(pen, plane, frame, grips)
    ellipseLevel(pen, box.left, box.bottom + 32)
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(grips)) view.handle(to, key, { ...grip, name: undefined })
    })
  })
}

/** The ellipses of equal probability that lead to the touching one, as parts of it. @param {Frame} frame */
const levels = ({ params: { radius, sealed } }) => (radius > 0 || sealed ? [] : [1 / 3, 2 / 3, 1])

/** How far the axes reach from their middle: as far as prediction and line. With the ellipse, a prediction that End
 * takes to the edge would be taken farther by the next.
 * @param {Frame} frame @param {number[]} shape how much longer than the shorter one each axis is */
function reachOf({ params, euclideanFoot }, shape) {
  const points = [params.mean, euclideanFoot.at]
  const far = Math.max(...points.flatMap((at) => at.map((value, i) => Math.abs(value - CENTRE[i]) / shape[i])))
  // A little farther, so that nothing of a handle lies beyond the edge.
  return REACHES.find((reach) => reach >= 1.02 * far) ?? 1.02 * far
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawScene(pen, plane, frame) {
  const { mean, reading } = frame.params
  const { euclideanFoot: gray, mahalanobisFoot: purple, update, predicted, posterior } = frame
  const { sealed, radius } = frame.params
  const lines = { ...(sealed ? {} : { likely: ['line dashed', frame.mostLikelyOutput] }), omega: ['line', reading] }
  for (const [key, [shape, output]] of Object.entries(lines)) {
    const ends = clipLine(frame.H, /** @type {number} */ (output), plane)
    if (ends) segment(pen, key, plane, ...ends, meaning(/** @type {string} */ (shape), 'measurement'))
  }
  pen.mark('path', 'predicted', { ...meaning('outline', 'prediction'), d: ellipsePath(predicted.ellipse, mean, plane) })
  // Ellipses of equal probability grow until one touches the line, and that is where the purple foot stands. The reader
  // may let one grow instead.
  if (radius > 0)
    pen.mark('path', 'grown', {
      ...meaning('curve', 'prediction'),
      d: ellipsePath(predicted.ellipse, mean, plane, radius),
    })
  for (const part of levels(frame)) {
    pen.mark('path', `equal${part}`, {
      ...meaning(part === 1 ? 'curve' : 'curve thin', 'prediction'),
      d: ellipsePath(purple.ellipse, mean, plane, part),
    })
  }
  if (!sealed)
    pen.mark('path', 'posterior', {
      ...meaning('outline', 'posterior'),
      d: ellipsePath(posterior.ellipse, posterior.x, plane),
    })
  if (sealed) return
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
  pen.mark('path', 'corner', {
    ...meaning('way', 'truth'),
    d: `M${px + ux} ${py + uy}L${px + ux + vx} ${py + uy + vy}L${px + vx} ${py + vy}`,
  })
}

/**
 * The name of a handle.
 * @param {[string, import('../../figure/spec.js').HandleSpec]} grip
 * @returns {import('../../draw/labels.js').Label}
 */
function ofGrip([key, { at, name = '', kin }]) {
  return {
    key: `${key}-name`,
    words: name,
    at,
    kin,
    name: `handle-name ${kin}`,
    gap: 15,
    sides: ['right', 'above-right'],
  }
}

/**
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {Frame} frame
 * @param {Record<string, import('../../figure/spec.js').HandleSpec>} grips
 */
function names(pen, plane, frame, grips) {
  const { box, x, y } = plane
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const lefter = frame.mahalanobisFoot.at[0] < frame.euclideanFoot.at[0]
  /** @type {import('../../draw/labels.js').Label[]} */
  const labels = Object.entries(grips)
    .filter(([key]) => key !== 'guess')
    .map(ofGrip)
  const { sealed } = frame.params
  const [gray, purple, update] = [frame.euclideanFoot, frame.mahalanobisFoot, frame.update].map((foot) => at(foot.at))
  const meet = (/** @type {number[]} */ one, /** @type {number[]} */ other) =>
    Math.hypot(one[0] - other[0], one[1] - other[1]) < 4
  // What is one point has one name; what lies outside the drawing has none in it.
  const one = meet(gray, purple)
  if (!sealed)
    labels.push(
      .../** @type {import('../../draw/labels.js').Label[]} */ ([
        {
          key: 'gray-name',
          words: !one ? 'gray foot' : meet(gray, update) ? 'both feet, update' : 'both feet',
          at: gray,
          kin: one ? 'posterior' : 'truth',
          sides: lefter ? ['below-right', 'right'] : ['below-left', 'left'],
        },
        {
          key: 'purple-name',
          words: 'purple foot',
          at: purple,
          kin: 'posterior',
          sides: lefter ? ['below-left', 'left'] : ['below-right', 'right'],
        },
        {
          key: 'update-name',
          words: 'update',
          at: update,
          kin: 'posterior',
          sides: lefter ? ['above-left', 'left'] : ['above-right', 'right'],
        },
      ]).filter((label, i) => within(label.at, box) && !(one && (i === 1 || (i === 2 && meet(gray, update))))),
    )
  // A guess is put near the feet, whose names keep their places.
  if (grips.guess) labels.push(ofGrip(['guess', grips.guess]))
  const line = (
    /** @type {string} */ key,
    /** @type {number} */ output,
    /** @type {import('../../draw/words.js').Words} */ words,
    /** @type {boolean} */ over,
    place = 0.93,
  ) => {
    const ends = clipLine(frame.H, output, plane)
    if (!ends) return
    const [from, to] = ends[0][0] <= ends[1][0] ? ends : [ends[1], ends[0]]
    const mark = from.map((value, i) => value + place * (to[i] - value))
    // Beside a steep line there is room, above its end there is none.
    const steep = Math.abs(x(to[0]) - x(from[0])) < Math.abs(y(to[1]) - y(from[1]))
    const [beside, along] = [
      over ? ['right', 'left'] : ['left', 'right'],
      over ? ['above', 'above-right', 'above-left'] : ['below', 'below-right', 'below-left'],
    ]
    labels.push({
      key,
      words,
      at: at(mark),
      gap: 5,
      kin: 'measurement',
      sides: /** @type {import('../../draw/labels.js').Side[]} */ (steep ? beside : along),
    })
  }
  const upper = frame.params.reading > frame.mostLikelyOutput
  // On a phone the equation has no room beside the foot's name and would lie on both lines.
  const narrow = box.right - box.left < 360
  line('omega-name', frame.params.reading, narrow ? 'Ω' : 'Ω: {H}*x* = {y}', upper, narrow ? 0.84 : 0.93)
  if (frame.params.noise > 0 && !sealed) line('likely-name', frame.mostLikelyOutput, 'Ω^{∗}', !upper)
  const marks = [frame.euclideanFoot.at, ...(sealed ? [] : [frame.mahalanobisFoot.at, frame.update.at])].map((place) =>
    clear(at(place), 4),
  )
  const { predicted, posterior, mahalanobisFoot, params } = frame
  const outlines = [
    ...ellipsePoints(predicted.ellipse, params.mean, plane),
    ...levels(frame).flatMap((part) => ellipsePoints(mahalanobisFoot.ellipse, params.mean, plane, part)),
    ...(sealed ? [] : ellipsePoints(posterior.ellipse, posterior.x, plane)),
  ]
  drawLabels(pen, box, labels, [
    ...marks,
    ...along(outlines),
    ...Object.values(grips).map((grip) => clear(grip.at, 11)),
  ])
}
