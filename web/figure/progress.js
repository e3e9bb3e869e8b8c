/**
 * How far a figure has come that computes for longer than a moment, and a way to stop it: in the last line of its
 * sentence.
 */

import { button, part } from '../draw/dom.js'

/**
 * @typedef {{ step: number, of: number, unit?: string }} Work how far a computation has come, in steps if no unit is
 * given
 */

/** A computation that is over sooner than this, milliseconds, shows no bar. */
const PATIENCE = 500
/** The words change this often, milliseconds, so that they can be read. */
const WORDS_MS = 200

export class Progress {
  /**
   * @param {HTMLElement} into
   * @param {() => void} cancel
   */
  constructor(into, cancel) {
    const { ownerDocument: document } = into
    this.box = /** @type {HTMLElement} */ (
      part(document, part(document, into, 'div', 'progress-place'), 'div', 'progress')
    )
    this.bar = /** @type {HTMLProgressElement} */ (part(document, this.box, 'progress', ''))
    this.bar.setAttribute('aria-label', 'Computed')
    this.words = part(document, this.box, 'span', '')
    button(document, this.box, 'Cancel', cancel)
    this.box.hidden = true
    /** When the present computation was first heard of. */
    this.began = NaN
    this.wrote = -Infinity
  }

  /**
   * @param {Work | null} progress null when nothing is being computed
   * @param {number} now
   * @returns {boolean} whether the bar has appeared with this call
   */
  show(progress, now) {
    if (!progress) {
      this.began = NaN
      this.box.hidden = true
      return false
    }
    if (Number.isNaN(this.began)) this.began = now
    if (now - this.began < PATIENCE) return false
    const appears = this.box.hidden
    this.box.hidden = false
    this.bar.max = progress.of
    this.bar.value = progress.step
    if (appears || now - this.wrote > WORDS_MS) {
      this.words.textContent = wordsOf(progress)
      this.wrote = now
    }
    return appears
  }
}

/** @param {Work} progress */
function wordsOf({ step, of, unit = 'step' }) {
  return `Computing ${unit} ${step.toLocaleString('en')} of ${of.toLocaleString('en')}`
}
