/**
 * Fills maps of the likelihood, in a worker. It is told things by messages and answers by messages.
 *
 * - `{ kind: 'fill', id, params, size }`: `{ kind: 'top', id, top, limit }`, then `{ kind: 'rows', id, values }` until
 *   the map is full, or `{ kind: 'refused', id }`
 * - `{ kind: 'cancel' }`: nothing more about the map that was being filled
 *
 * Between two chunks it reads its messages. A later `fill` replaces an earlier one.
 */

import { PartServer } from '../../load/part-server.js'
import { attend } from '../../load/worker-server.js'

/**
 * Answers what comes through a channel.
 * @param {import('../../load/worker-port.js').Channel} channel
 * @param {() => Promise<import('../../load/loader.js').Loaded<any>>} load
 */
export const serve = (channel, load) => attend(channel, load, (module, tell, soon) => new Server(module, tell, soon))

/** Its module has `Tune`. */
export class Server extends PartServer {
  /** @param {any} message */
  take(message) {
    if (message.kind === 'fill') this.begin(message.id, () => this.map(message))
    else this.drop()
  }

  /** @param {{ id: number, params: Record<string, unknown>, size: number }} wish */
  map({ id, params, size }) {
    const lab = this.module.Tune.from({ version: 1, lab: 'tune', step: 0, params: { ...params, fit: true } })
    let [row, told] = [0, -1]
    /** @type {number[]} rows that are not told yet */
    let values = []
    return {
      part() {
        values.push(...lab.likelihoodRow(row, size, size))
        row += 1
        return row < size
      },
      tell: () => {
        // First what the rows are measured against.
        if (told < 0) {
          const { logLikelihood: top, limit } = lab.frame().fit
          this.tell({ kind: 'top', id, top, limit })
        }
        this.tell({ kind: 'rows', id, values })
        ;[told, values] = [row, []]
      },
      free: () => lab.free(),
    }
  }
}
