/**
 * The small picture at the head of the cover and of a chapter: the ellipse of a prediction grows until it touches the
 * line of a reading, and there the estimate goes. The core computes ellipse, line and feet; the style sheet plays it
 * once.
 */

import { createRequire } from 'node:module'
import { join } from 'node:path'
import { ellipsePath, evenPlane } from '../draw/plot.js'

const SIZE = { width: 300, height: 190 }

/** The picture as SVG. @param {string} pkg the module's build for Node */
export function vignette(pkg) {
  const { Picture } = createRequire(import.meta.url)(join(pkg, 'estimate_wasm.js'))
  const lab = Picture.from({ version: 1, lab: 'picture', step: 0, params: { noise: 0 } })
  const {
    params: { mean, reading },
    predicted,
    mahalanobisFoot: foot,
  } = lab.frame()
  lab.free()
  const plane = evenPlane({ left: 0, top: 0, right: SIZE.width, bottom: SIZE.height }, [3.9, 3.95], 1.75)
  const at = (/** @type {number[]} */ [x, y]) => [plane.x(x), plane.y(y)].map((value) => Math.round(value * 10) / 10)
  const [[mx, my], [fx, fy]] = [at(mean), at(foot.at)]
  const line = at([0, reading])[1]
  return [
    `<svg class="vignette" viewBox="0 0 ${SIZE.width} ${SIZE.height}" aria-hidden="true" focusable="false">`,
    `<path class="mark outline prediction" d="${ellipsePath(predicted.ellipse, mean, plane)}"/>`,
    `<path class="mark line measurement" d="M0 ${line}H${SIZE.width}"/>`,
    `<path class="mark curve prediction" style="transform-origin:${mx}px ${my}px" ` +
      `d="${ellipsePath(foot.ellipse, mean, plane)}"/>`,
    `<path class="mark way posterior" pathLength="1" d="M${mx} ${my}L${fx} ${fy}"/>`,
    `<circle class="mark hollow prediction" cx="${mx}" cy="${my}" r="4.5"/>`,
    `<circle class="mark full posterior" cx="${fx}" cy="${fy}" r="5"/>`,
    '</svg>',
  ].join('')
}
