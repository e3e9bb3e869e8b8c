/**
 * The handles of the plane: prediction, the two axes of its ellipse, the reading, the reader's guess and the radius of
 * the ellipse that grows.
 */

import { clipLine } from '../../draw/plot.js'

/** @typedef {import('estimate-wasm').PictureFrame} Frame */
/** @typedef {import('../../draw/plot.js').Plane} Plane */
/** @typedef {import('../../figure/spec.js').HandleSpec} HandleSpec */
/** @typedef {import('../../figure/spec.js').View} View */

/** The growing ellipse gets a handle where that is in the drawing and keeps so many pixels from the prediction's. */
const CLEAR = 24

/**
 * How far an ellipse grows, in standard deviations: within three of them lies almost everything, and the drawing shows
 * hardly more.
 */
export const GROWN = 3

export const within = (
  /** @type {number[]} */ [px, py],
  /** @type {import('../../draw/plot.js').Box} */ { left, top, right, bottom },
  margin = 0,
) => px >= left + margin && px <= right - margin && py >= top + margin && py <= bottom - margin
const clamp = (/** @type {number} */ value, /** @type {number} */ low, /** @type {number} */ high) =>
  Math.max(low, Math.min(high, value))

/**
 * A place on the reading's line to hold it by; where no part of the line is in the drawing, the one nearest to its
 * middle.
 * @param {Plane} plane @param {Frame} frame
 */
function onLine(plane, { H, params: { reading } }) {
  const ends = clipLine(H, reading, plane)
  if (ends) {
    const [from, to] = ends[0][0] <= ends[1][0] ? ends : [ends[1], ends[0]]
    return from.map((value, i) => value + 0.12 * (to[i] - value))
  }
  const { box, x, y } = plane
  const middle = [x.invert((box.left + box.right) / 2), y.invert((box.top + box.bottom) / 2)]
  const away = reading - H[0] * middle[0] - H[1] * middle[1]
  return middle.map((value, i) => value + away * H[i])
}

/**
 * The handles by their keys.
 * @param {Plane} plane @param {Frame} frame @param {View} view
 * @returns {Record<string, HandleSpec>}
 */
export function handlesOf(plane, frame, view) {
  const { box, x, y } = plane
  const { mean, semiMajor, semiMinor, angle, reading } = frame.params
  const [c, s] = [Math.cos(angle), Math.sin(angle)]
  const words = (/** @type {number} */ value) => value.toFixed(2)
  const inside = (/** @type {number[]} */ [px, py]) =>
    /** @type {[number, number]} */ ([clamp(px, box.left + 8, box.right - 8), clamp(py, box.top + 8, box.bottom - 8)])
  const data = (/** @type {number} */ px, /** @type {number} */ py) => {
    const at = inside([px, py])
    return [x.invert(at[0]), y.invert(at[1])]
  }
  const held = (/** @type {number[]} */ at) => data(x(at[0]), y(at[1]))
  /** An end of the first axis, so many times as far from the middle. @param {number} times */
  const first = (times) => [x(mean[0] + times * semiMajor * c), y(mean[1] + times * semiMajor * s)]
  /** An end of the second. @param {number} times */
  const second = (times) => [x(mean[0] - times * semiMinor * s), y(mean[1] + times * semiMinor * c)]
  /** An axis is held by the end that is in the drawing. @param {(times: number) => number[]} end */
  const side = (end) => (within(end(1), box) || !within(end(-1), box) ? 1 : -1)
  const axis = view.limits.semiMajor
  const length = (/** @type {number} */ value) => clamp(value, axis.least, axis.greatest)

  /** @type {Record<string, HandleSpec>} */
  const grips = {}
  grips.mean = {
    at: [x(mean[0]), y(mean[1])],
    label: 'Prediction',
    name: 'prediction',
    kin: 'prediction',
    value: `at ${words(mean[0])} metres, ${words(mean[1])} metres a second`,
    now: mean[0],
    min: x.invert(box.left + 8),
    max: x.invert(box.right - 8),
    move: (px, py) => ({ mean: data(px, py) }),
    nudge: (dx, dy) => ({ mean: held([mean[0] + 0.05 * dx, mean[1] + 0.05 * dy]) }),
    jump: (end) => ({ mean: data(end === 'home' ? box.left : box.right, y(mean[1])) }),
  }
  grips.major = {
    at: inside(first(side(first))),
    label: 'First axis of the ellipse',
    name: 'turn, stretch',
    kin: 'prediction',
    value: `${words(semiMajor)} long, at ${Math.round((angle * 180) / Math.PI)} degrees`,
    now: semiMajor,
    min: axis.least,
    max: axis.greatest,
    move: (px, py) => {
      const [dx, dy] = data(px, py).map((value, i) => value - mean[i])
      return { semiMajor: length(Math.hypot(dx, dy)), angle: Math.atan2(dy, dx) }
    },
    nudge: (dx, dy) => ({ angle: angle + (dx * Math.PI) / 180, semiMajor: length(semiMajor + 0.05 * dy) }),
    jump: (end) => ({ semiMajor: end === 'home' ? axis.least : axis.greatest }),
  }
  grips.minor = {
    at: inside(second(side(second))),
    label: 'Second axis of the ellipse',
    name: 'stretch',
    kin: 'prediction',
    value: `${words(semiMinor)} long`,
    now: semiMinor,
    min: axis.least,
    max: axis.greatest,
    move: (px, py) => {
      const [dx, dy] = data(px, py).map((value, i) => value - mean[i])
      return { semiMinor: length(Math.abs(dy * c - dx * s)) }
    },
    nudge: (dx, dy) => ({ semiMinor: length(semiMinor + 0.05 * (dx + dy)) }),
    jump: (end) => ({ semiMinor: end === 'home' ? axis.least : axis.greatest }),
  }
  const at = onLine(plane, frame)
  const { least, greatest } = view.limits.reading
  const output = (/** @type {number[]} */ point) =>
    clamp(frame.H[0] * point[0] + frame.H[1] * point[1], least, greatest)
  grips.reading = {
    at: inside([x(at[0]), y(at[1])]),
    label: 'Reading',
    name: '{y}',
    kin: 'measurement',
    value: words(reading),
    now: reading,
    min: least,
    max: greatest,
    move: (px, py) => ({ reading: output(data(px, py)) }),
    nudge: (dx, dy) => ({
      reading: clamp(reading + 0.05 * (Math.abs(frame.H[1]) > 0.5 ? dy || dx : dx || dy), least, greatest),
    }),
    jump: (end) => ({ reading: end === 'home' ? least : greatest }),
  }
  if (frame.params.guess !== null) grips.guess = guessed(plane, frame, view, inside)
  const { radius } = frame.params
  const other = -side(first)
  const [ex, ey] = first(other * radius)
  if (radius * semiMajor * (x(1) - x(0)) > CLEAR && within([ex, ey], box, 8)) {
    const grow = (/** @type {number} */ value) => ({ radius: clamp(value, 0.05, GROWN) })
    grips.grow = {
      at: [ex, ey],
      label: 'Radius of the growing ellipse',
      name: box.right - box.left > 250 ? 'grow' : undefined,
      kin: 'prediction',
      value: `${words(radius)} standard deviations`,
      now: radius,
      min: 0,
      max: GROWN,
      move: (px, py) => {
        const [dx, dy] = data(px, py).map((value, i) => value - mean[i])
        return grow((other * (dx * c + dy * s)) / semiMajor)
      },
      nudge: (dx, dy) => grow(radius + 0.05 * (dx || dy)),
      jump: (end) => grow(end === 'home' ? 0 : GROWN),
    }
  }
  return grips
}

/**
 * The reader's guess, which stays on the line.
 * @param {Plane} plane @param {Frame} frame @param {View} view
 * @param {(at: number[]) => [number, number]} inside
 * @returns {HandleSpec}
 */
function guessed({ x, y }, { params, euclideanFoot, along }, view, inside) {
  const guess = /** @type {number} */ (params.guess)
  const { least, greatest } = view.limits.guess
  const put = (/** @type {number} */ place) => ({ guess: clamp(place, least, greatest) })
  const at = euclideanFoot.at.map((value, i) => value + guess * along[i])
  return {
    at: inside([x(at[0]), y(at[1])]),
    label: 'Your guess',
    name: 'your guess',
    kin: 'measurement',
    value: `at ${at[0].toFixed(2)} metres, ${at[1].toFixed(2)} metres a second`,
    now: guess,
    min: least,
    max: greatest,
    move: (px, py) =>
      put((x.invert(px) - euclideanFoot.at[0]) * along[0] + (y.invert(py) - euclideanFoot.at[1]) * along[1]),
    nudge: (dx, dy) => put(guess + 0.05 * (Math.abs(along[0]) > 0.5 ? dx || dy : dy || dx)),
    jump: (end) => put(end === 'home' ? -3 : 3),
  }
}
