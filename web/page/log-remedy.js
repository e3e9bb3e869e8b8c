/** What mends a fault that the verdict names, as its sentence says: a setting, a fit of several, or another reading. */

import { decimal, fixed } from '../draw/numbers.js'
import { isLate, startBelow } from '../widgets/robot-log/antenna.js'
import { factors } from '../widgets/robot-log/driven.js'
import { cutsFirst, longest } from '../widgets/robot-log/gaps.js'
import { rounded } from '../widgets/robot-log/sized.js'
import { wrapped } from '../widgets/robot-log/start.js'
import { counted, unsettled } from '../widgets/robot-log/unsettled.js'
import { mayBeCourse, told } from '../widgets/robot-log/named.js'
import { apart } from '../widgets/robot-log/noise.js'
import { bySensor } from './log-numbers.js'

/** @typedef {import('../widgets/robot-log/words.js').Frame} Frame */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/**
 * Settings, what is read otherwise, or the names of what is fitted, and whether without the gates.
 * @typedef {{ press: string, patch?: Record<string, unknown>, corrections?: import('estimate-wasm').LogCorrections,
 *   fit?: string[], ungated?: boolean }} Remedy
 */

/** What refuses outliers and next to nothing else. */
export const GATE = 0.999
const DEGREE = Math.PI / 180
/** The delays of readings that come late together, in the order of their sizes. */
const TOGETHER = /** @type {const} */ (['delayFix', 'delayHeading', 'delaySighting'])
const DELAYS = /** @type {const} */ (['delaySpeed', 'delayTurn', ...TOGETHER])
/** The longest delay that is tried from none, s. */
const FAR = 3
/** Faults that another reading of the files mends. */
const READ_OTHERWISE = [
  'odometry',
  'lengths',
  'wheel-size',
  'turn-scale',
  'unequal-wheels',
  'landmark-bias',
  'exchanged',
  'displaced',
]
/** What the filter learns by itself, by the number that is off. @type {Record<string, string>} */
const LEARNED = { turnBias: 'learnBias', speedScale: 'learnSpeed' }

/**
 * A size as its sentence says it, in the filter's unit.
 * @param {Suspect['sizes'][number]} size @param {number} [times] what one of its units is in the sentence's
 */
const said = (size, times = 1) => Number((rounded(size, times) / times).toPrecision(12))

/**
 * What is read otherwise where landmarks or odometry are wrong; null where they are not, or a unit is.
 * @param {Suspect} suspect @param {Frame['log']} log
 * @returns {Remedy | null}
 */
function corrected({ fault, landmarks: ids, sizes }, log) {
  if (!log?.corrections) return null
  const { driven, landmarks: moved, ranges, swerve = 0 } = log.corrections
  if (fault === 'lengths') {
    if (sizes[0].end || sizes[2].end) return null
    const [along] = factors([sizes[2]])
    return {
      press: 'Take them so',
      patch: { scale: said(sizes[0], 100), offset: said(sizes[1]) },
      corrections: { ...log.corrections, driven: [driven[0] * along, driven[1]], swerve: swerve / along },
    }
  }
  if (['odometry', 'wheel-size', 'turn-scale'].includes(fault)) {
    if (sizes[0].end) return null
    const [first, second = fault === 'odometry' ? 1 : first] = factors(sizes)
    const [along, about] = fault === 'turn-scale' ? [1, first] : [first, second]
    return {
      press: 'Take them so',
      // What was added for each metre is counted in the turns and metres of before.
      corrections: {
        ...log.corrections,
        driven: [driven[0] * along, driven[1] * about],
        swerve: Number(((swerve * about) / along).toPrecision(12)),
      },
    }
  }
  if (fault === 'unequal-wheels') {
    if (sizes[0].end) return null
    const more = Number((swerve + said(sizes[0], 1 / DEGREE)).toPrecision(12))
    return { press: 'Take them so', corrections: { ...log.corrections, swerve: more } }
  }
  const at = (/** @type {number} */ id) => log.landmarks?.find((one) => one.id === id)
  const [one, other = one] = ids ?? []
  if (fault === 'landmark-bias' && sizes.length > 0) {
    // What was taken off before is counted in.
    const before = ranges.find(([id]) => id === one)?.[1] ?? 0
    const by = Number((before + said(sizes[0])).toPrecision(12))
    const others = ranges.filter(([id]) => id !== one)
    return { press: 'Take them so', corrections: { ...log.corrections, ranges: [...others, [one, by]] } }
  }
  const [here, there] = [at(one), at(other)]
  if (!here || !there) return null
  const [x, y] = sizes.map((size) => said(size))
  /** @type {[number, number, number][]} */
  const places =
    fault === 'displaced'
      ? [[one, x, y]]
      : [
          [one, there.x, there.y],
          [other, here.x, here.y],
        ]
  const others = moved.filter(([id]) => !ids?.includes(id))
  const press = fault === 'displaced' ? 'Take it there' : 'Exchange them'
  return { press, corrections: { ...log.corrections, landmarks: [...others, ...places] } }
}

/**
 * The longest stretch of a log between gaps in its motion, which is read alone.
 * @param {LogJudgement} judgement @param {Frame['log']} log
 * @returns {(Remedy & { only: boolean }) | null} `only` where nothing else is to be pressed first
 */
function cut({ gaps, suspects: [first] }, log) {
  if (!log?.corrections || gaps.length === 0 || first.standing === 'cleared') return null
  const { between } = longest(gaps)
  const [before] = log.corrections.kept ?? [0]
  const [from, to] = between.map((time) => fixed(time, 1))
  return {
    press: `Cut the log: keep ${from} to ${to} s`,
    corrections: { ...log.corrections, kept: [before + between[0], before + between[1]] },
    only: cutsFirst(gaps),
  }
}

/**
 * The setting that mends a fault as its sentence says, and the words of the press; null where the reader has to mend
 * the file, a unit or the truth.
 * @param {Suspect} suspect @param {Frame['params']} params @param {boolean} truth @param {Frame['log']} [log]
 * @returns {Remedy | null}
 */
export function remedy(suspect, params, truth, log = null) {
  const { fault, name, with: other, sensor, sizes, times: read } = suspect
  if (['mirrored', 'mirrored-bearings'].includes(fault)) return null
  if (READ_OTHERWISE.includes(fault)) return corrected(suspect, log)
  if (fault === 'tails') {
    const gate = { ...bySensor(params.gate), [sensor ?? 'fix']: GATE }
    const behind = name !== null && sizes.length > 1
    return behind
      ? { press: 'Switch the gate on, with that σ', patch: { gate, [name]: said(sizes[1]) } }
      : { press: 'Switch the gate on', patch: { gate } }
  }
  // One beyond all that are tried is set once: further on it is no sensor that is late, but a file's clock.
  if (fault === 'clock' && sizes[0].end && DELAYS.some((one) => Math.abs(params[one] ?? 0) >= FAR)) return null
  if (fault === 'start') {
    if (truth) return null
    const [x, y, theta] = sizes
    const start = [said(x), said(y), said({ ...theta, value: wrapped(theta.value) }, 1 / DEGREE)]
    return { press: 'Set the start so', patch: { start } }
  }
  if (fault === 'antenna') {
    const [antennaAhead, antennaLeft, delay] = sizes.map((size) => said(size))
    const patch = { antennaAhead, antennaLeft, ...(isLate(sizes[2]) ? { [other ?? 'delayFix']: delay } : {}) }
    const start = truth || !params.start ? {} : { start: startBelow(params, patch) }
    return { press: 'Set its place so', patch: { ...patch, ...start } }
  }
  // It may be in another unit, which is the reader's to say.
  if (fault === 'scale' && (sizes[0].end || read?.unit)) return null
  const learned = LEARNED[name ?? '']
  if (learned) return { press: 'Let the filter learn it', patch: { [learned]: true } }
  const names = sizes.length > 2 ? TOGETHER : [name, other].filter((one) => one !== null)
  const times = fault === 'turned' ? 1 / DEGREE : fault === 'scale' ? 100 : 1
  const patch = Object.fromEntries(names.map((one, i) => [one, said(sizes[i], i === 0 ? times : 1)]))
  return { press: names.length > 1 ? 'Set them so' : 'Set it so', patch }
}

/**
 * The presses for what a judgement names: one, or two where the readings do not tell which it is; before them one that
 * cuts the log where its motion is not read.
 * @param {LogJudgement | null} judgement @param {Frame} frame
 * @returns {Remedy[]}
 */
export function remedies(judgement, frame) {
  const first = judgement && cut(judgement, frame.log)
  const { thinning = null } = judgement ?? {}
  const mends = mending(judgement, frame)
  const all = thinning ? either([thinned(thinning, frame.params), ...mends]) : mends
  if (!first) return all
  const { only, ...press } = first
  return only ? [press] : [press, ...all]
}

/**
 * @param {LogJudgement | null} judgement @param {Frame} frame
 * @returns {Remedy[]}
 */
function mending(judgement, { params, truth, log }) {
  // What may be no fault has no press.
  const suspects = judgement ? told(judgement, log).filter(({ own }) => !own) : []
  const together = judgement ? unsettled(judgement, params) : []
  // What is said without the gate is mended without it.
  const off = judgement?.ungated ? { ungated: true } : {}
  if (together.length > 1) return [{ press: `Fit ${counted(together)} σ`, fit: together, ...off }]
  const course = mayBeCourse(suspects, params, log ?? null)
  const without = course ? [{ press: 'Leave the courses out', patch: { headings: false } }] : []
  return either([...suspects.map((suspect) => remedy(suspect, params, Boolean(truth), log)), ...without])
}

/**
 * Whether what a judgement names, or a part of it, is mended where the files are read alone: a sign, a unit, a clock.
 * @param {LogJudgement} judgement @param {Frame} frame
 */
export const isOfFiles = (judgement, { params, truth, log }) =>
  told(judgement, log).some((suspect) => !suspect.own && !remedy(suspect, params, Boolean(truth), log))

/** One that mends it, or one of two. @param {(Remedy | null)[]} all @returns {Remedy[]} */
const either = (all) =>
  all.flatMap((one, i) => {
    if (!one) return []
    const { press } = one
    const which = i === 0 ? 'Either' : 'Or'
    return [{ ...one, press: all.length > 1 ? `${which}: ${press[0].toLowerCase()}${press.slice(1)}` : press }]
  })

/**
 * Takes fixes so far apart that they err apart.
 * @param {LogJudgement['thinning'] & {}} thinning @param {Frame['params']} params @returns {Remedy}
 */
const thinned = (thinning, params) => ({
  press: `Take those ${apart(thinning)}`,
  patch: { every: { ...bySensor(params.every), fix: thinning.every } },
})

/**
 * The gates without which σ that were found beside outliers are of no use, and what is said of that.
 * @param {import('estimate-wasm').LogFound} found @param {Record<string, any>} params
 * @returns {{ gate: Record<string, unknown>, words: string }}
 */
export function gated({ outliers, readings, expected }, params) {
  const set = bySensor(params.gate)
  const chance = expected * readings
  const none = Object.values(set).every((gate) => gate === null)
  if (!none || outliers === null || outliers <= chance + 3 * Math.sqrt(chance)) return { gate: {}, words: '' }
  const share = decimal((100 * outliers) / readings, 1)
  return { gate: { gate: GATE }, words: `${share} % of the readings are outliers: the gates are on, and refuse them.` }
}
