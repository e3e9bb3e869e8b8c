/**
 * Reads and replays logs, in a worker. It answers questions, and is told things by messages.
 *
 * - `{ kind: 'files', set, files }`, the log as `File`s: `{ kind: 'log', set, contents, parameters, files }`, or
 *   `{ kind: 'no-log', set, files, file, line, column, message, shown, name, mend }` with `line` 0 where the fault is
 *   of all files together, `name` of a file that could not be read, and `mend`, what to do, where that is not plain; on
 *   the way `{ kind: 'reading', name, done, of }` is told, in bytes
 * - `{ kind: 'reading', set, change }`, to read one of the files of `set` otherwise: the same; once other files have
 *   been read, what was said of them
 * - `{ kind: 'table', params, table }`, the replay as `'track'` or `'innovations'`, or the log itself as `'log'`:
 *   `{ kind: 'table', text }`, a `Blob` of CSV, or `{ kind: 'no-table', message }`
 * - `{ kind: 'opening', params }`: `{ kind: 'opening', found }`, where the log began
 * - `{ kind: 'fit', params, only }`, of the numbers of these names alone where some are given: `{ kind: 'fit', found }`
 *   or `{ kind: 'no-fit', message }`; on the way `{ kind: 'fitting', done, of }` is told; told
 *   `{ kind: 'stop-fit' }` it ends
 * - `{ kind: 'map', params, from, across, up }`: `{ kind: 'map' }` or `{ kind: 'no-map', message }`; on the way each
 *   row is told as `{ kind: 'mapped', row, values }`; told `{ kind: 'stop-map' }` it ends
 * - `{ kind: 'verdict', params }`: `{ kind: 'verdict', found }` or `{ kind: 'no-verdict', message }`; on the way
 *   `{ kind: 'judging', done, of }` is told; the next `go` ends it
 * - told `{ kind: 'go', id, params, step, smooth }`, it tells `{ kind: 'progress', id, step, of }` on the way; then
 *   `{ kind: 'there', id, frame, digest }`, or `{ kind: 'refused', id, message }`
 * - told `{ kind: 'cancel' }`, it tells nothing more about the replay that was under way
 *
 * A replay is computed in chunks, and between two of them the worker reads its messages. A later `go` replaces an
 * earlier one, unless that one is nearly there: a slider that is dragged over a long log is still answered now and
 * then.
 */

import { attend, wordsOf } from '../../load/worker-server.js'
import { NEARLY_DONE_MS, Pace, TURN_MS, remaining } from '../../figure/time-slices.js'
import { applyChange } from './change.js'
import { Mapping } from './likelihood.js'
import { Searching } from './searching.js'
import { tableOf } from './table.js'
import { decode, lineOf } from './text.js'

/** The words for a progress bar come this often, milliseconds. */
const PROGRESS_MS = 50

/** @typedef {{ id: number, params: Record<string, unknown>, step: number | null, smooth?: boolean }} Wish */
/** @typedef {import('./change.js').Change} Change */
/** @typedef {{ wish: Wish, lab: any, of: number, from: number, began: number, told: number }} Replay */

/** What is said of files that are no log, where a reading says nothing else. */
const NO_LOG = { kind: 'no-log', files: [], file: 0, line: 0, column: 1, shown: '', mend: '', name: '' }

/**
 * Answers what comes through a channel.
 * @param {import('../../load/worker-port.js').Channel} channel
 * @param {() => Promise<import('../../load/loader.js').Loaded<any>>} load
 */
export const serve = (channel, load) => attend(channel, load, (module, tell, soon) => new Server(module, tell, soon))

export class Server {
  /**
   * @param {any} module with `RobotLog`
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} [clock]
   */
  constructor(module, tell, soon, clock = () => performance.now()) {
    this.module = module
    this.tell = tell
    this.soon = soon
    this.clock = clock
    this.calls = new Pace(clock)
    this.fitting = new Searching(tell, soon, clock)
    this.judging = new Searching(tell, soon, clock)
    this.mapping = new Mapping(tell, soon, clock)
    /**
     * The files of the log that was read last.
     * @type {any}
     */
    this.files = null
    /** Their texts, from which a faulty line is shown. @type {string[] | null} */
    this.texts = null
    /** Sentences about their encodings. @type {string[]} */
    this.notes = []
    /** Which files they are. @type {number | undefined} */
    this.set = undefined
    /** What was said of a log last. @type {any} */
    this.said = null
    /** @type {any} */
    this.log = null
    /** The lab that was shown last. @type {any} */
    this.lab = null
    /** @type {Replay | null} */
    this.replay = null
    /** @type {Wish | null} */
    this.wish = null
  }

  /** @param {any} message */
  take(message) {
    if (message.kind === 'go') this.go(message)
    if (message.kind === 'cancel') this.cancel()
    if (message.kind === 'stop-fit') this.fitting.stop()
    if (message.kind === 'stop-map') this.mapping.stop()
  }

  /** @param {any} message @returns {Promise<any>} */
  async answer(message) {
    const { kind, set, files, change } = message
    if (kind === 'table') return tableOf(this.module, this.log, message, this.soon)
    if (kind === 'opening') return { kind, found: this.log.opening(message.params) }
    if (kind === 'map') return this.mapping.map(this.module, this.log, message)
    if (kind === 'fit') return this.fitting.fit(this.module, this.log, message)
    if (kind === 'verdict') return this.judging.judge(this.module, this.log, message.params)
    if (kind === 'files') this.said = await this.open(files, set)
    // A change of files that are gone changes nothing of those that came meanwhile.
    else if (set === this.set && this.files) this.said = this.reread(change)
    return this.said
  }

  /**
   * Opens the files of a log.
   * @param {File[]} given
   * @param {number | undefined} set
   */
  async open(given, set) {
    const files = new this.module.LogFiles()
    /** @type {string[]} */
    const texts = []
    const notes = []
    const of = given.reduce((sum, { size }) => sum + size, 0)
    let done = 0
    try {
      for (const file of given) {
        const { name, size } = file
        this.tell({ kind: 'reading', name, done, of })
        const { text, note } = decode(name, await file.arrayBuffer())
        texts.push(text)
        if (note) notes.push(note)
        files.add(name, text)
        done += size
      }
    } catch (error) {
      const words = wordsOf(error)
      const unread = /** @type {any} */ (error).code !== 'log'
      const name = given[texts.length]?.name
      const said = unread
        ? { ...NO_LOG, name, line: 1, message: 'the file could not be read; it may be a folder, or gone' }
        : { ...NO_LOG, message: words, mend: 'Open fewer files together, or smaller ones' }
      Object.assign(said, { set, files: files.files() })
      files.free()
      return said
    }
    this.files?.free()
    this.files = files
    this.texts = texts
    this.notes = notes
    this.set = set
    return this.read()
  }

  /** Reads one of the files otherwise. @param {Change} change */
  reread(change) {
    const { files, set } = this
    try {
      applyChange(files, change)
    } catch (error) {
      return { ...NO_LOG, set, files: files.files(), message: wordsOf(error) }
    }
    return this.read()
  }

  /** Reads the files. What is no log leaves the log before in its place. */
  read() {
    const { files, set } = this
    const shown = files.files()
    try {
      const log = files.read()
      this.cancel()
      this.log?.free()
      this.lab?.free()
      this.lab = null
      this.log = log
      // A log in the book's own format has no line that could be wrong later on.
      if (shown.every((/** @type {any} */ { role }) => role === 'log')) this.texts = null
      const contents = log.contents()
      contents.notes.unshift(...this.notes)
      return { kind: 'log', set, contents, parameters: this.module.RobotLog.parameters(), files: shown }
    } catch (error) {
      const { file = 0, line = 1, column = 1 } = /** @type {any} */ (error)
      const message = wordsOf(error).replace(/^line \d+, column \d+: /, '')
      const from = line === 0 ? '' : lineOf(this.texts?.[shown[file]?.again ?? file] ?? '', line)
      // A file that is missing is said before what others ask.
      const asked = line === 0 && shown[file]?.asks.some((/** @type {string} */ ask) => message.endsWith(ask))
      const mend = asked ? 'Answer below' : ''
      return { ...NO_LOG, set, files: shown, file, line, column, message, shown: from, mend }
    }
  }

  /** @param {Wish} wish */
  go(wish) {
    this.judging.stop()
    this.wish = wish
    if (!this.replay) this.start()
    else if (this.remaining() > NEARLY_DONE_MS) {
      this.drop()
      this.start()
    }
  }

  cancel() {
    this.judging.stop()
    this.wish = null
    this.drop()
  }

  drop() {
    const { replay } = this
    this.replay = null
    if (replay && replay.lab !== this.lab) replay.lab.free()
  }

  /**
   * Begins what was wished for last: from where the lab is, if the wish only leads on, else from the log's first row.
   */
  start() {
    const { wish, lab } = this
    if (!wish) return
    this.wish = null
    try {
      const of = wish.step ?? this.log.contents().steps
      const now = lab?.state()
      const on =
        now && now.step <= of && JSON.stringify(now.params) === JSON.stringify({ ...now.params, ...wish.params })
      const next = on
        ? lab
        : this.module.RobotLog.from(this.log, { version: 1, lab: 'robot-log', params: wish.params, step: 0 })
      const from = on ? now.step : 0
      const began = this.clock()
      this.replay = { wish, lab: next, of, from, began, told: began }
      this.goOn()
    } catch (error) {
      this.tell({ kind: 'refused', id: wish.id, message: wordsOf(error) })
    }
  }

  goOn() {
    const { replay } = this
    if (!replay) return
    const { wish, lab, of } = replay
    try {
      const { step } = lab.state()
      if (step < of) this.calls.run(lab, of - step, TURN_MS)
      if (lab.state().step < of) return this.wait(replay)
      this.replay = null
      if (this.lab !== lab) this.lab?.free()
      this.lab = lab
      if (wish.smooth) lab.smooth()
      this.tell({ kind: 'there', id: wish.id, frame: lab.frame(), digest: lab.digest() })
    } catch (error) {
      this.drop()
      this.tell({ kind: 'refused', id: wish.id, message: wordsOf(error) })
    }
    this.start()
  }

  /** @param {Replay} replay */
  wait(replay) {
    const { wish, lab, of } = replay
    const now = this.clock()
    if (now - replay.told > PROGRESS_MS) {
      replay.told = now
      this.tell({ kind: 'progress', id: wish.id, step: lab.state().step, of })
    }
    this.soon(() => {
      if (this.replay === replay) this.goOn()
    })
  }

  /** Milliseconds that the present replay still needs, as far as it has shown. */
  remaining() {
    if (!this.replay) return 0
    const { lab, of, from, began } = this.replay
    const { step } = lab.state()
    return remaining({ done: step - from, left: of - step, spent: this.clock() - began })
  }
}
