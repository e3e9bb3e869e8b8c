/** Two rails with a cart on each, where they start. The second cart is a handle, and so is the arrow of its speed. */

import { FLOOR, cart, rail } from '../../draw/cart.js'
import { fixed } from '../../draw/numbers.js'
import { meaning, scaleLinear } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').TwoCartsFrame} Frame */

/** The rails in sight, metres. */
const RAIL = /** @type {[number, number]} */ ([-3, 3])
/** A speed of 1 m/s is an arrow so many metres long. */
const ARROW = 0.8

/**
 * @param {import('../../figure/shell.js').Panel} panel
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 */
export function drawRails({ pen, width, height }, frame, view) {
  const x = scaleLinear(RAIL, [70, width - 20])
  const size = { wide: width < 420 ? 40 : 52, high: 20 }
  const grounds = [0.4 * height, height - 24]
  const [first, second] = frame.start
  pen.draw(() => {
    pen.mark('path', 'first-rail', { class: 'axis', d: `M${x(RAIL[0])} ${grounds[0]}H${x(RAIL[1])}` })
    rail(pen, x, grounds[1])
    pen.mark('path', 'apart', {
      ...meaning('way dashed', 'truth'),
      d: [first, second]
        .map(([at]) => `M${x(at).toFixed(1)} ${(grounds[0] + 3).toFixed(1)}V${grounds[1] - FLOOR - 2}`)
        .join(''),
    })
    for (const [i, words] of ['first', 'second'].entries())
      pen.text(words, { class: 'plot-title', x: 4, y: grounds[i] - FLOOR - 4 }, words)
    cart(pen, 'cart-1', x(first[0]), grounds[0], size, { class: 'robot' })
    cart(pen, 'cart-2', x(second[0]), grounds[1], size, meaning('outline', 'posterior'))
    const tip = x(second[0] + ARROW * second[1])
    const up = grounds[1] - FLOOR - size.high - 12
    if (second[1] !== 0)
      pen.mark('line', 'speed', { ...meaning('line', 'posterior'), x1: x(second[0]), x2: tip, y1: up, y2: up })
    pen.group('handles', {}, (to) => {
      for (const [key, grip] of Object.entries(handles(x, grounds[1] - FLOOR - size.high / 2, [tip, up], frame, view)))
        view.handle(to, key, grip)
    })
  })
}

/**
 * @param {import('../../draw/plot.js').Scale} x
 * @param {number} middle of the second cart
 * @param {[number, number]} tip of the arrow
 * @param {Frame} frame
 * @param {import('../../figure/spec.js').View} view
 * @returns {Record<string, import('../../figure/spec.js').HandleSpec>}
 */
function handles(x, middle, tip, { params, start: [first, second] }, { limits }) {
  const put = (/** @type {'position' | 'speed'} */ name, /** @type {number} */ value) => ({
    [name]: Math.max(limits[name].least, Math.min(limits[name].greatest, Math.round(value / 0.05) / 20)),
  })
  const shared = (/** @type {'position' | 'speed'} */ name) => ({
    small: true,
    kin: /** @type {const} */ ('posterior'),
    now: params[name],
    min: limits[name].least,
    max: limits[name].greatest,
    nudge: (/** @type {number} */ dx, /** @type {number} */ dy) => put(name, params[name] + 0.05 * (dx || dy)),
    jump: (/** @type {'home' | 'end'} */ end) => put(name, end === 'home' ? limits[name].least : limits[name].greatest),
  })
  return {
    position: {
      ...shared('position'),
      at: [x(second[0]), middle],
      label: 'Start of the second cart, from the first',
      value: `${fixed(params.position)} metres`,
      move: (px) => put('position', x.invert(px) - first[0]),
    },
    speed: {
      ...shared('speed'),
      at: tip,
      label: 'Speed of the second cart, from the first’s',
      name: 'speed',
      // Beside the ring as it is while it is held.
      nameAt: [tip[0] > x(RAIL[1]) - 40 ? -18 : 18, 4],
      value: `${fixed(params.speed)} metres a second`,
      move: (px) => put('speed', (x.invert(px) - second[0]) / ARROW),
    },
  }
}
