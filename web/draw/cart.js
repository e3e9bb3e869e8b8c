/** A rail with its metres, and a cart on it, from the side. */

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./scale.js').Scale} Scale */

/** The radius of a wheel, pixels. */
const WHEEL = 5

/** @param {Pen} pen @param {Scale} x @param {number} y @param {string} [key] */
export function rail(pen, x, y, key = 'rail') {
  const [from, to] = x.domain
  const marks = x.ticks(8)
  const words = x.words(8)
  pen.group(key, {}, (into) => {
    into.mark('path', 'line', {
      class: 'axis',
      d: `M${x(from)} ${y}H${x(to)}${marks.map((value) => `M${x(value).toFixed(1)} ${y}v5`).join('')}`,
    })
    for (const value of marks)
      into.text(
        `metre${value}`,
        { class: 'tick', x: x(value), y: y + 18, 'text-anchor': 'middle' },
        `${words(value)}${value === 0 ? ' m' : ''}`,
      )
  })
}

/**
 * A cart from the side, its wheels on the rail.
 * @param {Pen} pen
 * @param {string} key
 * @param {number} x its middle
 * @param {number} y of the rail
 * @param {{ wide: number, high: number }} size of its body
 * @param {import('./pen.js').Attributes} look
 */
export function cart(pen, key, x, y, { wide, high }, look) {
  const round = `a${WHEEL} ${WHEEL} 0 1 0`
  const wheels = [-wide / 4, wide / 4].map(
    (dx) => `M${(x + dx - WHEEL).toFixed(1)} ${y - WHEEL}${round} ${2 * WHEEL} 0${round} ${-2 * WHEEL} 0`,
  )
  const body = `M${(x - wide / 2).toFixed(1)} ${y - 2 * WHEEL}v${-high}h${wide}v${high}Z`
  pen.mark('path', key, { ...look, d: `${body}${wheels.join('')}` })
}

/** How high a cart's body begins above the rail, pixels. */
export const FLOOR = 2 * WHEEL
