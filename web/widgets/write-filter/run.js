/** The run: the rail robot in the plane of position and velocity, or the museum's robot from above. */

import { fixed } from '../../draw/numbers.js'
import { clear, drawLabels } from '../../draw/labels.js'
import { axes, dot, ellipseLevel, ellipsePath, halves, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'
import { rounded } from '../../draw/scale.js'
import { drawMap } from '../../draw/stadium.js'
import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').WriteFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** Beyond this an estimate does not lead the axes. */
const FAR = 1e4

/** @param {Panel} panel @param {Frame} frame @param {import('../../figure/spec.js').View} view */
export function drawRun(panel, frame, view) {
  if (view.memory.world !== frame.world) {
    // One has an upright axis, the other a map.
    panel.pen.draw(() => {})
    view.memory.world = frame.world
  }
  if (frame.world === 'linear') return drawPlane(panel, frame)
  const { landmarks, tracks, truth, estimate, ellipse, sighted, used } = frame
  const sighting = sighted === null ? null : { landmark: sighted, used }
  const pose = (/** @type {number[]} */ of) => /** @type {[number, number, number]} */ (of)
  const [at, by] = [pose(truth), pose(estimate)]
  return drawMap(panel, { landmarks, tracks, truth: at, estimate: by, ellipse, sighting }, view)
}

/** @param {Panel} panel @param {Frame} frame */
function drawPlane({ pen, width, height }, frame) {
  const { truth, estimate, right, ellipse, rightEllipse, tracks } = frame
  const around = [
    ...(rightEllipse ? [{ at: right, ellipse: rightEllipse }] : []),
    ...(ellipse ? [{ at: estimate, ellipse }] : []),
  ]
  const reach = [tracks.truth, tracks.estimate].map(({ x, y }) => [x, y])
  const ends = [0, 1].map((axis) => {
    const edges = around.flatMap(({ at, ellipse }) => [-1, 1].map((side) => at[axis] + side * halves(ellipse)[axis]))
    const all = [truth[axis], ...edges, ...reach.flatMap((track) => [...track[axis]])].filter((one) => Math.abs(one) < FAR)
    return rounded(Math.min(...all), Math.max(...all), 5)
  })
  const plane = planeOf({ left: 48, top: 30, right: width - 14, bottom: height - 42 }, ends[0], ends[1])
  pen.draw(() => {
    axes(pen, plane, { x: 'position (m)', y: 'velocity (m/s)', ticks: [5, 5] })
    pen.window('scene', plane.box, (to) => {
      const track = (/** @type {'truth' | 'posterior'} */ kin, /** @type {{ x: number[], y: number[] }} */ { x, y }) =>
        to.mark('path', `track-${kin}`, { ...meaning('track', kin), d: seriesPath(plane, x, y) })
      track('truth', tracks.truth)
      track('posterior', tracks.estimate)
      if (rightEllipse)
        to.mark('path', 'right', { ...meaning('curve dashed', 'truth'), d: ellipsePath(rightEllipse, right, plane) })
      if (ellipse)
        to.mark('path', 'ellipse', { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, estimate, plane) })
      dot(to, 'estimate', plane, estimate, { ...meaning('full', 'posterior'), r: 4 })
      const [x, y] = [plane.x(truth[0]), plane.y(truth[1])]
      to.mark('path', 'truth', { ...meaning('cross', 'truth'), d: `M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}` })
    })
    const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([plane.x(p[0]), plane.y(p[1])])
    drawLabels(
      pen,
      plane.box,
      [
        { key: 'estimate-name', words: 'estimate', at: at(estimate), kin: 'posterior', gap: 12, sides: ['right', 'left', 'below'] },
        { key: 'truth-name', words: 'truth', at: at(truth), kin: 'truth', gap: 12, sides: ['above', 'left', 'below'] },
      ],
      [clear(at(estimate), 7), clear(at(truth), 9)],
    )
    ellipseLevel(pen, plane.box.left, plane.box.bottom + 32)
  })
}

/** The error of the first two states against what the program claims. @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, { series, world }) {
  const { step, first, second, twoSigmaFirst, twoSigmaSecond } = series
  const half = { width: panel.width, height: panel.height / 2 }
  const names = world === 'linear' ? ['position (m)', 'velocity (m/s)'] : ['*x* (m)', '*y* (m)']
  panel.pen.draw((pen) => {
    for (const [i, [error, sigma]] of [
      [first, twoSigmaFirst],
      [second, twoSigmaSecond],
    ].entries())
      pen.group(`state${i}`, { transform: `translate(0 ${i * half.height})` }, (to) => {
        timePlot(to, half, {
          title: `error of ${names[i]}, and ±2σ as claimed`.replace('σ', '*σ*'),
          steps: step,
          include: [-1, 1],
          lines: [
            { key: 'high', values: sigma, name: '', kin: 'posterior', shape: 'thin' },
            { key: 'low', values: sigma.map((one) => -one), name: '', kin: 'posterior', shape: 'thin' },
            { key: 'error', values: error, name: '', kin: 'truth' },
          ],
        })
      })
  })
}

/** @param {Frame} frame */
export function describeRun({ world, step, truth, estimate, ellipse }) {
  const off = Math.hypot(truth[0] - estimate[0], truth[1] - estimate[1])
  const [where, unit] = world === 'linear' ? ['Position and velocity', ''] : ['The stadium from above', ' metres']
  const claimed = ellipse ? `its ellipse has a longer half axis of ${fixed(ellipse.semiMajor, 2)}` : 'its P has no ellipse'
  return `${where} after step ${step}: the estimate is off by ${fixed(off, 2)}${unit}, and ${claimed}.`
}
