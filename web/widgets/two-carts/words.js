/** What the two carts say: whether the readings tell one from the other. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').TwoCartsFrame} Frame */

/** @param {Frame} frame */
const unit = ({ params }) => (params.sensor === 'velocity' ? 'm/s' : 'm')

/** How the second cart differs at the start. @param {Frame} frame */
function apart({ params: { position, speed } }) {
  const parts = [
    ...(position === 0 ? [] : [`stand ${fixed(Math.abs(position))} m apart`]),
    ...(speed === 0 ? [] : [`differ by ${fixed(Math.abs(speed))} m/s in speed`]),
  ]
  return parts.join(' and ')
}

/** @param {Frame} frame */
export function verdict(frame) {
  const { params, difference, readings } = frame
  const start = apart(frame)
  if (start === '') return 'The carts start alike: drag the second one away.'
  const all = readings[0].length
  if (difference === 0)
    return (
      `The carts ${start}, and all ${all} readings are the same: ` +
      'no filter can tell from them which cart it rides on.'
    )
  const told =
    `The carts ${start}, and the readings differ by up to ${fixed(difference)} ${unit(frame)}: ` +
    'they tell the carts apart.'
  const blind = params.sensor === 'velocity' && params.position !== 0
  return blind ? `${told} They show the speed, and not the metres between.` : told
}

/** @param {Frame} frame */
export function describe(frame) {
  const { start, readings, difference, params } = frame
  const strip = (/** @type {number[]} */ values) => values.map((value) => fixed(value, 1)).join(', ')
  return {
    rails:
      `Two rails, a cart at ${fixed(start[0][0])} metres and one at ${fixed(start[1][0])} metres, ` +
      `whose speeds differ by ${fixed(Math.abs(start[1][1]))} metres a second.`,
    strips:
      `What the ${params.sensor} sensor of each reads, step by step. The first: ${strip(readings[0])}. ` +
      `The second: ${strip(readings[1])}. They differ by at most ${fixed(difference)}.`,
  }
}
