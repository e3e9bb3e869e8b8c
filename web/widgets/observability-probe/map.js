/** Room A from above: path, robot, estimate with its ellipse, landmarks to drag, and the direction no reading sees. */

import { clear, drawLabels } from '../../core/labels.js'
import { dot, ellipseLevel, ellipsePath, evenPlane, meaning, pointsPath, scaleBar, segment, seriesPath } from '../../core/plot.js'
import { fixed } from '../../core/numbers.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('../../core/pen.js').Pen} Pen */
/** @typedef {import('../../core/plot.js').Plane} Plane */

/** Half the length of a drawn direction, metres. */
const ARM = 0.9
/** A direction that turns by more than this for each metre, radians, is drawn as a turn in place. */
const IN_PLACE = 20

/** @param {import('../../core/shell.js').Panel} panel @param {Frame} frame @param {import('../../core/spec.js').View} view */
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
  pen.mark('path', 'walls', { class: 'wall', d: `${pointsPath(plane, [[0, 0], [width, 0], [width, height], [0, height]])}Z` })
  pen.mark('path', 'square', { class: 'grid', fill: 'none', d: `${pointsPath(plane, square)}Z` })
  pen.mark('path', 'track-truth', { ...meaning('track', 'truth'), d: seriesPath(plane, tracks.truth.x, tracks.truth.y) })
  if (ghost) pen.mark('path', 'track-ghost', { ...meaning('track ghost dashed'), d: seriesPath(plane, ghost.track.x, ghost.track.y) })
  pen.mark('path', 'track-estimate', { ...meaning('track', 'posterior'), d: seriesPath(plane, tracks.estimate.x, tracks.estimate.y) })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function sightings(pen, plane, frame) {
  for (const { landmark, range, outcome, to } of frame.sightings) {
    const at = frame.landmarks[landmark]
    const rejected = outcome === 'rejected'
    segment(pen, `sight${landmark}`, plane, frame.truth, to ?? [at.x, at.y], meaning(rejected ? 'way dashed' : 'sight', 'measurement'))
    if (frame.sensor === 'range') {
      // All the places from which this range is read.
      pen.mark('circle', `ring${landmark}`, { ...meaning('curve thin', 'measurement'), cx: plane.x(at.x), cy: plane.y(at.y), r: plane.x(range) - plane.x(0) })
    }
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
    else pen.mark('circle', key, { class: shape, fill: 'none', cx: plane.x(estimate[0]), cy: plane.y(estimate[1]), r: 20 })
  }
  dot(pen, 'estimate', plane, estimate, { ...meaning('full', 'posterior'), r: 4 })
  if (frame.ghost) robot(pen, 'ghost', plane, frame.ghost.pose)
  robot(pen, 'robot', plane, truth)
}

/** @param {Pen} pen @param {string} key @param {Plane} plane @param {number[]} pose */
function robot(pen, key, plane, pose) {
  const [x, y, turn] = [plane.x(pose[0]), plane.y(pose[1]), (-pose[2] * 180) / Math.PI]
  pen.mark('path', key, { class: key === 'ghost' ? 'robot ghost' : 'robot', d: 'M11 0L-7 7L-4 0L-7 -7Z', transform: `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${turn.toFixed(2)})` })
}

/**
 * The directions that no output sees: a line through the estimate, with how the heading turns along it, or a turn in place. Of
 * several hidden directions any mix is hidden too: two of a basis are drawn.
 * @param {Frame} frame
 * @returns {{ key: string, shape: string, words: string, ends: number[][] | null }[]}
 */
function hidden({ estimate: at, frozen, alongPath }) {
  // Before the first step there is no path, and nothing is said of one.
  const driven = alongPath.steps > 0 ? [{ name: 'along the path', shape: 'direction', ranks: alongPath }] : []
  return [{ name: 'frozen', shape: 'level', ranks: frozen }, ...driven].flatMap(({ name, shape, ranks: { directions } }) => directions.slice(0, 2).map(([dx, dy, turn], i) => {
    const among = directions.length > 1 ? `${name}, one of ${directions.length}` : name
    const inPlace = (dx === 0 && dy === 0) || Math.abs(turn) > IN_PLACE
    const degrees = Math.round(Math.abs(turn * 180) / Math.PI)
    return {
      key: `${name}${i}`, shape,
      words: inPlace ? `${among}: a turn` : degrees === 0 ? among : `${among}, ${degrees}° a metre`,
      ends: inPlace ? null : [-ARM, ARM].map((arm) => [at[0] + arm * dx, at[1] + arm * dy]),
    }
  }))
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, plane, frame) {
  const { box, x, y } = plane
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([x(p[0]), y(p[1])])
  const landmarks = frame.params.landmarks.slice(0, frame.params.count).map(at)
  drawLabels(pen, box, [
    ...landmarks.map((mark, i) => ({ key: `landmark-name${i}`, words: String(i + 1), at: mark, kin: 'measurement', name: 'handle-name measurement', gap: 15 })),
    ...(frame.ghost ? [{ key: 'ghost-name', words: 'ghost', at: at(frame.ghost.pose), gap: 13 }] : []),
    ...hidden(frame).map(({ key, words, ends }, i) => ({ key: `${key}-name`, words, at: at(ends?.[i % 2] ?? frame.estimate), gap: ends ? 8 : 24 })),
  ], [...landmarks.map((mark) => clear(mark, 11)), clear(at(frame.estimate), 8), { left: x(0), top: y(0) + 2, right: x(frame.room.width), bottom: box.bottom }])
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame @param {import('../../core/spec.js').View} view */
function handles(pen, plane, frame, view) {
  const { landmarks } = frame.params
  const clamp = (/** @type {number} */ value, /** @type {number} */ high) => Math.max(0, Math.min(high, value))
  landmarks.slice(0, frame.params.count).forEach(([x, y], i) => {
    const put = (/** @type {number} */ px, /** @type {number} */ py) => ({
      landmarks: landmarks.map((point, j) => (j === i ? [clamp(px, frame.room.width), clamp(py, frame.room.height)] : point)),
    })
    view.handle(pen, `landmark${i}`, {
      at: [plane.x(x), plane.y(y)], label: `Landmark ${i + 1}`, kin: 'measurement',
      value: `at ${fixed(x, 2)}, ${fixed(y, 2)} metres`, now: x, min: 0, max: frame.room.width,
      move: (px, py) => put(plane.x.invert(px), plane.y.invert(py)),
      nudge: (dx, dy) => put(x + 0.05 * dx, y + 0.05 * dy),
      jump: (end) => put(end === 'home' ? 0 : frame.room.width, y),
    })
  })
}
