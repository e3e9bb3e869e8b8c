// Valid arguments for exports of the module, drawn at random: vectors, matrices, systems.
import { covariance } from './nonsense.mjs'

export const vector = (n, dice) => Array.from({ length: n }, () => dice.normal() * 10 ** dice.below(3))
/** A vector as a program may hand it over. */
export const row = (n, dice) => (dice.uniform() < 0.5 ? vector(n, dice) : Float64Array.from(vector(n, dice)))

/** A matrix as a program may hand it over, row by row. */
export const matrix = (rows, columns, dice) => Array.from({ length: rows }, () => row(columns, dice))

/** A reading as a program may hand it over: now and then a part of it is missing, or every part. */
export function reading(n, dice) {
  if (dice.uniform() < 0.7) return row(n, dice)
  return vector(n, dice).map((part) => (dice.uniform() < 0.5 ? part : null))
}

export function sizes(dice) {
  return { n: 1 + dice.below(4), p: 1 + dice.below(2), m: 1 + dice.below(2) }
}

export function system({ n, p, m }, dice) {
  return {
    F: matrix(n, n, dice).map((row) => row.map((a) => a / 20)),
    G: matrix(n, m, dice),
    H: matrix(p, n, dice),
    V: covariance(n, dice),
    W: covariance(p, dice),
  }
}
