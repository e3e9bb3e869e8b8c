/** The map of a log's likelihood as a figure sees it: filled row by row by a worker, anew for each log. */

import { Beside } from '../../figure/beside.js'
import { openWorker } from '../../load/worker-port.js'

/** Cells to a side. */
const SIZE = 96
/** In a still, which every reader of the page fetches. */
const STILL_SIZE = 40

/**
 * @typedef {import('../../draw/likelihood.js').Likelihood & { stopped: boolean }} Likelihood `stopped` where the reader
 * has cancelled the rest
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

/** @returns {Promise<import('../../figure/beside.js').Port>} */
const begin = () => openWorker(import('tune-worker'), 'tune', () => import('./server.js'))

/** A map that is being filled. @extends {Beside<Likelihood>} */
export class Filling extends Beside {
  /** Whether the reader asked for the fit last. */
  fit = false

  /** @returns {import('../../figure/progress.js').Work | null} */
  get progress() {
    return this.working ? { step: this.value?.rows ?? 0, of: SIZE, unit: 'row' } : null
  }

  /**
   * Begins anew where the log is another, or where the reader asks for the fit of a map that was cancelled.
   * @param {{ params: { seed: number, length: number, fit: boolean } }} frame
   */
  follow({ params: { seed, length, fit } }) {
    const log = `${seed} ${length}`
    const again = this.value?.stopped && fit && !this.fit
    this.fit = fit
    if (log !== this.key || again) this.ask(log, { kind: 'fill', params: { seed, length }, size: SIZE })
  }

  cancel() {
    if (this.working && this.value) this.value = { ...this.value, stopped: true }
    super.cancel()
  }

  /** @param {any} message */
  hear({ kind, top, limit, values }) {
    if (kind === 'top') this.value = { size: SIZE, rows: 0, values: [], top, limit, stopped: false }
    if (kind !== 'rows' || !this.value) return
    const all = [...this.value.values, ...values]
    this.value = { ...this.value, values: all, rows: all.length / SIZE }
    this.working = this.value.rows < SIZE
  }
}
