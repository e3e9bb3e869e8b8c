/**
 * A map of a log's likelihood over two of its numbers, in the worker: a replay for each cell; between two parts it
 * reads its messages.
 */

import { wordsOf } from '../../load/worker-server.js'

/** How long it computes without reading its messages, milliseconds. */
const CHUNK_MS = 40

/** @typedef {{ name: string, values: number[] }} Axis */

export class Mapping {
  /**
   * @param {(message: any) => void} tell
   * @param {(act: () => void) => void} soon calls back once waiting messages have been read
   * @param {() => number} clock
   */
  constructor(tell, soon, clock) {
    this.tell = tell
    this.soon = soon
    this.clock = clock
    /** Counts the maps: a later one, or giving up, ends the one before. */
    this.which = 0
  }

  stop() {
    this.which += 1
  }

  /**
   * @param {any} module with `RobotLog.logLikelihood`
   * @param {any} log
   * @param {{ params: any, from: number, across: Axis, up: Axis }} wish readings count from `from` on
   * @returns {Promise<any>} `{ kind: 'map' }` behind the last row, or `{ kind: 'no-map', message }`
   */
  async map(module, log, { params, from, across, up }) {
    this.stop()
    const { which } = this
    try {
      for (const [row, high] of up.values.entries()) {
        const values = []
        let began = this.clock()
        for (const wide of across.values) {
          const settings = { ...params, [across.name]: wide, [up.name]: high }
          values.push(module.RobotLog.logLikelihood(log, settings, from).logLikelihood)
          if (this.clock() - began < CHUNK_MS) continue
          await new Promise((resolve) => this.soon(() => resolve(undefined)))
          if (which !== this.which) return GIVEN_UP
          began = this.clock()
        }
        await new Promise((resolve) => this.soon(() => resolve(undefined)))
        if (which !== this.which) return GIVEN_UP
        this.tell({ kind: 'mapped', row, values })
      }
      return { kind: 'map' }
    } catch (error) {
      return { kind: 'no-map', message: wordsOf(error) }
    }
  }
}

const GIVEN_UP = { kind: 'no-map', message: 'The map was given up.' }
