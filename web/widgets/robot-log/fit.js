/** The fit of a log's noise and delays, in the worker: a replay at a time; between two it reads its messages. */

import { wordsOf } from '../../load/worker-server.js'

/** What is told of a fit is told this often, milliseconds. */
const TOLD_MS = 100

export class Fitting {
  /**
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} clock
   */
  constructor(tell, soon, clock) {
    this.tell = tell
    this.soon = soon
    this.clock = clock
    /** Counts the fits: a later one, or giving up, ends the one before. */
    this.which = 0
  }

  stop() {
    this.which += 1
  }

  /**
   * @param {any} module with `LogFit`
   * @param {any} log
   * @param {any} params where the search begins
   * @returns {Promise<any>} `{ kind: 'fit', found }`, or `{ kind: 'no-fit', message }`
   */
  async fit(module, log, params) {
    this.stop()
    const { which } = this
    let fit
    try {
      fit = new module.LogFit(log, params)
      let told = this.clock()
      while (fit.step()) {
        await new Promise((resolve) => this.soon(() => resolve(undefined)))
        if (which !== this.which) return { kind: 'no-fit', message: 'The fit was given up.' }
        if (this.clock() - told < TOLD_MS) continue
        told = this.clock()
        const [done, of] = fit.found().replays
        this.tell({ kind: 'fitting', done, of })
      }
      return { kind: 'fit', found: fit.found() }
    } catch (error) {
      return { kind: 'no-fit', message: wordsOf(error) }
    } finally {
      fit?.free()
    }
  }
}
