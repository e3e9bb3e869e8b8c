/**
 * Draws axes and the shapes that figures share. An ellipse comes from the core, as its axes and angle.
 *
 * The class of a mark says what it means (`prediction`, `posterior`, `measurement`, `truth`). `data-kin` says the same,
 * so that a word of the text can light the mark up.
 */

import { pairs, pixel, polyline } from './path.js'
import { scaleLinear, scaleLog } from './scale.js'

export { ellipsePath, ellipsePoints, halves } from './ellipse.js'
export { scaleLinear, scaleLog }

/** @typedef {import('./pen.js').Pen} Pen */
/** @typedef {import('./words.js').Words} Words */
/** @typedef {'prediction' | 'posterior' | 'measurement' | 'truth'} Kin */
/** @typedef {import('./scale.js').Scale} Scale */
/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box pixels */
/** @typedef {{ x: Scale, y: Scale, box: Box }} Plane */

/**
 * Class and kin of a mark.
 * @param {string} shape
 * @param {Kin | null} [kin]
 */
export function meaning(shape, kin) {
  const key = `mark ${shape} ${kin ?? ''}`
  let known = MEANINGS.get(key)
  if (!known) MEANINGS.set(key, (known = kin ? { class: key, 'data-kin': kin } : { class: key.trim() }))
  return known
}

/** @type {Map<string, { class: string, 'data-kin'?: Kin }>} */
const MEANINGS = new Map()

/**
 * A plane with the same scale on both axes: `reach` units to the nearer edge from the centre.
 * @param {Box} box
 * @param {[number, number]} centre
 * @param {number} reach
 * @returns {Plane}
 */
export function evenPlane(box, [cx, cy], reach) {
  const [w, h] = [(box.right - box.left) / 2, (box.bottom - box.top) / 2]
  const unit = Math.min(w, h) / reach
  return {
    box,
    x: scaleLinear([cx - w / unit, cx + w / unit], [box.left, box.right]),
    y: scaleLinear([cy - h / unit, cy + h / unit], [box.bottom, box.top]),
  }
}

/**
 * A plane whose axes each have their own scale.
 * @param {Box} box
 * @param {[number, number]} across
 * @param {[number, number]} up
 * @returns {Plane}
 */
export function plane(box, across, up) {
  return { box, x: scaleLinear(across, [box.left, box.right]), y: scaleLinear(up, [box.bottom, box.top]) }
}

/**
 * Ticks, faint grid and the names of the axes.
 * @param {Pen} pen
 * @param {Plane} plane
 * @param {{ x?: Words, y?: Words, title?: Words, ticks?: [number, number], grid?: boolean, zero?: boolean, drop?:
 * number }} [names] `drop` from the axis to the feet of its numbers
 */
export function axes(pen, { x, y, box }, names = {}) {
  const across = apart(x, names.ticks?.[0] ?? 5, box.left, box.right, 26)
  const up = apart(y, names.ticks?.[1] ?? 5, box.top, box.bottom, 15)
  const stamp = JSON.stringify([x.domain, y.domain, box, names])
  pen.group(
    'axes',
    { class: 'axes' },
    (to) => {
      const format = { x: x.words(across.count), y: y.words(up.count) }
      let grid = ''
      for (const value of up.ticks) {
        const at = pixel(y(value))
        grid += `M${box.left} ${at}H${box.right}`
        to.text(`ty${value}`, { class: 'tick', x: box.left - 6, y: at + 4, 'text-anchor': 'end' }, format.y(value))
      }
      for (const value of across.ticks) {
        const at = pixel(x(value))
        grid += `M${at} ${box.top}V${box.bottom}`
        to.text(
          `tx${value}`,
          { class: 'tick', x: at, y: box.bottom + (names.drop ?? 15), 'text-anchor': 'middle' },
          format.x(value),
        )
      }
      if (names.grid !== false) to.mark('path', 'grid', { class: 'grid', d: grid })
      to.mark('path', 'axis', { class: 'axis', d: `M${box.left} ${box.top}V${box.bottom}H${box.right}` })
      if (names.zero) {
        if (inside(y(0), box.top, box.bottom))
          to.mark('line', 'zy', { class: 'zero', x1: box.left, x2: box.right, y1: y(0), y2: y(0) })
        if (inside(x(0), box.left, box.right))
          to.mark('line', 'zx', { class: 'zero', x1: x(0), x2: x(0), y1: box.top, y2: box.bottom })
      }
      if (names.title) to.text('title', { class: 'plot-title', x: box.left, y: box.top - 9 }, names.title)
      if (names.x) to.text('x', { class: 'axis-name', x: box.right, y: box.bottom + 32, 'text-anchor': 'end' }, names.x)
      if (names.y) to.text('y', { class: 'axis-name', x: box.left, y: box.top - 9 }, names.y)
    },
    stamp,
  )
}

/** @param {number} at @param {number} low @param {number} high */
function inside(at, low, high) {
  return at >= low && at <= high
}

/**
 * At most so many ticks, and no two of them nearer than `gap` pixels: on a small plot there are fewer, but two or more
 * where some count has them, since one alone tells no scale. None if `most` is 0.
 * @param {Scale} scale @param {number} most @param {number} low @param {number} high @param {number} gap
 */
function apart(scale, most, low, high, gap) {
  let best = { ticks: /** @type {number[]} */ ([]), count: 1 }
  for (let count = most; count > 0; count -= 1) {
    const all = shown(scale.ticks(count), scale, low, high)
    let last = Infinity
    const ticks = all.filter((value) => Math.abs(scale(value) - last) >= gap && ((last = scale(value)), true))
    if (ticks.length > 1 && (ticks.length === all.length || count === 1)) return { ticks, count }
    if (ticks.length > best.ticks.length) best = { ticks, count }
  }
  return best
}

/** @param {number[]} ticks @param {Scale} scale @param {number} low @param {number} high */
function shown(ticks, scale, low, high) {
  const all = ticks.filter((value) => inside(scale(value), low - 0.5, high + 0.5))
  if (all.length <= 8 || !scale.log) return all
  const lead = all.filter((value) => [1, 2, 5].includes(Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9))))
  return lead.length <= 7 ? lead : all.filter((value) => Number.isInteger(Math.round(Math.log10(value) * 1e6) / 1e6))
}

/**
 * Says at which level the ellipses of a drawing stand. It is one level in every figure: (x − x̂)ᵀP⁻¹(x − x̂) = 1.
 * @param {Pen} pen @param {number} x @param {number} y
 */
export function ellipseLevel(pen, x, y) {
  pen.text('ellipse-level', { class: 'tick', x, y }, 'ellipses: 1 *σ*')
}

/**
 * A bar that says how long a metre is on a map: 1, 2 or 5 times a power of ten metres, about as long as a finger is
 * wide.
 * @param {Pen} pen @param {Plane} plane @param {number} right its right end @param {number} y
 */
export function scaleBar(pen, { x }, right, y) {
  const metre = x(1) - x(0)
  const least = 40 / metre
  const tens = 10 ** Math.floor(Math.log10(least))
  const long = tens * /** @type {number} */ ([1, 2, 5, 10].find((times) => times * tens >= least))
  const left = right - long * metre
  pen.mark('path', 'scale-bar', { class: 'scale-bar', d: `M${pixel(left)} ${y - 8}v4h${pixel(long * metre)}v-4` })
  pen.text('scale-bar-name', { class: 'tick', x: left - 5, y, 'text-anchor': 'end' }, `${long} m`)
}

/**
 * An arrow between two points in data units; none where it would be shorter than its head.
 * @param {Pen} pen
 * @param {string} key
 * @param {Plane} plane
 * @param {number[]} from
 * @param {number[]} to
 * @param {Kin} kin
 */
export function arrow(pen, key, plane, from, to, kin) {
  const [x1, y1, x2, y2] = [plane.x(from[0]), plane.y(from[1]), plane.x(to[0]), plane.y(to[1])].map(pixel)
  const long = Math.hypot(x2 - x1, y2 - y1)
  if (long < 8) return
  const [u, v] = [(x2 - x1) / long, (y2 - y1) / long]
  const barb = (/** @type {number} */ side) =>
    `${pixel(x2 - 9 * u + side * 4.5 * v)} ${pixel(y2 - 9 * v - side * 4.5 * u)}`
  pen.mark('path', key, { ...meaning('arrow', kin), d: `M${x1} ${y1}L${x2} ${y2}M${barb(1)}L${x2} ${y2}L${barb(-1)}` })
}

/**
 * The part of the line {p : h·p = c} inside the plane, in data units, or null.
 * @param {number[]} h
 * @param {number} c
 * @param {Plane} plane
 * @returns {[[number, number], [number, number]] | null}
 */
export function clipLine([a, b], c, plane) {
  const { box } = plane
  const [x0, x1] = [plane.x.invert(box.left), plane.x.invert(box.right)]
  const [y0, y1] = [plane.y.invert(box.bottom), plane.y.invert(box.top)]
  /** @type {[number, number][]} */
  const ends = []
  const add = (/** @type {number} */ x, /** @type {number} */ y) => {
    const slack = 1e-9 * (x1 - x0 + y1 - y0)
    const within = x >= x0 - slack && x <= x1 + slack && y >= y0 - slack && y <= y1 + slack
    if (within && !ends.some(([p, q]) => Math.abs(p - x) + Math.abs(q - y) < slack * 4)) ends.push([x, y])
  }
  if (b !== 0) for (const x of [x0, x1]) add(x, (c - a * x) / b)
  if (a !== 0) for (const y of [y0, y1]) add((c - b * y) / a, y)
  return ends.length >= 2 ? [ends[0], ends[1]] : null
}

/**
 * A straight mark between two points in data units.
 * @param {Pen} pen
 * @param {string} key
 * @param {Plane} plane
 * @param {number[]} from
 * @param {number[]} to
 * @param {import('./pen.js').Attributes} attributes
 */
export function segment(pen, key, plane, from, to, attributes) {
  const [x1, y1, x2, y2] = [plane.x(from[0]), plane.y(from[1]), plane.x(to[0]), plane.y(to[1])].map(pixel)
  return pen.mark('line', key, { x1, y1, x2, y2, ...attributes })
}

/**
 * A dot at a point in data units.
 * @param {Pen} pen
 * @param {string} key
 * @param {Plane} plane
 * @param {number[]} at
 * @param {import('./pen.js').Attributes} attributes `r` among them, 5 if not
 */
export function dot(pen, key, plane, at, attributes) {
  return pen.mark('circle', key, { cx: pixel(plane.x(at[0])), cy: pixel(plane.y(at[1])), r: 5, ...attributes })
}

/**
 * A series as a path; it breaks where a value is not finite (or, on a log scale, not positive).
 * @param {Plane} plane
 * @param {number[]} xs
 * @param {number[]} ys
 */
export function seriesPath({ x, y }, xs, ys) {
  return polyline(ys.length, x, xs, y, ys)
}

/** Points as a path. @param {Plane} plane @param {number[][]} points */
export function pointsPath({ x, y }, points) {
  return pairs(points, x, y)
}
