/**
 * What the verdict names, set at a press below it and undone at another. What no setting mends, the places of landmarks
 * and the size of wheels, is read otherwise than the files have it.
 */

import { button, part } from '../draw/dom.js'
import { factors } from '../widgets/robot-log/driven.js'
import { rounded } from '../widgets/robot-log/sized.js'
import { wrapped } from '../widgets/robot-log/start.js'
import { named } from '../widgets/robot-log/verdict.js'
import { bySensor } from './log-numbers.js'

/** @typedef {import('../widgets/robot-log/words.js').Frame} Frame */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {Record<string, unknown>} Patch */
/** @typedef {import('estimate-wasm').LogCorrections} Corrections */
/** @typedef {{ press: string, patch?: Patch, corrections?: Corrections }} Remedy */

/** What refuses outliers and next to nothing else. */
const GATE = 0.999
const DEGREE = Math.PI / 180
/** The delays of readings that come late together, in the order of their sizes. */
const TOGETHER = ['delayFix', 'delayHeading', 'delaySighting']
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
  const { driven, landmarks: moved } = log.corrections
  if (fault === 'odometry') {
    if (sizes[0].end) return null
    const [along, about = 1] = factors(sizes)
    return { press: 'Take them so', corrections: { driven: [driven[0] * along, driven[1] * about], landmarks: moved } }
  }
  const at = (/** @type {number} */ id) => log.landmarks?.find((one) => one.id === id)
  const [one, other = one] = ids ?? []
  const [here, there] = [at(one), at(other)]
  if (!here || !there) return null
  const [x, y] = sizes.map((size) => said(size))
  /** @type {Corrections['landmarks']} */
  const places =
    fault === 'displaced'
      ? [[one, x, y]]
      : [
          [one, there.x, there.y],
          [other, here.x, here.y],
        ]
  const others = moved.filter(([id]) => !ids?.includes(id))
  const press = fault === 'displaced' ? 'Take it there' : 'Exchange them'
  return { press, corrections: { driven, landmarks: [...others, ...places] } }
}

/**
 * The setting that mends a fault as its sentence says, and the words of the press; null where the reader has to mend
 * the file, a unit or the truth.
 * @param {Suspect} suspect @param {Frame['params']} params @param {boolean} truth @param {Frame['log']} [log]
 * @returns {Remedy | null}
 */
export function remedy(suspect, params, truth, log = null) {
  const { fault, name, with: other, sensor, sizes, times: read } = suspect
  if (fault === 'mirrored') return null
  if (['odometry', 'exchanged', 'displaced'].includes(fault)) return corrected(suspect, log)
  if (fault === 'tails')
    return { press: 'Switch the gate on', patch: { gate: { ...bySensor(params.gate), [sensor ?? 'fix']: GATE } } }
  if (fault === 'start') {
    if (truth) return null
    const [x, y, theta] = sizes
    const start = [said(x), said(y), said({ ...theta, value: wrapped(theta.value) }, 1 / DEGREE)]
    return { press: 'Set the start so', patch: { start } }
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
 * The presses for what a judgement names: one, or two where the readings do not tell which it is.
 * @param {LogJudgement | null} judgement @param {Frame} frame
 */
export function remedies(judgement, { params, truth, log }) {
  const all = (judgement ? named(judgement) : []).map((suspect) => remedy(suspect, params, Boolean(truth), log))
  const either = ['Either', 'Or']
  return all.flatMap((one, i) => {
    if (!one) return []
    const { press } = one
    return [{ ...one, press: all.length > 1 ? `${either[i]}: ${press[0].toLowerCase()}${press.slice(1)}` : press }]
  })
}

export class MendBar {
  /**
   * @param {(patch: Patch) => void} change
   * @param {{ may: () => boolean, take: (corrections: Corrections) => Promise<void> }} reread whether the page has the
   * files of the log, and how these are read otherwise
   */
  constructor(change, reread) {
    this.change = change
    this.reread = reread
    this.box = document.createElement('div')
    this.box.className = 'log-mend'
    this.box.tabIndex = -1
    this.presses = part(document, this.box, 'span', '')
    this.undoing = button(document, this.box, 'Undo', () => this.undo())
    /** What the presses are of. @type {LogJudgement | null} */
    this.judgement = null
    /** What presses have set or corrected, and what was so before each. @type {{ mended: Remedy, before: Remedy }[]} */
    this.taken = []
    /** Whether the log that comes is this one, corrected. */
    this.correcting = false
    this.begin()
  }

  /** Another log, or this one as it is corrected. */
  begin() {
    if (this.correcting) return
    this.taken = []
    this.judgement = null
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
    if (judging) this.wait()
    else if (judgement !== this.judgement) this.fill(judgement, frame, wanted)
    this.hide()
  }

  /** @param {LogJudgement | null} judgement @param {Frame} frame @param {Patch} wanted */
  fill(judgement, frame, wanted) {
    this.judgement = judgement
    this.presses.replaceChildren()
    if (judgement) this.hold('')
    for (const remedy of remedies(judgement, frame))
      if (remedy.patch || this.reread.may())
        button(document, this.presses, remedy.press, () => this.take(remedy, frame, wanted), 'button')
  }

  /** Keeps what was set before a press, for Undo. @param {Patch} patch what it sets @param {Patch} wanted */
  keep(patch, wanted) {
    const before = Object.fromEntries(Object.keys(patch).map((name) => [name, wanted[name]]))
    this.taken.push({ mended: { press: '', patch }, before: { press: '', patch: before } })
    this.hide()
  }

  /** @param {Remedy} remedy @param {Frame} frame @param {Patch} wanted */
  take(remedy, { log }, wanted) {
    const { patch } = remedy
    if (patch) this.keep(patch, wanted)
    else this.taken.push({ mended: remedy, before: { press: '', corrections: log?.corrections } })
    this.hide()
    this.undoing.focus({ preventScroll: true })
    this.wait()
    this.hold()
    this.mend(remedy)
  }

  /** @param {Remedy} remedy */
  async mend({ patch, corrections }) {
    if (patch) this.change(patch)
    if (!corrections) return
    this.correcting = true
    try {
      await this.reread.take(corrections)
    } finally {
      this.correcting = false
    }
  }

  undo() {
    const last = this.taken.pop()
    if (!last) return
    if (this.taken.length === 0) this.box.focus({ preventScroll: true })
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
    this.undoing.hidden = this.taken.length === 0
    this.box.hidden = this.undoing.hidden && !this.presses.hasChildNodes()
  }
}

/** @param {unknown} one @param {unknown} other */
const same = (one, other) => JSON.stringify(one) === JSON.stringify(other)
