/**
 * The lawn from above, with the beacons, the three tracks, and a timeline by which the reader goes to a moment of the
 * drive.
 */

import { followed } from '../../draw/camera.js'
import { drawLabels, clear } from '../../draw/labels.js'
import { dot, ellipseLevel, ellipsePath, halves, meaning, scaleBar, segment, seriesPath } from '../../draw/plot.js'
import { scaleLinear } from '../../draw/scale.js'
import { clock } from './words.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** The room of the timeline, and of the scale bar above it, pixels. */
const TIMELINE = 46
const FOOT = 20
/** How long a sighting's line stays, seconds of the log. */
const FLASH = 1.5
const NOSE = 15

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 0, top: 0, right: width, bottom: height - TIMELINE }
  const { plane, moving } = followed(view, { ...box, bottom: box.bottom - FOOT }, (axis) => seen(frame, axis))
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      drawTracks(to, plane, frame)
      drawBeacons(to, plane, frame)
      drawRobots(to, plane, frame)
    })
    drawNames(pen, plane, frame)
    ellipseLevel(pen, box.left + 6, box.bottom - 6)
    scaleBar(pen, plane, box.right - 6, box.bottom - 6)
    drawTimeline(pen, { left: 12, right: width - 12, at: height - 26 }, frame, view)
  })
  return moving
}

/**
 * What has to be seen: the landmarks, the tracks, and the robot with its ellipse, but of an ellipse that grows without
 * end no more than half of what the landmarks and the true track take.
 * @param {Frame} frame @param {number} axis
 */
function seen({ landmarks, tracks, estimate, ellipse }, axis) {
  const at = axis ? 'y' : 'x'
  const fixed = [...landmarks.map((landmark) => landmark[at]), ...tracks.truth[at]]
  const extent = fixed.reduce(
    ([low, high], value) => [Math.min(low, value), Math.max(high, value)],
    [estimate[axis], estimate[axis]],
  )
  const half = 1 + Math.min(halves(ellipse)[axis], (extent[1] - extent[0]) / 2)
  return [
    [estimate[axis] - half, estimate[axis] + half],
    landmarks.map((landmark) => landmark[at]),
    ...Object.values(tracks).map((track) => track[at]),
  ]
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawTracks(pen, plane, { tracks, params, ellipse, estimate }) {
  const track = (
    /** @type {string} */ key,
    /** @type {string} */ shape,
    /** @type {import('../../draw/plot.js').Kin} */ kin,
    /** @type {{ x: number[], y: number[] }} */ { x, y },
  ) => pen.mark('path', `${key}-track`, { ...meaning(shape, kin), d: seriesPath(plane, x, y) })
  track('truth', 'track fine', 'truth', tracks.truth)
  track('reckoning', 'track fine dashed', 'prediction', tracks.reckoning)
  if (params.sightings) track('estimate', 'track fine', 'posterior', tracks.estimate)
  pen.mark('path', 'ellipse', { ...meaning('outline', kinOf(params)), d: ellipsePath(ellipse, estimate, plane) })
}

/** @param {Frame['params']} params @returns {import('../../draw/plot.js').Kin} */
function kinOf({ sightings }) {
  return sightings ? 'posterior' : 'prediction'
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawBeacons(pen, plane, { landmarks, sighting, time }) {
  if (sighting && time - sighting.time < FLASH) {
    segment(
      pen,
      'sight',
      plane,
      sighting.from,
      sighting.at,
      meaning(sighting.used ? 'line' : 'line dashed', 'measurement'),
    )
  }
  for (const { id, x, y } of landmarks) {
    pen.mark('rect', `landmark${id}`, { class: 'corner', x: plane.x(x) - 4, y: plane.y(y) - 4, width: 8, height: 8 })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawRobots(pen, plane, { truth, estimate, params }) {
  const kin = kinOf(params)
  if (truth) dot(pen, 'truth-body', plane, truth, { ...meaning('hollow', 'truth'), r: 6 })
  const [x, y] = [plane.x(estimate[0]), plane.y(estimate[1])]
  pen.mark('line', 'estimate-nose', {
    ...meaning('line', kin),
    x1: x,
    y1: y,
    x2: x + NOSE * Math.cos(estimate[2]),
    y2: y - NOSE * Math.sin(estimate[2]),
  })
  dot(pen, 'estimate-body', plane, estimate, { ...meaning(params.sightings ? 'full' : 'hollow', kin), r: 6 })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, { x, y, box }, { landmarks, truth, estimate, params }) {
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const beacons = landmarks.map((landmark) => at([landmark.x, landmark.y]))
  const names = [
    {
      key: 'estimate-name',
      words: params.sightings ? 'estimate' : 'dead reckoning',
      at: at(estimate),
      kin: kinOf(params),
      gap: 18,
    },
  ]
  if (truth) names.push({ key: 'truth-name', words: 'truth', at: at(truth), kin: 'truth', gap: 13 })
  // A figure's few beacons have names; of a long list the names would hide the map.
  const few =
    landmarks.length <= 12
      ? landmarks.map(({ id }, i) => ({
          key: `landmark-name${id}`,
          words: String(id),
          at: beacons[i],
          name: 'label',
          gap: 8,
        }))
      : []
  drawLabels(pen, box, [...names, ...few], [...beacons.map((beacon) => clear(beacon, 5)), clear(at(estimate), 8)])
}

/**
 * @param {Pen} pen
 * @param {{ left: number, right: number, at: number }} place
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
function drawTimeline(pen, { left, right, at }, frame, view) {
  const {
    timeline: { time, step },
    duration,
    rows,
  } = frame
  const x = scaleLinear([0, duration || 1], [left, right])
  const now = x(frame.time)
  pen.mark('line', 'timeline', { class: 'axis', x1: left, x2: right, y1: at, y2: at })
  pen.mark('line', 'timeline-past', { class: 'timeline-past', x1: left, x2: now, y1: at, y2: at })
  pen.text('timeline-end', { class: 'tick', x: right, y: at + 22, 'text-anchor': 'end' }, clock(duration))
  pen.text('timeline-start', { class: 'tick', x: left, y: at + 22 }, `${clock(frame.time)} driven`)
  const index = (/** @type {number} */ wanted) => {
    const found = time.findIndex((other) => other >= wanted)
    return found < 0 ? time.length - 1 : found
  }
  const here = step.findIndex((other) => other >= frame.step)
  const to = (/** @type {number} */ i) => ({ step: i < 0 ? 0 : step[Math.min(step.length - 1, i)] })
  pen.group('handles', {}, (into) =>
    view.handle(into, 'time', {
      at: [now, at],
      small: true,
      label: 'Time of the drive',
      value: `${clock(frame.time)} of ${clock(duration)}`,
      now: frame.step,
      min: 0,
      max: rows,
      move: (px) => (px <= left ? { step: 0 } : to(index(x.invert(px)))),
      nudge: (dx, dy) => to((here < 0 ? step.length - 1 : here) + (dx || dy)),
      jump: (end) => ({ step: end === 'home' ? 0 : rows }),
    }),
  )
}
