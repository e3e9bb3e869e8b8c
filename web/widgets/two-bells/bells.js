/** The two bells, their product, and the beam below. The axis holds still; middles and flanks are handles. */

import { BEAM, balance, bell } from '../../draw/bells.js'
import { clear, drawLabels, widthOf } from '../../draw/labels.js'
import { axes, meaning, plane as planeOf } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').TwoBellsFrame} Frame */
/** @typedef {import('../../draw/bells.js').Bell} Bell */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/** @typedef {import('../../figure/spec.js').HandleSpec} HandleSpec */

const TITLE = 'opinions about the velocity (m/s)'
/** The velocities in sight, m/s. */
const AXIS = /** @type {[number, number]} */ ([-0.5, 7.5])
/** The ring of a handle while it is held, pixels. */
const HELD = 14
/** A bell's height at one standard deviation, a part of that in the middle. */
const FLANK = Math.exp(-0.5)

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawBells({ pen, width, height }, frame, view) {
  const all = bellsOf(frame)
  const plane = planeOf({ left: 14, top: 30, right: width - 14, bottom: height - BEAM - 22 }, AXIS, [0, 1.15])
  // The narrowest bell is the highest, as for densities.
  const least = Math.min(...all.map(({ sigma }) => sigma))
  const top = (/** @type {Bell} */ { sigma }) => least / sigma
  const grips = handles(plane, frame, view, all, top)
  pen.draw(() => {
    axes(pen, plane, { title: TITLE, ticks: [8, 0] })
    pen.window('bells', { ...plane.box, bottom: plane.box.bottom + 1 }, (to) => {
      for (const one of all)
        to.mark('path', one.key, {
          ...meaning(one.kin === 'prediction' ? 'outline' : 'curve', one.kin),
          d: bell(plane, one.mean, one.sigma, top(one)),
        })
    })
    balance(pen, plane, frame.likely, all)
    names(pen, plane, frame, all, top, grips)
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(grips)) view.handle(to, key, grip)
    })
  })
}

/** @param {Frame} frame @returns {Bell[]} */
function bellsOf({ likely, variance, params: { expected, expectedVariance, reading, noise } }) {
  return [
    { key: 'expected', kin: 'prediction', mean: expected, sigma: Math.sqrt(expectedVariance), words: 'prediction' },
    { key: 'read', kin: 'measurement', mean: reading, sigma: Math.sqrt(noise), words: 'reading' },
    { key: 'product', kin: 'posterior', mean: likely, sigma: Math.sqrt(variance), words: 'both' },
  ]
}

/**
 * @param {import('../../draw/pen.js').Pen} pen @param {Plane} plane @param {Frame} frame @param {Bell[]} all
 * @param {(bell: Bell) => number} top @param {Record<string, HandleSpec>} grips
 */
function names(pen, { x, y, box }, { likely }, all, top, grips) {
  drawLabels(
    pen,
    { ...box, top: 14 },
    all.map((one) => ({
      key: `${one.key}-name`,
      words: one.words,
      at: /** @type {[number, number]} */ ([x(one.mean), y(top(one))]),
      kin: one.kin,
      gap: one.key === 'product' ? 6 : HELD + 4,
      sides:
        one.mean < likely || (one.mean === likely && one.key === 'read')
          ? ['left', 'above-left']
          : ['right', 'above-right'],
    })),
    [
      { left: 0, right: box.left + widthOf(TITLE), top: 0, bottom: box.top - 6 },
      ...Object.values(grips).map(({ at }) => clear(at, HELD)),
    ],
  )
}

/**
 * @param {Plane} plane @param {Frame} frame @param {import('../../figure/spec.js').View} view
 * @param {Bell[]} all @param {(bell: Bell) => number} top
 * @returns {Record<string, HandleSpec>}
 */
function handles({ x, y }, { params }, { limits }, [expected, read], top) {
  const away = read.mean < expected.mean ? 1 : -1
  /** How far the axis reaches on a side of a bell, m/s. @param {Bell} bell @param {number} side */
  const room = ({ mean }, side) => (side > 0 ? AXIS[1] - mean : mean - AXIS[0])
  /**
   * The middle of a bell and its flank: that on this side, and the other where this one lies beyond the axis.
   * @param {Bell} bell @param {'expected' | 'reading'} mean @param {'expectedVariance' | 'noise'} variance
   * @param {string} label @param {number} wished
   * @returns {Record<string, HandleSpec>}
   */
  const pair = (bell, mean, variance, label, wished) => {
    const side = bell.sigma <= room(bell, wished) ? wished : -wished
    const put = (
      /** @type {'expected' | 'reading' | 'expectedVariance' | 'noise'} */ name,
      /** @type {number} */ value,
    ) => ({
      [name]: Math.max(limits[name].least, Math.min(limits[name].greatest, value)),
    })
    const spread = (/** @type {number} */ sigma) => put(variance, Math.max(0, sigma) ** 2)
    const end = (/** @type {string} */ name, /** @type {'home' | 'end'} */ which) =>
      which === 'home' ? limits[name].least : limits[name].greatest
    const kin = bell.kin
    return {
      [`${bell.key}-mean`]: {
        at: [x(bell.mean), y(top(bell))],
        small: true,
        label,
        kin,
        value: `${params[mean].toFixed(2)} metres a second`,
        now: params[mean],
        min: limits[mean].least,
        max: limits[mean].greatest,
        move: (px) => put(mean, x.invert(px)),
        nudge: (dx, dy) => put(mean, params[mean] + 0.05 * (dx || dy)),
        jump: (which) => put(mean, end(mean, which)),
      },
      [`${bell.key}-width`]: {
        at: [x(bell.mean + side * bell.sigma), y(FLANK * top(bell))],
        small: true,
        label: `${label}: standard deviation`,
        kin,
        value: bell.sigma.toFixed(2),
        now: bell.sigma,
        min: Math.sqrt(limits[variance].least),
        max: Math.sqrt(limits[variance].greatest),
        // Beyond the axis the flank would change sides under the hand.
        move: (px) => spread(Math.min(room(bell, side), side * (x.invert(px) - bell.mean))),
        nudge: (dx, dy) => spread(bell.sigma + 0.05 * (dx || dy)),
        jump: (which) => put(variance, end(variance, which)),
      },
    }
  }
  return {
    ...pair(expected, 'expected', 'expectedVariance', 'What the prediction expects', away),
    ...pair(read, 'reading', 'noise', 'What the sensor reads', -away),
  }
}
