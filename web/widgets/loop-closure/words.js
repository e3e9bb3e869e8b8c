/** What the figure of the loop says: each sentence follows from the numbers of the frame. */

import { fixed } from '../../draw/numbers.js'
import { LONGER } from './map.js'
import { pairOf } from './pair.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */

/** @param {number} n @param {string} one @param {string} [more] */
const count = (n, one, more = `${one}s`) => `${n === 0 ? 'no' : n} ${n === 1 ? one : more}`

/** @param {Frame} frame */
export function verdict(frame) {
  return [mapOf(frame), faultsOf(frame), closureOf(frame), pullOf(frame), neesOf(frame)].filter(Boolean).join(' ')
}

/** @param {Frame} frame */
function mapOf({ step, map, closure }) {
  if (closure) return ''
  if (step === 0)
    return (
      `At the start the pose is known exactly, and ${count(map.landmarks.length, 'landmark')} in reach ` +
      `${map.landmarks.length === 1 ? 'is' : 'are'} founded.`
    )
  return `The map has ${count(map.landmarks.length, 'landmark')}; ${useOf(map)}.`
}

/** How many of the sightings were used. @param {Frame['map']} map */
function useOf({ sightings, rejected }) {
  const all = count(sightings, 'sighting')
  if (rejected > 0) return `${rejected} of ${all} ${rejected === 1 ? 'was' : 'were'} not used`
  return sightings < 2 ? `${all} was used` : `all ${all} were used`
}

/** @param {Frame} frame */
function faultsOf({ map }) {
  const found = []
  if (map.spurious > 0)
    found.push(
      count(
        map.spurious,
        'landmark is a ghost, founded though the map had it already',
        'landmarks are ghosts, founded though the map had them already',
      ),
    )
  if (map.wrong > 0)
    found.push(
      count(map.wrong, 'sighting was matched to the wrong landmark', 'sightings were matched to the wrong landmark'),
    )
  if (map.full) found.push('the map is full and founds no more')
  if (found.length === 0) return ''
  const all = found.join('; ')
  return `${all[0].toUpperCase()}${all.slice(1)}.`
}

/** @param {Frame} frame */
function closureOf({ closure, lap }) {
  if (!closure) return lap > 0 ? 'No landmark that was long out of sight has been recognized.' : ''
  const { step, landmark, before, after } = closure
  const [from, to] = [before, after].map((sigma) => fixed(sigma, 3))
  const change =
    from === to ? `hardly changed, ${to} m` : `${before > after ? 'shrank' : 'grew'} from ${from} to ${to} m`
  return `At step ${step} landmark ${landmark + 1} was recognized again, and the landmarks’ mean σ ${change}.`
}

/**
 * What the gain does to the landmark that it moves farthest of those that the closing step has not read.
 * @param {Frame} frame
 */
function pullOf(frame) {
  const pair = pairOf(frame)
  if (!pair) return ''
  const { moved, by, correlation } = pair
  return (
    `Nothing was read of landmark ${moved.truth + 1}: its row of the gain, ` +
    `${fixed(moved.reach, 3)} m for a reading off by one σ, moved it by ${fixed(moved.far, 3)} m ` +
    `(the arrows are ${LONGER} times as long). ` +
    `Its correlation with landmark ${by.truth + 1}, framed in the square, is still ${fixed(correlation, 2)}.`
  )
}

/** @param {Frame} frame */
function neesOf({ meanNees, neesBand: [, high] }) {
  if (meanNees === null) return ''
  const over = meanNees > high ? ': the filter claims far more than it knows' : ''
  return `The mean NEES of the pose is ${fixed(meanNees, 1)}, where 3 is expected${over}.`
}
