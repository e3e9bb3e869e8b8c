/** Finds σ, delays, scales and offsets by the likelihood of a log's readings, and says how well the log tells them. */

import { button, part } from '../draw/dom.js'
import {
  BENT,
  bentBy,
  stayingBy,
  delaysAreOfModel,
  isAsSet,
  isOfModel,
  mendBefore,
  rises,
  rounded,
  sentence,
  untold,
  whyAsSet,
} from './log-fit-words.js'

/** @typedef {import('estimate-wasm').LogFound} LogFound */
/**
 * @typedef {object} Orders
 * @property {(only?: string[]) => Promise<any>} fit
 * @property {() => void} stop
 * @property {(patch: Record<string, unknown>) => void} take
 */

/** @param {string} words */
function line(words) {
  const text = document.createElement('p')
  text.textContent = words
  return text
}

export class FitForm {
  /** @param {HTMLElement} into @param {Orders} orders */
  constructor(into, orders) {
    this.orders = orders
    this.box = part(document, into, 'div', 'log-sensors')
    /** Whether the verdict on what is set is looked for, and what waits for it. */
    this.judging = false
    /** @type {(() => void) | null} */
    this.judged = null
    /** The settings that the fit that is shown was of, as text, and whether what it found is being taken. */
    this.of = ''
    this.taking = false
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
      'ranges, and the offsets of bearings and headings under which the readings are likeliest. Where a gate is on, ' +
      'outliers are left out. The first seconds, where a delay moves the start, do not count. A delay of all sensors ' +
      'together cannot be seen: the turn rate’s stays as it is, and without turn rates the speed’s.'
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
  show({ judgement, judging, params }) {
    /** What is set. @type {any} */
    this.params = params
    this.age(JSON.stringify(params))
    this.judging = Boolean(judging)
    if (!judging) this.judged?.()
    this.staying = stayingBy(judgement ?? null)
    if (this.first) this.first.textContent = mendBefore(judgement ?? null)
  }

  /** Says of a fit whether other settings have come since, but for its own. @param {string} now */
  age(now) {
    if (!this.of || now === this.of) return
    this.of = this.taking ? now : ''
    this.taking = false
    if (!this.of) this.result?.prepend(line('Found before the settings were changed:'))
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

  /** @param {string[]} [only] what it looks for, where that is not all */
  async fit(only) {
    const { result } = this
    if (!result) return
    this.wait(true)
    this.of = ''
    result.textContent = ''
    const answer = await this.orders.fit(only)
    // What is taken depends on the verdict, too.
    if (this.judging) await new Promise((resolve) => (this.judged = () => resolve(undefined)))
    if (result !== this.result) return // Another log has come.
    this.wait(false)
    this.begin?.focus({ preventScroll: true })
    if (answer.kind === 'fit') this.found(answer.found)
    else result.textContent = answer.message ?? answer.why ?? 'The fit was given up.'
    result.scrollIntoView({ block: 'nearest' })
  }

  /** @param {LogFound} found */
  found(found) {
    const { numbers, pace, period, ownDelay, halfTurn } = found
    const { result } = this
    if (!result) return
    this.of = JSON.stringify(this.params)
    part(document, result, 'p', '').textContent = rises(found)
    const bent = bentBy(found)
    if (bent) part(document, result, 'p', '').textContent = bent
    const list = part(document, result, 'ul', '')
    const own = delaysAreOfModel(numbers, ownDelay)
    const motion = { pace, period, ownDelay: own ? ownDelay : 0, halfTurn }
    const stays = (/** @type {LogFound['numbers'][number]} */ number) =>
      number.sigma === null ? '' : bent ? BENT : whyAsSet(number, this.params ?? {}, this.staying?.(number.name) ?? '')
    for (const number of numbers)
      part(document, list, 'li', '').textContent = `${sentence(number, motion)}${stays(number)}`
    const taken = numbers.filter((one) => one.sigma !== null && !isOfModel(one, motion.ownDelay) && !stays(one))
    if (taken.length === 0) return
    const actions = part(document, result, 'div', 'log-actions')
    // What was found beside a number that stays does not hold without it.
    const held = (/** @type {LogFound['numbers'][number]} */ one) => stays(one) && !isAsSet(one, this.params ?? {})
    if (numbers.some((one) => held(one) && !isOfModel(one, motion.ownDelay))) {
      const others = numbers.filter((one) => !held(one)).map(({ name }) => name)
      button(document, actions, 'Fit the others without these', () => this.fit(others))
      return
    }
    // What the log does not tell stays, where what was found beside it holds with it.
    const patch = rounded([...taken, ...untold(numbers, this.params ?? {})])
    button(document, actions, 'Take what the log tells', () => {
      this.taking = true
      this.orders.take(patch)
    })
  }
}
