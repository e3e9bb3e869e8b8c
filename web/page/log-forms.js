/** What a reader tells the filter of a log, in the strip of the workbench: sensors, start, afterwards, fit. */

import { startBelow } from '../widgets/robot-log/antenna.js'
import { sameCorrections } from './log-corrections.js'
import { FitForm } from './log-fit.js'
import { SENSORS, openingOf, settingWords } from './log-numbers.js'
import { SensorForm } from './log-sensors.js'
import { StartForm } from './log-start.js'

/** What was said of the log before and is not true of another. */
const UNTOLD = ['start', 'startSigma', 'startSigmaHeading', 'withheld']

/**
 * What became of settings: a sentence, a press that makes it otherwise, what it sets, and what is said after.
 * @typedef {{ words: string, press: string, patch: Record<string, unknown>, after: string }} Told
 */

/**
 * The settings that are not the usual ones, by their names.
 * @param {Record<string, unknown>} params @param {import('estimate-wasm').Parameter[]} parameters
 */
function changed(params, parameters) {
  const set = parameters.filter((one) => JSON.stringify(params[one.name]) !== JSON.stringify(one.default))
  return set.map(({ name }) => name).filter((name) => !UNTOLD.includes(name))
}

/** @param {unknown} one @param {unknown} other */
const same = (one, other) => JSON.stringify(one ?? null) === JSON.stringify(other ?? null)

/** @param {Record<string, unknown>} params @param {string[]} names */
const only = (params, names) => Object.fromEntries(names.map((name) => [name, params[name]]))

/** @param {string[]} names */
const listed = (names) => names.map(settingWords).join('; ')

/** How often the run is led on, milliseconds. */
const FOLLOW_MS = 40

export class Forms {
  /**
   * @param {{ figure: any }} host of the figure
   * @param {() => Promise<import('../widgets/robot-log/remote-run.js').RemoteRun>} run
   */
  constructor(host, run) {
    const box = document.createElement('div')
    box.className = 'log-forms'
    this.box = box
    this.host = host
    /** What waits to follow the run. */
    this.following = 0
    /** @type {import('estimate-wasm').LogContents | null} */
    this.contents = null
    this.change = (/** @type {Record<string, unknown>} */ patch) => {
      host.figure.change({ ...this.withStart(patch), ...this.below(patch), ...patch })
      this.follow()
    }
    const smooth = async () => {
      const running = await run()
      running.smooth()
      this.follow()
    }
    /** @param {string[]} [only] */
    const fit = async (only) => {
      const running = await run()
      if (!this.isRead()) return { kind: 'none', message: 'No reading is used: tick “used” beside a sensor first.' }
      running.onfitting = (told) => this.fit.progress(told)
      return running.fit({ only })
    }
    /**
     * Finds several σ together, whatever outliers there are behind a gate.
     * @param {string[]} only @param {number | null} gate @param {(told: { done: number, of: number }) => void} told
     */
    this.fitTogether = (only, gate, told) => {
      const { run: running } = host.figure
      running.onfitting = told
      return running.fit({ only, from: { gate } })
    }
    this.stopFit = () => host.figure?.run?.stop('fit')
    /** Told what Fit is about to set, and what is set now. @type {import('./log-mend.js').MendBar['keep'] | null} */
    this.keep = null
    const take = (/** @type {Record<string, unknown>} */ patch) => {
      this.keep?.(patch, host.figure.run.wanted.params)
      this.change(patch)
    }
    const parameters = () => this.host.figure.run?.parameters() ?? []
    this.sensors = new SensorForm(box, this.change, parameters)
    // The first readings tell it as they are read now: with the σ and the offsets that are set.
    const opening = async () => {
      const { found } = await host.figure.run.opening()
      if (!found) return
      this.started.push(found.start)
      this.change(found)
    }
    /** Where the page has started this log: an Undo goes back to one before. @type {unknown[]} */
    this.started = []
    /**
     * What σ that were found set besides: the start, where that is the page's own, as the first readings tell it then.
     * @param {Record<string, unknown>} patch
     */
    this.settled = async (patch) => {
      const { run: running } = host.figure
      const { start } = running.wanted.params
      if (!start || !this.isOwn(start)) return patch
      const { found } = await running.opening(patch)
      if (!found) return patch
      this.started.push(found.start)
      return { ...patch, ...found }
    }
    this.start = new StartForm(box, this.change, { opening, smooth }, parameters)
    this.fit = new FitForm(box, { fit, stop: this.stopFit, take })
    /** Where the log begins by its first fixes, as text. */
    this.opening = ''
    /** How the log before was read otherwise. @type {import('estimate-wasm').LogCorrections | null} */
    this.corrections = null
    /** The names of the files of the reader's log, as text; null until there is one. @type {string | null} */
    this.names = null
  }

  /** Leads the run on where the figure is far from the window: it takes its turns by itself only near to it. */
  follow() {
    clearTimeout(this.following)
    const { figure } = this.host
    figure.turn(performance.now())
    // A panel may have been left for a later turn.
    if (figure.run?.busy || figure.behind) this.following = setTimeout(() => this.follow(), FOLLOW_MS)
  }

  /** @param {import('estimate-wasm').LogContents} contents */
  take(contents) {
    this.contents = contents
    for (const form of [this.sensors, this.start, this.fit]) form.take(contents)
  }

  /**
   * Starts another log, or one that is read otherwise, where its first fixes say. A log whose files are called as those
   * of the one before is that one, mended: it keeps the settings. So does the first, as they may have come with a link.
   * Others begin with the usual ones.
   * @param {import('estimate-wasm').LogContents} contents
   * @param {import('estimate-wasm').Parameter[]} parameters
   * @param {boolean} other whether other files were opened
   * @param {string[]} names of the files
   * @returns {Told | null} what became of settings that the reader had changed
   */
  begin(contents, parameters, other, names) {
    const { opening: usually, corrections } = contents
    const [before, called, last] = [this.opening, this.names, this.corrections]
    const ofReader = !this.isOwn(this.host.figure.run.wanted.params.start)
    this.corrections = corrections
    this.contents = contents
    this.opening = JSON.stringify(usually)
    this.started = [usually?.start ?? null]
    if (other) this.names = JSON.stringify(names)
    const moved = before !== this.opening
    const { params } = this.host.figure.run.wanted
    const opening = openingOf(contents, params.fixSigmaScale)
    const usual = Object.fromEntries(parameters.map((one) => [one.name, one.default]))
    const untold = Object.fromEntries(UNTOLD.map((name) => [name, usual[name]]))
    if (!other) {
      // A press that reads turns or places otherwise leaves a start that the reader has set; a cut begins elsewhere.
      const corrected = last && !sameCorrections(last, corrections)
      const set = corrected && same(last.kept, corrections.kept) && ofReader
      if (moved && !set) this.change({ ...untold, ...opening })
      return null
    }
    const set = changed(params, parameters)
    const mended = called === this.names
    if (called !== null && !mended) {
      this.change({ ...usual, ...usually })
      if (set.length === 0) return null
      const words = `The settings are the usual ones; those of the log before are not taken over: ${listed(set)}.`
      return { words, press: 'Take them over', patch: only(params, set), after: 'They are taken over.' }
    }
    const first = called === null && !params.sightings && this.untouched(parameters)
    if (!mended || moved) this.change({ ...untold, ...(first ? { sightings: true } : {}), ...opening })
    const kept = first ? [] : set
    if (kept.length === 0) return null
    const words = `Settings from before are kept: ${listed(kept)}.`
    return { words, press: 'Begin with the usual ones', patch: only(usual, kept), after: 'They are the usual ones.' }
  }

  /**
   * The σ of a start that is at the first fix, where the factor on the fixes’ own changes: it is a fix’s own too.
   * @param {Record<string, unknown>} patch
   */
  withStart({ fixSigmaScale: factor }) {
    const { contents } = this
    const params = this.host.figure.run?.wanted.params
    if (typeof factor !== 'number' || !contents || !params) return {}
    const [before, after] = [params.fixSigmaScale, factor].map((one) => openingOf(contents, one)?.startSigma)
    return before !== undefined && params.startSigma === before ? { startSigma: after } : {}
  }

  /**
   * The start of a log without truth, which the first fixes have told, where their antenna is set elsewhere.
   * @param {Record<string, any>} patch
   */
  below(patch) {
    const params = this.host.figure.run?.wanted.params
    const moved = ['antennaAhead', 'antennaLeft'].some((name) => name in patch && patch[name] !== params?.[name])
    if (!moved || !params.start || this.contents?.truth !== false) return {}
    const start = patch.start ?? startBelow(params, patch)
    if (this.isOwn(params.start)) this.started.push(start)
    return { start }
  }

  /** Whether the page has found a start, and no reader set it. @param {unknown} start */
  isOwn(start) {
    return this.started.some((one) => same(one, start))
  }

  /** Whether the filter uses any of the log’s readings. */
  isRead() {
    const { readings } = /** @type {import('estimate-wasm').LogContents} */ (this.contents)
    const params = this.host.figure.run.wanted.params
    return SENSORS.some(({ name, on }) => readings[/** @type {'fix'} */ (name)] && params[on])
  }

  /**
   * Whether the reader has set nothing yet: the mower begins without its ranges, and no log of a reader's does.
   * @param {import('estimate-wasm').Parameter[]} parameters
   */
  untouched(parameters) {
    const { params } = this.host.figure.run.wanted
    const set = parameters.filter(
      ({ name, default: usual }) => name !== 'sightings' && JSON.stringify(params[name]) !== JSON.stringify(usual),
    )
    return set.length === 0
  }

  /**
   * What the reader has set last, and not what the frame was computed with: a slider that went back to it would take
   * the next key from there.
   * @param {import('../widgets/robot-log/words.js').Frame} frame
   */
  show(frame) {
    const told = { ...frame, params: this.host.figure.run.wanted.params }
    this.sensors.show(told)
    this.start.show(told)
    this.fit.show(frame)
  }
}
