/**
 * Fills maps of the likelihood, in a worker. It is told things by messages and answers by messages.
 *
 * - `{ kind: 'fill', id, params, size }`: `{ kind: 'top', id, top, limit }`, then `{ kind: 'rows', id, values }` until
 *   the map is full, or `{ kind: 'refused', id }`
 * - `{ kind: 'cancel' }`: nothing more about the map that was being filled
 *
 * Between two chunks it reads its messages. A later `fill` replaces an earlier one.
 */

import { attend, wordsOf } from '../../load/worker-server.js'

/** How long it computes without reading its messages, milliseconds. */
const CHUNK_MS = 24

/** @typedef {{ id: number, lab: any, size: number, row: number }} Work */

/**
 * Answers what comes through a channel.
 * @param {import('../../load/worker-port.js').Channel} channel
 * @param {() => Promise<import('../../load/loader.js').Loaded<any>>} load
 */
export const serve = (channel, load) => attend(channel, load, (module, tell, soon) => new Server(module, tell, soon))

export class Server {
  /**
   * @param {any} module with `Tune`
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} [clock]
   */
  constructor(module, tell, soon, clock = () => performance.now()) {
    this.module = module
    this.tell = tell
    this.soon = soon
    this.clock = clock
    /** @type {Work | null} */
    this.work = null
  }

  /** @param {any} message */
  take(message) {
    this.drop()
    if (message.kind === 'fill') this.fill(message)
  }

  drop() {
    this.work?.lab.free()
    this.work = null
  }

  /** @param {{ id: number, params: Record<string, unknown>, size: number }} wish */
  fill({ id, params, size }) {
    this.attempt(id, () => {
      const lab = this.module.Tune.from({ version: 1, lab: 'tune', step: 0, params: { ...params, fit: true } })
      this.work = { id, lab, size, row: 0 }
      const { logLikelihood: top, limit } = lab.frame().fit
      this.tell({ kind: 'top', id, top, limit })
      this.goOn()
    })
  }

  /** A part of a map: one that fails ends the map, and says so. @param {number} id @param {() => void} act */
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
    const { id, lab, size } = work
    const began = this.clock()
    const values = []
    while (work.row < size && this.clock() - began < CHUNK_MS) {
      values.push(...lab.likelihoodRow(work.row, size, size))
      work.row += 1
    }
    this.tell({ kind: 'rows', id, values })
    if (work.row === size) return this.drop()
    this.soon(() => {
      if (this.work === work) this.attempt(id, () => this.goOn())
    })
  }
}
