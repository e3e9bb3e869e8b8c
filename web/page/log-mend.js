/**
 * What the verdict names, set at a press below it and undone at another. What no setting mends, the places of landmarks
 * and the size of wheels, is read otherwise than the files have it; σ that are wrong together are fitted together.
 */

import { button, part } from '../draw/dom.js'
import { bentBy, mostAreOut, rounded, shutOut, shutWords, untold, vague } from './log-fit-words.js'
import { GATE, gated, isOfFiles, remedies } from './log-remedy.js'

/** @typedef {import('../widgets/robot-log/words.js').Frame} Frame */
/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').LogCorrections} Corrections */
/** @typedef {import('./log-remedy.js').Remedy} Remedy */
/** @typedef {Record<string, unknown>} Patch */
/**
 * @typedef {object} Orders
 * @property {(patch: Patch) => void} change
 * @property {() => boolean} may whether the page has the files of the log
 * @property {(corrections: Corrections) => Promise<void>} reread how these are read otherwise
 * @property {(names: string[], gate: number | null, progress: (told: { done: number, of: number }) => void)
 *   => Promise<any>} fit
 * @property {(patch: Patch) => Promise<Patch>} settled what is set with σ that were found
 * @property {() => void} stop the fit
 */

const GIVEN_UP = 'The fit was given up.'

export class MendBar {
  /** @param {Orders} orders */
  constructor(orders) {
    this.orders = orders
    this.box = document.createElement('div')
    this.box.className = 'log-mend'
    this.box.setAttribute('role', 'group')
    this.box.setAttribute('aria-label', 'What the verdict proposes')
    // Here the focus waits for the next verdict: the next key sets nothing, and takes nothing back.
    this.box.tabIndex = -1
    this.presses = part(document, this.box, 'span', '')
    this.words = part(document, this.box, 'span', 'log-fitting')
    this.words.setAttribute('role', 'status')
    this.bar = /** @type {HTMLProgressElement} */ (part(document, this.box, 'progress', ''))
    this.bar.setAttribute('aria-label', 'Fit')
    this.end = button(document, this.box, 'Cancel', () => this.cancel())
    this.undoing = button(document, this.box, 'Undo the last press', () => this.undo())
    /** What the presses are of. @type {LogJudgement | null} */
    this.judgement = null
    /** What presses have set or corrected, and what was so before each. @type {{ mended: Remedy, before: Remedy }[]} */
    this.taken = []
    /** What is said of a fit beside the next verdict. */
    this.told = ''
    /** Whether the log that comes is this one, corrected. */
    this.correcting = false
    /** The fit that is under way. @type {Remedy | null} */
    this.fitting = null
    this.begin()
  }

  /** Another log, or this one as it is corrected. */
  begin() {
    if (this.correcting) return
    this.taken = []
    this.judgement = null
    this.giveUp()
    this.words.textContent = ''
    this.presses.replaceChildren()
    this.hold('')
    this.hide()
  }

  /** @param {Frame} frame @param {Patch} wanted what the reader has set last */
  show(frame, wanted) {
    const { judgement = null, judging } = frame
    const last = this.taken.at(-1)
    // What the reader has set otherwise since is not undone.
    const set = Object.entries(last?.mended.patch ?? {})
    if (set.some(([name, value]) => !same(wanted[name], value))) this.taken = []
    // While the next verdict is looked for, the presses keep their places and wait: nothing moves under the finger.
    // A fit of settings that the reader has changed meanwhile is of no use.
    if (judging) {
      this.giveUp()
      this.wait()
    } else if (judgement !== this.judgement) this.fill(judgement, frame, wanted)
    this.hide()
  }

  /** @param {LogJudgement | null} judgement @param {Frame} frame @param {Patch} wanted */
  fill(judgement, frame, wanted) {
    this.judgement = judgement
    this.presses.replaceChildren()
    this.words.textContent = this.told
    this.told = ''
    if (judgement) this.hold('')
    for (const remedy of remedies(judgement, frame))
      if (!remedy.corrections || this.orders.may())
        button(document, this.presses, remedy.press, () => this.take(remedy, frame, wanted), 'button')
    if (judgement && isOfFiles(judgement, frame)) this.toFiles()
  }

  /** A sign, a unit or a clock is the reader's to say, beside the file that has it. */
  toFiles() {
    /** @type {HTMLElement | null} */
    const field = document.querySelector('#log-files select')
    if (!field) return
    const link = /** @type {HTMLAnchorElement} */ (part(document, this.presses, 'a', ''))
    link.href = '#log-files'
    link.textContent = 'See how the files are read'
    // A jump to a place that takes no focus would leave the keys with the page.
    link.addEventListener('click', (event) => {
      event.preventDefault()
      field.focus()
    })
  }

  /**
   * Keeps what was set before a press, for Undo.
   * @param {Patch} patch what it sets @param {Patch} wanted @param {Corrections} [corrections] before it makes others
   */
  keep(patch, wanted, corrections) {
    const before = Object.fromEntries(Object.keys(patch).map((name) => [name, wanted[name]]))
    this.taken.push({ mended: { press: '', patch }, before: { press: '', patch: before, corrections } })
    this.hide()
  }

  /** Reads a part of the log alone. @param {[number, number]} part s since its first row @param {Frame['log']} log */
  keepPart(part, log) {
    if (!log?.corrections) return
    const [before] = log.corrections.kept ?? [0]
    const kept = /** @type {[number, number]} */ (part.map((time) => before + time))
    this.take({ press: '', corrections: { ...log.corrections, kept } }, { log }, {})
  }

  /** @param {Remedy} remedy @param {Pick<Frame, 'log'>} frame @param {Patch} wanted */
  take(remedy, { log }, wanted) {
    const { patch, fit } = remedy
    if (fit) return this.fit(remedy, fit, wanted)
    this.keep(patch ?? {}, wanted, remedy.corrections ? log?.corrections : undefined)
    this.hide()
    this.box.focus({ preventScroll: true })
    this.wait()
    this.hold()
    this.mend(remedy)
  }

  /**
   * Fits several σ and sets them.
   * @param {Remedy} remedy @param {string[]} names @param {Patch} wanted
   */
  async fit(remedy, names, wanted) {
    this.fitting = remedy
    this.hide()
    this.end.focus({ preventScroll: true })
    this.wait()
    this.words.textContent = 'Fitting …'
    this.bar.removeAttribute('value')
    const find = (/** @type {number | null} */ gates) =>
      this.orders.fit(names, gates, ({ done, of }) => {
        this.bar.max = of
        this.bar.value = done
      })
    const behind = await find(remedy.ungated ? null : GATE)
    const shut = behind.kind === 'fit' && !mostAreOut(behind.found) && shutOut(behind.found)
    if (this.fitting !== remedy) return
    const answer = shut ? await find(null) : behind
    if (this.fitting !== remedy) return
    if (answer.kind !== 'fit') {
      this.fitting = null
      return this.free(answer.message ?? answer.why ?? GIVEN_UP)
    }
    const { numbers } = answer.found
    if (mostAreOut(answer.found)) {
      this.fitting = null
      return this.free(bentBy(answer.found))
    }
    const off = { gate: { gate: null }, words: shut ? shutWords(behind.found) : '' }
    const { gate, words } = remedy.ungated || shut ? off : gated(answer.found, wanted)
    const free = untold(numbers, wanted)
    const found = { ...rounded(numbers), ...rounded(free) }
    const patch = await this.orders.settled({ ...found, ...gate })
    if (this.fitting !== remedy) return
    this.fitting = null
    this.told = [words, ...free.map((one) => one.words), ...vague(numbers)].join(' ').trim()
    this.words.textContent = ''
    this.hold()
    this.keep(patch, wanted)
    this.orders.change(patch)
    this.box.focus({ preventScroll: true })
  }

  /** Nothing has come of a fit. @param {string} words */
  free(words) {
    this.words.textContent = words
    for (const press of this.presses.children) /** @type {HTMLButtonElement} */ (press).disabled = false
    this.hide()
    this.presses.querySelector('button')?.focus({ preventScroll: true })
  }

  cancel() {
    this.giveUp()
    this.free(GIVEN_UP)
  }

  giveUp() {
    if (!this.fitting) return
    this.fitting = null
    this.words.textContent = ''
    this.orders.stop()
  }

  /** @param {Remedy} remedy */
  async mend({ patch, corrections }) {
    if (patch && Object.keys(patch).length > 0) this.orders.change(patch)
    if (!corrections) return
    this.correcting = true
    try {
      await this.orders.reread(corrections)
    } finally {
      this.correcting = false
    }
  }

  undo() {
    const last = this.taken.pop()
    if (!last) return
    this.box.focus({ preventScroll: true })
    this.wait()
    this.hold()
    this.mend(last.before)
  }

  /**
   * Keeps the verdict above as high as it is until the next one stands there: the words meanwhile are fewer.
   * @param {string} [height]
   */
  hold(height) {
    const verdict = this.box.parentElement?.querySelector('.verdict')
    if (verdict instanceof HTMLElement)
      verdict.style.minBlockSize = height ?? `${verdict.getBoundingClientRect().height}px`
  }

  wait() {
    for (const press of this.presses.children) /** @type {HTMLButtonElement} */ (press).disabled = true
  }

  hide() {
    this.end.hidden = this.bar.hidden = !this.fitting
    this.undoing.hidden = this.taken.length === 0 || Boolean(this.fitting)
    this.box.hidden = this.undoing.hidden && !this.presses.hasChildNodes()
  }
}

/** @param {unknown} one @param {unknown} other */
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other)
