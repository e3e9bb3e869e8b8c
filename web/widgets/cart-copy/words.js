/** What the cart and its copy say: of the two speedometers, of the nudge, and of what it leaves. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').CartCopyFrame} Frame */

/** Below half of what two decimals show there is nothing to see. */
const SEEN = 0.005

/** @param {number} value in metres */
const ahead = (value) => `${fixed(Math.abs(value))} m ${value < 0 ? 'behind' : 'ahead'}`
/** @param {number} value in metres a second */
const faster = (value) => `${fixed(Math.abs(value))} m/s too ${value < 0 ? 'slow' : 'fast'}`

/** Where the copy stands against the cart. @param {Frame} frame */
function stands({ error: [position, speed] }) {
  const parts = [
    ...(Math.abs(speed) < SEEN ? [] : [faster(speed)]),
    ...(Math.abs(position) < SEEN ? [] : [ahead(position)]),
  ]
  return parts.join(' and ')
}

/** @param {Frame} frame */
export function verdict(frame) {
  const { innovation, nudge, params, step, error, K } = frame
  if (stands(frame) === '') return 'The copy does what the cart does, and the innovation is 0.'
  if (Math.abs(innovation) < SEEN && Math.abs(error[1]) < SEEN)
    return (
      'Both speedometers show the same. The innovation is 0, so nothing is nudged: ' +
      `the copy stays ${ahead(error[0])}, whatever the gain.`
    )
  if (step === 0) return `The copy is ${stands(frame)}. Press Step: both drive, you compare, the copy is nudged.`
  if (params.gain === 0)
    return `The innovation is ${fixed(innovation)} m/s, and at gain 0 nothing is nudged. The copy is ${stands(frame)}.`
  return (
    `The innovation was ${fixed(innovation)} m/s. The nudge is {K} times that: ${fixed(K[1])} of it, ` +
    `${fixed(nudge[1])} m/s, for the copy’s speed, and ${fixed(nudge[0])} m for its position. ` +
    `The copy is now ${stands(frame)}.`
  )
}

/** @param {Frame} frame */
export function describe(frame) {
  const { truth, copy, reading, expected, innovation } = frame
  return {
    rail:
      `A rail with a cart at ${fixed(truth[0])} metres and its copy at ${fixed(copy[0])} metres. ` +
      `The cart’s speedometer reads ${fixed(reading)} metres a second, the copy’s would read ${fixed(expected)}: ` +
      `the innovation is ${fixed(innovation)}.`,
  }
}
