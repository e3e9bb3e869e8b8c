/** Errors, NEES, NIS, innovations and the covariance over the steps of the run. */

import { axes, meaning, plane as planeOf, scaleLog, seriesPath } from '../../draw/plot.js'
import { rounded } from '../../draw/scale.js'
import { band } from '../../draw/statistics.js'
import { drawCrosses, drawPoints } from '../../draw/points.js'

/** @typedef {import('estimate-wasm').MuseumFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/** @typedef {import('../../draw/plot.js').Box} Box */
/** @typedef {import('../../draw/words.js').Words} Words */

/** What a log scale of χ² shows. @type {[number, number]} */
const CHI2 = [0.01, 1e4]
const DEGREES = 180 / Math.PI

/**
 * Strips one below the other, over the steps that the frame has.
 * @param {Panel} panel
 * @param {Frame} frame
 * @param {{ title: Words, up: [number, number], log?: boolean, paint: (pen: Pen, plane: Plane) => void }[]} strips
 */
function draw({ pen, width, height }, { series }, strips) {
  const [first, last] = [series.step[0] ?? 0, Math.max(series.step[series.step.length - 1] ?? 0, 20)]
  const high = (height - 18) / strips.length
  pen.draw(() =>
    strips.forEach(({ title, up, log, paint }, i) =>
      pen.group(`strip${i}`, {}, (to) => {
        const box = { left: 46, top: i * high + 26, right: width - 30, bottom: (i + 1) * high - 4 }
        const flat = planeOf(box, [first, last], up)
        const plane = log ? { ...flat, y: scaleLog(up, [box.bottom, box.top]) } : flat
        axes(to, i === strips.length - 1 ? plane : { ...plane, x: bare(plane.x) }, { title, ticks: [5, 3], zero: !log })
        if (i === strips.length - 1)
          to.text('unit', { class: 'axis-name', x: width - 2, y: box.bottom + 15, 'text-anchor': 'end' }, '*k*')
        paint(to, plane)
      }),
    ),
  )
}

/**
 * The same scale without ticks: those of the last strip serve all.
 * @param {import('../../draw/plot.js').Scale} x
 * @returns {import('../../draw/plot.js').Scale}
 */
const bare = (x) => Object.assign((/** @type {number} */ value) => x(value), x, { ticks: () => [] })

/** @param {number[]} values @param {number} least @returns {[number, number]} */
function even(values, least) {
  const most = values.reduce((sum, value) => (Number.isFinite(value) ? Math.max(sum, Math.abs(value)) : sum), least)
  return rounded(-most, most, 3)
}

/** The three errors against ±2 σ. @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, frame) {
  const { series } = frame
  const strip = (
    /** @type {Words} */ title,
    /** @type {number[]} */ error,
    /** @type {number[]} */ bound,
    factor = 1,
    least = 0.3,
  ) => {
    const [errors, bounds] = [error, bound].map((values) => values.map((value) => factor * value))
    // A bound that has grown without end would flatten the error.
    const most = even(errors, least)[1] * 2
    return {
      title,
      up: even([...errors, ...bounds.map((value) => Math.min(value, most))], least),
      paint: (/** @type {Pen} */ pen, /** @type {Plane} */ plane) =>
        pen.window('curves', plane.box, (to) => {
          for (const side of [-1, 1])
            to.mark('path', `bound${side}`, {
              ...meaning('curve thin', 'posterior'),
              d: seriesPath(
                plane,
                series.step,
                bounds.map((value) => side * value),
              ),
            })
          to.mark('path', 'error', { ...meaning('curve', 'truth'), d: seriesPath(plane, series.step, errors) })
        }),
    }
  }
  draw(panel, frame, [
    strip('error in *x* and claimed ±2 *σ* (m)', series.x, series.twoSigmaX),
    strip('in *y* (m)', series.y, series.twoSigmaY),
    strip('of the heading (degrees)', series.theta, series.twoSigmaTheta, DEGREES, 5),
  ])
}

/** @param {Plane} plane @param {number[]} values */
const held = ({ y }, values) => values.map((value) => Math.max(y.domain[0], Math.min(y.domain[1], value)))

/** NEES on a log scale with the band of single values. @param {Panel} panel @param {Frame} frame */
export function drawNees(panel, frame) {
  const {
    series,
    neesBand: [low, high],
  } = frame
  draw(panel, frame, [
    {
      title: 'NEES, and where 95 % should lie',
      up: CHI2,
      log: true,
      paint: (pen, plane) => {
        band(pen, plane, low, high)
        pen.mark('path', 'nees', {
          ...meaning('curve thin', 'posterior'),
          d: seriesPath(plane, series.step, held(plane, series.nees)),
        })
      },
    },
  ])
}

/** NIS of each reading on a log scale, with the gate. @param {Panel} panel @param {Frame} frame */
export function drawNis(panel, frame) {
  const { step, nis, used } = frame.readings
  draw(panel, frame, [
    {
      title: 'NIS of each reading, and the gate',
      up: CHI2,
      log: true,
      paint: (pen, plane) => {
        const at = plane.y(frame.gate)
        pen.mark('line', 'gate', {
          ...meaning('rule', 'measurement'),
          x1: plane.box.left,
          x2: plane.box.right,
          y1: at,
          y2: at,
        })
        points(pen, plane, step, held(plane, nis), used)
      },
    },
  ])
}

/** Normalized innovations of range and bearing. @param {Panel} panel @param {Frame} frame */
export function drawInnovations(panel, frame) {
  const { step, range, bearing, used } = frame.readings
  const strip = (/** @type {Words} */ title, /** @type {number[]} */ values) => ({
    title,
    up: /** @type {[number, number]} */ ([-5, 5]),
    paint: (/** @type {Pen} */ pen, /** @type {Plane} */ plane) => {
      band(pen, plane, -2, 2)
      points(pen, plane, step, held(plane, values), used)
    },
  })
  draw(panel, frame, [strip('{innov}/√*S* of the range; × refused', range), strip('of the bearing', bearing)])
}

/** The smallest eigenvalue, and the asymmetry on a log scale. @param {Panel} panel @param {Frame} frame */
export function drawCovariance(panel, frame) {
  const { step, least, asymmetry } = frame.series
  draw(panel, frame, [
    {
      title: 'smallest eigenvalue of {P}, scaled',
      up: [-1, 0.5],
      paint: (pen, plane) => {
        band(pen, plane, frame.figures[12].band[0], 1)
        pen.mark('path', 'least', { ...meaning('curve', 'posterior'), d: seriesPath(plane, step, held(plane, least)) })
      },
    },
    {
      title: 'asymmetry of {P}',
      up: [1e-18, 1],
      log: true,
      paint: (pen, plane) => {
        pen.mark('path', 'asymmetry', { ...meaning('curve', 'posterior'), d: seriesPath(plane, step, asymmetry) })
        if (asymmetry.every((value) => value === 0))
          pen.text(
            'none',
            {
              class: 'label',
              x: (plane.box.left + plane.box.right) / 2,
              y: (plane.box.top + plane.box.bottom) / 2 + 4,
              'text-anchor': 'middle',
            },
            'none, to the last bit',
          )
      },
    },
  ])
}

/** @param {Pen} pen @param {Plane} plane @param {number[]} steps @param {number[]} values @param {number[]} used */
function points(pen, plane, steps, values, used) {
  drawPoints(pen, 'used', plane, steps, values, 'measurement', (i) => used[i] === 1)
  drawCrosses(pen, 'refused', plane, steps, values, (i) => used[i] === 0)
}
