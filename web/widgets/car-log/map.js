/** The town from above: the fixes, the course by speeds and turn rates alone, the estimate and the smoothed course. */

import { followed } from '../../draw/camera.js'
import { drawLabels } from '../../draw/labels.js'
import { axes, meaning, plane as planeOf, scaleBar, seriesPath } from '../../draw/plot.js'
import { drawCrosses, drawPoints } from '../../draw/points.js'
import { band, empty } from '../../draw/statistics.js'

/** @typedef {import('estimate-wasm').CarFrame} Frame */

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {boolean} whether the camera still moves
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 0, top: 0, right: width, bottom: height }
  const { estimate, reckoning, smoothed, fixes, refused, withheld } = frame
  const all = [estimate, reckoning, smoothed, fixes, refused, withheld]
  const { plane, moving } = followed(view, { ...box, bottom: box.bottom - 20 }, (axis) =>
    all.map((one) => (axis ? one.y : one.x)),
  )
  const place = (/** @type {{ x: number[], y: number[] }} */ { x, y }, /** @type {number} */ part) => {
    const i = Math.floor(x.length * part)
    return /** @type {[number, number]} */ ([plane.x(x[i]), plane.y(y[i])])
  }
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      const track = (
        /** @type {string} */ key,
        /** @type {string} */ shape,
        /** @type {import('../../draw/plot.js').Kin} */ kin,
        /** @type {{ x: number[], y: number[] }} */ { x, y },
      ) => to.mark('path', key, { ...meaning(shape, kin), d: seriesPath(plane, x, y) })
      drawPoints(to, 'fixes', plane, fixes.x, fixes.y, 'measurement')
      drawPoints(to, 'withheld', plane, withheld.x, withheld.y, 'truth')
      track('reckoning', 'track dashed', 'prediction', reckoning)
      if (frame.params.fixes !== 'none') track('estimate', 'track', 'posterior', estimate)
      if (smoothed.x.length > 0) track('smoothed', 'curve thin dashed', 'posterior', smoothed)
      drawCrosses(to, 'refused', plane, refused.x, refused.y, () => true)
    })
    scaleBar(pen, plane, box.right - 6, box.bottom - 6)
    /** @type {import('../../draw/labels.js').Label[]} */
    const labels = []
    if (reckoning.x.length > 0)
      labels.push({ key: 'alone', words: 'speed and turn alone', at: place(reckoning, 0.8), kin: 'prediction' })
    if (frame.params.fixes !== 'none' && estimate.x.length > 0)
      labels.push({ key: 'estimate-name', words: 'estimate', at: place(estimate, 0.3), kin: 'posterior' })
    if (smoothed.x.length > 0)
      labels.push({ key: 'smoothed-name', words: 'the track afterwards', at: place(smoothed, 0.6), kin: 'posterior' })
    if (withheld.x.length > 0)
      labels.push({ key: 'withheld-name', words: 'withheld', at: place(withheld, 0.5), kin: 'truth' })
    drawLabels(pen, box, labels)
  })
  return moving
}

/** The innovations along the track. @param {import('../../figure/shell.js').Panel} panel @param {Frame} frame */
export function drawAlong({ pen, width, height }, { time, along }) {
  const box = { left: 46, top: 26, right: width - 14, bottom: height - 24 }
  const plane = planeOf(box, [0, Math.max(10, time[time.length - 1] ?? 0)], [-6, 6])
  pen.draw(() => {
    axes(pen, plane, { title: '{innov}/√*S* along the track', ticks: [5, 4], zero: true })
    pen.text('unit', { class: 'axis-name', x: box.right, y: box.bottom - 5, 'text-anchor': 'end' }, 's')
    if (time.length === 0) return empty(pen, plane, 'no fix is used')
    band(pen, plane, -2, 2)
    drawPoints(pen, 'along', plane, time, along, 'measurement')
  })
}
