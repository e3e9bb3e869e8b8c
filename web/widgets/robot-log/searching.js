/** Searches in a log, in the worker: its fit, its verdict. Between two replays, or two suspects, it reads messages. */

import { wordsOf } from '../../load/worker-server.js'

/** What is told of a search is told this often, milliseconds. */
const TOLD_MS = 100

const FIT = {
  found: 'fit',
  none: 'no-fit',
  telling: 'fitting',
  count: (/** @type {any} */ found) => found.replays,
  given: 'The fit was given up.',
}
const VERDICT = {
  found: 'verdict',
  none: 'no-verdict',
  telling: 'judging',
  count: (/** @type {any} */ found) => found.tried,
  given: 'The verdict was given up.',
}

export class Searching {
  /**
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} clock
   */
  constructor(tell, soon, clock) {
    this.tell = tell
    this.soon = soon
    this.clock = clock
    /** Counts the searches: a later one, or giving up, ends the one before. */
    this.which = 0
  }

  stop() {
    this.which += 1
  }

  /**
   * The fit of noise and delays.
   * @param {any} module with `LogFit`
   * @param {any} log
   * @param {{ params: any, only?: string[] }} wish where the search begins, and what it looks for where that is said
   * @returns {Promise<any>} `{ kind: 'fit', found }`, or `{ kind: 'no-fit', message }`
   */
  fit(module, log, { params, only }) {
    return this.search(() => new module.LogFit(log, params, only), FIT)
  }

  /**
   * What is wrong with the log or its settings.
   * @param {any} module with `LogVerdict`
   * @param {any} log
   * @param {any} params under which it is judged
   * @returns {Promise<any>} `{ kind: 'verdict', found }`, or `{ kind: 'no-verdict', message }`
   */
  judge(module, log, params) {
    return this.search(() => new module.LogVerdict(log, params), VERDICT)
  }

  /** @param {() => any} open @param {typeof FIT} kinds @returns {Promise<any>} */
  async search(open, { found, none, telling, count, given }) {
    this.stop()
    const { which } = this
    let search
    try {
      search = open()
      let told = this.clock()
      while (search.step()) {
        await new Promise((resolve) => this.soon(() => resolve(undefined)))
        if (which !== this.which) return { kind: none, message: given }
        if (this.clock() - told < TOLD_MS) continue
        told = this.clock()
        const [done, of] = count(search.found())
        this.tell({ kind: telling, done, of })
      }
      return { kind: found, found: search.found() }
    } catch (error) {
      return { kind: none, message: wordsOf(error) }
    } finally {
      search?.free()
    }
  }
}
