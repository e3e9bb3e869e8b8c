/** Systems to begin with. Each is given for one period, which its name says. */

import { lettersOf } from './names.js'

/**
 * @typedef {object} System
 * @property {string} name
 * @property {string[]} states what they are called
 * @property {number[][]} F
 * @property {number[][]} G
 * @property {number[][]} H
 * @property {number[][]} V
 * @property {number[][]} W
 * @property {number} [period] seconds of a step, where it is known
 * @property {boolean} [continuous] whether F, G and V are of continuous time
 * @property {number[]} [spread] the variance of each state at the start
 */

/** A matrix of such blocks on its diagonal. @param {number[][]} block @param {number} count */
const blocks = (block, count) =>
  Array.from({ length: count * block.length }, (_, i) =>
    Array.from({ length: count * block[0].length }, (_, j) =>
      Math.floor(i / block.length) === Math.floor(j / block[0].length)
        ? block[i % block.length][j % block[0].length]
        : 0,
    ),
  )

/** @type {System[]} */
export const PRESETS = [
  {
    name: 'Constant velocity, 0.5 s',
    period: 0.5,
    states: ['position', 'velocity'],
    F: [
      [1, 0.5],
      [0, 1],
    ],
    G: [[0.125], [0.5]],
    H: [[1, 0]],
    V: [
      [0.0015625, 0.00625],
      [0.00625, 0.025],
    ],
    W: [[0.5]],
  },
  {
    name: 'Constant velocity, velocity read',
    period: 0.5,
    states: ['position', 'velocity'],
    F: [
      [1, 0.5],
      [0, 1],
    ],
    G: [[0.125], [0.5]],
    H: [[0, 1]],
    V: [
      [0.0015625, 0.00625],
      [0.00625, 0.025],
    ],
    W: [[0.5]],
  },
  {
    name: 'Constant acceleration, 0.5 s',
    period: 0.5,
    states: ['position', 'velocity', 'acceleration'],
    F: [
      [1, 0.5, 0.125],
      [0, 1, 0.5],
      [0, 0, 1],
    ],
    G: [[0], [0], [0.5]],
    H: [[1, 0, 0]],
    V: [
      [0, 0, 0],
      [0, 0, 0],
      [0, 0, 0.05],
    ],
    W: [[0.5]],
  },
  {
    name: 'Pendulum, 0.1 s',
    period: 0.1,
    states: ['angle', 'rate'],
    F: [
      [0.9515, 0.0979],
      [-0.9602, 0.9417],
    ],
    G: [[0.0049], [0.0979]],
    H: [[1, 0]],
    V: [
      [0, 0],
      [0, 0.01],
    ],
    W: [[0.01]],
  },
  {
    name: 'DC motor, 0.05 s',
    period: 0.05,
    states: ['angle', 'speed', 'current'],
    F: [
      [1, 0.0475, 0.0117],
      [0, 0.9026, 0.452],
      [0, -0.009, 0.9026],
    ],
    G: [[0.0004], [0.0234], [0.0951]],
    H: [[1, 0, 0]],
    V: [
      [0, 0, 0],
      [0, 0.02, 0],
      [0, 0, 0.001],
    ],
    W: [[0.001]],
  },
  {
    name: 'Bias plus sensor',
    states: ['value', 'bias'],
    F: [
      [1, 0],
      [0, 1],
    ],
    G: [[1], [0]],
    H: [[1, 1]],
    V: [
      [0.1, 0],
      [0, 0],
    ],
    W: [[0.5]],
  },
  {
    name: 'Two tanks, 1 s',
    period: 1,
    states: ['upper', 'lower'],
    F: [
      [0.9, 0],
      [0.1, 0.8],
    ],
    G: [[0.1], [0]],
    H: [[0, 1]],
    V: [
      [0.01, 0],
      [0, 0.01],
    ],
    W: [[0.02]],
  },
  {
    name: 'Height, speed and bias, 0.01 s',
    period: 0.01,
    states: ['height', 'speed', 'bias'],
    F: [
      [1, 0.01, -0.00005],
      [0, 1, -0.01],
      [0, 0, 1],
    ],
    G: [[0.00005], [0.01], [0]],
    H: [[1, 0, 0]],
    V: [
      [1e-10, 2e-8, 0],
      [2e-8, 4e-6, 0],
      [0, 0, 1e-8],
    ],
    W: [[0.25]],
  },
  {
    name: 'Mass on a spring, continuous time',
    period: 0.1,
    continuous: true,
    states: ['position', 'velocity'],
    F: [
      [0, 1],
      [-4, -0.2],
    ],
    G: [[0], [1]],
    H: [[1, 0]],
    V: [
      [0, 0],
      [0, 0.1],
    ],
    W: [[0.01]],
  },
  {
    name: 'Acceleration in space, continuous time',
    period: 0.1,
    continuous: true,
    states: ['x', 'y', 'z'].flatMap((axis) => [axis, `speed ${axis}`, `accel. ${axis}`]),
    F: blocks(
      [
        [0, 1, 0],
        [0, 0, 1],
        [0, 0, 0],
      ],
      3,
    ),
    G: Array.from({ length: 9 }, () => []),
    H: blocks([[1, 0, 0]], 3),
    V: blocks(
      [
        [0, 0, 0],
        [0, 0, 0],
        [0, 0, 0.5],
      ],
      3,
    ),
    W: blocks([[0.25]], 3),
  },
]

/** The matrices of a system, and the parameters that hold them. */
export const MATRICES = /** @type {const} */ (['F', 'G', 'H', 'V', 'W'])
/** A list has at least so many entries, and a matrix so many rows and columns. */
const LEAST = 4
/** The most states. */
export const MOST = 9
/** Values that the plots keep of a run. */
const KEPT = 239

/** The lab's parameters for a system. @param {Omit<System, 'name' | 'states'> & { states?: string[] }} system */
export function paramsOf({ F, G, H, V, W, states = [], period = 0, continuous = false, spread }) {
  const length = (/** @type {number} */ n) => Math.max(LEAST, n)
  const whole = (/** @type {number[][]} */ m) =>
    Array.from({ length: length(m.length) }, (_, i) =>
      Array.from({ length: length(m[0].length) }, (_, j) => m[i]?.[j] ?? 0),
    )
  return {
    states: F.length,
    inputs: G[0]?.length ?? 0,
    readings: H.length,
    f: whole(F),
    g: whole(G),
    h: whole(H),
    v: whole(V),
    w: whole(W),
    names: Array.from({ length: length(F.length) }, (_, i) => lettersOf(states[i] ?? '')),
    period,
    continuous,
    ...(spread ? { start: 1 } : {}),
    spread: Array.from({ length: MOST }, (_, i) => (spread ? (spread[i] ?? 0) : 1)),
  }
}

/** The step of a run that shows the slowest error die out, and how many steps a value of the plots stands for. */
export const runOf = (/** @type {number} */ length) => ({ step: length, every: Math.ceil(length / KEPT) })

/** How many rows and columns of a matrix count. @param {string} name @param {any} params @returns {[number, number]} */
export function sizeOf(name, { states: n, inputs: m, readings: p }) {
  return /** @type {Record<string, [number, number]>} */ ({
    F: [n, n],
    G: [n, m],
    H: [p, n],
    V: [n, n],
    W: [p, p],
    K: [n, p],
    P: [1, n],
  })[name]
}

/**
 * The part of a matrix that counts; what the lab leaves out is zero. P is the diagonal of the start.
 * @param {string} name @param {any} params @returns {number[][]}
 */
export function partOf(name, params) {
  const [rows, columns] = sizeOf(name, params)
  const from =
    name === 'P' ? [params.spread.map((/** @type {number} */ part) => part * params.start)] : params[name.toLowerCase()]
  return Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (_, j) => from[i]?.[j] ?? 0))
}

/** @param {any} params @returns {Record<'F' | 'G' | 'H' | 'V' | 'W', number[][]>} */
export function systemOf(params) {
  return /** @type {any} */ (Object.fromEntries(MATRICES.map((name) => [name, partOf(name, params)])))
}
