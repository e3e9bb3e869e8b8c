/**
 * The small pictures at the heads. A chapter’s: the ellipse of a prediction grows until it touches a reading’s line,
 * and there the estimate goes; the style sheet plays it once, and then it is the reader's to drag. The cover's: a lap
 * as it was driven, and as the encoders tell it for each error of a wheel. The core computes all of it.
 */

import { createRequire } from 'node:module'
import { join } from 'node:path'
import { fixed } from '../draw/numbers.js'
import { ellipsePath, evenPlane, seriesPath } from '../draw/plot.js'

const SIZE = { width: 300, height: 190 }

/**
 * The picture as SVG. The ellipse leans to the other side than that of the figures, whose question is where it touches.
 * @param {string} pkg the module's build for Node
 */
export function vignette(pkg) {
  const { Picture } = createRequire(import.meta.url)(join(pkg, 'estimate_wasm.js'))
  const open = (/** @type {object} */ params) => Picture.from({ version: 1, lab: 'picture', step: 0, params })
  const figures = open({})
  const lab = open({ noise: 0, angle: Math.PI - figures.frame().params.angle })
  figures.free()
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
    `<svg class="vignette" viewBox="0 0 ${SIZE.width} ${SIZE.height}" aria-hidden="true" focusable="false" ` +
      `data-toy="touch" data-mean="${mx} ${my}" data-foot="${fx} ${fy}" data-expected="${mean[1]}" ` +
      `data-reading="${reading}" ` +
      `style="--mx:${mx}px;--my:${my}px;--dx:${fx - mx}px;--dy:${fy - my}px">`,
    `<path class="mark outline prediction" d="${ellipsePath(predicted.ellipse, mean, plane)}"/>`,
    `<path class="mark line measurement" d="M0 ${line}H${SIZE.width}"/>`,
    `<path class="mark curve prediction" d="${ellipsePath(foot.ellipse, mean, plane)}"/>`,
    `<path class="mark way posterior" pathLength="1" d="M${mx} ${my}L${fx} ${fy}"/>`,
    `<circle class="mark hollow prediction" cx="${mx}" cy="${my}" r="4.5"/>`,
    `<circle class="mark full posterior" cx="${fx}" cy="${fy}" r="5"/>`,
    '</svg>',
  ].join('')
}

/** Biases of the right wheel, and the one that the cover opens with. */
const BIASES = Array.from({ length: 21 }, (_, i) => i * 0.0005)
const OPENS = 10
const LAP = 640

/** The cover's picture as SVG. @param {string} pkg the module's build for Node */
export function lap(pkg) {
  const { OdometryHook } = createRequire(import.meta.url)(join(pkg, 'estimate_wasm.js'))
  const plane = evenPlane({ left: 0, top: 0, right: SIZE.width, bottom: SIZE.height }, [4.6, 2.6], 6.9)
  const runs = BIASES.map((bias) => {
    const run = OdometryHook.from({ version: 1, lab: 'odometry-hook', step: LAP, params: { bias, slip: 0 } })
    const { tracks, error } = run.frame()
    run.free()
    return { bias, tracks, error }
  })
  const [{ tracks: driven }] = runs
  return [
    `<svg class="vignette" viewBox="0 0 ${SIZE.width} ${SIZE.height}" aria-hidden="true" focusable="false" ` +
      'data-toy="lap">',
    `<path class="mark track truth" d="${seriesPath(plane, driven.truth.x, driven.truth.y)}"/>`,
    ...runs.map(({ bias, tracks: { estimate }, error }, i) => {
      const end = [plane.x(estimate.x.at(-1)), plane.y(estimate.y.at(-1))].map((value) => Math.round(value * 10) / 10)
      const [wheel, off] = [fixed(100 * bias, 2), fixed(error.position, 1)]
      const words = `a wheel ${wheel} % smaller than believed: ${off} m off after a lap`
      return (
        `<path class="mark track prediction lap" data-end="${end.join(' ')}" data-words="${words}"` +
        `${i === OPENS ? '' : ' hidden'} d="${seriesPath(plane, estimate.x, estimate.y)}"/>`
      )
    }),
    '</svg>',
  ].join('')
}
