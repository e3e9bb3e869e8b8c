/**
 * Where the filter starts in a log without truth: typed, taken from the first readings, or dragged on the map. Then the
 * stretch whose fixes are withheld, typed or as the panels show it, and the track afterwards.
 */

import { button, part } from '../draw/dom.js'
import { fixed, metres } from '../draw/numbers.js'
import { withholdingShown } from '../widgets/robot-log/withheld.js'
import { boundsOf, openedBy } from './log-numbers.js'
import { numberField } from './number-field.js'

/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').LogFrame} Frame */
/** @typedef {Record<string, unknown>} Patch */

const DEGREE = Math.PI / 180
/** The pose, and what a number of a field is in the lab's units. @type {[string, number][]} */
const POSE = [
  ['x, m', 1],
  ['y, m', 1],
  ['heading, °', DEGREE],
]
/** How uncertain it is. @type {[string, string, number][]} */
const SPREAD = [
  ['startSigma', 'σ of x and y, m', 1],
  ['startSigmaHeading', 'σ of the heading, °', DEGREE],
]

const UNZOOMED = 'The panels show the whole log. Drag across one over time first.'

export class StartForm {
  /**
   * @param {HTMLElement} into @param {(patch: Patch) => void} change
   * @param {{ opening: () => void, smooth: () => void }} orders
   * @param {() => import('estimate-wasm').Parameter[]} parameters of the filter, with their bounds
   */
  constructor(into, change, orders, parameters) {
    this.parameters = parameters
    this.change = change
    this.orders = orders
    this.box = part(document, into, 'div', 'log-sensors')
    /** @type {((frame: Frame) => void)[]} */
    this.shows = []
  }

  /** @param {LogContents} contents */
  take(contents) {
    const { truth, readings, span } = contents
    this.box.replaceChildren()
    this.shows = []
    if (!truth) this.start(contents)
    if (readings.fix) this.afterwards(span[0])
  }

  /** @param {Frame} frame */
  show(frame) {
    for (const show of this.shows) show(frame)
  }

  /** @param {string} words */
  row(words) {
    const row = part(document, this.box, 'fieldset', 'log-sensor')
    part(document, row, 'legend', '').textContent = words
    return row
  }

  /** @param {LogContents} contents */
  start(contents) {
    const row = this.row('start')
    /** @type {number[]} */
    let pose = [0, 0, 0]
    const fields = POSE.map(([words, factor], i) =>
      numberField(row, words, (value) =>
        this.change({ start: pose.map((old, at) => (at === i ? value * factor : old)) }),
      ),
    )
    const [sigma, turned] = SPREAD.map(([name, words, unit]) => {
      const change = (/** @type {number} */ value) => this.change({ [name]: value * unit })
      return numberField(row, words, change, () => boundsOf(this.parameters(), name, unit))
    })
    const actions = part(document, row, 'div', 'log-actions')
    if (contents.opening) button(document, actions, `From the first ${openedBy(contents)}`, this.orders.opening)
    button(document, actions, 'At the origin', () => this.change({ start: null }))
    const words = part(document, row, 'p', 'log-says')
    words.textContent =
      'Keep this as A, go to the beginning of the time line, and drag the start on the map against the fixes of A.'
    this.shows.push(({ params }) => {
      pose = params.start ?? [0, 0, 0]
      fields.forEach((field, i) => {
        field.show(pose[i] / POSE[i][1])
      })
      sigma.show(params.startSigma)
      turned.show(params.startSigmaHeading / DEGREE)
    })
  }

  /** @param {number} first the log's first time: fields count from there */
  afterwards(first) {
    const row = this.row('withheld fixes, and the track afterwards')
    /** @type {ArrayLike<number> | null} */
    let withheld = null
    /** What withholds the stretch that the panels show. @type {Patch | null} */
    let shown = null
    /** An end of a stretch whose other one is not typed yet: alone it withholds nothing. @type {(number | null)[]} */
    let typed = [null, null]
    /** @param {0 | 1} at @param {number} value */
    const set = (at, value) => {
      const other = withheld ? withheld[1 - at] - first : typed[1 - at]
      if (other === null) {
        typed[at] = value
        words.textContent = at === 0 ? 'Say also until when.' : 'Say also from when.'
        return
      }
      typed = [null, null]
      const pair = at === 0 ? [value, Math.max(other, value)] : [Math.min(other, value), value]
      this.change({ withheld: pair.map((seconds) => first + seconds) })
    }
    const from = numberField(row, 'withhold from, s', (value) => set(0, value))
    const to = numberField(row, 'to, s', (value) => set(1, value))
    const actions = part(document, row, 'div', 'log-actions')
    button(document, actions, 'Withhold what is shown', () => {
      if (shown) this.change(shown)
      else words.textContent = UNZOOMED
    })
    button(document, actions, 'Withhold none', () => {
      typed = [null, null]
      this.change({ withheld: null })
    })
    button(document, actions, 'Smooth the track', this.orders.smooth)
    const words = part(document, row, 'p', 'log-says')
    this.shows.push((frame) => {
      withheld = frame.params.withheld
      shown = withholdingShown(frame)
      if (withheld) typed = [null, null]
      from.show(withheld ? withheld[0] - first : typed[0])
      to.show(withheld ? withheld[1] - first : typed[1])
      if (typed.every((end) => end === null)) words.textContent = `${tested(frame)}${smoothed(frame)}`
    })
  }
}

/** What the withheld fixes say of the filter, and of the smoother. @param {Frame} frame */
function tested({ summary: { withheld } }) {
  if (!withheld || withheld.rows === 0) return 'Fixes that are withheld test the estimate. '
  const { rows, rms, worst, rmsSmoothed, worstSmoothed } = withheld
  const after =
    rmsSmoothed === null || rmsSmoothed === undefined
      ? ''
      : ` The smoothed track is ${fixed(rmsSmoothed, 2)} m from them, ${fixed(worstSmoothed, 2)} m at worst.`
  return (
    `The filter is ${metres(rms)} m (RMS) from the ${rows.toLocaleString('en')} withheld fixes, ` +
    `${fixed(worst, 2)} m at worst.${after} `
  )
}

/** @param {Frame} frame */
function smoothed({ smoothed }) {
  return smoothed
    ? 'The dotted track on the map is the smoothed one: the best track in the light of all readings, later ones too.'
    : 'The smoothed track uses later readings too; the filter cannot.'
}
