/** What the faults are called that a verdict looks for. */

import { READINGS } from './noise.js'
import { sigmaKind } from './sigmas.js'

/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {Suspect['sizes'][number]} Size */

/** @type {Record<string, [string, string]>} what comes late, and its verb */
export const DELAYED = {
  delaySpeed: ['speed', 'comes'],
  delayTurn: ['turn rate', 'comes'],
  delayFix: ['positions', 'come'],
  delayHeading: ['headings', 'come'],
  delaySighting: ['ranges', 'come'],
}
/** @type {Record<string, string>} what a number that is off is called */
const NAMES = {
  turnBias: 'a bias of the turn rate',
  offset: 'an offset of the ranges',
  scale: 'a scale of the ranges',
  speedScale: 'a scale of the speed',
  bearingOffset: 'a turned camera',
  headingOffset: 'a turned compass',
}
/** @type {Record<string, string>} what a fault without a number is called */
const KINDS = {
  start: 'another start',
  mirrored: 'the sign of the turns',
  'mirrored-bearings': 'the sign of the bearings',
  odometry: 'a scale of the odometry',
  lengths: 'the lengths of ranges and ways together',
  'wheel-size': 'the size of both wheels',
  'turn-scale': 'a scale of the turn rates',
  'unequal-wheels': 'wheels of two sizes',
  antenna: 'another place of the antenna',
  exchanged: 'an exchange of two landmarks',
  displaced: 'another place of a landmark',
  'landmark-bias': 'an offset of the ranges to one landmark',
}

/** What comes late by the same. @param {string | null} name @param {string} other @param {Size} [third] */
export const together = (name, other, third) =>
  third ? 'readings' : `${DELAYED[name ?? ''][0]} and the ${DELAYED[other][0]}`

/** What a fault is called. @param {Suspect} suspect */
export function kind({ fault, name, with: other, sensor, sizes }) {
  if (KINDS[fault]) return KINDS[fault]
  if (fault === 'tails') return `a share of outliers among the ${READINGS[sensor ?? 'fix']}`
  if (fault === 'clock')
    return `a delay of the ${other ? `${together(name, other, sizes[2])} together` : DELAYED[name ?? ''][0]}`
  if (fault === 'sigma') return sigmaKind(name)
  return other ? 'scale and offset of the ranges together' : NAMES[name ?? '']
}
