/**
 * The lawn from above, with the beacons, the three tracks, and a timeline by which the reader goes to a moment of the
 * drive.
 */

import { followed } from '../../draw/camera.js'
import { drawLabels, clear } from '../../draw/labels.js'
import { decimal } from '../../draw/numbers.js'
import { dot, ellipseLevel, ellipsePath, halves, meaning, scaleBar, segment, seriesPath } from '../../draw/plot.js'
import { scaleLinear } from '../../draw/scale.js'
import { landmarkName, looksOf, touchedIn } from './looks.js'
import { clock, listens } from './words.js'

/** @typedef {import('./looks.js').Frame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** The room of the timeline, and of the scale bar above it, pixels. */
const TIMELINE = 46
const FOOT = 20
/** How long a sighting's line stays, seconds of the log. */
const FLASH = 1.5
const NOSE = 15
/** How far from the start the handle of its heading is, pixels. */
const HEADING = 42

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
    drawStart(pen, plane, frame, view)
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
function seen(frame, axis) {
  const { landmarks, tracks, estimate, ellipse } = frame
  const at = axis ? 'y' : 'x'
  const fixed = [...landmarks.map((landmark) => landmark[at]), ...tracks.truth[at]]
  const extent = fixed.reduce(
    ([low, high], value) => [Math.min(low, value), Math.max(high, value)],
    [estimate[axis], estimate[axis]],
  )
  const half = 1 + Math.min(halves(ellipse)[axis], (extent[1] - extent[0]) / 2)
  // At the beginning of the time line the start is dragged against what was kept.
  const { kept } = looksOf(frame)
  return [
    ...(kept ? [kept.tracks.estimate[at], kept.fixes[at]] : []),
    [estimate[axis] - half, estimate[axis] + half],
    landmarks.map((landmark) => landmark[at]),
    ...Object.values(tracks).map((track) => track[at]),
  ]
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawTracks(pen, plane, frame) {
  const { tracks, ellipse, estimate, fixes, smoothed } = frame
  if (fixes.x.length > 0)
    pen.mark('path', 'fixes', { ...meaning('track fine', 'measurement'), d: crosses(plane, fixes) })
  const track = (
    /** @type {string} */ key,
    /** @type {string} */ shape,
    /** @type {import('../../draw/plot.js').Kin} */ kin,
    /** @type {{ x: number[], y: number[] }} */ { x, y },
  ) => pen.mark('path', `${key}-track`, { ...meaning(shape, kin), d: seriesPath(plane, x, y) })
  track('truth', 'track fine', 'truth', tracks.truth)
  track('reckoning', 'track fine dashed', 'prediction', tracks.reckoning)
  const { kept } = looksOf(frame)
  if (kept)
    pen.group('kept', { class: 'pale' }, (to) => {
      to.mark('path', 'fixes', { ...meaning('track fine', 'measurement'), d: crosses(plane, kept.fixes) })
      to.mark('path', 'estimate-track', {
        ...meaning('track fine', kinOf(kept)),
        d: seriesPath(plane, kept.tracks.estimate.x, kept.tracks.estimate.y),
      })
    })
  if (listens(frame)) track('estimate', 'track fine', 'posterior', tracks.estimate)
  if (smoothed) track('smoothed', 'track fine dotted', 'posterior', smoothed)
  pen.mark('path', 'ellipse', { ...meaning('outline', kinOf(frame)), d: ellipsePath(ellipse, estimate, plane) })
}

/** A cross at each fix. @param {Plane} plane @param {{ x: number[], y: number[] }} places */
function crosses(plane, { x, y }) {
  const at = x.map((east, i) => [plane.x(east).toFixed(1), plane.y(y[i]).toFixed(1)])
  return at.map(([px, py]) => `M${px} ${py}m-2 0h4m-2-2v4`).join('')
}

/** @param {Frame} frame @returns {import('../../draw/plot.js').Kin} */
function kinOf(frame) {
  return listens(frame) ? 'posterior' : 'prediction'
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
function drawRobots(pen, plane, frame) {
  const { truth, estimate, innovations } = frame
  const kin = kinOf(frame)
  const touched = touchedIn(frame)
  if (touched >= 0) {
    const place = /** @type {[number, number]} */ ([innovations.x[touched], innovations.y[touched]])
    const landmark = frame.landmarks.find(({ id }) => id === innovations.landmark[touched])
    const line = meaning(innovations.used[touched] ? 'line' : 'line dashed', 'measurement')
    if (landmark) segment(pen, 'touched-sight', plane, place, [landmark.x, landmark.y], line)
    dot(pen, 'touched', plane, place, { ...meaning('hollow', 'measurement'), r: 9 })
  }
  if (truth) dot(pen, 'truth-body', plane, truth, { ...meaning('hollow', 'truth'), r: 6 })
  const [x, y] = [plane.x(estimate[0]), plane.y(estimate[1])]
  pen.mark('line', 'estimate-nose', {
    ...meaning('line', kin),
    x1: x,
    y1: y,
    x2: x + NOSE * Math.cos(estimate[2]),
    y2: y - NOSE * Math.sin(estimate[2]),
  })
  dot(pen, 'estimate-body', plane, estimate, { ...meaning(listens(frame) ? 'full' : 'hollow', kin), r: 6 })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, { x, y, box }, frame) {
  const { landmarks, truth, estimate } = frame
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const beacons = landmarks.map((landmark) => at([landmark.x, landmark.y]))
  const names = [
    {
      key: 'estimate-name',
      words: listens(frame) ? 'estimate' : 'dead reckoning',
      at: at(estimate),
      kin: kinOf(frame),
      gap: 18,
    },
  ]
  if (truth) names.push({ key: 'truth-name', words: 'truth', at: at(truth), kin: 'truth', gap: 13 })
  // A figure's few beacons have names; of a long list the names would hide the map.
  const few =
    landmarks.length <= 12
      ? landmarks.map(({ id }, i) => ({
          key: `landmark-name${id}`,
          words: shortly(landmarkName(frame, id)),
          at: beacons[i],
          name: 'label',
          gap: 8,
        }))
      : []
  drawLabels(pen, box, [...names, ...few], [...beacons.map((beacon) => clear(beacon, 5)), clear(at(estimate), 8)])
}

/** The beginning of a long name. @param {string} name */
const shortly = (name) => (name.length > 16 ? `${name.slice(0, 15)}…` : name)

/**
 * The start, which a reader moves where no truth says it: its place, and its heading at the end of a line.
 * @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view
 */
function drawStart(pen, plane, { step, params, tracks }, view) {
  if (step > 0 || tracks.truth.x.length > 0) return
  const [x, y, theta] = params.start ?? [0, 0, 0]
  const [px, py] = [plane.x(x), plane.y(y)]
  const tip = /** @type {[number, number]} */ ([px + HEADING * Math.cos(theta), py - HEADING * Math.sin(theta)])
  /** @param {number[]} start */
  const to = (start) => ({ start: start.map((value) => Number(value.toFixed(4))) })
  pen.mark('line', 'start-heading', { class: 'axis', x1: px, y1: py, x2: tip[0], y2: tip[1] })
  pen.group('start', {}, (into) => {
    view.handle(into, 'start-place', {
      at: [px, py],
      label: 'Start of the filter',
      value: `x ${decimal(x)} m, y ${decimal(y)} m`,
      move: (mx, my) => to([plane.x.invert(mx), plane.y.invert(my), theta]),
      nudge: (dx, dy) => to([x + dx / 10, y + dy / 10, theta]),
    })
    view.handle(into, 'start-heading', {
      at: tip,
      small: true,
      label: 'Heading at the start',
      value: `${((theta * 180) / Math.PI).toFixed(0)}°`,
      move: (mx, my) => to([x, y, Math.atan2(py - my, mx - px)]),
      nudge: (dx, dy) => to([x, y, theta + ((dy || -dx) * Math.PI) / 90]),
    })
  })
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
