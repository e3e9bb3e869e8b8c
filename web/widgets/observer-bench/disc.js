/** The unit disc with the eigenvalues of the error dynamics. */

import { dot, evenPlane, meaning } from '../../core/plot.js'
import { complex, fixed } from '../../core/numbers.js'

const REACH = 1.32
/** A gain set by hand and the filter's gain have letters of their own in both conventions. */
const TITLE = {
  fixed: 'eigenvalues of (*I* − {K}{H}){F}',
  // The filter's gain changes at every step, so its eigenvalues are those of one step's matrix as if it stayed.
  filter: 'frozen eigenvalues of (*I* − {R}{H}){F}',
}

/**
 * @param {import('../../core/shell.js').Panel} panel
 * @param {import('estimate-wasm').BenchFrame} frame
 */
export function drawDisc({ pen, width, height }, frame) {
  const plane = evenPlane({ left: 14, top: 30, right: width - 14, bottom: height - 12 }, [0, 0], REACH)
  const { x, y, box } = plane
  pen.draw(() => {
    pen.text('title', { class: 'plot-title', x: box.left, y: 16 }, TITLE[frame.params.mode])
    pen.mark('circle', 'disc', { class: 'disc', cx: x(0), cy: y(0), r: x(1) - x(0) })
    pen.mark('line', 'real', { class: 'zero', x1: box.left, x2: box.right, y1: y(0), y2: y(0) })
    pen.mark('line', 'imaginary', { class: 'zero', x1: x(0), x2: x(0), y1: box.top, y2: box.bottom })
    for (const at of frame.pinned === null ? [-1, 1] : [-1]) pen.text(`tick${at}`, { class: 'tick', x: x(at) + (at < 0 ? 5 : -5), y: y(0) + 15, 'text-anchor': at < 0 ? 'start' : 'end' }, fixed(at, 0))
    pen.text('tick-i', { class: 'tick', x: x(0) + 5, y: y(1) + 14 }, 'i')
    pen.mark('circle', 'rim', { class: 'disc-rim', cx: x(0), cy: y(0), r: x(1) - x(0) })
    frame.eigenvalues.forEach((value, i) => eigenvalue(pen, plane, frame, value, i))
  })
}

/** @param {import('../../core/pen.js').Pen} pen @param {import('../../core/plot.js').Plane} plane @param {import('estimate-wasm').BenchFrame} frame @param {import('estimate-wasm').Complex} value @param {number} i */
function eigenvalue(pen, plane, frame, value, i) {
  const { x, y, box } = plane
  const pinned = frame.pinned === i
  const outside = frame.outside[i]
  const re = Math.max(x.invert(box.left + 7), Math.min(x.invert(box.right - 7), value.re))
  const off = re !== value.re
  const name = `eigenvalue ${outside ? 'outside' : ''} ${pinned ? 'pinned' : ''}`.replace(/ +/g, ' ').trim()
  if (pinned) pen.mark('circle', `ring${i}`, { class: 'pinned-ring', cx: x(re), cy: y(value.im), r: 11 })
  if (off) pen.mark('path', `off${i}`, { class: name, d: `M${x(re) + 3} ${y(0) - 6}L${x(re) - 6} ${y(0)}L${x(re) + 3} ${y(0) + 6}Z` })
  else dot(pen, `dot${i}`, plane, [re, value.im], { ...meaning(name), r: 5.5 })
  const pair = value.im !== 0
  if (pair && i > 0) return
  const words = pinned ? '1, pinned' : pair ? `${fixed(value.re, 2)} ± ${fixed(Math.abs(value.im), 2)} i` : complex(value, 2)
  const left = x(re) > (box.left + box.right) / 2 + 20
  const near = frame.eigenvalues.some((other, j) => j < i && other.im === 0 && Math.abs(other.re - value.re) < 0.5)
  const dy = pinned || (near && frame.pinned === null) ? 30 : -13
  pen.text(`name${i}`, { class: `eigenvalue-name${outside ? ' outside' : ''}`, x: x(re) + (left ? 8 : off ? 4 : 0), y: y(value.im) + dy, 'text-anchor': left ? 'end' : off ? 'start' : 'middle' }, words)
}
