/** The stretch of the log whose fixes are withheld, as a pale band with its name in every panel over time. */

import { looksOf } from './looks.js'

/** @typedef {import('./looks.js').Frame} Frame */

/** The room that the name takes, pixels. */
const NAME = 56

/**
 * The stretch in seconds since the log's first row, as panels and looks count; null where no fix is withheld.
 * @param {Frame} frame @returns {[number, number] | null}
 */
export function withheldIn({ params: { withheld }, summary, log }) {
  const first = log?.span[0] ?? 0
  return withheld && summary.withheld ? [withheld[0] - first, withheld[1] - first] : null
}

/** What withholds the fixes of the stretch that the panels show; null where they show all. @param {Frame} frame */
export function withholdingShown(frame) {
  const { window } = looksOf(frame)
  const first = frame.log?.span[0] ?? 0
  return window && { withheld: window.map((seconds) => first + seconds) }
}

/**
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {Frame} frame
 */
export function drawWithheld(pen, { box, x }, frame) {
  const stretch = withheldIn(frame)
  if (!stretch) return
  const [left, right] = stretch.map((at) => Math.max(box.left, Math.min(box.right, x(at / 60))))
  if (!(right > left)) return
  pen.mark('rect', 'withheld', {
    class: 'band withheld',
    x: left,
    y: box.top,
    width: right - left,
    height: box.bottom - box.top,
  })
  const middle = Math.max(box.left + NAME / 2, Math.min(box.right - NAME / 2, (left + right) / 2))
  pen.text('withheld-name', { class: 'tick', x: middle, y: box.top + 12, 'text-anchor': 'middle' }, 'withheld')
}
