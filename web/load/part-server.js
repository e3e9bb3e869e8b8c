/**
 * One long computation at a time, in a worker: in parts, between which it reads its messages. A later one replaces an
 * earlier one, and one that fails is over, and says so by `{ kind: 'refused', id, message }`.
 */

import { TURN_MS } from '../figure/time-slices.js'
import { wordsOf } from './worker-server.js'

/**
 * @typedef {object} Work
 * @property {() => boolean} part computes a part; whether there is another
 * @property {() => void} tell tells what has come
 * @property {() => void} free
 */

export class PartServer {
  /**
   * @param {any} module
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

  drop() {
    this.work?.free()
    this.work = null
  }

  /** @param {number} id what the answers are marked with @param {() => Work} open */
  begin(id, open) {
    this.drop()
    this.attempt(id, () => {
      this.work = open()
      this.goOn(id)
    })
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

  /** @param {number} id */
  goOn(id) {
    const { work } = this
    if (!work) return
    const began = this.clock()
    let more = true
    while (more && this.clock() - began < TURN_MS) more = work.part()
    work.tell()
    if (!more) return this.drop()
    this.soon(() => {
      if (this.work === work) this.attempt(id, () => this.goOn(id))
    })
  }
}
