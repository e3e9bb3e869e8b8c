/**
 * The axis of the output: two opinions about it, that of the prediction and that of the reading, and their product.
 * Below the axis two weights stand on a beam, each 1/variance heavy: y* is where it balances. Means and widths are
 * handles.
 */

import { BEAM, balance, bell } from '../../draw/bells.js'
import { clear, drawLabels, widthOf } from '../../draw/labels.js'
import { axes, meaning, plane as planeOf } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */
/** @typedef {import('../../draw/bells.js').Bell} Bell */

/** The middle of the axis, and how far it reaches: the first that is far enough. */
const CENTRE = 3.7
const REACHES = [4.5, 6, 9, 13, 20, 40, 110]
/** The least width that is drawn, a part of the axis' reach: a narrower bell is a stroke. */
const LEAST = 0.012

const TITLE = 'two opinions about the output {y}'
const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
  Math.max(low, Math.min(high, value))

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawAxis({ pen, width, height }, frame, view) {
  // Sealed, the product and the point of balance are not drawn: either tells the answer.
  const bells = bellsOf(frame).slice(0, frame.params.sealed ? 2 : 3)
  const far = Math.max(...bells.slice(0, 2).map(({ mean, sigma }) => Math.abs(mean - CENTRE) + 2 * sigma))
  if (!pen.held) view.memory.output = REACHES.find((reach) => reach >= far) ?? far
  const reach = view.memory.output
  const box = { left: 14, top: 30, right: width - 14, bottom: height - BEAM - 22 }
  const plane = planeOf(box, [CENTRE - reach, CENTRE + reach], [0, 1.12])
  const narrow = LEAST * reach
  // The narrowest bell is the highest, as for densities; below a width that the eye can tell, height says nothing more.
  const least = Math.max(narrow, Math.min(...bells.map(({ sigma }) => sigma)))
  const top = (/** @type {number} */ sigma) => least / Math.max(least, sigma)
  pen.draw(() => {
    axes(pen, plane, { title: TITLE, ticks: [5, 0] })
    pen.window('bells', { ...box, bottom: box.bottom + 1 }, (to) => {
      for (const { key, kin, mean, sigma } of bells)
        to.mark('path', key, {
          ...meaning(kin === 'prediction' ? 'outline' : 'curve', kin),
          d: bell(plane, mean, Math.max(sigma, narrow / 3), top(sigma)),
        })
    })
    balance(pen, plane, frame.params.sealed ? null : frame.mostLikelyOutput, bells)
    const { x, y } = plane
    const at = (/** @type {Bell} */ { mean, sigma }) => /** @type {[number, number]} */ ([x(mean), y(top(sigma))])
    const grips = handles(plane, frame, view, bells, top)
    const title = { left: 0, right: box.left + widthOf(TITLE), top: 0, bottom: box.top - 6 }
    drawLabels(
      pen,
      { ...box, top: 14 },
      bells.map((one) => ({
        key: `${one.key}-name`,
        words: one.words,
        at: at(one),
        kin: one.kin,
        gap: one.key === 'product' ? 6 : 14,
        sides: one.mean < frame.mostLikelyOutput ? ['left', 'above-left'] : ['right', 'above-right'],
      })),
      [title, ...Object.values(grips).map(({ at }) => clear(at, 9))],
    )
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(grips)) view.handle(to, key, grip)
    })
  })
}

/** @param {Frame} frame @returns {Bell[]} */
function bellsOf({
  expectedOutput,
  expectedVariance,
  mostLikelyOutput,
  mostLikelyVariance,
  params: { reading, noise },
}) {
  return [
    { key: 'expected', kin: 'prediction', mean: expectedOutput, sigma: Math.sqrt(expectedVariance), words: 'expected' },
    { key: 'read', kin: 'measurement', mean: reading, sigma: Math.sqrt(noise), words: 'reading' },
    {
      key: 'product',
      kin: 'posterior',
      mean: mostLikelyOutput,
      sigma: Math.sqrt(mostLikelyVariance),
      words: 'product',
    },
  ]
}

/**
 * @param {import('../../draw/plot.js').Plane} plane
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @param {Bell[]} bells
 * @param {(sigma: number) => number} top
 * @returns {Record<string, import('../../figure/spec.js').HandleSpec>}
 */
function handles({ x, y, box }, { params, H, expectedOutput }, { limits }, [expected, read], top) {
  const { mean, semiMajor, semiMinor, reading } = params
  const words = (/** @type {number} */ value) => value.toFixed(2)
  const inside = (/** @type {number} */ px, /** @type {number} */ py) =>
    /** @type {[number, number]} */ ([clamp(px, box.left, box.right), py])
  const { least, greatest } = limits.reading
  const axis = limits.semiMajor
  // As far as the axis is in sight, and no farther than a reading can be.
  const [low, high] = [
    Math.max(x.invert(box.left), Math.min(least, expectedOutput)),
    Math.min(x.invert(box.right), Math.max(greatest, expectedOutput)),
  ]
  const output = (/** @type {number} */ px) => x.invert(clamp(px, box.left, box.right))
  /** The prediction moves along H until it expects this output. @param {number} wanted */
  const expect = (wanted) => ({
    mean: mean.map((value, i) => value + (clamp(wanted, low, high) - expectedOutput) * H[i]),
  })
  const read_ = (/** @type {number} */ wanted) => ({ reading: clamp(wanted, least, greatest) })
  /** Both axes of the ellipse grow by one factor until the expected output is spread so far. @param {number} sigma */
  const widen = (sigma) => {
    const factor = clamp(
      sigma / expected.sigma,
      axis.least / Math.min(semiMajor, semiMinor),
      axis.greatest / Math.max(semiMajor, semiMinor),
    )
    return {
      semiMajor: clamp(semiMajor * factor, axis.least, axis.greatest),
      semiMinor: clamp(semiMinor * factor, axis.least, axis.greatest),
    }
  }
  const blur = (/** @type {number} */ sigma) => ({ noise: Math.min(limits.noise.greatest, Math.max(0, sigma) ** 2) })
  // At one standard deviation a bell has 0.607 of its height.
  const flank = (/** @type {Bell} */ { sigma }) => y(0.607 * top(sigma))
  const away = read.mean < expected.mean ? 1 : -1
  return {
    'expected-mean': {
      at: inside(x(expected.mean), y(top(expected.sigma))),
      small: true,
      label: 'Expected output',
      kin: 'prediction',
      value: words(expected.mean),
      now: expected.mean,
      min: low,
      max: high,
      move: (px) => expect(output(px)),
      nudge: (dx, dy) => expect(expectedOutput + 0.05 * (dx || dy)),
      jump: (end) => expect(end === 'home' ? low : high),
    },
    'expected-width': {
      at: inside(x(expected.mean + away * expected.sigma), flank(expected)),
      small: true,
      label: 'Standard deviation of the expected output',
      kin: 'prediction',
      value: words(expected.sigma),
      now: expected.sigma,
      min: 0,
      max: axis.greatest,
      move: (px) => widen(away * (output(px) - expected.mean)),
      nudge: (dx, dy) => widen(expected.sigma + 0.05 * (dx || dy)),
      jump: (end) => widen(end === 'home' ? 0 : Infinity),
    },
    'read-mean': {
      at: inside(x(reading), y(top(read.sigma))),
      small: true,
      label: 'Output that is read',
      kin: 'measurement',
      value: words(reading),
      now: reading,
      min: least,
      max: greatest,
      move: (px) => read_(output(px)),
      nudge: (dx, dy) => read_(reading + 0.05 * (dx || dy)),
      jump: (end) => read_(end === 'home' ? least : greatest),
    },
    'read-width': {
      at: inside(x(reading - away * read.sigma), flank(read)),
      small: true,
      label: 'Standard deviation of the reading',
      kin: 'measurement',
      value: words(read.sigma),
      now: read.sigma,
      min: 0,
      max: Math.sqrt(limits.noise.greatest),
      move: (px) => blur(-away * (output(px) - reading)),
      nudge: (dx, dy) => blur(read.sigma + 0.05 * (dx || dy)),
      jump: (end) => blur(end === 'home' ? 0 : Infinity),
    },
  }
}
