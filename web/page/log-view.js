/** What of a log the panels show: whose innovations, which stretch of time, and the reading that was touched. */

import { button, part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { looksOf, nameOf, numbersOf, sourcesOf, touchedIn } from '../widgets/robot-log/looks.js'
import { numberField } from './number-field.js'

/** @typedef {import('../widgets/robot-log/looks.js').Frame} Frame */
/** @typedef {import('../widgets/robot-log/looks.js').Source} Source */

const HINT = 'Touch a reading for its place; drag across to look closer.'
const ALL = 'all readings'

export class ViewBar {
  /**
   * @param {(looks: any) => void} look
   * @param {{ may: () => boolean, keep: (window: [number, number], log: Frame['log']) => void }} orders whether the log
   *   can be read otherwise, and what reads a part of it alone
   */
  constructor(look, { may, keep }) {
    this.may = may
    this.box = document.createElement('div')
    this.box.className = 'log-view'
    const label = part(document, this.box, 'label', '')
    part(document, label, 'span', '').textContent = 'innovations of'
    this.select = /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
    this.select.addEventListener('change', () =>
      look({ source: this.sources[Number(this.select.value)] ?? null, touched: null }),
    )
    /** @type {Source[]} */
    this.sources = []
    this.said = ''
    /** @param {0 | 1} at @param {number} value */
    const set = (at, value) => {
      const other = this.window ?? [0, this.duration]
      const pair = at === 0 ? [value, other[1]] : [other[0], value]
      if (pair[0] < pair[1]) look({ window: pair })
    }
    this.from = numberField(this.box, 'from, s', (value) => set(0, value))
    this.to = numberField(this.box, 'to, s', (value) => set(1, value))
    this.whole = button(document, this.box, 'Whole log', () => look({ window: null }))
    this.alone = button(document, this.box, 'Read this part alone', () => {
      const { window } = this
      look({ window: null })
      if (window) keep(window, this.log)
    })
    this.words = part(document, this.box, 'p', 'log-touched')
    /** @type {Frame['log']} */
    this.log = null
    /** @type {[number, number] | null} */
    this.window = null
    this.duration = 0
  }

  /** @param {Frame} frame */
  show(frame) {
    const { window, source } = looksOf(frame)
    this.window = window
    this.duration = frame.duration
    const sources = sourcesOf(frame)
    const names = [ALL, ...sources.map((one) => nameOf(one, frame))]
    const said = JSON.stringify([sources, names])
    if (said !== this.said) {
      ;[this.said, this.sources] = [said, sources]
      this.select.replaceChildren(
        ...names.map((name, i) => {
          const option = document.createElement('option')
          option.value = String(i - 1)
          option.textContent = name
          return option
        }),
      )
    }
    this.select.value = String(sources.findIndex((one) => JSON.stringify(one) === JSON.stringify(source)))
    this.from.show(window?.[0] ?? 0)
    this.to.show(window?.[1] ?? frame.duration)
    this.whole.hidden = !window
    this.log = frame.log
    this.alone.hidden = !window || !frame.log?.corrections || !this.may()
    const words = touchedWords(frame)
    if (this.words.textContent !== words) this.words.textContent = words
  }
}

/** @param {Frame} frame */
function touchedWords(frame) {
  const i = touchedIn(frame)
  if (i < 0) return frame.innovations.time.length > 0 ? HINT : ''
  const { time, sensor, landmark, bearing, used } = frame.innovations
  const { source } = looksOf(frame)
  const turned = source?.bearing ? bearing[i] : null
  const value = numbersOf(frame, source)[i]
  const whose = nameOf({ sensor: sensor[i], landmark: landmark[i], bearing: turned !== null }, frame)
  const raw = turned === null ? '' : `${fixed((180 / Math.PI) * turned, 1)}°, `
  return `At ${fixed(time[i], 2)} s, ${whose}: ${raw}${fixed(value, 1)} σ, ${used[i] ? 'used' : 'refused'}.`
}
