/** Singular values of the observability matrix over the largest, against a tolerance that the reader moves. */

import { power } from '../../draw/numbers.js'
import { scaleLog } from '../../draw/plot.js'

/** Zero stands at the scale's left end. */
const FLOOR = 1e-17

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {import('estimate-wasm').OwnFrame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawRanks({ pen, width, height }, { rank, tolerance, params }, view) {
  const box = { left: 16, top: 30, right: width - 16, bottom: height - 44 }
  const x = scaleLog([FLOOR, 1.6], [box.left, box.right])
  const middle = (box.top + box.bottom) / 2
  const { least, greatest } = view.limits.logTolerance
  const to = (/** @type {number} */ exponent) => ({
    logTolerance: Math.round(10 * Math.max(least, Math.min(greatest, exponent))) / 10,
  })
  pen.draw(() => {
    pen.text(
      'title',
      { class: 'plot-title', x: box.left, y: 16 },
      `singular values over the largest: rank ${rank.rank} of ${params.states}`,
    )
    for (const exponent of [-15, -10, -5, 0]) {
      const at = x(10 ** exponent)
      pen.mark('line', `grid${exponent}`, { class: 'grid', x1: at, x2: at, y1: box.top, y2: box.bottom })
      pen.text(
        `tick${exponent}`,
        { class: 'tick', x: at, y: box.bottom + 16, 'text-anchor': 'middle' },
        power(10 ** exponent),
      )
    }
    pen.mark('line', 'base', { class: 'axis', x1: box.left, x2: box.right, y1: middle, y2: middle })
    const level = x(tolerance)
    pen.mark('line', 'tolerance', { class: 'level', x1: level, x2: level, y1: box.top, y2: box.bottom + 4 })
    rank.relative.forEach((value, i) =>
      pen.mark('circle', `value${i}`, {
        class: i < rank.rank ? 'mark full' : 'mark hollow',
        cx: x(Math.max(value, FLOOR)),
        cy: middle,
        r: 6,
      }),
    )
    const name = `tolerance ${power(tolerance)}`
    pen.text(
      'tolerance-name',
      {
        class: 'rule-name',
        x: level,
        y: box.bottom + 36,
        'text-anchor': level > width - 90 ? 'end' : level < 90 ? 'start' : 'middle',
      },
      name,
    )
    pen.group('handles', {}, (into) =>
      view.handle(into, 'level', {
        at: [level, box.top + 8],
        small: true,
        label: 'Tolerance of the rank',
        value: power(tolerance),
        now: params.logTolerance,
        min: least,
        max: greatest,
        move: (px) => to(Math.log10(x.invert(px))),
        nudge: (dx, dy) => to(params.logTolerance + 0.1 * (dx || dy)),
        jump: (end) => to(end === 'home' ? least : greatest),
      }),
    )
  })
}
