/** A start that is not where the filter has it, in words. */

import { fixed } from '../../draw/numbers.js'
import { plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */

const DEGREES = 180 / Math.PI

/** What is looked for begins where the filter starts: from far off it comes nearer, and no further. */
const FAR = ' So far off this is a first step: the verdict after it brings the next.'

/** An angle within half a turn. @param {number} angle */
export const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle))

/**
 * Where the robot started, and what to do.
 * @param {Size[]} sizes x, y and heading, in m and rad @param {boolean} truth whether it was the first true pose
 */
export function startSentence([x, y, theta], truth) {
  const far = Math.hypot(x.value - x.now, y.value - y.now)
  const turned = Math.abs(wrapped(theta.value - theta.now)) * DEGREES
  const where = `${fixed(far, 2)} m beside, and turned by ${fixed(turned, 0)}°`
  if (truth) return `The robot did not start at the first true pose, but ${where}: mend that row of the truth.`
  const heading = plusMinus({ ...theta, value: wrapped(theta.value) }, DEGREES)
  return (
    `The robot did not start where the filter does, but ${where}: ` +
    `set the start to ${plusMinus(x)} m, ${plusMinus(y)} m and ${heading}°.${turned > 60 ? FAR : ''}`
  )
}
