/** What a fit of a log has found, in words, and what of it is taken. */

import { fixed } from '../draw/numbers.js'
import { isStair, ownStep } from '../widgets/robot-log/sized.js'
import { cutsFirst } from '../widgets/robot-log/gaps.js'
import { hides } from '../widgets/robot-log/sigmas.js'
import { told } from '../widgets/robot-log/named.js'
import { kind } from '../widgets/robot-log/kinds.js'
import { percent } from '../widgets/robot-log/words.js'
import { grouped } from './log-likelihood.js'

/** @typedef {import('estimate-wasm').LogFound} LogFound */

/** @type {Record<string, string>} */
const NAMES = {
  sigmaDistance: 'σ of the distance, m/√s',
  sigmaTurn: 'σ of the turn, rad/√s',
  sigmaFix: 'σ of a position, m',
  fixSigmaScale: 'factor on the positions’ own σ',
  sigmaHeading: 'σ of a heading, rad',
  headingSigmaScale: 'factor on the headings’ own σ',
  sigmaRange: 'σ of a range, m',
  sigmaBearing: 'σ of a bearing, rad',
  delaySpeed: 'delay of the speed, s',
  delayFix: 'delay of the positions, s',
  delayHeading: 'delay of the headings, s',
  delaySighting: 'delay of the ranges, s',
  scale: 'scale ε of the ranges',
  offset: 'offset of the ranges, m',
  bearingOffset: 'offset of the bearings, °',
  headingOffset: 'offset of the headings, °',
}

/** As they are set: six digits are enough for each. @param {{ name: string, value: number }[]} numbers */
export const rounded = (numbers) =>
  Object.fromEntries(numbers.map(({ name, value }) => [name, Number(value.toPrecision(6))]))

/**
 * What a verdict names and Fit does not look for: its error would go into what Fit finds.
 * @param {import('estimate-wasm').LogJudgement | null} judgement
 */
export function mendBefore(judgement) {
  const [fault] = judgement ? told(judgement) : []
  if (fault && cutsFirst(judgement?.gaps ?? []))
    return 'No motion is read for a while, as the verdict says: cut the log there before, or σ and delays mean nothing.'
  // Behind a gate outliers have a σ of their own, and Fit finds that; what seems to be one may be a landmark elsewhere.
  if (!fault || (fault.fault !== 'tails' && NAMES[fault.name ?? ''])) return ''
  return (
    `The verdict names ${kind(fault)}, which Fit does not look for: mend that before, or it makes ` +
    'each σ come out too large.'
  )
}

/** What has come of a fit. @param {Pick<LogFound, 'logLikelihood' | 'readings' | 'outliers' | 'settled'>} found */
export function rises({ logLikelihood: [before, after], readings, outliers, settled }) {
  const all = readings.toLocaleString('en')
  const gain = grouped(after - before)
  const ended = settled ? '' : ' The search was ended before it settled.'
  // What is said of outliers is part of that sum, and of no other on the page.
  if (outliers === null) return `The log-likelihood of ${all} readings rises by ${gain}, to ${grouped(after)}.${ended}`
  const are = outliers > 1 ? 'are outliers and were left out' : 'is an outlier and was left out'
  const out =
    outliers === 0 ? 'None is an outlier' : `${outliers.toLocaleString('en')} (${percent(outliers / readings)}) ${are}`
  return `The log-likelihood of ${all} readings rises by ${gain}. ${out}.${ended}`
}

/** A fit that leaves more than this share of the readings out has none to go by. */
const MOST_OUT = 0.5

/** Whether most readings count as outliers. @param {Pick<LogFound, 'readings' | 'outliers'>} found */
export const mostAreOut = ({ readings, outliers }) => (outliers ?? 0) > MOST_OUT * readings

/**
 * Gates that refuse this share more than outliers are shut the filter out: it loses its way behind them. Not where
 * there are as many outliers as this: another start than the one that is set may be what they refuse then.
 */
const SHUT_OUT = 0.15
const MANY_OUTLIERS = 0.05

/**
 * Whether the gates refuse far more than what is an outlier.
 * @param {Pick<LogFound, 'readings' | 'outliers' | 'refused'>} found
 */
export function shutOut({ readings, outliers, refused }) {
  const out = outliers ?? 0
  return out < MANY_OUTLIERS * readings && (refused ?? 0) > out + SHUT_OUT * readings
}

/** Why gates stay off. @param {Pick<LogFound, 'readings' | 'refused'>} found */
export const shutWords = ({ readings, refused }) =>
  `Behind gates the filter would lose its way, and refuse ${percent((refused ?? 0) / readings)} of the readings: ` +
  'they stay off.'

/**
 * What has bent a fit: outliers of sensors without a gate, or a gate that refuses most.
 * @param {Pick<LogFound, 'beyond' | 'expected' | 'readings' | 'outliers' | 'refused'>} found
 */
export function bentBy({ beyond, expected, readings, outliers, refused }) {
  if (mostAreOut({ readings, outliers }))
    return 'Most readings count as outliers, so something else is wrong, and nothing of it can be taken.'
  if (shutOut({ readings, outliers, refused }))
    return (
      `Under what was found the gates refuse ${percent((refused ?? 0) / readings)} of the readings: behind them the ` +
      'filter loses its way, and nothing of it can be taken. Switch the gates off, and fit again.'
    )
  const used = readings - (outliers ?? 0)
  if (!(beyond > 5 * expected * used && beyond > expected * used + 5)) return ''
  const far = `${percent(beyond / used)} of ${outliers ? 'the others' : 'these readings'} lie beyond what should hold`
  const [what, mend] = outliers
    ? ['a start or another fault that the verdict names, or outliers of a sensor without a gate,', 'Mend that first.']
    : [
        'outliers, or a fault that the verdict names,',
        'Mend first what it names, or switch on the gate of the sensor that has outliers, and Fit leaves them out.',
      ]
  return (
    `${far} ${fixed(100 * (1 - expected), 1)} % of them: ${what} have bent the fit: each σ comes out too large, and ` +
    `a delay may be anything. Nothing of it can be taken. ${mend}`
  )
}

/**
 * Whether a delay is so short that it may be the motion model’s own, which holds what it reads for a step: it is not
 * taken.
 * @param {LogFound['numbers'][number]} number @param {number} ownDelay how long it may be then, seconds
 */
export function isOfModel({ name, value, flat }, ownDelay) {
  return name.startsWith('delay') && !flat && ownDelay > 0 && Math.abs(value) <= ownDelay
}

/**
 * Whether a number that is no σ is told from what is set by less than twice its ±: it stays as it is set.
 * @param {LogFound['numbers'][number]} number @param {Record<string, any>} params
 */
export const isAsSet = ({ name, value, relative, sigma }, params) =>
  !relative && sigma !== null && Math.abs(value - (params[name] ?? 0)) < 2 * sigma

/**
 * Why a number stays as it is set; empty where it does not.
 * @param {LogFound['numbers'][number]} number @param {Record<string, any>} params
 * @param {string} told what the verdict on what is set says of it
 */
export function whyAsSet(number, params, told) {
  if (isAsSet(number, params)) return AS_SET
  return number.relative ? '' : told
}

/**
 * Why a verdict says of a number, by its name, that it stays. Delays are told against one another: one that may be
 * wrong leaves all open.
 * @param {import('estimate-wasm').LogJudgement | null} judgement
 * @returns {(name: string) => string}
 */
export function stayingBy(judgement) {
  if (!judgement) return () => ''
  if (judgement.other || mendBefore(judgement)) return () => FIRST
  const open = judgement.suspects.filter(({ standing }) => standing !== 'cleared')
  const names = open.flatMap(({ name, with: other }) => [name, other])
  const late = open.filter(({ fault }) => fault === 'clock')
  // What is no fault of the log is none to be taken off.
  const model = late.length > 0 && late.every(({ own }) => own) ? MODEL : ''
  return (name) => {
    if (name.startsWith('delay') && late.length > 0) return model
    return names.includes(name) ? '' : CLEARED
  }
}

const AS_SET = ': what is set lies within twice that, and stays'
const FIRST = ': what the verdict names may look like it and is to be mended first, so it stays'
const MODEL = ': the verdict on what is set calls it no fault, as it may be the motion model’s own, so it stays'
const CLEARED = ': the verdict on what is set does not find it wrong, so it stays; the likelihood may have several tops'
export const BENT = ': bent by outliers, and not taken'

/**
 * Whether all delays may be the motion model’s own. Only what sensors are late against one another is told: where
 * one is longer, all are taken, as they were found together.
 * @param {LogFound['numbers']} numbers @param {number} ownDelay
 */
export function delaysAreOfModel(numbers, ownDelay) {
  return numbers.every((number) => !number.name.startsWith('delay') || isOfModel(number, ownDelay))
}

/**
 * How well the log tells a number, and what may hide in it.
 * @param {LogFound['numbers'][number]} number
 * @param {{ pace: number, period: number, ownDelay: number, halfTurn?: number }} motion metres driven in a second,
 * seconds between its rows and of a delay that is the model’s own, 0 where none is, and half the mean turn of a step
 */
export function sentence(number, { pace, period, ownDelay, halfTurn = 0 }) {
  const { name, value, relative, sigma, flat, most } = number
  const words = NAMES[name] ?? name
  if (flat && isStair(flat, sigma))
    return `${words}: ${fixed(flat[0], 2)} to ${fixed(flat[1], 2)}, all alike: the log has no row of motion in between`
  const alike = most ? `; all up to about ${Number(most.toPrecision(2))} are as likely` : ''
  if (sigma === null) return `${words}: the log does not tell it${alike}.`
  const unit = words.endsWith('°') ? 180 / Math.PI : 1
  const told = (relative ? value * sigma : sigma) * unit
  const digits = decimalsOf(told)
  const more = name === 'sigmaDistance' ? hides(value, pace) : ''
  if (relative)
    return `${words}: ${fixed(value, digits)} ± ${fixed(100 * sigma, sigma < 0.1 ? 1 : 0)} %${more && `. ${more}`}`
  const own = isOfModel(number, ownDelay)
    ? `: less than ${ownStep({ period, ownDelay })}, which may be the motion model’s own, and not taken`
    : ''
  const half = halfTurn * unit
  const turns =
    name === 'bearingOffset' && Math.abs(half) > 0.5 * told
      ? `, of which ${fixed(half, digits)} may be the motion model’s own, half of the turn of a step`
      : ''
  return `${words}: ${fixed(value * unit, digits)} ± ${fixed(told, digits)}${turns}${own}`
}

/** A σ that is known less well than this is said so. */
const VAGUE = 0.3

/** What is said of σ that a log tells roughly. @param {LogFound['numbers']} numbers */
export const vague = (numbers) =>
  numbers
    .filter(({ relative, sigma }) => relative && sigma !== null && sigma > VAGUE)
    .map(({ name, sigma }) => `The ${(NAMES[name] ?? name).split(', ')[0]} is known to ± ${percent(sigma ?? 0)} only.`)

/**
 * The σ that a log does not tell, and what is made of each: as it is set, but no greater than one that is about as
 * likely as all smaller ones. A filter that is too sure of itself is the worse one.
 * @param {LogFound['numbers']} numbers @param {Record<string, any>} params
 */
export const untold = (numbers, params) =>
  numbers
    .filter(({ relative, sigma }) => relative && sigma === null)
    .map(({ name, most }) => {
      const now = params[name] ?? 0
      const value = Math.min(now, most ?? Infinity)
      const [words, unit = ''] = (NAMES[name] ?? name).split(', ')
      const much = (/** @type {number} */ number) => `${Number(number.toPrecision(2))} ${unit}`.trim()
      const alike = most === null ? '' : `all up to about ${much(most)} are as likely, and `
      const ends = value < now ? 'it is set so' : `it stays ${much(now)}`
      return { name, value, words: `The log does not tell the ${words}: ${alike}${ends}.` }
    })

/** So many decimals that an uncertainty has two digits. @param {number} sigma */
const decimalsOf = (sigma) => (sigma > 0 ? Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(sigma)))) : 12)
