/** An antenna that does not stand where the robot’s pose is: in words, and what it does to a start taken from fixes. */

import { plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */

/** @param {Size} size @param {[string, string]} words of one above 0, and below */
const off = (size, [more, less]) =>
  `${plusMinus({ ...size, value: Math.abs(size.value) })} m ${size.value < 0 ? less : more}`

/** @param {Size[]} sizes ahead and to the left, m */
export const antennaSentence = ([ahead, left]) =>
  `The antenna whose positions these are stands ${off(ahead, ['ahead of', 'behind'])} the point about which the ` +
  `robot turns, and ${off(left, ['to its left', 'to its right'])}: set its place so.`

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
