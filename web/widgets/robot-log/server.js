/**
 * Reads and replays logs, in a worker. It is told things by messages and answers by messages.
 *
 * | told | answers |
 * |---|---|
 * | `{ kind: 'log', bytes }` | `{ kind: 'log', contents, parameters }`, or `{ kind: 'no-log', line, column, message }` |
 * | `{ kind: 'go', id, params, step }` | `{ kind: 'progress', id, step, of }` on the way; then `{ kind: 'there', id, frame, digest }`, or `{ kind: 'refused', id, message }` |
 * | `{ kind: 'cancel' }` | nothing more about the replay that was under way |
 *
 * A replay is computed in chunks, and between two of them the worker reads its messages. A later `go` replaces an earlier one, unless
 * that one is nearly there: a slider that is dragged over a long log is still answered now and then.
 */

import { Pace } from '../../core/pace.js'

/** How long the worker computes without reading its messages, milliseconds. */
const CHUNK_MS = 24
/** A replay that needs no longer than this, milliseconds, is finished before a later one begins. */
const NEARLY_THERE_MS = 150
/** The words for a progress bar come this often, milliseconds. */
const PROGRESS_MS = 50

/** @typedef {{ id: number, params: Record<string, unknown>, step: number | null }} Wish */
/** @typedef {{ wish: Wish, lab: any, of: number, from: number, began: number, told: number }} Replay */

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
    if (message.kind === 'log') this.read(message.bytes)
    if (message.kind === 'go') this.go(message)
    if (message.kind === 'cancel') this.cancel()
  }

  /** Reads a log. One that is wrong leaves the log before in its place. @param {Uint8Array} bytes */
  read(bytes) {
    const { RobotLog } = this.module
    try {
      // What is no UTF-8 becomes U+FFFD, which no log may hold.
      const log = RobotLog.parse(new TextDecoder().decode(bytes))
      this.cancel()
      this.log?.free()
      this.lab?.free()
      this.lab = null
      this.log = log
      this.tell({ kind: 'log', contents: log.contents(), parameters: RobotLog.parameters() })
    } catch (error) {
      const { line = 1, column = 1, message } = /** @type {any} */ (error)
      this.tell({ kind: 'no-log', line, column, message })
    }
  }

  /** @param {Wish} wish */
  go(wish) {
    this.wish = wish
    if (!this.replay) this.start()
    else if (this.remaining() > NEARLY_THERE_MS) {
      this.drop()
      this.start()
    }
  }

  cancel() {
    this.wish = null
    this.drop()
  }

  drop() {
    const { replay } = this
    this.replay = null
    if (replay && replay.lab !== this.lab) replay.lab.free()
  }

  /** Begins what was wished for last: from where the lab is, if the wish only leads on, else from the log's first row. */
  start() {
    const { wish, lab } = this
    if (!wish) return
    this.wish = null
    try {
      const of = wish.step ?? this.log.contents().steps
      const now = lab?.state()
      const on = now && now.step <= of && JSON.stringify(now.params) === JSON.stringify({ ...now.params, ...wish.params })
      const next = on ? lab : this.module.RobotLog.from(this.log, { version: 1, lab: 'robot-log', params: wish.params, step: 0 })
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
      if (step < of) this.calls.run(lab, of - step, CHUNK_MS)
      if (lab.state().step < of) return this.wait(replay)
      this.replay = null
      if (this.lab !== lab) this.lab?.free()
      this.lab = lab
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
    return step === from ? Infinity : ((this.clock() - began) * (of - step)) / (step - from)
  }
}

/** @param {unknown} error */
function wordsOf(error) {
  return error instanceof Error ? error.message : 'The log could not be replayed.'
}
