/**
 * Counts a program's worlds, in a worker. It is told things by messages and answers by messages.
 *
 * - `{ kind: 'count', id, params }`: `{ kind: 'found', id, found }` until all worlds are counted, or
 *   `{ kind: 'refused', id, message }` where a line has no value in one of them
 * - `{ kind: 'cancel' }`: nothing more about the program that was being counted
 *
 * Between two chunks it reads its messages. A later `count` replaces an earlier one.
 */

import { attend, wordsOf } from '../../load/worker-server.js'

/** How long it computes without reading its messages, milliseconds. */
const CHUNK_MS = 24

/**
 * Answers what comes through a channel.
 * @param {import('../../load/worker-port.js').Channel} channel
 * @param {() => Promise<import('../../load/loader.js').Loaded<any>>} load
 */
export const serve = (channel, load) => attend(channel, load, (module, tell, soon) => new Server(module, tell, soon))

export class Server {
  /**
   * @param {any} module with `WriteFilter`
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} [clock]
   */
  constructor(module, tell, soon, clock = () => performance.now()) {
    this.module = module
    this.tell = tell
    this.soon = soon
    this.clock = clock
    /** @type {{ id: number, worlds: any } | null} */
    this.work = null
  }

  /** @param {any} message */
  take({ kind, id, params }) {
    this.drop()
    if (kind !== 'count') return
    this.attempt(id, () => {
      const lab = this.module.WriteFilter.from({ version: 1, lab: 'write-filter', step: 0, params })
      try {
        this.work = { id, worlds: lab.worlds() }
      } finally {
        lab.free()
      }
      this.goOn()
    })
  }

  drop() {
    this.work?.worlds.free()
    this.work = null
  }

  /** @param {number} id @param {() => void} act */
  attempt(id, act) {
    try {
      act()
    } catch (error) {
      const message = wordsOf(error)
      this.drop()
      this.tell({ kind: 'refused', id, message })
    }
  }

  goOn() {
    const { work } = this
    if (!work) return
    const began = this.clock()
    let more = true
    while (more && this.clock() - began < CHUNK_MS) more = work.worlds.step()
    this.tell({ kind: 'found', id: work.id, found: work.worlds.found() })
    if (!more) return this.drop()
    this.soon(() => {
      if (this.work === work) this.attempt(work.id, () => this.goOn())
    })
  }
}
