/** The log-likelihood, always in sight: how it changed with the last setting, and against the replay A. */

import { button, part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { looksOf } from '../widgets/robot-log/looks.js'

/** @typedef {import('../widgets/robot-log/looks.js').Frame} Frame */
/** @typedef {{ change: (patch: Record<string, unknown>) => void, look: (looks: any) => void }} Orders */

export class LikelihoodLine {
  /** @param {Orders} orders */
  constructor({ change, look }) {
    this.box = document.createElement('div')
    this.box.className = 'log-tells'
    this.words = part(document, this.box, 'p', 'log-likelihood')
    const actions = part(document, this.box, 'div', 'log-actions')
    this.keep = button(document, actions, 'Keep this as A', () => look({ kept: this.present }))
    this.back = button(document, actions, 'Back to A', () => {
      if (this.kept) change({ ...this.kept.params })
    })
    this.drop = button(document, actions, 'Drop A', () => {
      look({ kept: null })
      this.keep.focus({ preventScroll: true })
    })
    /** @type {Frame | null} */
    this.present = null
    /** @type {Frame | null} */
    this.kept = null
    /** The frame of the setting before. @type {Frame | null} */
    this.before = null
  }

  /** Another log: what was said of the one before is not compared. */
  begin() {
    this.present = null
    this.before = null
  }

  /** @param {Frame} frame */
  show(frame) {
    this.before = settingBefore(this.before, this.present, frame)
    this.present = frame
    this.kept = looksOf(frame).kept
    const words = sentence(frame, this.before, this.kept)
    if (this.words.textContent !== words) this.words.textContent = words
    this.back.hidden = this.drop.hidden = !this.kept
  }
}

/**
 * The frame of the setting before, once another frame comes. A log that has just come shows the one before once more,
 * which is no setting of its own.
 * @param {Frame | null} before @param {Frame | null} present @param {Frame} frame
 */
export function settingBefore(before, present, frame) {
  if (present && present.log !== frame.log) return null
  return present && JSON.stringify(present.params) !== JSON.stringify(frame.params) ? present : before
}

/** @param {Frame} frame @param {Frame | null} before @param {Frame | null} kept */
export function sentence({ summary }, before, kept) {
  const { logLikelihood, used } = summary
  if (logLikelihood === null) return 'Log-likelihood: no reading has been used yet.'
  const now = `Log-likelihood ${grouped(logLikelihood)} of ${readings(used)}`
  const changes = [against(summary, before, 'the last setting'), against(summary, kept, 'A')].filter(Boolean)
  return `${[now, ...changes].join('; ')}.`
}

/**
 * Sums over other readings are not compared: refusing some raises them.
 * @param {Frame['summary']} now @param {Frame | null} other @param {string} name */
function against({ logLikelihood, used }, other, name) {
  const was = other?.summary.logLikelihood
  if (was === undefined || was === null || logLikelihood === null || !other) return ''
  if (other.summary.used !== used)
    return `${name} used ${readings(other.summary.used)}, and a sum over others is no measure`
  const change = logLikelihood - was
  return `${change > 0 ? '+' : ''}${grouped(change)} against ${name}`
}

/** With a digit behind the point and commas between thousands: changes of a tenth count. @param {number} value */
export function grouped(value) {
  const digits = { minimumFractionDigits: 1, maximumFractionDigits: 1 }
  return Math.abs(value) < 1e15 ? value.toLocaleString('en', digits).replace('-', '−') : fixed(value, 1)
}

/** @param {number} count */
const readings = (count) => `${count.toLocaleString('en')} ${count === 1 ? 'reading' : 'readings'}`
