/**
 * The run of a log that a worker replays. A figure asks it what it asks a `Run` of a lab in the page; here a turn sends
 * the worker what the reader has asked for, and takes what has come back.
 */

/** @typedef {import('../../figure/run.js').Outcome} Outcome */
/** @typedef {import('../../load/worker-port.js').Port} Port */

/** Where motion is not wanted a run in play goes on in lumps, and each picture stays this long, milliseconds. */
const STILL_MS = 500

export class RemoteRun {
  /**
   * @param {Port} port to the worker
   * @param {any} frame the first
   * @param {import('estimate-wasm').Parameter[]} parameters
   * @param {number} pace rows a second at speed 1
   */
  constructor(port, frame, parameters, pace) {
    this.port = port
    this.frame = frame
    this.known = parameters
    this.pace = pace
    this.digest = ''
    /** What the log holds. @type {any} */
    this.contents = null
    this.goal = frame.step
    /** @type {Record<string, unknown> | null} */
    this.patch = null
    this.wantsReset = false
    this.playing = false
    this.rate = 1
    this.due = 0
    this.stepped = -Infinity
    this.id = 0
    /**
     * What the worker was asked for and has not answered.
     * @type {{ id: number, params: any, step: number, moved: Outcome['moved'] } | null}
     */
    this.sent = null
    /** What the worker has said since the last turn. @type {any} */
    this.answer = null
    /** @type {{ step: number, of: number } | null} */
    this.progress = null
    /** @type {any} */
    this.remembered = null
    /**
     * Who waits for a log to be read or a table to be written, first come first served.
     * @type {((answer: any) => void)[]}
     */
    this.waiting = []
    port.onmessage = ({ data }) => this.hear(data)
  }

  /** The last step of all. */
  get last() {
    return this.frame.rows
  }

  parameters() {
    return this.known
  }

  get asked() {
    return this.patch || this.sent ? { ...(this.sent?.params ?? this.frame.params), ...this.patch } : null
  }

  /**
   * The frame on the screen, but with the parameters that the reader has asked for; the same object until one of the
   * two changes.
   */
  get wanted() {
    const { frame, patch, sent, asked, remembered: old } = this
    if (!asked) return frame
    if (old && old.frame === frame && old.patch === patch && old.sent === sent) return old.wanted
    const wanted = { ...frame, params: asked }
    this.remembered = { frame, patch, sent, wanted }
    return wanted
  }

  get busy() {
    return Boolean(this.patch || this.sent || this.answer || this.wantsReset || this.frame.step !== this.goal)
  }

  state() {
    return { version: 1, lab: 'robot-log', params: this.asked ?? this.frame.params, step: this.goal }
  }

  /** @param {Record<string, unknown>} patch parameters, and `step` where the run is to go to one */
  change({ step, ...patch }) {
    if (typeof step === 'number') {
      this.playing = false
      this.goal = Math.max(0, Math.min(this.last, Math.round(step)))
    }
    if (Object.keys(patch).length > 0) this.patch = { ...this.patch, ...patch }
  }

  /** @param {number} steps */
  advance(steps) {
    this.playing = false
    this.goal = Math.min(this.last, this.goal + steps)
  }

  reset() {
    this.playing = false
    this.wantsReset = true
    this.goal = 0
  }

  /** @param {boolean} on at the log's end it plays from the start */
  play(on) {
    this.due = 0
    if (on && this.goal === this.last) this.reset()
    this.playing = on
    if (!on) this.goal = this.sent?.step ?? this.frame.step
  }

  cancel() {
    this.port.postMessage({ kind: 'cancel' })
    this.sent = null
    this.answer = null
    this.patch = null
    this.progress = null
    this.wantsReset = false
    this.playing = false
    this.goal = this.frame.step
  }

  /**
   * Gives the worker a log, or asks it to read the log otherwise. A log that was read is replayed to its end with the
   * present settings; one that is wrong leaves the run as it is.
   * @param {{ kind: 'files', files: File[] } | { kind: 'reading', change: import('./server.js').Change }} message
   * @returns {Promise<any>} what the worker says of it
   */
  async read(message) {
    const answer = await this.request(message)
    if (answer.kind !== 'log') return answer
    this.contents = answer.contents
    const params = this.asked
    this.cancel()
    this.patch = params
    this.wantsReset = true
    this.goal = answer.contents.steps
    return answer
  }

  /** The replay as a table. @param {'track' | 'innovations'} table @returns {Promise<any>} */
  table(table) {
    return this.request({ kind: 'table', params: this.asked ?? this.frame.params, table })
  }

  /** @param {any} message @returns {Promise<any>} */
  request(message) {
    return new Promise((resolve) => {
      this.waiting.push(resolve)
      this.port.postMessage(message)
    })
  }

  /** @param {any} message */
  hear(message) {
    if (message.id === undefined) return this.waiting.shift()?.(message)
    if (message.id !== this.sent?.id) return
    if (message.kind === 'progress') this.progress = { step: message.step, of: message.of }
    else this.answer = message
  }

  /** @param {number} now @param {number} elapsed @param {boolean} calm @returns {Outcome} */
  turn(now, elapsed, calm) {
    const outcome = this.receive()
    if (this.playing && !this.sent && this.goal === this.frame.step)
      this.goal = Math.min(this.last, this.goal + this.dueSteps(now, elapsed, calm))
    this.send()
    return outcome
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
    this.frame = answer.frame
    this.digest = answer.digest
    const ended = this.playing && this.frame.step === this.last
    if (ended) this.playing = false
    return { moved: sent.moved, refused: null, ended }
  }

  send() {
    const { patch, goal, sent, frame } = this
    const there = sent ? sent.step === goal : frame.step === goal
    if (!patch && !this.wantsReset && there) return
    // While steps are played the worker is asked again once it has answered.
    if (sent && !patch && !this.wantsReset && this.playing) return
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
    this.port.postMessage({ kind: 'go', id: this.id, params, step: goal })
  }

  /** @param {number} now @param {number} elapsed @param {boolean} calm */
  dueSteps(now, elapsed, calm) {
    this.due += Number.isFinite(elapsed) ? (Math.min(elapsed, 250) / 1000) * this.rate * this.pace : 0
    if (calm && now - this.stepped < STILL_MS) return 0
    const whole = Math.floor(this.due)
    this.due -= whole
    if (whole > 0) this.stepped = now
    return whole
  }
}
