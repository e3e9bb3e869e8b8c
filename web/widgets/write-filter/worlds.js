/** The program in 500 worlds: the mean NEES and NIS in a right filter's bands. */

import { fixed } from '../../draw/numbers.js'
import { Beside } from '../../figure/beside.js'
import { SEEDS } from '../../figure/ensemble.js'
import { openWorker } from '../../load/worker-port.js'

/** @typedef {import('estimate-wasm').WriteWorlds} Found */

/** @type {import('../../figure/spec.js').Aside} */
export const worlds = {
  whole(lab) {
    const counted = lab.worlds()
    while (counted.step());
    const found = counted.found()
    counted.free()
    return found
  },
  open: (changed) => new Counting(changed, begin),
}

/** @returns {Promise<import('../../figure/beside.js').Port>} */
const begin = () => openWorker(import('write-filter-worker'), 'write-filter', () => import('./server.js'))

/** Worlds that are being counted, anew for each program. @extends {Beside<Found>} */
export class Counting extends Beside {
  /** @returns {import('../../figure/progress.js').Work | null} */
  get progress() {
    return this.working ? { step: this.value?.count ?? 0, of: SEEDS, unit: 'world' } : null
  }

  /** @param {import('estimate-wasm').WriteFrame} frame */
  follow({ params: { begin, text, notation }, outcome }) {
    const params = { begin, text, notation }
    const key = outcome === 'refused' ? '' : JSON.stringify(params)
    if (key !== this.key) this.ask(key, key === '' ? null : { kind: 'count', params })
  }

  /** @param {{ found: Found }} message */
  hear({ found }) {
    this.value = found
    this.working = found.count < SEEDS
  }
}

/** A row for each number: a right filter's band in the middle third, and the program's mean. */
const ROWS = /** @type {const} */ ([
  ['nees', 'NEES'],
  ['nis', 'NIS'],
])
const [LEFT, RIGHT] = [48, 64]
/** What a mean below its band says, and one above it. */
const BEYOND = {
  nees: ['errors are smaller than P says', 'errors are larger than P says'],
  nis: ['innovations are smaller than S says', 'innovations are larger than S says'],
}

/** @param {'nees' | 'nis'} key @param {import('estimate-wasm').WriteMean | null} mean */
function told(key, mean) {
  if (!mean) return key === 'nis' ? 'innovation or S has no line' : 'P is no covariance'
  const { value, band } = mean
  return value < band[0] ? BEYOND[key][0] : value > band[1] ? BEYOND[key][1] : ''
}

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {import('estimate-wasm').WriteFrame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawWorlds({ pen, width, height }, frame, { aside }) {
  const found = /** @type {Found | null} */ (aside)
  const [left, right] = [LEFT, width - RIGHT]
  const third = (right - left) / 3
  const row = (height - 26) / 2
  pen.draw(() => {
    const title =
      frame.outcome === 'refused'
        ? 'no worlds yet'
        : `means over ${found?.count ?? 0} worlds, and 99 % of right filters’`
    pen.text('title', { class: 'plot-title', x: 0, y: 14 }, title)
    pen.mark('rect', 'band', { class: 'band', x: left + third, y: 26, width: third, height: 2 * row })
    for (const [i, [key, name]] of ROWS.entries()) {
      const y = 26 + i * row + 12
      const mean = found?.[key] ?? null
      pen.text(`name${i}`, { class: 'tick', x: 0, y: y + 4 }, name)
      pen.mark('line', `line${i}`, { class: 'grid', x1: left, x2: right, y1: y, y2: y })
      pen.text(`said${i}`, { class: 'rule-name', x: left, y: y + 32 }, found ? told(key, mean) : '')
      pen.text(`value${i}`, { class: 'tick', x: width, y: y + 4, 'text-anchor': 'end' }, fixed(mean?.value, 2))
      if (!mean) continue
      const [low, high] = mean.band
      for (const [end, at] of mean.band.entries())
        pen.text(
          `end${i}${end}`,
          {
            class: 'rule-name',
            x: left + third * (1 + end) + (end ? 4 : -4),
            y: y + 16,
            'text-anchor': end ? 'start' : 'end',
          },
          fixed(at, 2),
        )
      const place = Math.max(0, Math.min(3, 1 + (mean.value - low) / (high - low)))
      pen.mark('circle', `dot${i}`, {
        class: mean.value < low || mean.value > high ? 'mark eigenvalue outside' : 'mark full posterior',
        cx: left + third * place,
        cy: y,
        r: 5,
      })
    }
  })
}

/** @param {Found | null} found */
export const describeWorlds = (found) =>
  ['A right filter’s bands of NEES and NIS over many worlds.', ...(found?.sentences ?? [])].join(' ')
