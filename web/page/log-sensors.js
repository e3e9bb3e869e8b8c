/**
 * What the filter is told of each sensor of the reader's log, a row for each: whether it is used, its σ, delay, gate
 * and how often; beside it what its readings say. Then the start, and what is done afterwards.
 */

import { part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { percent } from '../widgets/robot-log/words.js'
import { numberField } from './number-field.js'

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {Record<string, unknown>} Patch */

/** The sensors of readings, by their names in the summary. */
const SENSORS = [
  { name: 'fix', words: 'positions', on: 'fixes', delay: 'delayFix', sigmas: [['sigmaFix', 'σ, m']] },
  { name: 'heading', words: 'headings', on: 'headings', delay: 'delayHeading', sigmas: [['sigmaHeading', 'σ, rad']] },
  { name: 'range', words: 'ranges', on: 'sightings', delay: 'delaySighting', sigmas: [['sigmaRange', 'σ, m']] },
  {
    name: 'bearing',
    words: 'ranges with bearings',
    on: 'sightings',
    delay: 'delaySighting',
    sigmas: [
      ['sigmaRange', 'σ of the range, m'],
      ['sigmaBearing', 'σ of the bearing, rad'],
    ],
  },
]
/** What is known of the motion. @type {[string, string][]} */
const MOTION = [
  ['sigmaDistance', 'σ of the distance, m/√s'],
  ['sigmaTurn', 'σ of the turn, rad/√s'],
]
/** Of motion that is held from row to row. @type {[string, string][]} */
const HELD = [
  ['delaySpeed', 'delay of the speed, s'],
  ['delayTurn', 'delay of the turn rate, s'],
]
const GATES = [null, 0.95, 0.99, 0.999]

export class SensorForm {
  /**
   * @param {HTMLElement} into
   * @param {(patch: Patch) => void} change
   */
  constructor(into, change) {
    this.change = change
    this.box = part(document, into, 'div', 'log-sensors')
    /** What shows a frame. @type {((frame: Frame) => void)[]} */
    this.shows = []
  }

  /** Builds the rows that a log has. @param {LogContents} contents */
  take({ readings, motion }) {
    this.box.replaceChildren()
    this.shows = []
    for (const sensor of SENSORS)
      if (readings[/** @type {'fix'} */ (sensor.name)])
        this.sensor(sensor, readings[/** @type {'fix'} */ (sensor.name)])
    const row = this.row('motion')
    for (const [name, words] of [...MOTION, ...(motion === 'velocity' ? HELD : [])]) this.number(row, name, words)
    if (motion === 'velocity') {
      this.toggle(row, 'learnSpeed', 'learn the scale of the speed')
      this.toggle(row, 'learnBias', 'learn the bias of the turn rate')
      this.says(row, ({ summary: { speedScale, speedScaleSigma, turnBias, turnBiasSigma } }) =>
        [
          speedScale === null
            ? ''
            : `Speed × ${fixed(1 + speedScale, 3)} ± ${fixed(speedScaleSigma ?? Number.NaN, 3)}.`,
          turnBias === null ? '' : `Bias ${fixed(turnBias, 4)} ± ${fixed(turnBiasSigma ?? Number.NaN, 4)} rad/s.`,
        ].join(' '),
      )
    }
  }

  /** @param {Frame} frame */
  show(frame) {
    for (const show of this.shows) show(frame)
  }

  /** @param {(typeof SENSORS)[number]} sensor @param {number | undefined} count */
  sensor({ name, words, on, delay, sigmas }, count) {
    const row = this.row(words)
    const key = /** @type {'fix'} */ (name)
    this.toggle(row, on, 'used')
    for (const [sigma, label] of sigmas) this.number(row, sigma, label)
    this.number(row, delay, 'delay, s')
    this.gate(row, key)
    this.number(row, 'every', 'one in so many s', {
      get: ({ every }) => bySensor(every)[key] ?? 0,
      set: (value, { every }) => ({ every: { ...bySensor(every), [key]: value } }),
    })
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

  /**
   * @param {HTMLElement} row @param {string} name @param {string} words
   * @param {{ get: (params: any) => number, set: (value: number, params: any) => Patch }} [how]
   */
  number(row, name, words, how) {
    const {
      get = (/** @type {any} */ params) => params[name],
      set = (/** @type {number} */ value) => ({ [name]: value }),
    } = how ?? {}
    /** @type {any} */
    let params = {}
    const field = numberField(row, words, (value) => this.change(set(value, params)))
    this.shows.push((frame) => {
      params = frame.params
      field.show(get(params))
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

/** A value for each sensor, of one for all or of some. @param {any} value @returns {Record<string, any>} */
function bySensor(value) {
  if (value !== null && typeof value === 'object') return value
  return Object.fromEntries(SENSORS.map(({ name }) => [name, value]))
}

/** What a fix is off along and across the heading: a delay shows along it. @param {any} said */
function across(said) {
  if (said?.meanAlong === undefined || said.meanAlong === null) return ''
  return `, along the heading ${fixed(said.meanAlong, 2)}, across it ${fixed(said.meanAcross, 2)}`
}
