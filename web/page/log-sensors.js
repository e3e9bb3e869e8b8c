/**
 * What the filter is told of each sensor of the reader's log, a row for each: whether it is used, its σ, delay, gate
 * and how often; beside it what its readings say. Then the start, and what is done afterwards.
 */

import { part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { percent } from '../widgets/robot-log/words.js'
import { GATES, HELD, MOTION, SENSORS, acts, boundsOf, bySensor, learnedWords, ownFactor } from './log-numbers.js'
import { numberSlider } from './log-slider.js'
import { numberField } from './number-field.js'

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {Record<string, unknown>} Patch */

export class SensorForm {
  /**
   * @param {HTMLElement} into
   * @param {(patch: Patch) => void} change
   * @param {() => import('estimate-wasm').Parameter[]} parameters of the filter, with their bounds
   */
  constructor(into, change, parameters) {
    this.change = change
    this.parameters = parameters
    this.box = part(document, into, 'div', 'log-sensors')
    /** What shows a frame. @type {((frame: Frame) => void)[]} */
    this.shows = []
  }

  /** Builds the rows that a log has. @param {LogContents} contents */
  take(contents) {
    const { readings, motion } = contents
    this.box.replaceChildren()
    this.shows = []
    for (const sensor of SENSORS) if (readings[/** @type {'fix'} */ (sensor.name)]) this.sensor(sensor, contents)
    const row = this.row('motion')
    for (const number of [...MOTION, ...HELD].filter(([name]) => acts(contents, name))) this.number(row, number)
    if (motion === 'velocity') {
      if (acts(contents, 'learnSpeed')) this.toggle(row, 'learnSpeed', 'learn the scale of the speed')
      if (acts(contents, 'learnBias')) this.toggle(row, 'learnBias', 'learn the bias of the turn rate')
      this.says(row, ({ summary }) => {
        const { speed, bias } = learnedWords(summary)
        return [speed && `Speed ${speed}.`, bias && `Bias ${bias}.`].join(' ').trim()
      })
    }
  }

  /** @param {Frame} frame */
  show(frame) {
    for (const show of this.shows) show(frame)
  }

  /** @param {(typeof SENSORS)[number]} sensor @param {LogContents} contents */
  sensor({ name, words, on, numbers }, contents) {
    const row = this.row(words)
    const key = /** @type {'fix'} */ (name)
    const count = contents.readings[key]
    this.toggle(row, on, 'used')
    for (const number of numbers.filter(([name]) => acts(contents, name))) {
      this.number(row, number)
      const own = ownFactor(contents, number[0])
      if (own) part(document, row, 'p', 'log-says').textContent = own
    }
    if (on === 'sightings') this.toggle(row, 'learn', 'learn the scale\u00a0ε')
    this.gate(row, key)
    this.every(row, key)
    this.says(row, (frame) => {
      const said = frame.summary.sensors[key]
      const { used = 0, refused = 0, nis = null, meanInnovation = null } = said ?? {}
      if (used + refused === 0) return `${(count ?? 0).toLocaleString('en')} readings, none taken so far.`
      const share = refused === 0 ? 'none refused' : `${percent(refused / (used + refused))} refused`
      return (
        `${used.toLocaleString('en')} used, ${share}, NIS ${fixed(nis, 2)}, ` +
        `mean of ν/√S ${fixed(meanInnovation, 2)}${across(said)}.`
      )
    })
  }

  /** @param {string} words */
  row(words) {
    const row = part(document, this.box, 'fieldset', 'log-sensor')
    part(document, row, 'legend', '').textContent = words
    return row
  }

  /** @param {HTMLElement} row @param {string} name @param {string} words */
  toggle(row, name, words) {
    const label = part(document, row, 'label', 'log-toggle')
    const input = /** @type {HTMLInputElement} */ (part(document, label, 'input', ''))
    input.type = 'checkbox'
    part(document, label, 'span', '').textContent = words
    input.addEventListener('change', () => this.change({ [name]: input.checked }))
    this.shows.push(({ params }) => {
      input.checked = Boolean(/** @type {any} */ (params)[name])
    })
  }

  /** @param {HTMLElement} row @param {import('./log-numbers.js').Told} number */
  number(row, [name, words, scale, unit = 1]) {
    const change = (/** @type {number} */ value) => this.change({ [name]: value * unit })
    const slider = numberSlider(row, words, scale, change, () => boundsOf(this.parameters(), name, unit))
    // A scale that the filter learns is not told.
    this.shows.push(({ params }) =>
      slider.show(/** @type {any} */ (params)[name] / unit, name === 'scale' && params.learn),
    )
  }

  /** @param {HTMLElement} row @param {'fix'} key of the sensor */
  every(row, key) {
    /** @type {any} */
    let every = 0
    const change = (/** @type {number} */ value) => this.change({ every: { ...bySensor(every), [key]: value } })
    const field = numberField(row, 'least gap in time, s', change, () => boundsOf(this.parameters(), 'every'))
    this.shows.push(({ params }) => {
      every = params.every
      field.show(bySensor(every)[key] ?? 0)
    })
  }

  /** @param {HTMLElement} row @param {'fix'} key of the sensor */
  gate(row, key) {
    const label = part(document, row, 'label', '')
    part(document, label, 'span', '').textContent = 'gate'
    const select = /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
    for (const [i, value] of GATES.entries()) {
      const option = /** @type {HTMLOptionElement} */ (part(document, select, 'option', ''))
      option.value = String(i)
      option.textContent = value === null ? 'off' : `${fixed(100 * value, 1)} %`
    }
    /** @type {any} */
    let gate = null
    select.addEventListener('change', () =>
      this.change({ gate: { ...bySensor(gate), [key]: GATES[Number(select.value)] } }),
    )
    this.shows.push(({ params }) => {
      gate = params.gate
      select.value = String(GATES.indexOf(bySensor(gate)[key] ?? null))
    })
  }

  /** @param {HTMLElement} row @param {(frame: Frame) => string} words */
  says(row, words) {
    const line = part(document, row, 'p', 'log-says')
    this.shows.push((frame) => {
      line.textContent = words(frame)
    })
  }
}

/** What a fix is off along and across the heading: a delay shows along it. @param {any} said */
function across(said) {
  if (said?.meanAlong === undefined || said.meanAlong === null) return ''
  return `, along the heading ${fixed(said.meanAlong, 2)}, across it ${fixed(said.meanAcross, 2)}`
}
