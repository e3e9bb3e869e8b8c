/** What a log's run asks its worker besides replays: tables, a fit, a map of the likelihood. */

import { Player } from '../../figure/player.js'

/**
 * @typedef {object} Port the way to the worker
 * @property {(message: any) => void} post
 * @property {(message: any) => Promise<any>} ask
 * @property {((message: any) => void) | null} onmessage
 * @property {(why: string) => void} restart
 */

export class Asking extends Player {
  /** @param {Port} port @param {number} pace rows a second at speed 1 */
  constructor(port, pace) {
    super({ step: 0, rows: 0, params: {} }, pace)
    this.port = port
    /** Called with how far a fit has come. @type {((told: { done: number, of: number }) => void) | null} */
    this.onfitting = null
    /** Called with a row of a map. @type {((told: { row: number, values: number[] }) => void) | null} */
    this.onmapped = null
  }

  /** The log, or its replay, as a table. @param {'track' | 'innovations' | 'log'} table @returns {Promise<any>} */
  table(table) {
    return this.port.ask({ kind: 'table', params: this.asked ?? this.frame.params, table })
  }

  /**
   * Where the log began by its first readings, as they are read now.
   * @param {Record<string, unknown>} [more] settings besides @returns {Promise<any>}
   */
  opening(more) {
    return this.port.ask({ kind: 'opening', params: { ...(this.asked ?? this.frame.params), ...more } })
  }

  /**
   * The σ and the delays under which the log's readings are likeliest, or only those of these names.
   * @param {{ only?: string[], from?: Record<string, unknown> }} [wish] `from`, settings for the search alone
   * @returns {Promise<any>}
   */
  fit({ only, from } = {}) {
    this.stop('map')
    return this.port.ask({ kind: 'fit', params: { ...(this.asked ?? this.frame.params), ...from }, only })
  }

  /**
   * The log's likelihood over two numbers, with the gates off: its rows come by `onmapped`.
   * @param {Omit<Parameters<import('./likelihood.js').Mapping['map']>[2], 'params'>} wish @returns {Promise<any>}
   */
  map(wish) {
    return this.port.ask({ kind: 'map', ...wish, params: { ...(this.asked ?? this.frame.params), gate: null } })
  }

  /** Gives up what was asked for and takes long. @param {'fit' | 'map'} what */
  stop(what) {
    this.port.post({ kind: `stop-${what}` })
  }

  /** Takes what the worker tells on the way; whether it was that. @param {any} message */
  told(message) {
    if (message.kind === 'fitting') this.onfitting?.(message)
    else if (message.kind === 'mapped') this.onmapped?.(message)
    else return false
    return true
  }
}
