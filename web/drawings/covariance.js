/**
 * A covariance of two errors as its ellipse: the standard deviations along the axes, the line of the regression of the
 * first error on the second, and the long axis, which is another line. It is the predicted covariance of the Picture's
 * lab as it starts.
 */

import { fixed } from '../draw/numbers.js'
import { axes, ellipseLevel, ellipsePath, evenPlane, halves, meaning, segment } from '../draw/plot.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */

/** How far the axes and the two lines go, in the units of the errors. */
const REACH = 2
const LINE = 1.85

/** What the drawing says in numbers. @param {Frame} frame */
function facts({ P, predicted: { ellipse } }) {
  const [position, velocity] = halves(ellipse)
  return { position, velocity, regression: P[0][1] / P[1][1], axis: Math.cos(ellipse.angle) / Math.sin(ellipse.angle) }
}

/** @param {Frame} frame */
function describe(frame) {
  const { position, velocity, regression, axis } = facts(frame)
  return (
    'The plane of a position error, across, and a velocity error, upward. ' +
    `A 1 sigma ellipse about zero reaches ${fixed(position, 2)} metres to either side ` +
    `and ${fixed(velocity, 2)} metres a second up and down, and leans to the right. ` +
    'The line of the regression passes through its highest and its lowest point: ' +
    `${fixed(regression, 2)} metres of position error for each metre a second of velocity error. ` +
    `The long axis is a flatter line: ${fixed(axis, 2)} metres for each metre a second.`
  )
}

/**
 * @param {import('../draw/pen.js').Pen} pen
 * @param {Frame} frame
 */
function draw(pen, frame) {
  const box = { left: 44, top: 30, right: drawing.width - 12, bottom: drawing.height - 42 }
  const plane = evenPlane(box, [0, 0], REACH)
  const { position, velocity, regression, axis } = facts(frame)
  const { x, y } = plane
  pen.draw(() => {
    axes(pen, plane, { x: 'position error (m)', y: 'velocity error (m/s)', ticks: [5, 5], zero: true })
    ellipseLevel(pen, box.left, box.bottom + 32)
    pen.mark('path', 'ellipse', {
      ...meaning('outline', 'prediction'),
      d: ellipsePath(frame.predicted.ellipse, [0, 0], plane),
    })
    // From the ellipse to the axes: one standard deviation on each.
    segment(pen, 'position', plane, [position, -REACH], [position, frame.P[0][1] / position], meaning('way dashed'))
    segment(
      pen,
      'velocity',
      plane,
      [x.domain[0], velocity],
      [frame.P[0][1] / velocity, velocity],
      meaning('way dashed'),
    )
    const line = (/** @type {string} */ key, /** @type {number} */ slope, /** @type {string} */ shape) =>
      segment(pen, key, plane, [-slope * LINE, -LINE], [slope * LINE, LINE], meaning(shape))
    line('axis', axis, 'way dashed')
    line('regression', regression, 'line')
    const name = (
      /** @type {string} */ key,
      /** @type {number[]} */ at,
      /** @type {string} */ words,
      anchor = 'start',
    ) => pen.text(key, { class: 'mark-name', x: x(at[0]), y: y(at[1]), 'text-anchor': anchor }, words)
    name('position-name', [position + 0.06, -1.86], `*σ* = ${fixed(position, 2)} m`)
    name('velocity-name', [x.domain[0] + 0.08, velocity + 0.09], `*σ* = ${fixed(velocity, 2)} m/s`)
    name('axis-name', [axis * LINE + 0.08, LINE - 0.14], `long axis: ${fixed(axis, 2)} s`)
    name('regression-name', [regression * LINE - 0.1, LINE - 0.1], `regression: ${fixed(regression, 2)} s`, 'end')
  })
}

/** @type {import('./index.js').Drawing} */
export const drawing = { lab: 'Picture', name: 'picture', width: 480, height: 400, draw, describe }
