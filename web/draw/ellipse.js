/** An ellipse as it is drawn: it comes from the core, as its axes and angle. */

import { Outline } from './path.js'

/** @typedef {import('./plot.js').Plane} Plane */
/** @typedef {{ semiMajor: number, semiMinor: number, angle: number }} Ellipse */

/** How far along its tangent a quarter of a circle leans, for the cubic nearest to it (within 2 parts in 10 000). */
const LEAN = 0.5519150244935106
const QUARTERS = /** @type {const} */ ([
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
  [1, 0],
])

/** So many points around the unit circle. @param {number} count */
export const turns = (count) =>
  Array.from({ length: count }, (_, i) => [Math.cos((2 * Math.PI * i) / count), Math.sin((2 * Math.PI * i) / count)])

/**
 * Half the width and half the height of an ellipse's box.
 * @param {Ellipse} ellipse
 */
export function halves({ semiMajor, semiMinor, angle }) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  return [Math.hypot(semiMajor * c, semiMinor * s), Math.hypot(semiMajor * s, semiMinor * c)]
}

/**
 * Where a point of the unit circle lies on an ellipse under the plane's scales, across and up.
 * @param {Ellipse} ellipse @param {number[]} centre @param {Plane} plane @param {number} radius
 */
function onEllipse({ semiMajor, semiMinor, angle }, centre, plane, radius) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  const [a, b] = [radius * semiMajor, radius * semiMinor]
  return [
    (/** @type {number} */ u, /** @type {number} */ v) => plane.x(centre[0] + c * a * u - s * b * v),
    (/** @type {number} */ u, /** @type {number} */ v) => plane.y(centre[1] + s * a * u + c * b * v),
  ]
}

/**
 * Points along the outline of an ellipse, pixels.
 * @param {Ellipse} ellipse @param {number[]} centre @param {Plane} plane @param {number} [radius]
 */
export function ellipsePoints(ellipse, centre, plane, radius = 1) {
  const on = onEllipse(ellipse, centre, plane, radius)
  return turns(72).map(([u, v]) => on.map((place) => place(u, v)))
}

/**
 * The outline of an ellipse under the plane's scales: four cubics, which the scales keep.
 * @param {Ellipse} ellipse
 * @param {number[]} centre
 * @param {Plane} plane
 * @param {number} [radius] a multiple of the axes
 */
export function ellipsePath(ellipse, centre, plane, radius = 1) {
  const [x, y] = onEllipse(ellipse, centre, plane, radius)
  const out = new Outline()
  out.move(x(1, 0), y(1, 0))
  for (let i = 1; i < 5; i += 1) {
    const [[u0, v0], [u1, v1]] = [QUARTERS[i - 1], QUARTERS[i]]
    const [cu, cv, du, dv] = [u0 + LEAN * u1, v0 + LEAN * v1, u1 + LEAN * u0, v1 + LEAN * v0]
    out.curve(x(cu, cv), y(cu, cv), x(du, dv), y(du, dv), x(u1, v1), y(u1, v1))
  }
  return `${out.data}Z`
}
