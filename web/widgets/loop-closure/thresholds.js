/** The χ² axis with the gate and the threshold for founding, and where the last sightings fell on it. */

import { fixed } from '../../draw/numbers.js'
import { widthOf } from '../../draw/labels.js'
import { pixel } from '../../draw/path.js'
import { meaning, scaleLog } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */

/** Ends of the axis; a sighting beyond stands at the end. */
const ENDS = /** @type {[number, number]} */ ([0.01, 1000])
/** An arrow multiplies a threshold by this. */
const STEP = 1.05
/** How many of the last sightings are drawn. */
const LAST = 240

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawThresholds({ pen, width, height }, frame, view) {
  const { params, series, sightings } = frame
  const box = { left: 12, top: 26, right: width - 12, bottom: height - 46 }
  const x = scaleLog(ENDS, [box.left, box.right])
  const place = (/** @type {number} */ chi2) => x(Math.max(ENDS[0], Math.min(ENDS[1], chi2)))
  // The thresholds in effect: the gate ends where founding begins.
  const [gate, found] = [place(Math.min(params.gate, params.found)), place(params.found)]
  pen.draw(() => {
    pen.text('title', { class: 'plot-title', x: box.left, y: 17 }, '*χ*^{2} of each sighting')
    pen.mark('rect', 'matched', {
      ...meaning('area', 'posterior'),
      x: box.left,
      y: box.top,
      width: gate - box.left,
      height: box.bottom - box.top,
    })
    pen.mark('rect', 'founded', {
      ...meaning('area', 'measurement'),
      x: found,
      y: box.top,
      width: box.right - found,
      height: box.bottom - box.top,
    })
    pen.mark('line', 'axis', { class: 'axis', x1: box.left, x2: box.right, y1: box.bottom, y2: box.bottom })
    for (const tick of [0.01, 0.1, 1, 10, 100, 1000]) {
      pen.mark('line', `notch${tick}`, { class: 'axis', x1: x(tick), x2: x(tick), y1: box.bottom, y2: box.bottom + 4 })
      pen.text(
        `tick${tick}`,
        {
          class: 'tick',
          x: x(tick),
          y: height - 4,
          'text-anchor': tick === ENDS[0] ? 'start' : tick === ENDS[1] ? 'end' : 'middle',
        },
        String(tick),
      )
    }
    const rows = (box.bottom - box.top - 24) / 12
    let d = ''
    for (const [i, chi2] of series.chi2.slice(-LAST).entries()) {
      if (Number.isFinite(chi2)) d += `M${pixel(place(chi2))} ${pixel(box.top + 8 + (i % 12) * rows)}h0`
    }
    pen.mark('path', 'past', { ...meaning('points', 'measurement'), d })
    for (const [i, { chi2 }] of sightings.entries()) {
      if (chi2 !== null)
        pen.mark('circle', `now${i}`, {
          ...meaning('full', 'measurement'),
          cx: place(chi2),
          cy: box.bottom - 8,
          r: 4.5,
        })
    }
    drawNames(pen, box, gate, found)
    pen.group('handles', {}, (to) => {
      for (const name of /** @type {const} */ (['gate', 'found']))
        view.handle(to, name, handleOf(name, frame, view, x, box))
    })
  })
}

/**
 * What becomes of a sighting in each part of the axis, where the part has room for the word.
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {import('../../draw/plot.js').Box} box
 * @param {number} gate
 * @param {number} found
 */
function drawNames(pen, { left, right, top, bottom }, gate, found) {
  const y = top + (bottom - top) / 2 + 4
  const parts = /** @type {[string, number, number, string][]} */ ([
    ['matched', left, gate, 'matched'],
    ['refused', gate, found, 'not used'],
    ['founded', found, right, right - found > widthOf('new landmark') + 8 ? 'new landmark' : 'new'],
  ])
  for (const [key, from, to, words] of parts) {
    if (to - from > widthOf(words) + 8)
      pen.text(`${key}-name`, { class: 'label', x: (from + to) / 2, y, 'text-anchor': 'middle' }, words)
  }
}

/**
 * @param {'gate' | 'found'} name @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @param {import('../../draw/scale.js').Scale} x @param {import('../../draw/plot.js').Box} box
 * @returns {import('../../figure/spec.js').HandleSpec}
 */
function handleOf(name, { params }, { limits }, x, box) {
  const { least, greatest } = limits[name]
  const to = (/** @type {number} */ chi2) => ({ [name]: Number(Math.max(least, Math.min(greatest, chi2)).toFixed(2)) })
  return {
    at: [x(params[name]), name === 'gate' ? box.bottom : box.top],
    small: true,
    label: name === 'gate' ? 'Gate' : 'Threshold for founding',
    value: fixed(params[name], 2),
    now: params[name],
    min: least,
    max: greatest,
    move: (px) => to(x.invert(px)),
    nudge: (dx, dy) => to(params[name] * STEP ** (dx || dy)),
    jump: (end) => to(end === 'home' ? least : greatest),
  }
}
