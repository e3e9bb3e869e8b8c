/** A camera over a map: a plane with one scale for both axes, which follows what has to be seen. */

import { Span } from '../figure/motion.js'
import { evenPlane } from './plot.js'

/** Room beside what has to be seen, as a part of its range. */
const MARGIN = 0.025
/** How much wider than needed the map of another run may stay. */
const CLOSE = 1.1
/** Room for a mark that stands at the edge, pixels. */
const MARK = 5

/**
 * @param {import('../figure/spec.js').View} view what remembers the camera between two frames
 * @param {import('./plot.js').Box} box where the map is drawn
 * @param {(axis: number) => number[][]} values what has to be seen on an axis, 0 across and 1 up
 * @param {{ params: object, tracks: object }} [frame] of a run whose scale is chosen anew where the reader has changed
 * its parameters
 * @returns {{ plane: import('./plot.js').Plane, moving: boolean }} the plane, and whether the camera still moves
 */
export function followed(view, box, values, frame) {
  /** @type {Span[]} */
  const spans = (view.memory.map ??= [new Span(), new Span()])
  const loose = frame && isAnother(view, frame) ? CLOSE : undefined
  const moving = spans
    .map((span, axis) => span.follow(...range(values(axis)), view.elapsed, MARGIN, loose))
    .includes(true)
  const [x, y] = spans.map(({ now }) => /** @type {[number, number]} */ (now))
  const [width, height] = [box.right - box.left, box.bottom - box.top]
  const unit = Math.min((width - 2 * MARK) / (x[1] - x[0]), (height - 2 * MARK) / (y[1] - y[0]))
  return { plane: evenPlane(box, [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2], Math.min(width, height) / 2 / unit), moving }
}

/** @param {number[][]} all @returns {[number, number]} */
function range(all) {
  let [low, high] = [Infinity, -Infinity]
  for (const values of all) {
    for (const value of values) {
      if (value < low) low = value
      if (value > high) high = value
    }
  }
  return [low, high]
}

/**
 * Whether the frame is of another run than the last. While a run is computed its frame has the new parameters and still
 * the tracks of the run before.
 * @param {import('../figure/spec.js').View} view
 * @param {{ params: object, tracks: object }} frame
 */
function isAnother({ memory }, { params, tracks }) {
  const last = memory.mapOf
  if (last?.tracks === tracks) return false
  const run = JSON.stringify(params)
  memory.mapOf = { run, tracks }
  return last !== undefined && last.run !== run
}
