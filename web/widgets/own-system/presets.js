/** Systems to begin with. Each is given for one period, which its name says. */

import { lettersOf } from './names.js'

/**
 * @typedef {{ name: string, states: string[], F: number[][], G: number[][], H: number[][], V: number[][], W: number[][]
 * }} System
 */

/** @type {System[]} */
export const PRESETS = [
  {
    name: 'Constant velocity, 0.5 s',
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
]

/** The matrices of a system, and the parameters that hold them. */
export const MATRICES = /** @type {const} */ (['F', 'G', 'H', 'V', 'W'])
const MOST = 4

/** The lab's parameters for a system. @param {Omit<System, 'name' | 'states'> & { states?: string[] }} system */
export function paramsOf({ F, G, H, V, W, states = [] }) {
  const whole = (/** @type {number[][]} */ m) =>
    Array.from({ length: MOST }, (_, i) => Array.from({ length: MOST }, (_, j) => m[i]?.[j] ?? 0))
  return {
    states: F.length,
    inputs: G[0]?.length ?? 0,
    readings: H.length,
    f: whole(F),
    g: whole(G),
    h: whole(H),
    v: whole(V),
    w: whole(W),
    names: Array.from({ length: MOST }, (_, i) => lettersOf(states[i] ?? '')),
  }
}

/** How many rows and columns of a matrix count. @param {string} name @param {any} params @returns {[number, number]} */
export function sizeOf(name, { states: n, inputs: m, readings: p }) {
  return /** @type {Record<string, [number, number]>} */ ({
    F: [n, n],
    G: [n, m],
    H: [p, n],
    V: [n, n],
    W: [p, p],
    K: [n, p],
  })[name]
}

/** The part of a matrix that counts. @param {string} name @param {any} params @returns {number[][]} */
export function partOf(name, params) {
  const [rows, columns] = sizeOf(name, params)
  return params[name.toLowerCase()].slice(0, rows).map((/** @type {number[]} */ row) => row.slice(0, columns))
}

/** @param {any} params @returns {Record<'F' | 'G' | 'H' | 'V' | 'W', number[][]>} */
export function systemOf(params) {
  return /** @type {any} */ (Object.fromEntries(MATRICES.map((name) => [name, partOf(name, params)])))
}
