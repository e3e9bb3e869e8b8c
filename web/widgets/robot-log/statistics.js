/** What the readings are worth: their errors against the range, their distribution, and whether one tells the next. */

import { fixed } from '../../draw/numbers.js'
import { axes, meaning, plane as planeOf, seriesPath } from '../../draw/plot.js'
import { drawCrosses, drawPoints } from '../../draw/points.js'
import { rounded } from '../../draw/scale.js'
import { drawLags, empty } from '../../draw/statistics.js'
import { looksOf } from './looks.js'
import { expecting } from './words.js'

/** @typedef {import('./looks.js').Frame} Frame */
/** @typedef {{ xs: number[], ys: number[] }} Points */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** Errors of ranges reach from −this to this at least, metres; at most three times as far. */
const LEAST = 3
/** The room below the points for what the line says, pixels. */
const FOOT = 20

/** @param {Panel} panel @param {Frame} frame */
export function drawRanges(panel, frame) {
  const { range, residual } = frame.ranges
  const known = frame.truth ? 'true' : 'dead-reckoned'
  scatter(
    panel,
    `range read less ${known} (m)`,
    `${known} range (m)`,
    range,
    residual,
    frame.rangeLine,
    () => true,
    'no reading so far',
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawInner(panel, frame) {
  const { kept } = looksOf(frame)
  const { xs, ys, used } = rangesOf(frame)
  scatter(
    panel,
    'the filter’s innovation {innov} (m)',
    'expected range (m)',
    xs,
    ys,
    frame.innovationLine,
    (i) => used[i],
    expecting(frame, 'no slope if the model is right'),
    kept && rangesOf(kept),
  )
}

/** Expected ranges and their innovations: what a fix or a heading is off is no range. @param {Frame} frame */
function rangesOf({ innovations: { expected, innovation, used, sensor } }) {
  const mine = (/** @type {unknown} */ _, /** @type {number} */ i) => sensor[i] === 'range' || sensor[i] === 'bearing'
  return { xs: expected.filter(mine), ys: innovation.filter(mine), used: used.filter(mine) }
}

/**
 * @param {Panel} panel @param {string} title @param {string} across @param {number[]} xs @param {number[]} ys
 * @param {{ slope: number, offset: number, r2: number } | null} line @param {(i: number) => boolean} used
 * @param {string} none what it says without a point @param {Points | null} [kept] those of A
 */
function scatter({ pen, width, height }, title, across, xs, ys, line, used, none, kept) {
  const box = { left: 36, top: 26, right: width - 10, bottom: height - 38 }
  const most = Math.min(
    3 * LEAST,
    ys.reduce((sum, y) => Math.max(sum, Math.abs(y)), LEAST),
  )
  const plane = planeOf(
    { ...box, bottom: box.bottom - FOOT },
    [0, xs.reduce((sum, x) => Math.max(sum, x), 10) * 1.02],
    rounded(-most, most, 4),
  )
  pen.draw(() => {
    axes(pen, { ...plane, box }, { title, x: across, ticks: [5, 4], zero: true })
    if (xs.length === 0) return empty(pen, plane, none)
    if (kept)
      pen.group('kept', { class: 'pale' }, (to) => drawPoints(to, 'used', plane, kept.xs, kept.ys, 'prediction'))
    drawPoints(pen, 'used', plane, xs, ys, 'measurement', used)
    drawCrosses(pen, 'refused', plane, xs, ys, (i) => !used(i))
    if (!line) return
    const [from, to] = plane.x.domain
    pen.window('fit', plane.box, (into) => {
      into.mark('path', 'line', {
        ...meaning('curve fit'),
        d: seriesPath(
          plane,
          [from, to],
          [from, to].map((x) => line.offset + line.slope * x),
        ),
      })
    })
    pen.text(
      'slope',
      { class: 'label', x: box.right - 4, y: box.bottom - 6, 'text-anchor': 'end' },
      `slope ${fixed(line.slope, 3)}, *R*^{2} = ${fixed(line.r2, 2)}`,
    )
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawHistogram({ pen, width, height }, { histogram }) {
  const { from, width: bin, density, normal } = histogram
  const to = from + bin * density.length
  const box = { left: 36, top: 26, right: width - 10, bottom: height - 38 }
  const plane = planeOf(box, [from, to], [0, Math.max(0.45, ...density) * 1.05])
  pen.draw(() => {
    axes(pen, plane, { title: 'density of {innov}/√*S* beside N(0, 1)', x: '*σ*', ticks: [5, 4] })
    const floor = box.bottom
    const tenths = (/** @type {number} */ value) => Math.round(value * 10) / 10
    let d = ''
    for (const [i, value] of density.entries()) {
      if (value > 0)
        d +=
          `M${plane.x(from + i * bin)} ${floor}V${tenths(plane.y(value))}` +
          `H${tenths(plane.x(from + (i + 1) * bin))}V${floor}Z`
    }
    pen.mark('path', 'bars', { ...meaning('area bars', 'measurement'), d })
    pen.mark('path', 'normal', {
      ...meaning('curve fit'),
      d: seriesPath(
        plane,
        normal.map((_, i) => from + (i * bin) / 2),
        normal,
      ),
    })
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawCorrelation(panel, frame) {
  drawLags(
    panel,
    { ...frame.correlation, kept: looksOf(frame).kept?.correlation.values },
    {
      title: 'autocorrelation of {innov}/√*S* and its 95 % band',
      lag: 'lag, used readings',
      none: expecting(frame, 'within its band if the model is right'),
    },
    12,
  )
}
