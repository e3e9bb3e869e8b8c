/** The corridor from above: where the robot is, where it believes itself to be, and how sure it claims to be. */

import { followed } from '../../draw/camera.js'
import { drawBuilding, drawRobot } from '../../draw/building.js'
import { clear, drawLabels } from '../../draw/labels.js'
import { dot, ellipseLevel, ellipsePath, halves, meaning, scaleBar, segment, seriesPath } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').HookFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** Ticks a sightline takes to fade. */
const FLASH = 40
const FOOT = 20

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 0, top: 0, right: width, bottom: height }
  // Below the map is a line for what the ellipses mean and how long a metre is.
  const { plane, moving } = followed(view, { ...box, bottom: height - FOOT }, (axis) => seen(frame, axis), frame)
  // While neither the robot nor the camera has moved, this is not drawn again.
  const stamp = [width, height, ...plane.x.domain, ...plane.y.domain].join(' ')
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      to.group('building', {}, (into) => drawPlace(into, plane, frame), stamp)
      to.group(
        'trail',
        {},
        (into) => drawTrail(into, plane, frame),
        `${stamp} ${JSON.stringify(frame.params)} ${stops(frame).map(({ step }) => step)}`,
      )
      drawTracks(to, plane, frame)
      drawSight(to, plane, frame)
      drawRobots(to, plane, frame)
    })
    drawNames(pen, plane, frame)
    ellipseLevel(pen, box.left + 6, box.bottom - 6)
    scaleBar(pen, plane, box.right - 8, box.bottom - 6)
  })
  return moving
}

/**
 * What has to be seen: the estimate with its ellipse, those that it left behind, the course with its corridor, and the
 * estimate's track.
 * @param {Frame} frame
 * @param {number} axis
 */
function seen({ world, tracks, trail, estimate, ellipse }, axis) {
  const at = axis ? 'y' : 'x'
  const half = halves(ellipse)[axis] + 0.5
  return [
    [estimate[axis] - half, estimate[axis] + half],
    world.corners.map((corner) => corner[at]),
    trail.flatMap(({ x, ellipse: left }) => [-1, 1].map((side) => x[axis] + side * halves(left)[axis])),
    tracks.estimate[at],
  ]
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawPlace(pen, plane, { world }) {
  const { x, y } = plane
  drawBuilding(pen, plane, world)
  for (const { id, x: cx, y: cy } of world.corners) {
    pen.mark('rect', `corner${id}`, { class: 'corner', x: x(cx) - 4, y: y(cy) - 4, width: 8, height: 8 })
  }
}

/** @param {Frame} frame */
function kinOf({ params }) {
  return params.fixes ? 'posterior' : 'prediction'
}

/** The steps whose ellipses stay: all of the trail but the robot's own. @param {Frame} frame */
function stops({ trail, step }) {
  return trail[trail.length - 1]?.step === step ? trail.slice(0, -1) : trail
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawTrail(pen, plane, frame) {
  for (const { step, x, ellipse } of stops(frame)) {
    pen.mark('path', `trail${step}`, { ...meaning('area', kinOf(frame)), d: ellipsePath(ellipse, x, plane) })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawTracks(pen, plane, frame) {
  const { tracks } = frame
  const kin = kinOf(frame)
  pen.mark('path', 'truth-track', {
    ...meaning('track', 'truth'),
    d: seriesPath(plane, tracks.truth.x, tracks.truth.y),
  })
  pen.mark('path', 'estimate-track', {
    ...meaning('track', kin),
    d: seriesPath(plane, tracks.estimate.x, tracks.estimate.y),
  })
  if (frame.params.fixes && frame.sightings.length) {
    pen.mark('path', 'predicted', {
      ...meaning('outline', 'prediction'),
      d: ellipsePath(frame.predicted.ellipse, frame.predicted.x, plane),
    })
  }
  pen.mark('path', 'ellipse', { ...meaning('outline', kin), d: ellipsePath(frame.ellipse, frame.estimate, plane) })
}

/**
 * A corner is read in one tick: the line stays for a second and fades; dashed where the filter does not use it.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {Frame} frame
 */
function drawSight(pen, plane, { step, lastSighting, params }) {
  if (!lastSighting || step - lastSighting.step >= FLASH) return
  const { from, x, y } = lastSighting
  const opacity = 1 - (step - lastSighting.step) / FLASH
  segment(pen, 'sight', plane, from, [x, y], {
    ...meaning(params.fixes ? 'line' : 'line dashed', 'measurement'),
    'stroke-opacity': opacity,
  })
  dot(pen, 'seen', plane, [x, y], { ...meaning('sight', 'measurement'), r: 9, 'stroke-opacity': opacity })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawRobots(pen, plane, frame) {
  const kin = kinOf(frame)
  drawRobot(pen, 'truth', plane, frame.truth, 'hollow', 'truth')
  drawRobot(pen, 'estimate', plane, frame.estimate, frame.params.fixes ? 'full' : 'hollow', kin)
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, { x, y, box }, frame) {
  const { truth, estimate, world } = frame
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const above = truth[1] >= estimate[1]
  const corners = world.corners.map((corner) => at([corner.x, corner.y]))
  const middle = corners.reduce((sum, [cx]) => sum + cx / corners.length, 0)
  drawLabels(
    pen,
    box,
    [
      {
        key: 'truth-name',
        words: 'truth',
        at: at(truth),
        kin: 'truth',
        gap: 13,
        sides: above ? ['above', 'left'] : ['below', 'left'],
      },
      {
        key: 'estimate-name',
        words: frame.params.fixes ? 'estimate' : 'odometry',
        at: at(estimate),
        kin: kinOf(frame),
        gap: 20,
        sides: ['right', 'left', above ? 'below' : 'above'],
      },
      ...corners.map((corner, i) => ({
        key: `corner-name${i}`,
        words: String(world.corners[i].id + 1),
        at: corner,
        name: 'label',
        gap: 8,
        sides: /** @type {import('../../draw/labels.js').Side[]} */ ([corner[0] > middle ? 'right' : 'left']),
      })),
    ],
    [...corners.map((corner) => clear(corner, 5)), clear(at(truth), 8), clear(at(estimate), 8)],
  )
}
