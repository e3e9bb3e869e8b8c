/**
 * Counts a program's worlds, in a worker. It is told things by messages and answers by messages.
 *
 * - `{ kind: 'count', id, params }`: `{ kind: 'found', id, found }` until all worlds are counted, or
 *   `{ kind: 'refused', id, message }` where a line has no value in one of them
 * - `{ kind: 'cancel' }`: nothing more about the program that was being counted
 *
 * Between two chunks it reads its messages. A later `count` replaces an earlier one.
 */

import { PartServer } from '../../load/part-server.js'
import { attend } from '../../load/worker-server.js'

/**
 * Answers what comes through a channel.
 * @param {import('../../load/worker-port.js').Channel} channel
 * @param {() => Promise<import('../../load/loader.js').Loaded<any>>} load
 */
export const serve = (channel, load) => attend(channel, load, (module, tell, soon) => new Server(module, tell, soon))

/** Its module has `WriteFilter`. */
export class Server extends PartServer {
  /** @param {any} message */
  take({ kind, id, params }) {
    if (kind === 'count') this.begin(id, () => this.count(id, params))
    else this.drop()
  }

  /** @param {number} id @param {Record<string, unknown>} params */
  count(id, params) {
    const lab = this.module.WriteFilter.from({ version: 1, lab: 'write-filter', step: 0, params })
    try {
      const worlds = lab.worlds()
      return {
        part: () => worlds.step(),
        tell: () => this.tell({ kind: 'found', id, found: worlds.found() }),
        free: () => worlds.free(),
      }
    } finally {
      lab.free()
    }
  }
}
