/** The run: the rail robot in the plane of position and velocity, or the museum's robot from above. */

import { fixed } from '../../draw/numbers.js'
import { clear, drawLabels } from '../../draw/labels.js'
import { axes, dot, ellipseLevel, ellipsePath, halves, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'
import { drawMap } from '../../draw/stadium.js'
import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').WriteFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** Steps that the trail of the estimate keeps. */
const TRAIL = 12
/** How far the axes reach from the truth; what is beyond the last does not lead them. */
const REACHES = [1, 2, 4, 8, 16, 40, 100, 1e3]
const FAR = 1e4

/** @param {Panel} panel @param {Frame} frame @param {import('../../figure/spec.js').View} view */
export function drawRun(panel, frame, view) {
  if (view.memory.world !== frame.world) {
    // One has an upright axis, the other a map.
    panel.pen.draw(() => {})
    view.memory.world = frame.world
  }
  if (frame.world === 'linear') return drawPlane(panel, frame)
  const { landmarks, truth, sighted, used } = frame
  const sighting = sighted === null ? null : { landmark: sighted, used }
  const { estimate, ellipse } = alive(frame) ? frame : { estimate: null, ellipse: null }
  const tracks = { ...frame.tracks, estimate: near(frame.tracks.estimate) }
  const pose = /** @type {[number, number, number]} */ (truth)
  return drawMap(panel, { landmarks, tracks, truth: pose, estimate, ellipse, sighting }, view)
}

/**
 * Whether the program's run goes on: where it has ended, the world and the right filter go on alone.
 * @param {Frame} frame
 */
const alive = ({ stopped }) => stopped === null

/** A track without what has left the map. @param {{ x: number[], y: number[] }} track */
function near({ x, y }) {
  const there = (/** @type {number} */ _, /** @type {number} */ i) => Math.max(Math.abs(x[i]), Math.abs(y[i])) < 40
  return { x: x.filter(there), y: y.filter(there) }
}

/**
 * Seen from the truth, as in the Bench: the ellipse would be too small on a track of two hundred metres.
 * @param {Panel} panel @param {Frame} frame
 */
function drawPlane({ pen, width, height }, frame) {
  const { truth, rightEllipse, series } = frame
  const lives = alive(frame)
  const ellipse = lives ? frame.ellipse : null
  const from = (/** @type {number[]} */ x) => [0, 1].map((axis) => x[axis] - truth[axis])
  const [estimate, right] = [from(frame.estimate), from(frame.right)]
  const trail = [series.first, series.second].map((all) => (lives ? all.slice(-TRAIL).map((error) => -error) : []))
  const around = [
    ...(rightEllipse ? [{ at: right, ellipse: rightEllipse }] : []),
    ...(ellipse ? [{ at: estimate, ellipse }] : []),
  ]
  const reach = [0, 1].map((axis) => {
    const edges = around.flatMap(({ at, ellipse }) => [-1, 1].map((side) => at[axis] + side * halves(ellipse)[axis]))
    const all = [0, ...(lives ? [estimate[axis]] : []), ...edges, ...trail[axis]]
      .map(Math.abs)
      .filter((one) => one < FAR)
    const most = REACHES.find((one) => one >= Math.max(...all)) ?? FAR
    return /** @type {[number, number]} */ ([-most, most])
  })
  const plane = planeOf({ left: 48, top: 30, right: width - 14, bottom: height - 42 }, reach[0], reach[1])
  const at = (/** @type {number[]} */ p) => /** @type {[number, number]} */ ([plane.x(p[0]), plane.y(p[1])])
  const [x, y] = at([0, 0])
  pen.draw(() => {
    axes(pen, plane, { x: 'position − truth (m)', y: 'velocity − truth (m/s)', ticks: [5, 5], zero: true })
    pen.window('scene', plane.box, (to) => {
      to.mark('path', 'trail', { ...meaning('track', 'posterior'), d: seriesPath(plane, trail[0], trail[1]) })
      if (rightEllipse)
        to.mark('path', 'right', { ...meaning('curve dashed', 'truth'), d: ellipsePath(rightEllipse, right, plane) })
      if (ellipse)
        to.mark('path', 'ellipse', { ...meaning('outline', 'posterior'), d: ellipsePath(ellipse, estimate, plane) })
      if (lives) dot(to, 'estimate', plane, estimate, { ...meaning('full', 'posterior'), r: 4 })
      to.mark('path', 'truth', { ...meaning('cross', 'truth'), d: `M${x - 7} ${y}H${x + 7}M${x} ${y - 7}V${y + 7}` })
    })
    drawLabels(
      pen,
      plane.box,
      [
        {
          key: 'estimate-name',
          words: lives ? 'estimate' : 'a right filter',
          at: at(lives ? estimate : right),
          kin: lives ? 'posterior' : 'truth',
          gap: 12,
          sides: ['right', 'left', 'below'],
        },
        { key: 'truth-name', words: 'truth', at: [x, y], kin: 'truth', gap: 12, sides: ['above', 'left', 'below'] },
      ],
      [clear(at(lives ? estimate : right), 7), clear([x, y], 9)],
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
export function describeRun(frame) {
  const { world, step, truth, estimate, ellipse, series } = frame
  if (!alive(frame)) {
    const last = series.step.at(-1) ?? 0
    return last > 0 ? `The program’s run ends after step ${last}.` : 'The run waits for a program without faults.'
  }
  const off = Math.hypot(truth[0] - estimate[0], truth[1] - estimate[1])
  const [where, unit] = world === 'linear' ? ['Position and velocity', ''] : ['The stadium from above', ' metres']
  const claimed = ellipse
    ? `its ellipse has a longer half axis of ${fixed(ellipse.semiMajor, 2)}`
    : 'its P has no ellipse'
  return `${where} after step ${step}: the estimate is off by ${fixed(off, 2)}${unit}, and ${claimed}.`
}
