/**
 * The map of the log-likelihood over q and W, with the noise that the reader has chosen, the likeliest and, when it is
 * unsealed, the true.
 */

import { clear, drawLabels } from '../../draw/labels.js'
import { drawLegend, drawLikelihood } from '../../draw/likelihood.js'
import { dot, ellipsePath, axes, meaning, plane as planeOf, scaleLog, segment } from '../../draw/plot.js'
import { level } from './words.js'

/** @typedef {import('estimate-wasm').TuneFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** An arrow moves the noise by so many decimal logarithms. */
const STEP = 0.02

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawMap({ pen, width, height }, frame, view) {
  const box = { left: 44, top: 26, right: width - 12, bottom: height - 62 }
  const { logQ, logW } = view.limits
  const logs = planeOf(box, [logQ.least, logQ.greatest], [logW.least, logW.greatest])
  const levels = {
    box,
    x: scaleLog([10 ** logQ.least, 10 ** logQ.greatest], [box.left, box.right]),
    y: scaleLog([10 ** logW.least, 10 ** logW.greatest], [box.bottom, box.top]),
  }
  pen.draw(() => {
    pen.window('likelihood', box, (to) => drawLikelihood(to, box, view.aside, frame.fit !== null))
    axes(pen, levels, { title: 'log-likelihood; {W}, m²', x: '*q*', ticks: [5, 5], grid: false })
    drawLegend(pen, box, height - 12)
    pen.window('marks', box, (to) => drawMarks(to, logs, frame))
    drawNames(pen, logs, frame)
    pen.group('handles', {}, (to) => view.handle(to, 'noise', handleOf(frame, view, logs)))
  })
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawMarks(pen, plane, { fit, verdict }) {
  if (fit) {
    const at = [fit.logQ, fit.logW]
    if (fit.region) {
      const { semiMajor, angle } = fit.region
      const [dx, dy] = [semiMajor * Math.cos(angle), semiMajor * Math.sin(angle)]
      pen.mark('path', 'region', { ...meaning('way dashed', 'posterior'), d: ellipsePath(fit.region, at, plane) })
      segment(pen, 'least', plane, [at[0] - dx, at[1] - dy], [at[0] + dx, at[1] + dy], meaning('way', 'posterior'))
    }
    dot(pen, 'fit', plane, at, { ...meaning('full', 'posterior'), r: 4.5 })
  }
  if (verdict) {
    const [x, y] = [plane.x(verdict.logQ), plane.y(verdict.logW)]
    pen.mark('path', 'truth', { ...meaning('cross', 'truth'), d: `M${x - 6} ${y - 6}l12 12m0-12l-12 12` })
  }
}

/** @param {Pen} pen @param {Plane} plane @param {Frame} frame */
function drawNames(pen, { x, y, box }, { params, fit, verdict }) {
  const at = (/** @type {{ logQ: number, logW: number }} */ { logQ, logW }) =>
    /** @type {[number, number]} */ ([x(logQ), y(logW)])
  /** @type {import('../../draw/labels.js').Label[]} */
  const names = [{ key: 'chosen-name', words: 'yours', at: at(params), gap: 15 }]
  if (verdict) names.push({ key: 'truth-name', words: 'truth', at: at(verdict), kin: 'truth', gap: 11 })
  if (fit) names.push({ key: 'fit-name', words: 'likeliest', at: at(fit), kin: 'posterior', gap: 10 })
  drawLabels(pen, box, names, [
    clear(at(params), 11),
    ...(fit ? [clear(at(fit), 5)] : []),
    ...(verdict ? [clear(at(verdict), 7)] : []),
  ])
}

/**
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @param {Plane} plane
 * @returns {import('../../figure/spec.js').HandleSpec}
 */
function handleOf({ params }, { limits: { logQ, logW } }, { x, y }) {
  const snap = (/** @type {number} */ value, /** @type {import('estimate-wasm').Parameter} */ { least, greatest }) =>
    Math.round(Math.max(least, Math.min(greatest, value)) / STEP) * STEP
  const to = (/** @type {number} */ q, /** @type {number} */ w) => ({
    logQ: Number(snap(q, logQ).toFixed(2)),
    logW: Number(snap(w, logW).toFixed(2)),
  })
  return {
    at: [x(params.logQ), y(params.logW)],
    label: 'The filter’s noise',
    value: `q ${level(params.logQ)}, sensor noise ${level(params.logW)} square metres`,
    now: params.logQ,
    min: logQ.least,
    max: logQ.greatest,
    move: (px, py) => to(x.invert(px), y.invert(py)),
    nudge: (dx, dy) => to(params.logQ + dx * STEP, params.logW + dy * STEP),
    jump: (end) => to(end === 'home' ? logQ.least : logQ.greatest, params.logW),
  }
}
