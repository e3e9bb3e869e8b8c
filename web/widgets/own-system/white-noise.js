/** The noises of a state and its derivatives by filterpy's functions, which many a script calls. */

import { Fault } from './number.js'

/** @typedef {number[][]} Matrix */
/** @typedef {{ key?: string, value: Matrix }} Named */

/** @param {number} n */
const factorial = (n) => Array.from({ length: n }, (_, i) => i + 1).reduce((all, one) => all * one, 1)

/** A last derivative that is drawn anew for each step and holds over it. @param {number} n @param {number} dt */
function held(n, dt) {
  // Two states are moved by an acceleration that is no state; of three and four the last is drawn.
  const first = n === 2 ? 1 : 0
  const by = Array.from({ length: n }, (_, i) => dt ** (n - 1 - i + first) / factorial(n - 1 - i + first))
  return by.map((a) => by.map((b) => a * b))
}

/** White noise that is integrated over a step. @param {number} n @param {number} dt */
const integrated = (n, dt) =>
  Array.from({ length: n }, (_, i) =>
    Array.from({ length: n }, (_, j) => {
      const [a, b] = [n - 1 - i, n - 1 - j]
      return dt ** (a + b + 1) / ((a + b + 1) * factorial(a) * factorial(b))
    }),
  )

const SIZE = /** @type {Record<string, string>} */ ({
  Q_discrete_white_noise: 'var',
  Q_continuous_white_noise: 'spectral_density',
})

/** @param {string} name */
export const isWhiteNoise = (name) => Object.hasOwn(SIZE, name)

/** @param {string} name @param {Named[]} given the values of the call @returns {Matrix} */
export function whiteNoise(name, given) {
  const keys = ['dim', 'dt', SIZE[name], 'block_size', 'order_by_dim']
  const values = /** @type {Record<string, number>} */ ({ dt: 1, [SIZE[name]]: 1, block_size: 1, order_by_dim: 1 })
  given.forEach((one, i) => {
    const { key = keys[i], value } = one
    if (!keys.includes(key) || value.flat().length !== 1)
      throw new Fault(`“${key} =” is not understood here; write the numbers that come of it.`)
    values[key] = value[0][0]
  })
  const { dim, dt, block_size: blocks, order_by_dim: byDim } = values
  if (![2, 3, 4].includes(dim)) throw new Fault(`“${name}” makes 2, 3 or 4 states; write the numbers that come of it.`)
  if (!Number.isInteger(blocks) || blocks < 1 || blocks * dim > 9) throw new Fault('at most 9 states are shown here.')
  const one = (name.includes('discrete') ? held : integrated)(dim, dt)
  return Array.from({ length: dim * blocks }, (_, r) =>
    Array.from({ length: dim * blocks }, (_, c) => {
      const [i, j] = [r, c].map((at) => (byDim ? at % dim : Math.floor(at / blocks)))
      const [block, other] = [r, c].map((at) => (byDim ? Math.floor(at / dim) : at % blocks))
      return block === other ? values[SIZE[name]] * one[i][j] : 0
    }),
  )
}
