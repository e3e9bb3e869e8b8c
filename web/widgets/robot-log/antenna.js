/** An antenna that does not stand where the robot’s pose is: in words, and what it does to a start taken from fixes. */

import { DELAYED } from './kinds.js'
import { claimed, digits, ownStep, plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {Suspect['sizes'][number]} Size */

/** @param {Size} size @param {string} unit @param {[string, string]} words of one above 0, and below */
const off = (size, unit, [more, less]) =>
  `${plusMinus({ ...size, value: Math.abs(size.value) })} ${unit} ${size.value < 0 ? less : more}`

/** Where it stands, and what is late as well. @param {Suspect} suspect */
export function antennaSentence({ with: other, sizes: [ahead, left, together] }) {
  const delay = isLate(together) && together
  return (
    `The antenna whose positions these are stands ${off(ahead, 'm', ['ahead of', 'behind'])} the point about which ` +
    `the robot turns, and ${off(left, 'm', ['to its left', 'to its right'])}${delay ? late(other, delay) : ''}: ` +
    `set its place so${delay ? `, and the delay to ${digits(delay)} s` : ''}.`
  )
}

/** @param {string | null} name of the delay @param {Size} delay */
function late(name, delay) {
  const [what, verb] = DELAYED[name ?? 'delayFix']
  const who = verb === 'comes' ? `the ${what}` : 'these'
  return `, and ${who} ${verb} ${off({ ...delay, value: delay.value - delay.now }, 's', ['late', 'early'])}`
}

/** Whether a delay was found that is not the motion model’s own. @param {Size} [delay] */
export const isLate = (delay) => Boolean(delay && delay.value !== delay.now)

/**
 * What the motion model may have as its own: of a place ahead the way of a step, which it holds what it reads for, and
 * of a delay the step.
 * @param {Size[]} sizes @param {{ pace: number, period: number, ownDelay: number }} judgement
 */
export function ofAStep([, , delay], { pace, period, ownDelay }) {
  if (isLate(delay)) return ownDelay > 0 ? `The delay may be ${ownStep({ period, ownDelay })}, ${OWN}` : ''
  const way = pace * ownDelay
  return !delay && way > 0
    ? `Up to ${claimed(way)} m of it ahead may be the motion model’s own, the way of a step.`
    : ''
}

const OWN = 'longer or shorter: that is the motion model’s own.'

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
