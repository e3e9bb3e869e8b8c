/**
 * Singular values over the largest, on a logarithmic scale against the tolerance: what counts as seen, and by how much.
 */

import { power } from '../../draw/numbers.js'
import { scaleLog } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */

/** Zero stands at the scale's left end. */
const FLOOR = 1e-17
/** Dots nearer than this would hide one another; so far below the one before the next one stands, pixels. */
const [COVERS, BELOW] = [7, 8]

/** @param {import('../../figure/shell.js').Panel} panel @param {Frame} frame */
export function drawRanks({ pen, width, height }, { frozen, alongPath, params }) {
  const box = { left: 12, top: 28, right: width - 16, bottom: height - 38 }
  const x = scaleLog([FLOOR, 1.6], [box.left, box.right])
  const place = (/** @type {number} */ value) => x(Math.max(value, FLOOR))
  // The two rows share the height, each with its name above it.
  const row = (box.bottom - box.top) / 2
  const past =
    alongPath.steps === 0
      ? 'along the path: no step yet'
      : `along the last ${alongPath.steps === 1 ? 'step' : `${alongPath.steps} steps`}: ` +
        `rank ${alongPath.rank} of ${alongPath.n}`
  const rows = [
    {
      key: 'frozen',
      ranks: frozen,
      name: `frozen at this pose: rank ${frozen.rank} of ${frozen.n}`,
      y: box.top + row - 12,
    },
    { key: 'path', ranks: alongPath, name: past, y: box.bottom - 12 },
  ]
  pen.draw(() => {
    pen.text('title', { class: 'plot-title', x: box.left, y: 18 }, 'singular values, over the largest')
    for (const exponent of [-15, -10, -5, 0]) {
      const at = x(10 ** exponent)
      pen.mark('line', `grid${exponent}`, { class: 'grid', x1: at, x2: at, y1: box.top, y2: box.bottom })
      pen.text(
        `tick${exponent}`,
        { class: 'tick', x: at, y: box.bottom + 16, 'text-anchor': 'middle' },
        power(10 ** exponent),
      )
    }
    pen.text('zero', { class: 'tick', x: box.left, y: box.bottom + 16, 'text-anchor': 'middle' }, '0')
    const level = place(params.tolerance)
    pen.mark('line', 'tolerance', { class: 'level', x1: level, x2: level, y1: box.top, y2: box.bottom + 4 })
    pen.text(
      'tolerance-name',
      {
        class: 'rule-name',
        x: level,
        y: box.bottom + 33,
        'text-anchor': level > width - 70 ? 'end' : level < 70 ? 'start' : 'middle',
      },
      'tolerance',
    )
    for (const { key, ranks, name, y } of rows) {
      pen.mark('line', `${key}-base`, { class: 'axis', x1: box.left, x2: box.right, y1: y, y2: y })
      pen.text(`${key}-name`, { class: 'mark-name', x: box.left, y: y - 12 }, name)
      if (key === 'path' && alongPath.steps === 0) continue
      const places = ranks.relative.map(place)
      ranks.relative.forEach((_, i) => {
        const seen = i < ranks.rank
        // One that would lie on the one before it stands below that.
        const down = places.slice(0, i).filter((at) => Math.abs(at - places[i]) < COVERS).length
        pen.mark('circle', `${key}-${i}`, {
          class: seen ? 'mark full' : 'mark hollow',
          cx: places[i],
          cy: y + BELOW * down,
          r: 6,
        })
      })
    }
  })
}
