/** The stadium from above: landmarks, both tracks, the present reading, and the estimate with its ellipse. */

import { followed } from './camera.js'
import { clear, drawLabels } from './labels.js'
import { dot, ellipseLevel, ellipsePath, meaning, scaleBar, segment, seriesPath } from './plot.js'

/**
 * @typedef {Pick<import('estimate-wasm').MuseumFrame, 'landmarks' | 'tracks' | 'truth'> & {
 *   estimate: number[] | null, ellipse: import('estimate-wasm').Ellipse | null,
 *   sighting: { landmark: number, used: boolean } | null }} Frame an estimate and an ellipse
 * where there are any
 */

/**
 * @param {import('../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../figure/spec.js').View} view
 */
export function drawMap({ pen, width, height }, frame, view) {
  const { landmarks, tracks, truth, estimate, ellipse, sighting } = frame
  const box = { left: 4, top: 4, right: width - 4, bottom: height - 4 }
  const { plane, moving } = followed(view, box, (axis) => {
    const at = axis ? 'y' : 'x'
    return [landmarks.map((landmark) => landmark[at]), tracks.truth[at], tracks.estimate[at], [-1.2, -0.8]]
  })
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([plane.x(p[0]), plane.y(p[1])])
  pen.draw(() => {
    pen.window('scene', box, (to) => {
      to.mark('path', 'track-truth', {
        ...meaning('track', 'truth'),
        d: seriesPath(plane, tracks.truth.x, tracks.truth.y),
      })
      to.mark('path', 'track-estimate', {
        ...meaning('track', 'posterior'),
        d: seriesPath(plane, tracks.estimate.x, tracks.estimate.y),
      })
      if (sighting) {
        const seen = landmarks[sighting.landmark]
        segment(
          to,
          'sight',
          plane,
          truth,
          [seen.x, seen.y],
          meaning(sighting.used ? 'line' : 'line dashed', 'measurement'),
        )
      }
      for (const { id, x, y } of landmarks)
        to.mark('rect', `landmark${id}`, { class: 'corner', x: plane.x(x) - 4, y: plane.y(y) - 4, width: 8, height: 8 })
      if (ellipse && estimate)
        to.mark('path', 'ellipse', { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, estimate, plane) })
      if (estimate) dot(to, 'estimate', plane, estimate, { ...meaning('full', 'posterior'), r: 4 })
      const [x, y] = at(truth)
      to.mark('path', 'robot', {
        class: 'robot',
        d: 'M11 0L-7 7L-4 0L-7 -7Z',
        transform: `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${((-truth[2] * 180) / Math.PI).toFixed(2)})`,
      })
    })
    const marks = landmarks.map(({ x, y }) => at([x, y]))
    const bars = { left: box.left, top: box.bottom - 20, right: box.right, bottom: box.bottom }
    drawLabels(
      pen,
      { ...box, bottom: box.bottom - 20 },
      [
        ...(estimate
          ? [
              {
                key: 'estimate-name',
                words: 'estimate',
                at: at(estimate),
                kin: /** @type {const} */ ('posterior'),
                gap: 14,
                sides: /** @type {('below' | 'above')[]} */ (['below', 'above']),
              },
            ]
          : []),
        { key: 'truth-name', words: 'truth', at: at(truth), kin: 'truth', gap: 14, sides: ['above', 'below'] },
      ],
      [
        ...marks.map((mark) => clear(mark, 7)),
        ...(estimate ? [clear(at(estimate), 8)] : []),
        clear(at(truth), 11),
        bars,
      ],
    )
    ellipseLevel(pen, box.left + 6, box.bottom - 4)
    scaleBar(pen, plane, box.right - 6, box.bottom - 4)
  })
  return moving
}
