/** The pair of landmarks that the closing step tells about: one that it has read, and one that moves though unread. */

import { ghosts } from './ghosts.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */

/**
 * Of the landmarks that the closing step has not read, the one that it moves farthest; and of those read, the one whose
 * error goes most with its error. Null at other steps.
 * @param {Frame} frame
 */
export function pairOf(frame) {
  const { pulls, sightings, map, correlation } = frame
  const spooky = ghosts(frame)
  const read = new Set(sightings.map(({ landmark }) => landmark))
  const places = new Map(map.landmarks.map(({ id, truth }, i) => [id, { truth, at: i + 1 }]))
  const known = pulls.flatMap((pull) => {
    const place = places.get(pull.id)
    return place && !spooky.has(pull.id) ? [{ ...pull, ...place, far: lengthOf(pull) }] : []
  })
  const [seen, unseen] = [true, false].map((was) => known.filter(({ truth }) => read.has(truth) === was))
  if (seen.length === 0 || unseen.length === 0) return null
  const moved = unseen.reduce((one, other) => (other.far > one.far ? other : one))
  const together = (/** @type {{ at: number }} */ { at }) => Math.abs(correlation[moved.at][at])
  const by = seen.reduce((one, other) => (together(other) > together(one) ? other : one))
  return { moved, by, correlation: correlation[moved.at][by.at] }
}

/** @param {Frame['pulls'][number]} pull */
const lengthOf = ({ from, to }) => Math.hypot(to[0] - from[0], to[1] - from[1])
