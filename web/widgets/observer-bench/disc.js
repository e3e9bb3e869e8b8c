/** The unit disc with the eigenvalues of the error dynamics. */

import { clear, drawLabels, rim, widthOf } from '../../draw/labels.js'
import { dot, evenPlane, meaning } from '../../draw/plot.js'
import { complex, fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').BenchFrame} Frame */

const REACH = 1.32
const PINNED = '1, pinned'
/** A gain set by hand and the filter's gain have letters of their own in both conventions. */
const TITLE = {
  fixed: 'eigenvalues of (*I* − {K}{H}){F}',
  // The filter's gain changes at every step, so its eigenvalues are those of one step's matrix as if it stayed.
  filter: 'frozen eigenvalues of (*I* − {R}{H}){F}',
  // No gain has been used yet: these are of the first step to come.
  coming: 'step 1: frozen eigenvalues of (*I* − {R}{H}){F}',
}

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 */
export function drawDisc({ pen, width, height }, frame) {
  const plane = evenPlane({ left: 14, top: 30, right: width - 14, bottom: height - 12 }, [0, 0], REACH)
  const { x, y, box } = plane
  const filters = frame.params.mode === 'filter'
  pen.draw(() => {
    pen.text(
      'title',
      { class: 'plot-title', x: box.left, y: 16 },
      TITLE[frame.step === 0 && filters ? 'coming' : frame.params.mode],
    )
    pen.mark('circle', 'disc', { class: 'disc', cx: x(0), cy: y(0), r: x(1) - x(0) })
    pen.mark('line', 'real', { class: 'zero', x1: box.left, x2: box.right, y1: y(0), y2: y(0) })
    pen.mark('line', 'imaginary', { class: 'zero', x1: x(0), x2: x(0), y1: box.top, y2: box.bottom })
    for (const at of frame.pinned === null ? [-1, 1] : [-1])
      pen.text(
        `tick${at}`,
        { class: 'tick', x: x(at) + (at < 0 ? 5 : -5), y: y(0) + 15, 'text-anchor': at < 0 ? 'start' : 'end' },
        fixed(at, 0),
      )
    pen.text('tick-i', { class: 'tick', x: x(0) + 5, y: y(1) + 14 }, 'i')
    pen.mark('circle', 'rim', { class: 'disc-rim', cx: x(0), cy: y(0), r: x(1) - x(0) })
    const seen = frame.eigenvalues.map((value, i) => eigenvalue(pen, plane, frame, value, i))
    drawLabels(
      pen,
      { left: 2, top: 22, right: width - 2, bottom: height - 2 },
      seen.flatMap(({ label }) => label ?? []),
      [...seen.map(({ at }) => clear(at, 8)), ...free(pen, plane, frame, width)],
    )
  })
}

/**
 * What the names keep clear of: the rim, the real axis and its ticks, and the name of an eigenvalue that stays at 1,
 * which stands outside the circle as near as the panel has room.
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {Frame} frame
 * @param {number} width
 * @returns {import('../../draw/plot.js').Box[]}
 */
function free(pen, { x, y, box }, frame, width) {
  const [cx, cy, r] = [x(0), y(0), x(1) - x(0)]
  const real = { left: box.left, right: box.right, top: cy - 1, bottom: cy + 1 }
  const ticks = [
    { left: cx - r, right: cx - r + 20, top: cy + 2, bottom: cy + 18 },
    { left: cx + r - 14, right: cx + r, top: cy + 2, bottom: cy + 18 },
  ]
  if (frame.pinned === null) return [...rim([cx, cy], r), real, ...ticks]
  const left = Math.min(x(1) + 4, width - 2 - widthOf(PINNED))
  const top = cy + Math.max(16, Math.sqrt(Math.max(0, r ** 2 - Math.max(0, left - 3 - cx) ** 2)))
  pen.text('pinned-name', { class: 'eigenvalue-name', x: left, y: top + 12 }, PINNED)
  return [...rim([cx, cy], r), real, ticks[0], clear([x(1), cy], 12), { left, right: width, top, bottom: top + 15 }]
}

/**
 * Draws an eigenvalue.
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {Frame} frame
 * @param {import('estimate-wasm').Complex} value
 * @param {number} i
 * @returns {{ at: [number, number], label?: import('../../draw/labels.js').Label }} where it stands, and what is
 * written beside it
 */
function eigenvalue(pen, plane, frame, value, i) {
  const { x, y, box } = plane
  const pinned = frame.pinned === i
  const outside = frame.outside[i]
  const re = Math.max(x.invert(box.left + 7), Math.min(x.invert(box.right - 7), value.re))
  const off = re !== value.re
  const at = /** @type {[number, number]} */ ([x(re), y(value.im)])
  const name = `eigenvalue ${outside ? 'outside' : ''} ${pinned ? 'pinned' : ''}`.replace(/ +/g, ' ').trim()
  if (pinned) pen.mark('circle', `ring${i}`, { class: 'pinned-ring', cx: at[0], cy: at[1], r: 11 })
  if (off)
    pen.mark('path', `off${i}`, {
      class: name,
      d: `M${at[0] + 3} ${y(0) - 6}L${at[0] - 6} ${y(0)}L${at[0] + 3} ${y(0) + 6}Z`,
    })
  else dot(pen, `dot${i}`, plane, [re, value.im], { ...meaning(name), r: 5.5 })
  const pair = value.im !== 0
  if (pinned || (pair && i > 0)) return { at }
  const words = pair ? `${fixed(value.re, 2)} ± ${fixed(Math.abs(value.im), 2)} i` : complex(value, 2)
  return {
    at,
    label: {
      key: `name${i}`,
      words,
      at,
      name: `eigenvalue-name${outside ? ' outside' : ''}`,
      gap: 12,
      sides: ['above', 'above-left', 'above-right', 'below', 'below-left', 'below-right'],
    },
  }
}
