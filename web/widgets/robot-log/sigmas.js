/** A σ that is not what it is said to be, in words: one of the settings, or one that readings bring. */

import { fixed } from '../../draw/numbers.js'
import { claimed, digits, plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect} Suspect */

/** @type {Record<string, [string, string]>} whose σ it is, and its unit */
const SIGMAS = {
  sigmaDistance: ['the distance driven', 'm/√s'],
  sigmaTurn: ['the turn', 'rad/√s'],
  sigmaFix: ['a position', 'm'],
  sigmaHeading: ['a heading', 'rad'],
  sigmaRange: ['a range', 'm'],
  sigmaBearing: ['a bearing', 'rad'],
}
/** @type {Record<string, [string, string]>} whose readings bring one, and its unit */
const CLAIMS = {
  fixSigmaScale: ['positions', 'm'],
  headingSigmaScale: ['headings', 'rad'],
}

/** What such a fault is called. @param {string | null} name of the setting that mends it */
export function sigmaKind(name) {
  const [who] = CLAIMS[name ?? ''] ?? []
  return who ? `a factor on the σ that the ${who} bring` : `another σ of ${SIGMAS[name ?? ''][0]}`
}

/** A σ of the distance that is this share of what is driven in a second is more than noise. */
const LOOSE = 0.2

/**
 * What a σ of the distance, m/√s, may hide, where so many metres are driven in a second.
 * @param {number} sigma @param {number} pace
 */
export function hides(sigma, pace) {
  if (!(pace > 0 && sigma > LOOSE * pace)) return ''
  const share = fixed((100 * sigma) / pace, 0)
  return `So much is ${share} % of what is driven in a second: a fault of the motion may hide in it.`
}

/** An angle with a σ of so many radians, twenty degrees, tells next to nothing of where something is. */
const BLIND = Math.PI / 9

/** What a σ of an angle, as it is set, may hide. @param {Suspect[]} suspects */
export function blind(suspects) {
  const wide = suspects.find(({ name, sizes }) => /^sigma(Bearing|Heading)$/.test(name ?? '') && sizes[0]?.now > BLIND)
  if (!wide) return ''
  const degrees = fixed((180 / Math.PI) * wide.sizes[0].now, 0)
  return `The σ of ${SIGMAS[wide.name ?? ''][0]} is set to ${degrees}°: a fault of those angles may hide in it.`
}

/** The σ that the readings have which are no outliers. @param {string} name @param {Suspect['sizes'][number]} size */
export function withoutOutliers(name, size) {
  const [whose, unit] = SIGMAS[name] ?? []
  if (!whose) return `Without them ${plusMinus(size)} times the σ that the ${CLAIMS[name][0]} bring fits.`
  return `Without them the σ of ${whose} is ${plusMinus(size)} ${unit}, and is set to ${claimed(size.now)}.`
}

/** What it is, and what mends it. @param {Suspect} suspect */
export function sigmaSentence({ name, claims, sizes: [size] }) {
  const { now, value } = size
  const beyond = value > now ? 'more than' : 'less than'
  if (!claims) {
    const [whose, unit] = SIGMAS[name ?? '']
    return (
      `The σ of ${whose} is ${plusMinus(size, 1, beyond)} ${unit}, and is set to ${claimed(now)}: ` +
      `set it ${value > now ? 'higher' : 'lower'}.`
    )
  }
  const [who, unit] = CLAIMS[name ?? '']
  const [least, claim, most] = claims
  const middle = least === most ? '' : ' in the median'
  const taken = now === 1 ? '' : `, taken times ${claimed(now)},`
  return (
    `The ${who} claim ${claimed(claim)} ${unit}${middle}${taken || ','} ` +
    `and ${plusMinus(size, claim, beyond)} ${unit} fits: set the factor on their own σ to ${digits(size)}.`
  )
}
