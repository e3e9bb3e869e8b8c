/** A sensor that is late, in words: by how much, what mends it, and what looks the same. */

import { fixed } from '../../draw/numbers.js'
import { DELAYED, together } from './kinds.js'
import { brief, digits, isStair, plusMinus } from './sized.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */

/** Who is late, and by how much. @param {Suspect} suspect */
export function late({ name, with: other, flat, sizes: [size, , third] }) {
  const off = size.value - size.now
  const [what, verb] = other ? [together(name, other, third), 'come together'] : DELAYED[name ?? '']
  const further = off > 0 ? 'later' : 'earlier'
  const claim = size.now === 0 ? (off > 0 ? 'late' : 'early') : `${further} than set`
  const stair = isStair(flat, size.sigma) && flat
  const much = stair
    ? stair
        .map((end) => fixed(Math.abs(end - size.now), 2))
        .sort()
        .join(' to ')
    : plusMinus({ ...size, value: Math.abs(off) })
  return `The ${what} ${verb} ${much} s ${claim}${stair ? ', and the rows of motion tell no more' : ''}`
}

/** Who is late, and what to set. @param {Suspect} suspect */
export function lateSentence(suspect) {
  const [size, second] = suspect.sizes
  const what = second ? delays(suspect) : `set the delay to ${digits(size)} s.`
  return `${late(suspect)}: ${what}${size.end ? END : ''}`
}

const END =
  ' No longer delay was tried. Where a whole file has another clock, add the seconds to its times, among its columns.'

/** What to set of sensors that have one clock. @param {Suspect} suspect */
function delays({ sizes }) {
  const all = sizes.map((size) => digits(size))
  const same = all.every((value) => value === all[0])
  return same
    ? `set ${all.length > 2 ? 'all their' : 'both'} delays to ${all[0]} s.`
    : `set their delays to ${all.join(' s and ')} s.`
}

const READ = ['delayFix', 'delayHeading', 'delaySighting']

/**
 * What looks the same as all that is read beside the motion being late, or the one sensor that is.
 * @param {Suspect} suspect @param {Suspect[]} suspects
 */
export function asMotion({ fault, name, with: other, sizes: [size] }, suspects) {
  const sensors = suspects.filter((one) => one.fault === 'clock' && !one.with && READ.includes(one.name ?? ''))
  const all = other !== null || (sensors.length === 1 && READ.includes(name ?? ''))
  if (fault !== 'clock' || !all) return ''
  const way = size.value < size.now ? 'late' : 'early'
  return `That all of the motion comes as ${way} would look the same.`
}

/** Between these parts of a step a delay is about half of it. */
const HALF = [0.3, 0.7]

/**
 * What a delay of half a step may come from, where the motion model has none of its own.
 * @param {Suspect} suspect @param {LogJudgement} judgement
 */
export function asMean({ fault, name, sizes: [size] }, { period, ownDelay }) {
  if (fault !== 'clock' || ownDelay > 0 || size.now !== 0) return ''
  const off = size.value - size.now
  const late = name === 'delaySpeed' || name === 'delayTurn' ? off : -off
  const [least, most] = HALF.map((part) => part * period)
  return least < late && late < most
    ? `It is about half of a step of the motion, ${brief(period)} s: a table of means over the step before is so late.`
    : ''
}
