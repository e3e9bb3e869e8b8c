/**
 * The rail with the cart and its copy, and above them the speedometer of each. In the copy's, the needle of the reading
 * stands beside the one that was expected: the gap between them is the innovation.
 */

import { fixed } from '../../draw/numbers.js'
import { cart, rail } from '../../draw/cart.js'
import { clear, drawLabels } from '../../draw/labels.js'
import { meaning, scaleLinear } from '../../draw/plot.js'
import { mix } from '../../figure/motion.js'
import { drawDial, faceOf, speedAt, tip } from './dial.js'

/** @typedef {import('estimate-wasm').CartCopyFrame} Frame */
/** @typedef {import('../../draw/pen.js').Pen} Pen */

/** The rail reaches so far, metres. The cart goes from 0 to 4. */
const RAIL = /** @type {[number, number]} */ ([-2, 6])

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawRail({ pen, width, height }, frame, view) {
  const small = width < 420
  const ground = height - 44
  const x = scaleLinear(RAIL, [16, width - 16])
  const at = stage(frame, view)
  const face = faceOf(width, height)
  pen.draw(() => {
    drawDial(pen, 'cart-dial', { ...face, x: width * 0.25 }, 'the cart reads', [['reading', 'measurement', at.reading]])
    drawDial(
      pen,
      'copy-dial',
      { ...face, x: width * 0.75 },
      'its copy',
      [
        ['read-again', 'measurement', at.reading],
        ['expected', 'prediction', at.expected],
        ...(at.copy[1] === at.expected ? [] : [/** @type {const} */ (['after', 'posterior', at.copy[1]])]),
      ],
      at.compared ? [at.expected, at.reading] : null,
    )
    rail(pen, x, ground)
    const size = { wide: small ? 40 : 52, high: small ? 17 : 22 }
    cart(pen, 'truth', held(x, at.truth[0]), ground, size, { class: 'robot' })
    if (Math.abs(x(at.copy[0]) - x(at.predicted)) > 1)
      cart(pen, 'predicted', held(x, at.predicted), ground, size, meaning('outline', 'prediction'))
    cart(pen, 'copy', held(x, at.copy[0]), ground, size, meaning('outline', at.corrected ? 'posterior' : 'prediction'))
    names(pen, x, ground, at, size, width)
    // On a phone the sentence alone says it.
    if (!small) between(pen, held(x, at.copy[0]), held(x, at.truth[0]), ground - 72, at.copy[0] - at.truth[0])
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(handles(x, ground, { ...face, x: width * 0.75 }, frame, view)))
        view.handle(to, key, grip)
    })
  })
}

/** The copy may be farther away than the rail goes. @param {import('../../draw/plot.js').Scale} x @param {number} at */
const held = (x, at) => Math.max(x(RAIL[0]), Math.min(x(RAIL[1]), x(at)))

/**
 * What the panel shows at this moment of the step: drive, compare, nudge.
 * @param {Frame} frame @param {import('../../figure/spec.js').View} view
 */
function stage(frame, { beat, previous }) {
  const { truth, predicted, copy, reading, expected, step } = frame
  const halfway = (/** @type {number[]} */ from, /** @type {number[]} */ to) =>
    from.map((value, i) => mix(value, to[i], beat.t))
  const driving = beat.name === 'predict' && previous
  const now = driving ? halfway(previous.truth, truth) : truth
  const drives = driving ? halfway(previous.copy, predicted) : predicted
  return {
    truth: now,
    reading: driving ? now[1] : reading,
    expected: driving ? drives[1] : expected,
    predicted: driving ? drives[0] : predicted[0],
    copy: driving ? drives : beat.name === 'update' ? halfway(predicted, copy) : copy,
    compared: !driving,
    corrected: !driving && step > 0,
  }
}

/**
 * The metres between the cart and its copy.
 * @param {Pen} pen @param {number} copy @param {number} cart_ @param {number} y @param {number} metres
 */
function between(pen, copy, cart_, y, metres) {
  if (Math.abs(metres) < 0.005) return
  const ends = [copy, cart_].map((x) => `M${x.toFixed(1)} ${y - 5}v10`).join('')
  pen.mark('path', 'between', { ...meaning('way', 'truth'), d: `${ends}M${copy.toFixed(1)} ${y}H${cart_.toFixed(1)}` })
  const middle = { class: 'mark-name truth', x: (copy + cart_) / 2, y: y - 9, 'text-anchor': 'middle' }
  pen.text('metres', middle, `${fixed(Math.abs(metres))} m`)
}

/**
 * @param {Pen} pen @param {import('../../draw/plot.js').Scale} x @param {number} ground
 * @param {ReturnType<typeof stage>} at @param {{ wide: number, high: number }} size @param {number} width
 */
function names(pen, x, ground, at, size, width) {
  const top = ground - 10 - size.high
  const [cart_, copy] = [held(x, at.truth[0]), held(x, at.copy[0])]
  const off = at.copy[0] < RAIL[0] || at.copy[0] > RAIL[1]
  const right = copy > cart_ || (copy === cart_ && cart_ < width / 2)
  drawLabels(
    pen,
    { left: 2, right: width - 2, top: top - 22, bottom: ground - 6 },
    [
      {
        key: 'cart-name',
        words: 'cart',
        at: [cart_, top - 9],
        gap: 2,
        kin: 'truth',
        sides: right ? ['left'] : ['right'],
      },
      {
        key: 'copy-name',
        words: off ? 'copy, beyond the rail' : 'copy',
        at: [copy, top - 9],
        gap: 2,
        kin: at.corrected ? 'posterior' : 'prediction',
        sides: right ? ['right'] : ['left'],
      },
    ],
    [clear([copy, ground - 10 - size.high / 2], 11)],
  )
}

/**
 * The copy on the rail and the needle of its speed. A copy that is put somewhere starts the run anew, with the cart
 * where it is.
 * @param {import('../../draw/plot.js').Scale} x
 * @param {number} ground
 * @param {import('./dial.js').Face} face
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {Record<string, import('../../figure/spec.js').HandleSpec>}
 */
function handles(x, ground, face, { params, step, error, truth, copy }, { limits }) {
  const within = (/** @type {'position' | 'speed'} */ name, /** @type {number} */ value) =>
    Math.max(limits[name].least, Math.min(limits[name].greatest, value))
  /** @param {{ position?: number, speed?: number }} put */
  const anew = ({ position = error[0], speed = error[1] }) => ({
    position: within('position', position),
    speed: within('speed', speed),
    phase: (params.phase + step) % (limits.phase.greatest + 1),
    step: 0,
  })
  const ends = (/** @type {'position' | 'speed'} */ name, /** @type {'home' | 'end'} */ end) =>
    anew({ [name]: end === 'home' ? limits[name].least : limits[name].greatest })
  return {
    position: {
      at: [held(x, copy[0]), ground - 21],
      small: true,
      label: 'Position of the copy, from the cart',
      kin: 'posterior',
      value: `${error[0].toFixed(2)} metres`,
      now: error[0],
      min: limits.position.least,
      max: limits.position.greatest,
      move: (px) => anew({ position: x.invert(px) - truth[0] }),
      nudge: (dx, dy) => anew({ position: error[0] + 0.05 * (dx || dy) }),
      jump: (end) => ends('position', end),
    },
    speed: {
      at: tip(face, copy[1]),
      small: true,
      label: 'Speed of the copy, from the cart’s',
      kin: 'posterior',
      value: `${error[1].toFixed(2)} metres a second`,
      now: error[1],
      min: limits.speed.least,
      max: limits.speed.greatest,
      move: (px, py) => anew({ speed: speedAt(face, px, py) - truth[1] }),
      nudge: (dx, dy) => anew({ speed: error[1] + 0.05 * (dx || dy) }),
      jump: (end) => ends('speed', end),
    },
  }
}
