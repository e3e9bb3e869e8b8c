/** The verdict on a log that a run shows, asked of the worker once the run stands at the log's end. */

import { listens } from './words.js'

export class Judging {
  /** @param {{ ask: (message: any) => Promise<any> }} port the way to the worker */
  constructor(port) {
    this.port = port
    /** Whether verdicts are wanted. */
    this.on = false
    /** Counts the questions: a later one, or giving up, makes an answer one to nothing. */
    this.which = 0
    this.waiting = false
    /** What was found, until the run takes it. @type {import('estimate-wasm').LogJudgement | null} */
    this.found = null
    /** How far it has come. @type {import('../../figure/progress.js').Work | null} */
    this.progress = null
  }

  get busy() {
    return this.waiting || this.found !== null
  }

  stop() {
    this.which += 1
    this.waiting = false
    this.found = null
    this.progress = null
  }

  /** Asks for the verdict under which a frame stands, if there is one to ask for. @param {any} frame */
  async begin(frame) {
    this.stop()
    if (!this.on || frame.step !== frame.rows || !listens(frame)) return
    const { which } = this
    this.waiting = true
    const answer = await this.port.ask({ kind: 'verdict', params: frame.params })
    if (which !== this.which) return
    this.stop()
    if (answer.kind === 'verdict') this.found = answer.found
  }

  /** @param {{ done: number, of: number }} told */
  tell({ done, of }) {
    if (this.waiting) this.progress = { step: done, of, unit: 'suspect' }
  }
}
