/** The corridor from above: the map that the robot makes, its gates about the sightings it expects, and the truth. */

import { followed } from '../../draw/camera.js'
import { drawBuilding, drawRobot } from '../../draw/building.js'
import { along as outline, clear, drawLabels } from '../../draw/labels.js'
import {
  arrow,
  dot,
  ellipseLevel,
  ellipsePath,
  ellipsePoints,
  halves,
  meaning,
  scaleBar,
  segment,
  seriesPath,
} from '../../draw/plot.js'
import { ghosts } from './ghosts.js'
import { pairOf } from './pair.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** What the words below the map take of it, pixels. */
export const FOOT = 20
/** The closing step moves landmarks by centimetres: its arrows are drawn so many times as long. */
export const LONGER = 5

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 0, top: 0, right: width, bottom: height }
  const { plane, moving } = followed(view, { ...box, bottom: height - FOOT }, (axis) => seen(frame, axis))
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      to.group(
        'building',
        {},
        (into) => drawPlace(into, plane, frame),
        [width, height, ...plane.x.domain, ...plane.y.domain].join(' '),
      )
      drawTracks(to, plane, frame)
      drawBefore(to, plane, frame)
      drawLandmarks(to, plane, frame)
      drawPulls(to, plane, frame)
      drawSightings(to, plane, frame)
      drawRobots(to, plane, frame)
    })
    drawNames(pen, plane, frame)
    ellipseLevel(pen, box.left + 6, box.bottom - 6)
    scaleBar(pen, plane, box.right - 8, box.bottom - 6)
  })
  return moving
}

/**
 * What has to be seen: the true landmarks, the map, the estimate and what it sights.
 * @param {Frame} frame
 * @param {number} axis
 */
export function seen({ landmarks, map, estimate, sightings, tracks }, axis) {
  const at = axis ? 'y' : 'x'
  return [
    [estimate[axis] - 0.5, estimate[axis] + 0.5],
    sightings.map((sighting) => sighting.at[axis]),
    landmarks.map((landmark) => landmark[at]),
    map.landmarks.flatMap((landmark) => [-1, 1].map((side) => landmark[at] + side * halves(landmark.ellipse)[axis])),
    tracks.estimate[at],
  ]
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawPlace(pen, plane, { world, landmarks }) {
  const { x, y } = plane
  drawBuilding(pen, plane, world)
  for (const { id, x: cx, y: cy } of landmarks) {
    pen.mark('rect', `true${id}`, { ...meaning('hollow', 'truth'), x: x(cx) - 4, y: y(cy) - 4, width: 8, height: 8 })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawTracks(pen, plane, { tracks }) {
  pen.mark('path', 'truth-track', {
    ...meaning('track', 'truth'),
    d: seriesPath(plane, tracks.truth.x, tracks.truth.y),
  })
  pen.mark('path', 'estimate-track', {
    ...meaning('track', 'posterior'),
    d: seriesPath(plane, tracks.estimate.x, tracks.estimate.y),
  })
}

/**
 * The map: each landmark with its ellipse, a ghost with a cross.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {Frame} frame
 */
function drawLandmarks(pen, plane, frame) {
  const spooky = ghosts(frame)
  for (const { id, x, y, ellipse } of frame.map.landmarks) {
    pen.mark('path', `ellipse${id}`, { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, [x, y], plane) })
    const [px, py] = [plane.x(x), plane.y(y)]
    if (spooky.has(id))
      pen.mark('path', `ghost${id}`, { class: 'mark refused ghost', d: `M${px - 4} ${py - 4}l8 8m0-8l-8 8` })
    else dot(pen, `landmark${id}`, plane, [x, y], { ...meaning('full', 'posterior'), r: 3 })
  }
}

/** The map before the step that closes the loop, pale. @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawBefore(pen, plane, { pulls }) {
  for (const { id, from, ellipse } of pulls)
    pen.mark('path', `before${id}`, { ...meaning('outline was', 'posterior'), d: ellipsePath(ellipse, from, plane) })
}

/**
 * Where that step moves each landmark, and the pair of them whose cell is framed in the square.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {Frame} frame
 */
function drawPulls(pen, plane, frame) {
  const { pulls } = frame
  const pair = pairOf(frame)
  if (pair) segment(pen, 'pair', plane, pair.moved.to, pair.by.to, { class: 'mark pair' })
  for (const { id, from, to } of pulls) {
    const tip = to.map((value, i) => from[i] + LONGER * (value - from[i]))
    arrow(pen, `pull${id}`, plane, from, tip, 'posterior')
  }
}

/**
 * The gates of this step, and each sighting as a line from the predicted pose to where it puts its landmark.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {Frame} frame
 */
function drawSightings(pen, plane, { gates, sightings, predicted }) {
  for (const { id, x, y } of gates)
    pen.mark('path', `gate${id}`, { ...meaning('outline gate', 'prediction'), d: `${seriesPath(plane, x, y)}Z` })
  for (const [i, { at, outcome }] of sightings.entries()) {
    segment(
      pen,
      `sight${i}`,
      plane,
      predicted,
      at,
      meaning(outcome === 'rejected' ? 'line dashed' : 'line', 'measurement'),
    )
    dot(pen, `seen${i}`, plane, at, { ...meaning(outcome === 'founded' ? 'full' : 'hollow', 'measurement'), r: 4 })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawRobots(pen, plane, { truth, estimate, ellipse }) {
  pen.mark('path', 'ellipse', { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, estimate, plane) })
  drawRobot(pen, 'truth', plane, truth, 'hollow', 'truth')
  drawRobot(pen, 'estimate', plane, estimate, 'full', 'posterior')
}

/** What names keep clear of along a line. @param {[number, number]} from @param {[number, number]} to */
function along([x1, y1], [x2, y2]) {
  const parts = Math.ceil(Math.hypot(x2 - x1, y2 - y1) / 8)
  return Array.from({ length: parts }, (_, i) =>
    clear([x1 + ((x2 - x1) * (i + 0.5)) / parts, y1 + ((y2 - y1) * (i + 0.5)) / parts], 4),
  )
}

/**
 * The ellipses on the map: of the robot, of its landmarks, and of those that were tugged before that.
 * @param {Frame} frame
 */
export const ellipses = ({ estimate, ellipse, map, pulls }) => [
  { ellipse, at: estimate },
  ...map.landmarks.map((one) => ({ ellipse: one.ellipse, at: [one.x, one.y] })),
  ...pulls.map((one) => ({ ellipse: one.ellipse, at: one.from })),
]

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, plane, frame) {
  const { truth, estimate, landmarks, predicted, sightings } = frame
  const { x, y, box } = plane
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const places = landmarks.map((landmark) => at([landmark.x, landmark.y]))
  /** @type {import('../../draw/labels.js').Label[]} */
  const names = [
    { key: 'truth-name', words: 'truth', at: at(truth), kin: 'truth', gap: 13 },
    { key: 'estimate-name', words: 'estimate', at: at(estimate), kin: 'posterior', gap: 20 },
    ...places.map((place, i) => ({
      key: `name${i}`,
      words: String(landmarks[i].id + 1),
      at: place,
      name: 'label',
      gap: 8,
    })),
  ]
  const sights = sightings.flatMap((sighting) => along(at(predicted), at(sighting.at)))
  drawLabels(pen, box, names, [
    ...places.map((place) => clear(place, 5)),
    clear(at(truth), 8),
    clear(at(estimate), 8),
    ...ellipses(frame).flatMap((one) => outline(ellipsePoints(one.ellipse, one.at, plane))),
    ...sights,
  ])
}
