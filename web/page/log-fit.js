/** Finds σ, delays, scales and offsets by the likelihood of a log's readings, and says how well the log tells them. */

import { button, part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { isStair } from '../widgets/robot-log/sized.js'
import { hides } from '../widgets/robot-log/sigmas.js'
import { kind, named } from '../widgets/robot-log/verdict.js'
import { percent } from '../widgets/robot-log/words.js'
import { grouped } from './log-likelihood.js'

/** @typedef {import('estimate-wasm').LogFound} LogFound */
/** @typedef {{ fit: () => Promise<any>, stop: () => void, take: (patch: Record<string, unknown>) => void }} Orders */

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

export class FitForm {
  /** @param {HTMLElement} into @param {Orders} orders */
  constructor(into, orders) {
    this.orders = orders
    this.box = part(document, into, 'div', 'log-sensors')
  }

  /** @param {import('estimate-wasm').LogContents} contents */
  take({ readings }) {
    this.orders.stop()
    this.box.replaceChildren()
    if (Object.keys(readings).length === 0) return
    const row = part(document, this.box, 'fieldset', 'log-sensor')
    part(document, row, 'legend', '').textContent = 'fit'
    const words = part(document, row, 'p', 'log-says')
    words.textContent =
      'Fit finds the σ, or the factor on what readings bring as theirs, the delays, the scale and the offset of ' +
      'ranges, and the offsets of bearings and headings under which the readings are likeliest. Gates are ' +
      'off meanwhile, and the first seconds, where a delay moves the start, do not count. A delay of all sensors ' +
      'together cannot be seen: the turn rate’s is 0, and without turn rates the speed’s stays as it is.'
    this.first = part(document, row, 'p', 'log-says')
    const actions = part(document, row, 'div', 'log-actions')
    this.result = part(document, row, 'div', 'log-says')
    this.result.setAttribute('role', 'status')
    this.begin = button(document, actions, 'Fit', () => this.fit())
    this.bar = /** @type {HTMLProgressElement} */ (part(document, actions, 'progress', ''))
    this.bar.setAttribute('aria-label', 'Fit')
    this.end = button(document, actions, 'Cancel', () => this.orders.stop())
    this.wait(false)
  }

  /** Says what is to be mended before. @param {import('../widgets/robot-log/words.js').Frame} frame */
  show({ judgement, params }) {
    /** What is set. @type {any} */
    this.params = params
    /** Whether nothing is wrong as it is set. */
    this.sound = judgement?.suspects[0]?.standing === 'cleared'
    if (this.first) this.first.textContent = mendBefore(judgement ?? null)
  }

  /** @param {boolean} waiting */
  wait(waiting) {
    if (!this.begin || !this.bar || !this.end) return
    this.begin.disabled = waiting
    this.bar.hidden = !waiting
    this.end.hidden = !waiting
    this.bar.removeAttribute('value')
    // The strip scrolls by itself: its end may hide what was begun here.
    if (waiting) this.end.scrollIntoView({ block: 'nearest' })
  }

  /** @param {{ done: number, of: number }} told */
  progress({ done, of }) {
    if (!this.bar) return
    this.bar.max = of
    this.bar.value = done
  }

  async fit() {
    const { result } = this
    if (!result) return
    this.wait(true)
    result.textContent = ''
    const answer = await this.orders.fit()
    if (result !== this.result) return // Another log has come.
    this.wait(false)
    this.begin?.focus({ preventScroll: true })
    if (answer.kind === 'fit') this.found(answer.found)
    else result.textContent = answer.message ?? answer.why ?? 'The fit was given up.'
    result.scrollIntoView({ block: 'nearest' })
  }

  /** @param {LogFound} found */
  found({ numbers, logLikelihood: [before, after], readings, settled, beyond, expected, pace, period }) {
    const { result } = this
    if (!result) return
    const gain = grouped(after - before)
    part(document, result, 'p', '').textContent =
      `The log-likelihood of ${readings.toLocaleString('en')} readings rises by ${gain}, to ${grouped(after)}.` +
      `${settled ? '' : ' The search was ended before it settled.'}`
    const bent = bentBy(beyond, expected, readings)
    if (bent) part(document, result, 'p', '').textContent = bent
    const list = part(document, result, 'ul', '')
    const own = delaysAreOfModel(numbers, period)
    const motion = { pace, period: own ? period : 0 }
    const stays = (/** @type {LogFound['numbers'][number]} */ number) =>
      number.sigma === null ? '' : bent ? BENT : whyAsSet(number, this.params ?? {}, Boolean(this.sound))
    for (const number of numbers)
      part(document, list, 'li', '').textContent = `${sentence(number, motion)}${stays(number)}`
    const patch = Object.fromEntries(
      numbers
        .filter((number) => number.sigma !== null && !isOfModel(number, motion.period) && !stays(number))
        .map(({ name, value }) => [name, Number(value.toPrecision(6))]),
    )
    if (Object.keys(patch).length === 0) return
    const actions = part(document, result, 'div', 'log-actions')
    button(document, actions, 'Take what the log tells', () => this.orders.take({ ...patch, delayTurn: 0 }))
  }
}

/**
 * What a verdict names and Fit does not look for: its error would go into what Fit finds.
 * @param {import('estimate-wasm').LogJudgement | null} judgement
 */
export function mendBefore(judgement) {
  const [fault] = judgement ? named(judgement) : []
  if (!fault || NAMES[fault.name ?? '']) return ''
  return (
    `The verdict names ${kind(fault)}, which Fit does not look for: mend that before, or it makes ` +
    'each σ come out too large.'
  )
}

/**
 * What outliers have done to a fit, which has no gate.
 * @param {number} beyond @param {number} share @param {number} readings
 */
export function bentBy(beyond, share, readings) {
  const expected = share * readings
  if (!(beyond > 5 * expected && beyond > expected + 5)) return ''
  return (
    `${percent(beyond / readings)} of these readings lie beyond what should hold ` +
    `${fixed(100 * (1 - share), 1)} % of them: ` +
    'outliers have bent the fit, as it has no gate: each σ comes out too large, and a delay may be anything. ' +
    'Nothing of it can be taken; leave those readings out of the file first.'
  )
}

/**
 * Whether a delay is so short that it may be the motion model’s own, which holds what it reads for a step: it is not
 * taken.
 * @param {LogFound['numbers'][number]} number @param {number} period seconds between rows of motion
 */
export function isOfModel({ name, value, flat }, period) {
  return name.startsWith('delay') && !flat && Math.abs(value) <= period / 2
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
 * @param {boolean} sound whether the verdict on what is set finds no fault
 */
export function whyAsSet(number, params, sound) {
  if (isAsSet(number, params)) return AS_SET
  return sound && !number.relative ? SOUND : ''
}

const AS_SET = ': what is set lies within twice that, and stays'
const SOUND = ': the verdict on what is set finds no fault, so it stays; the likelihood may have several tops'
const BENT = ': bent by outliers, and not taken'

/**
 * Whether all delays may be the motion model’s own. Only what sensors are late against one another is told: where
 * one is longer, all are taken, as they were found together.
 * @param {LogFound['numbers']} numbers @param {number} period
 */
export function delaysAreOfModel(numbers, period) {
  return numbers.every((number) => !number.name.startsWith('delay') || isOfModel(number, period))
}

/**
 * How well the log tells a number, and what may hide in it.
 * @param {LogFound['numbers'][number]} number
 * @param {{ pace: number, period: number }} motion metres driven in a second, seconds between its rows; 0 where no
 * delay is the model’s own
 */
export function sentence(number, { pace, period }) {
  const { name, value, relative, sigma, flat } = number
  const words = NAMES[name] ?? name
  if (flat && isStair(flat, sigma))
    return `${words}: ${fixed(flat[0], 2)} to ${fixed(flat[1], 2)}, all alike: the log has no row of motion in between`
  if (sigma === null) return `${words}: the log does not tell it.`
  const unit = words.endsWith('°') ? 180 / Math.PI : 1
  const told = (relative ? value * sigma : sigma) * unit
  const digits = decimalsOf(told)
  const more = name === 'sigmaDistance' ? hides(value, pace) : ''
  if (relative)
    return `${words}: ${fixed(value, digits)} ± ${fixed(100 * sigma, sigma < 0.1 ? 1 : 0)} %${more && `. ${more}`}`
  const own = isOfModel(number, period)
    ? `: less than half a step of ${fixed(period, 3)} s between rows of motion, ` +
      'which may be the motion model’s own, and not taken'
    : ''
  return `${words}: ${fixed(value * unit, digits)} ± ${fixed(told, digits)}${own}`
}

/** So many decimals that an uncertainty has two digits. @param {number} sigma */
const decimalsOf = (sigma) => (sigma > 0 ? Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(sigma)))) : 12)
