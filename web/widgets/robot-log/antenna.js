/** An antenna that does not stand where the robot’s pose is: in words, and what it does to a start taken from fixes. */

import { claimed, digits, plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */

/** @param {Size} size @param {string} unit @param {[string, string]} words of one above 0, and below */
const off = (size, unit, [more, less]) =>
  `${plusMinus({ ...size, value: Math.abs(size.value) })} ${unit} ${size.value < 0 ? less : more}`

/** @param {Size[]} sizes ahead and to the left, m, and a delay of the positions, s, where that is off as well */
export function antennaSentence([ahead, left, delay]) {
  const late = delay && `, and these come ${off({ ...delay, value: delay.value - delay.now }, 's', ['late', 'early'])}`
  return (
    `The antenna whose positions these are stands ${off(ahead, 'm', ['ahead of', 'behind'])} the point about which ` +
    `the robot turns, and ${off(left, 'm', ['to its left', 'to its right'])}${late ?? ''}: ` +
    `set its place so${delay ? `, and the delay to ${digits(delay)} s` : ''}.`
  )
}

/**
 * What of a place ahead the motion model may have as its own: the way of a step, which it holds what it reads for.
 * @param {{ pace: number, ownDelay: number }} judgement
 */
export function armOfAStep({ pace, ownDelay }) {
  const way = pace * ownDelay
  return way > 0 ? `Up to ${claimed(way)} m of it ahead may be the motion model’s own, the way of a step.` : ''
}

/**
 * Where the robot starts if its antenna stands elsewhere than is set: the antenna stays where it was.
 * @param {Record<string, any>} params @param {Record<string, any>} patch
 * @returns {[number, number, number]}
 */
export function startBelow({ start: [x, y, theta], antennaAhead, antennaLeft }, patch) {
  const [ahead, left] = [
    (patch.antennaAhead ?? antennaAhead) - antennaAhead,
    (patch.antennaLeft ?? antennaLeft) - antennaLeft,
  ]
  const [c, s] = [Math.cos(theta), Math.sin(theta)]
  return [x - c * ahead + s * left, y - s * ahead - c * left, theta]
}
