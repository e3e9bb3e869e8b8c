/** Room A from above: path, robot, estimate with its ellipse, landmarks to drag, and the direction no reading sees. */

import { clear, drawLabels } from '../../draw/labels.js'
import {
  dot,
  ellipseLevel,
  ellipsePath,
  evenPlane,
  meaning,
  pointsPath,
  scaleBar,
  segment,
  seriesPath,
} from '../../draw/plot.js'
import { fixed } from '../../draw/numbers.js'
import { hidden } from './hidden.js'
import { lap } from './lap.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 6, top: 6, right: width - 6, bottom: height - 6 }
  const plane = evenPlane(box, [frame.room.width / 2, frame.room.height / 2], 3.35)
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      room(to, plane, frame)
      sightings(to, plane, frame)
      belief(to, plane, frame)
    })
    drawNames(pen, plane, frame)
    ellipseLevel(pen, plane.x(0) + 2, box.bottom - 4)
    scaleBar(pen, plane, plane.x(frame.room.width), box.bottom - 4)
    pen.group('handles', {}, (to) => handles(to, plane, frame, view))
  })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function room(pen, plane, { room: { width, height }, square, tracks, ghost }) {
  const [x, y] = [plane.x(0), plane.y(height)]
  pen.mark('rect', 'floor', { class: 'floor', x, y, width: plane.x(width) - x, height: plane.y(0) - y })
  pen.mark('path', 'walls', {
    class: 'wall',
    d: `${pointsPath(plane, [
      [0, 0],
      [width, 0],
      [width, height],
      [0, height],
    ])}Z`,
  })
  pen.mark('path', 'square', { class: 'grid', fill: 'none', d: `${pointsPath(plane, square)}Z` })
  // A dashed line is drawn once: the dashes of a second lap would fill the gaps of the first.
  const dashed = (/** @type {{ x: number[], y: number[] }} */ track) =>
    pointsPath(plane, lap(track, tracks.truth, square))
  pen.mark('path', 'track-truth', { ...meaning('track', 'truth'), d: dashed(tracks.truth) })
  if (ghost) pen.mark('path', 'track-ghost', { ...meaning('track ghost dashed'), d: dashed(ghost.track) })
  pen.mark('path', 'track-estimate', {
    ...meaning('track', 'posterior'),
    d: seriesPath(plane, tracks.estimate.x, tracks.estimate.y),
  })
}

/** @param {Plane} plane @param {Frame} frame */
const inside = ({ x, y }, { room: { width, height } }) => ({
  left: x(0),
  top: y(height),
  right: x(width),
  bottom: y(0),
})

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function sightings(pen, plane, frame) {
  for (const { landmark, range, outcome, to } of frame.sightings) {
    const at = frame.landmarks[landmark]
    const rejected = outcome === 'rejected'
    segment(
      pen,
      `sight${landmark}`,
      plane,
      frame.truth,
      to ?? [at.x, at.y],
      meaning(rejected ? 'way dashed' : 'sight', 'measurement'),
    )
    if (frame.sensor !== 'range') continue
    // All the places of the room from which this range is read.
    pen.window(`ring${landmark}`, inside(plane, frame), (to) => {
      to.mark('circle', 'ring', {
        ...meaning('curve thin', 'measurement'),
        cx: plane.x(at.x),
        cy: plane.y(at.y),
        r: plane.x(range) - plane.x(0),
      })
    })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function belief(pen, plane, frame) {
  const { estimate, truth, ellipse } = frame
  for (const { id, x, y, ellipse: spread } of frame.slam?.landmarks ?? []) {
    pen.mark('path', `map${id}`, { ...meaning('outline', 'posterior'), d: ellipsePath(spread, [x, y], plane) })
    dot(pen, `founded${id}`, plane, [x, y], { ...meaning('full', 'posterior'), r: 1.5 })
  }
  pen.mark('path', 'ellipse', { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, estimate, plane) })
  for (const { key, shape, ends } of hidden(frame)) {
    if (ends) segment(pen, key, plane, ends[0], ends[1], { class: shape })
    else
      pen.mark('circle', key, { class: shape, fill: 'none', cx: plane.x(estimate[0]), cy: plane.y(estimate[1]), r: 20 })
  }
  dot(pen, 'estimate', plane, estimate, { ...meaning('full', 'posterior'), r: 4 })
  if (frame.ghost) robot(pen, 'ghost', plane, frame.ghost.pose)
  robot(pen, 'robot', plane, truth)
}

/** @param {Pen} pen @param {string} key @param {Plane} plane @param {number[]} pose */
function robot(pen, key, plane, pose) {
  const [x, y, turn] = [plane.x(pose[0]), plane.y(pose[1]), (-pose[2] * 180) / Math.PI]
  pen.mark('path', key, {
    class: key === 'ghost' ? 'robot ghost' : 'robot',
    d: 'M11 0L-7 7L-4 0L-7 -7Z',
    transform: `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${turn.toFixed(2)})`,
  })
}

/** What names keep clear of along a line. @param {number[]} from @param {number[]} to @param {number} r */
function along([x1, y1], [x2, y2], r) {
  const count = Math.max(1, Math.ceil(Math.hypot(x2 - x1, y2 - y1) / (2 * r)))
  return Array.from({ length: count + 1 }, (_, i) =>
    clear([x1 + ((x2 - x1) * i) / count, y1 + ((y2 - y1) * i) / count], r),
  )
}

/** The same along a closed line. @param {number[][]} corners @param {number} r */
const around = (corners, r) => corners.flatMap((corner, i) => along(corner, corners[(i + 1) % corners.length], r))

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, plane, frame) {
  const { box, x, y } = plane
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const landmarks = frame.params.landmarks.slice(0, frame.params.count).map(at)
  const strokes = hidden(frame)
  const { left, top, right, bottom } = inside(plane, frame)
  // Of a stroke that leaves the map, the name belongs to the part that is on it.
  const kept = (/** @type {[number, number]} */ [px, py]) =>
    /** @type {[number, number]} */ ([
      Math.max(box.left, Math.min(box.right, px)),
      Math.max(box.top, Math.min(box.bottom, py)),
    ])
  drawLabels(
    pen,
    box,
    [
      ...landmarks.map((mark, i) => ({
        key: `landmark-name${i}`,
        words: String(i + 1),
        at: mark,
        kin: 'measurement',
        name: 'handle-name measurement',
        gap: 15,
      })),
      ...(frame.ghost ? [{ key: 'ghost-name', words: 'ghost', at: at(frame.ghost.pose), gap: 13 }] : []),
      ...strokes.map(({ key, words, ends }, i) => ({
        key: `${key}-name`,
        words,
        at: kept(at(ends?.[i % 2] ?? frame.estimate)),
        gap: ends ? 8 : 24,
      })),
    ],
    [
      ...landmarks.map((mark) => clear(mark, 11)),
      clear(at(frame.estimate), 8),
      ...strokes.flatMap(({ ends }) => (ends ? along(at(ends[0]), at(ends[1]), 3) : [])),
      ...around(frame.square.map(at), 5),
      ...around(
        [
          [left, top],
          [right, top],
          [right, bottom],
          [left, bottom],
        ],
        3,
      ),
      { left, top: bottom + 2, right, bottom: box.bottom },
    ],
  )
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view */
function handles(pen, plane, frame, view) {
  const { landmarks } = frame.params
  const clamp = (/** @type {number} */ value, /** @type {number} */ high) => Math.max(0, Math.min(high, value))
  landmarks.slice(0, frame.params.count).forEach(([x, y], i) => {
    const put = (/** @type {number} */ px, /** @type {number} */ py) => ({
      landmarks: landmarks.map((point, j) =>
        j === i ? [clamp(px, frame.room.width), clamp(py, frame.room.height)] : point,
      ),
    })
    view.handle(pen, `landmark${i}`, {
      at: [plane.x(x), plane.y(y)],
      label: `Landmark ${i + 1}`,
      kin: 'measurement',
      value: `at ${fixed(x, 2)}, ${fixed(y, 2)} metres`,
      now: x,
      min: 0,
      max: frame.room.width,
      move: (px, py) => put(plane.x.invert(px), plane.y.invert(py)),
      nudge: (dx, dy) => put(x + 0.05 * dx, y + 0.05 * dy),
      jump: (end) => put(end === 'home' ? 0 : frame.room.width, y),
    })
  })
}
