/** What the cloud says: what one error puts into P₁₂, and how all of them make it. */

import { fixed } from '../../draw/numbers.js'
import { isShown } from './reach.js'

/** @typedef {import('estimate-wasm').ErrorCloudFrame} Frame */

/** @param {number} value */
export const signed = (value, decimals = 2) => `${value > 0 ? '+' : ''}${fixed(value, decimals)}`

/** Whether the ellipse has an axis longer than the other: a circle has none. @param {Frame} frame */
export const isLong = ({ ellipse: { semiMajor, semiMinor } }) => semiMajor - semiMinor > 0.005

/** @param {Frame} frame */
export function verdict({ error, product, share, positive, positives, negative, dots, P }) {
  return (
    `The product of the error you touch is ${signed(product)} m²/s` +
    `${isShown(error) ? '' : ', of an error at the edge of the drawing or beyond'}, and a two-hundredth of it, ` +
    `${signed(share, 3)}, goes into {P}_{12}. The ${positives} dots with a positive product add ${fixed(positive)}, ` +
    `the other ${dots.length - positives} take away ${fixed(-negative)}: {P}_{12} = ${fixed(P[0][1])}.`
  )
}

/** @param {Frame} frame */
export function describe(frame) {
  const { dots, sigma, correlation, regression, longAxis, error, product, inside } = frame
  const slope = Number.isFinite(longAxis) ? `${fixed(longAxis)} metres for each metre a second` : 'level'
  const line = isLong(frame) ? `the long axis is ${slope}` : 'the ellipse is a circle'
  return {
    plane:
      `The plane of a position error, across, and a velocity error, upward, with ${dots.length} errors as dots. ` +
      `Their standard deviations are ${fixed(sigma[0])} metres and ${fixed(sigma[1])} metres a second, their ` +
      `correlation is ${fixed(correlation)}; ${inside} dots lie in the ellipse at 1 sigma. The regression line has ` +
      `${fixed(regression)} metres for each metre a second, ${line}. ` +
      `The error looked at is ${fixed(error[0])} metres and ${fixed(error[1])} metres a second, its product ` +
      `${fixed(product)}.`,
  }
}
