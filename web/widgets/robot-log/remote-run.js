/**
 * The run of a log that a worker replays. A figure asks it what it asks a `Run` of a lab in the page; here a turn sends
 * the worker what the reader has asked for, and takes what has come back.
 */

import { NOTHING } from './looks.js'
import { Asking } from './asking.js'
import { Judging } from './judging.js'

/** @typedef {import('../../figure/player.js').Outcome} Outcome */
/**
 * @typedef {{ kind: 'files', files: File[], exercise?: boolean }
 *   | { kind: 'reading', set: number | undefined, change: import('./change.js').Change }} Question
 */

/** Longer logs are smoothed when that is asked for, rows. */
const MOST_SMOOTHED = 100_000

export class RemoteRun extends Asking {
  /** @param {import('./asking.js').Port} port @param {number} pace rows a second at speed 1 */
  constructor(port, pace) {
    super(port, pace)
    this.judging = new Judging(port)
    /** @type {import('estimate-wasm').Parameter[]} */
    this.known = []
    this.digest = ''
    /** What the log holds. @type {any} */
    this.contents = null
    this.id = 0
    /**
     * What the worker was asked for and has not answered.
     * @type {{ id: number, params: any, step: number, moved: Outcome['moved'] } | null}
     */
    this.sent = null
    /** What the worker has said since the last turn. @type {any} */
    this.answer = null
    /** Called once it has said where the run is. @type {(() => void) | null} */
    this.arrived = null
    /** @type {{ step: number, of: number } | null} */
    this.progress = null
    /** Called with the words of the worker about a log that it reads. @type {((words: any) => void) | null} */
    this.onreading = null
    /** Whether the track is smoothed in the light of all readings. */
    this.smoothed = false
    /** What the reader looks at, and whether the frame does not have it yet. @type {import('./looks.js').Looks} */
    this.looks = NOTHING
    this.looked = false
    this.sets = 0
    /** The questions of the files that were read last, and those that led to the log. @type {any[]} */
    this.tried = []
    /** @type {any[]} */
    this.story = []
    /** What another worker says of the log that the one before had. @type {Promise<any>} */
    this.restored = Promise.resolve()
    /** Whether it is still reading it. */
    this.restoring = false
    port.onmessage = (message) => this.hear(message)
  }

  /** The last step of all. */
  get last() {
    return this.frame.rows
  }

  /** Whether an exercise asks about the log that is tried. */
  get asks() {
    const [files] = this.tried
    return files?.kind === 'files' && Boolean(files.exercise)
  }

  parameters() {
    return this.known
  }

  get pending() {
    return this.sent
  }

  get busy() {
    const { patch, sent, answer, wantsReset, looked, judging } = this
    return Boolean(patch || sent || answer || wantsReset || looked || judging.busy || this.frame.step !== this.goal)
  }

  state() {
    return { version: 1, lab: 'robot-log', params: this.asked ?? this.frame.params, step: this.goal }
  }

  /** @param {Record<string, unknown>} patch parameters, `step` where the run is to go to one, and `look` */
  change({ step, look, ...patch }) {
    if (look) this.look(look)
    if (typeof step === 'number') {
      this.playing = false
      this.goal = Math.max(0, Math.min(this.last, Math.round(step)))
    }
    if (Object.keys(patch).length > 0) this.patch = { ...this.patch, ...patch }
  }

  /** Looks at something else, of which the worker knows nothing. @param {Partial<import('./looks.js').Looks>} looks */
  look(looks) {
    this.looks = { ...this.looks, ...looks }
    this.looked = true
  }

  /** @param {number} steps */
  advance(steps) {
    this.playing = false
    this.goal = Math.min(this.last, this.goal + steps)
  }

  /** @param {boolean} on at the log's end it plays from the start */
  play(on) {
    this.due = 0
    if (on && this.goal === this.last) this.reset()
    this.playing = on
    if (!on) this.goal = this.sent?.step ?? this.frame.step
  }

  cancel() {
    this.port.post({ kind: 'cancel' })
    this.judging.stop()
    this.sent = null
    this.answer = null
    this.patch = null
    this.progress = null
    this.wantsReset = false
    this.playing = false
    this.goal = this.frame.step
  }

  /**
   * The first frame of all.
   * @param {{ params: any, step: number | null }} wish
   * @returns {Promise<Outcome>}
   */
  async begin({ params, step }) {
    const goal = step ?? this.contents.steps
    this.sent = { id: (this.id += 1), params, step: goal, moved: 'reset' }
    this.port.post({ kind: 'go', id: this.id, params, step: goal })
    await new Promise((resolve) => {
      this.arrived = () => resolve(undefined)
    })
    const outcome = this.receive()
    this.goal = this.frame.step
    return outcome
  }

  /**
   * Gives the worker a log, or asks it to read the log otherwise. A log that was read is replayed to its end with the
   * present settings; one that is wrong leaves the run as it is.
   * @param {Question} question
   * @returns {Promise<any>} what the worker says of it; `{ kind: 'ended', message, files, set }` where it ended
   * meanwhile, with the files of the log that stays
   */
  async read(question) {
    const message = question.kind === 'files' ? { ...question, set: (this.sets += 1) } : question
    // What is computed for the log before would be waited for.
    this.stop('map')
    const answer = await this.port.ask(message)
    if (answer.kind === 'ended') {
      const { files = [], set } = (await this.restored) ?? {}
      return { ...answer, files, set }
    }
    if (message.kind === 'files') this.tried = [message]
    else if (message.set === answer.set) this.tried = [...this.tried, message]
    if (answer.kind !== 'log') return answer
    this.story = this.tried
    this.look(NOTHING)
    // What is wrong with the log that a figure opens with, or with one of an exercise, is its reader's to find out. A
    // log that asked how it is read comes with an answer, behind its files.
    this.judging.on = this.contents !== null && !this.asks
    this.contents = answer.contents
    this.known = answer.parameters
    const params = this.asked
    this.cancel()
    this.patch = params
    this.wantsReset = true
    this.goal = answer.contents.steps
    return answer
  }

  /** Gives up what is being read: the log before stays. */
  giveUp() {
    if (this.sent) {
      // What the reader has asked for meanwhile is asked of the next worker.
      this.patch = this.asked
      this.wantsReset ||= this.sent.moved === 'reset'
      this.sent = null
    }
    this.port.restart('Reading was given up.')
  }

  /** Another worker knows nothing of the log: it reads it again. @param {string} message why */
  restore(message) {
    if (this.sent) {
      this.answer = { kind: 'refused', message }
      this.arrived?.()
    }
    const again = async () => {
      let said
      for (const question of this.story) said = await this.port.ask(question)
      if (this.restored === restored) this.restoring = false
      return said
    }
    this.restoring = true
    const restored = again()
    this.restored = restored
  }

  /** @param {any} message */
  hear(message) {
    if (message.kind === 'ended') return this.restore(message.message)
    if (message.kind === 'reading') return this.onreading?.(message)
    if (this.told(message)) return
    if (message.kind === 'judging') return this.judging.tell(message)
    if (message.id !== this.sent?.id) return
    if (message.kind === 'progress') this.progress = { step: message.step, of: message.of }
    else {
      this.answer = message
      this.arrived?.()
    }
  }

  /** @param {number} now @param {number} elapsed @param {boolean} calm @returns {Outcome} */
  turn(now, elapsed, calm) {
    const outcome = this.receive()
    if (this.looked) {
      this.looked = false
      this.frame = { ...this.frame, looks: this.looks }
      if (outcome.moved === 'nothing') outcome.moved = 'replay'
    }
    if (this.playing && !this.sent && this.goal === this.frame.step)
      this.goal = Math.min(this.last, this.goal + this.dueSteps(now, elapsed, calm))
    this.send()
    const { found, progress } = this.judging
    if (!this.sent) this.progress = progress
    // No verdict has come of it.
    if (this.frame.judging && !this.judging.busy) {
      this.frame = { ...this.frame, judging: false }
      return { ...outcome, moved: outcome.moved === 'nothing' ? 'replay' : outcome.moved }
    }
    if (!found || outcome.moved !== 'nothing') return outcome
    this.judging.found = null
    this.frame = { ...this.frame, judgement: found, judging: false }
    return { ...outcome, moved: 'replay' }
  }

  /** @returns {Outcome} */
  receive() {
    const { answer, sent } = this
    if (!answer || !sent) return { moved: 'nothing', refused: null, ended: false }
    this.answer = null
    this.sent = null
    this.progress = null
    if (answer.kind === 'refused') {
      this.playing = false
      this.goal = this.frame.step
      return { moved: 'nothing', refused: answer.message, ended: false }
    }
    this.frame = Object.assign(answer.frame, { looks: this.looks, log: this.contents, known: this.known })
    this.looked = false
    this.digest = answer.digest
    const ended = this.playing && this.frame.step === this.last
    if (ended) this.playing = false
    this.judging.begin(this.frame)
    if (this.judging.waiting) this.frame.judging = true
    return { moved: sent.moved, refused: null, ended }
  }

  send() {
    const { patch, goal, sent, frame } = this
    if (this.restoring) return
    const there = sent ? sent.step === goal : frame.step === goal
    if (!patch && !this.wantsReset && there) return
    // While steps are played the worker is asked again once it has answered.
    if (sent && !patch && !this.wantsReset && this.playing) return
    this.judging.stop()
    const params = this.asked ?? frame.params
    const moved = this.wantsReset
      ? 'reset'
      : patch || sent?.moved === 'replay' || goal < frame.step
        ? 'replay'
        : 'steps'
    this.sent = { id: (this.id += 1), params, step: goal, moved }
    this.answer = null
    this.patch = null
    this.wantsReset = false
    this.port.post({ kind: 'go', id: this.id, params, step: goal, smooth: this.smoothed })
    if (this.last > MOST_SMOOTHED) this.smoothed = false
  }

  /** Smooths the track up to where the run is; a log that is not too long is smoothed again after each change. */
  smooth() {
    this.smoothed = true
    this.patch = { ...this.patch }
  }
}
