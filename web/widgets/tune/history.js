/** Innovations, NIS and NEES over the readings of the log. */

import { polyline } from '../../draw/path.js'
import { axes, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'
import { drawPoints } from '../../draw/points.js'
import { rounded } from '../../draw/scale.js'
import { band, drawLags, empty, rule } from '../../draw/statistics.js'
import { last } from './words.js'

/** @typedef {import('estimate-wasm').TuneFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */
/** @typedef {import('../../draw/pen.js').Pen} Pen */
/** @typedef {import('../../draw/plot.js').Plane} Plane */

/** Right of each plot, pixels: the unit stands there. */
const MARGIN = 26

const counted = (/** @type {number[]} */ values) => values.map((_, i) => i + 1)

/** @param {Panel} panel @param {Frame} frame */
export function drawInnovations(panel, { innovations, twoSigma }) {
  const most = Math.max(...innovations.map(Math.abs), Math.min(...twoSigma) * 1.2)
  draw(panel, innovations.length, [-most, most], 'innovations {innov} (m) and ±2√*S*', (pen, plane) => {
    between(
      pen,
      plane,
      counted(twoSigma),
      twoSigma.map((value) => -value),
      twoSigma,
    )
    drawPoints(pen, 'innovations', plane, counted(innovations), innovations, 'measurement')
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawCorrelation(panel, { autocorrelation: values, autocorrelationBand }) {
  drawLags(
    panel,
    { values, band: autocorrelationBand },
    { title: 'autocorrelation of {innov}/√*S* and its 95 % band', lag: 'lag, readings', none: '' },
    MARGIN,
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawNis(panel, frame) {
  const { nis, meanNis, meanNisBand } = frame
  draw(panel, nis.length, [0, Math.max(4, 2 * last(frame).mean)], 'NIS, its mean so far and band', (pen, plane) => {
    between(
      pen,
      plane,
      meanNisBand.map(({ readings }) => readings),
      meanNisBand.map(({ low }) => low),
      meanNisBand.map(({ high }) => high),
    )
    rule(pen, plane, 'one', 1)
    drawPoints(pen, 'nis', plane, counted(nis), nis, 'measurement')
    pen.window('mean', plane.box, (to) =>
      to.mark('path', 'mean', { ...meaning('curve', 'measurement'), d: seriesPath(plane, counted(meanNis), meanNis) }),
    )
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawNees(panel, { innovations, verdict }) {
  const most = verdict ? Math.max(10, 2.5 * verdict.meanNees) : 10
  draw(panel, innovations.length, [0, most], 'NEES and its 95 % band', (pen, plane) => {
    if (!verdict) return empty(pen, plane, 'sealed until you commit')
    const [low, high] = verdict.neesBand
    band(pen, plane, low, high)
    rule(pen, plane, 'two', 2)
    drawPoints(pen, 'nees', plane, counted(verdict.nees), verdict.nees, 'truth')
  })
}

/**
 * @param {Panel} panel
 * @param {number} readings
 * @param {[number, number]} up
 * @param {string} title
 * @param {(pen: Pen, plane: Plane) => void} paint
 */
function draw({ pen, width, height }, readings, [low, high], title, paint) {
  const box = { left: 40, top: 26, right: width - MARGIN, bottom: height - 24 }
  const plane = planeOf(box, [0, readings], rounded(low, high + (high - low) * 0.02, 4))
  pen.draw(() => {
    axes(pen, plane, { title, ticks: [5, 4], zero: low < 0 })
    pen.text('unit', { class: 'axis-name', x: width - 2, y: box.bottom + 15, 'text-anchor': 'end' }, '*k*')
    paint(pen, plane)
  })
}

/**
 * The room between two curves.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {number[]} xs
 * @param {number[]} lows
 * @param {number[]} highs
 */
function between(pen, { x, y, box }, xs, lows, highs) {
  const across = [...xs, ...[...xs].reverse()]
  const up = [...highs, ...[...lows].reverse()]
  pen.window('between', box, (to) =>
    to.mark('path', 'band', { class: 'band', d: `${polyline(up.length, x, across, y, up)}Z` }),
  )
}
