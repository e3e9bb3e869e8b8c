/** The map of a log's likelihood as a figure sees it: filled row by row by a worker, anew for each log. */

import { openPort } from '../../load/worker-port.js'

/** Cells to a side. */
const SIZE = 96
/** In a still, which every reader of the page fetches. */
const STILL_SIZE = 40

/**
 * @typedef {import('../../draw/likelihood.js').Likelihood & { stopped: boolean }} Likelihood `stopped` where the reader
 * has cancelled the rest
 */

/**
 * @typedef {object} Port the way to what computes
 * @property {(message: any) => void} post
 * @property {((message: any) => void) | null} onmessage
 */

/** @type {import('../../figure/spec.js').Aside} */
export const likelihood = {
  whole(lab) {
    const fitted = lab.constructor.from({ ...lab.state(), params: { ...lab.state().params, fit: true } })
    const { logLikelihood: top, limit } = fitted.frame().fit
    const values = Array.from({ length: STILL_SIZE }, (_, row) => [
      ...fitted.likelihoodRow(row, STILL_SIZE, STILL_SIZE),
    ]).flat()
    fitted.free()
    return { size: STILL_SIZE, rows: STILL_SIZE, values, top, limit, stopped: false }
  },
  open: (changed) => new Filling(changed, begin),
}

/** @returns {Promise<Port>} */
async function begin() {
  const { default: address } = await import('tune-worker')
  return openPort(address, async () => {
    const [{ serve }, { loadLab }] = await Promise.all([import('./server.js'), import('../../load/modules.js')])
    return (channel) => serve(channel, () => loadLab('tune'))
  })
}

/** A map that is being filled. */
export class Filling {
  /** @param {() => void} changed @param {() => Promise<Port>} open the way to what computes */
  constructor(changed, open) {
    this.changed = changed
    this.open = open
    /** @type {Promise<Port> | null} */
    this.port = null
    /** @type {Likelihood | null} */
    this.value = null
    this.id = 0
    this.log = ''
    this.filling = false
  }

  /** @returns {import('../../figure/progress.js').Work | null} */
  get progress() {
    return this.filling ? { step: this.value?.rows ?? 0, of: SIZE, unit: 'row' } : null
  }

  /**
   * Begins anew where the log is another, or where the reader asks for the fit of a map that was cancelled.
   * @param {{ params: { seed: number, length: number, fit: boolean } }} frame
   */
  follow({ params: { seed, length, fit } }) {
    const log = `${seed} ${length}`
    const again = this.value?.stopped && fit && !this.fit
    this.fit = fit
    if (log === this.log && !again) return
    this.log = log
    this.id += 1
    this.value = null
    this.filling = true
    this.say({ kind: 'fill', id: this.id, params: { seed, length }, size: SIZE })
  }

  cancel() {
    if (!this.filling) return
    this.filling = false
    this.id += 1
    if (this.value) this.value = { ...this.value, stopped: true }
    this.say({ kind: 'cancel' })
    this.changed()
  }

  /** @param {any} message */
  async say(message) {
    try {
      this.port ??= this.open()
      const port = await this.port
      port.onmessage = (told) => this.take(told)
      port.post(message)
    } catch {
      // Without its map the figure goes on; the next log tries again.
      this.port = null
      this.stop()
    }
  }

  /** @param {any} message */
  take({ kind, id, top, limit, values }) {
    if (kind === 'failed' || kind === 'ended' || (kind === 'refused' && id === this.id)) return this.stop()
    if (id !== this.id) return
    if (kind === 'top') this.value = { size: SIZE, rows: 0, values: [], top, limit, stopped: false }
    if (kind === 'rows' && this.value) {
      const all = [...this.value.values, ...values]
      this.value = { ...this.value, values: all, rows: all.length / SIZE }
      this.filling = this.value.rows < SIZE
    }
    this.changed()
  }

  stop() {
    this.filling = false
    this.log = ''
    this.changed()
  }
}
