/**
 * The map of the log-likelihood over q and W, with the noise that the reader has chosen, the likeliest and, when it is
 * unsealed, the true.
 */

import { contours } from 'd3-contour'
import { clear, drawLabels, widthOf } from '../../draw/labels.js'
import { dot, ellipsePath, axes, meaning, plane as planeOf, scaleLog, segment } from '../../draw/plot.js'
import { Outline } from '../../draw/path.js'
import { level } from './words.js'

/** @typedef {import('estimate-wasm').TuneFrame} Frame */
/** @typedef {import('./likelihood.js').Likelihood} Likelihood */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Box} Box */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** Edges of the colours: how far the log-likelihood lies below its maximum. */
const LEVELS = [1000, 300, 100, 30, 10]
/** The least room for a colour and its number, pixels. */
const LEVEL_WIDTH = 46
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

/**
 * The closed line is drawn with the likeliest noise, which it would give away.
 * @param {Pen} pen @param {Box} box @param {Likelihood | null} map @param {boolean} found
 */
function drawLikelihood(pen, box, map, found) {
  // Two rows are the least that has a contour.
  if (!map || map.rows < 2) return
  const { size, rows, values, top, limit } = map
  const contour = contours().size([size, rows])
  const path = (/** @type {number} */ below) => outline(contour.contour(values, top - below), box, size)
  pen.group(
    'colours',
    {},
    (to) => {
      for (const below of LEVELS) to.mark('path', `below${below}`, { class: 'likely', d: path(below) })
    },
    `${map.rows} ${top} ${JSON.stringify(box)}`,
  )
  if (found) pen.mark('path', 'contour', { class: 'likely contour', d: path(limit / 2) })
}

/**
 * Polygons in cells of the map as one path.
 * @param {{ coordinates: number[][][][] }} polygons
 * @param {Box} box
 * @param {number} size
 */
function outline({ coordinates }, { left, right, top, bottom }, size) {
  const out = new Outline()
  let d = ''
  for (const ring of coordinates.flat()) {
    out.data = ''
    for (const [i, [x, y]] of ring.entries()) {
      const at = /** @type {[number, number]} */ ([
        left + (x / size) * (right - left),
        bottom - (y / size) * (bottom - top),
      ])
      if (i === 0) out.move(...at)
      else out.line(...at)
    }
    d += `${out.data}Z`
  }
  return d
}

/** Which colour stands for what. @param {Pen} pen @param {Box} box @param {number} y */
function drawLegend(pen, box, y) {
  const said = 'below the maximum:'
  const wide = box.right - box.left - widthOf(said) > LEVEL_WIDTH * LEVELS.length
  // On a narrow map the words stand above.
  pen.text('legend', { class: 'tick', x: box.left, y: wide ? y : y - 17 }, said)
  const from = wide ? box.left + widthOf(said) : box.left
  const step = Math.min(54, (box.right - from) / LEVELS.length)
  for (const [i, below] of LEVELS.entries()) {
    const x = from + i * step
    // As many coats as the map has there.
    for (let coat = 0; coat <= i; coat += 1)
      pen.mark('rect', `swatch${below}-${coat}`, { class: 'likely', x, y: y - 10, width: 10, height: 12 })
    pen.text(`swatch-name${below}`, { class: 'tick', x: x + 13, y }, `${below}`)
  }
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
