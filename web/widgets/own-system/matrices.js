/** What MATLAB and numpy compute of matrices. A matrix is a list of rows, and a scalar is 1 × 1. */

import { Fault } from './number.js'

/** @typedef {number[][]} Matrix */

/** The most rows and columns of what is made here. */
const MOST = 9
/**
 * numpy’s rows without a direction: a transpose leaves them, and behind `@` they are columns.
 * @type {WeakSet<Matrix>}
 */
const LINES = new WeakSet()

/** @param {Matrix} m */
export const isLine = (m) => LINES.has(m)
/** @param {Matrix} m @param {boolean} [is] */
export const line = (m, is = true) => (is && LINES.add(m), m)
/** @param {Matrix} m */
export const isScalar = (m) => m.length === 1 && m[0].length === 1
/** @param {number} rows @param {number} columns @param {(i: number, j: number) => number} entry @returns {Matrix} */
const made = (rows, columns, entry) =>
  Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (_, j) => entry(i, j)))
/** @param {Matrix} m @param {(x: number) => number} f */
export const each = (m, f) =>
  line(
    made(m.length, m[0].length, (i, j) => f(m[i][j])),
    isLine(m),
  )
/** @param {Matrix} m */
export const turned = (m) => made(m[0].length, m.length, (i, j) => m[j][i])
/** @param {Matrix} m */
export const transposed = (m) => (isLine(m) ? m : turned(m))
/** @param {Matrix} a @param {Matrix} b @param {string} what */
const unfit = (a, b, what) =>
  new Fault(`a ${a.length} × ${a[0].length} and a ${b.length} × ${b[0].length} matrix have no ${what}.`)

/**
 * Entry by entry; one row, or one column, counts for all, as in both languages.
 * @param {Matrix} a @param {Matrix} b @param {(x: number, y: number) => number} f @param {string} what
 */
export function combined(a, b, f, what) {
  const both = (/** @type {number} */ m, /** @type {number} */ n) => {
    if (m !== n && m !== 1 && n !== 1) throw unfit(a, b, what)
    return m === 1 ? n : m
  }
  const at = (/** @type {Matrix} */ m, /** @type {number} */ i, /** @type {number} */ j) =>
    m[m.length === 1 ? 0 : i][m[0].length === 1 ? 0 : j]
  const all = made(both(a.length, b.length), both(a[0].length, b[0].length), (i, j) => f(at(a, i, j), at(b, i, j)))
  return line(all, (isLine(a) || isLine(b)) && [a, b].every((m) => isLine(m) || isScalar(m)))
}

/** @param {Matrix} a @param {Matrix} b @param {string} sign */
export const added = (a, b, sign) => combined(a, b, (x, y) => (sign === '-' ? x - y : x + y), 'sum')

/** The product of two matrices. @param {Matrix} a @param {Matrix} b @returns {Matrix} */
export function times(a, b) {
  if (isLine(b) && !isScalar(b)) return line(turned(times(a, turned(b))))
  if (a[0].length !== b.length) throw unfit(a, b, 'product')
  return line(
    a.map((row) => b[0].map((_, j) => row.reduce((sum, entry, k) => sum + entry * b[k][j], 0))),
    isLine(a),
  )
}

/** @param {Matrix} a @param {Matrix} b */
export const divided = (a, b) => {
  if (b.some((row) => row.includes(0))) throw new Fault('“/ 0” is not understood here: nothing is divided by 0.')
  return combined(a, b, (x, y) => x / y, 'quotient')
}

/** Matrices side by side. @param {Matrix[]} all */
export function beside(all) {
  if (all.some((m) => m.length !== all[0].length)) throw new Fault('matrices of different heights stand in one row.')
  return all[0].map((_, i) => all.flatMap((m) => m[i]))
}

/** @param {number} n */
const identity = (n) => made(n, n, (i, j) => Number(i === j))
/** @param {Matrix} m */
function square(m) {
  if (m.length !== m[0].length) throw new Fault(`a ${m.length} × ${m[0].length} matrix is not square.`)
  return m.length
}

/** The inverse, by Gauss’s elimination with the largest pivot of a column. @param {Matrix} m */
export function inverse(m) {
  const n = square(m)
  const rows = beside([m, identity(n)])
  const least = n * Number.EPSILON * Math.max(...m.flat().map(Math.abs))
  for (let k = 0; k < n; k += 1) {
    const best = rows.slice(k).reduce((top, row, i) => (Math.abs(row[k]) > Math.abs(rows[top][k]) ? k + i : top), k)
    const pivot = rows[best]
    if (!(Math.abs(pivot[k]) > least)) throw new Fault('a matrix has no inverse.')
    ;[rows[best], rows[k]] = [rows[k], pivot.map((entry) => entry / pivot[k])]
    for (let i = 0; i < n; i += 1) {
      const by = rows[i][k]
      if (i !== k) rows[i] = rows[i].map((entry, j) => entry - by * rows[k][j])
    }
  }
  return rows.map((row) => row.slice(n))
}

/** A whole power, by squares. @param {Matrix} m @param {number} by @returns {Matrix} */
export function raised(m, by) {
  if (!Number.isInteger(by) || Math.abs(by) > 1e6) throw new Fault(`a matrix has no power of ${by} here.`)
  if (by < 0) return raised(inverse(m), -by)
  let [power, squares] = [identity(square(m)), m]
  for (let left = by; left > 0; left = Math.floor(left / 2)) {
    if (left % 2 === 1) power = times(power, squares)
    squares = times(squares, squares)
  }
  return power
}

/** The exponential: Taylor’s series of a part small enough, and its squares. @param {Matrix} m */
function exponential(m) {
  const size = Math.max(1e-9, ...m.map((row) => row.reduce((sum, entry) => sum + Math.abs(entry), 0)))
  const halvings = Math.max(0, Math.ceil(Math.log2(size)) + 1)
  let term = identity(square(m))
  let whole = term
  for (let k = 1; k <= 18; k += 1) {
    term = each(times(term, m), (x) => x / (k * 2 ** halvings))
    whole = combined(whole, term, (x, y) => x + y, 'sum')
  }
  for (let k = 0; k < halvings; k += 1) whole = times(whole, whole)
  return whole
}

/**
 * A diagonal as a matrix, or that of a matrix.
 * @param {Matrix} m @param {number} k how far it lies above the middle @param {boolean} numpy
 */
function diagonal(m, k, numpy) {
  if (!Number.isInteger(k) || Math.abs(k) > MOST)
    throw new Fault(`a diagonal is one list: ${numpy ? 'np.diag([a, b])' : 'diag([a b])'}.`)
  const flat = m.flat()
  if (!isLine(m) && (numpy || (m.length > 1 && m[0].length > 1))) {
    const found = m.flatMap((row, i) => (row[i + k] === undefined ? [] : [row[i + k]]))
    if (found.length === 0) throw new Fault('is empty.')
    return numpy ? line([found]) : turned([found])
  }
  const n = flat.length + Math.abs(k)
  return made(n, n, (i, j) => (j - i === k ? flat[Math.min(i, j)] : 0))
}

/** @param {Matrix} a @param {Matrix} b */
const kron = (a, b) => a.flatMap((row) => beside(row.map((by) => each(b, (x) => by * x))))

/** @param {number} value @param {boolean} square @returns {Call} */
const filled = (value, square) => (args, numpy) => {
  const [rows, columns] = args.flatMap((m) => m.flat())
  if (![rows, columns ?? 1].every((n) => Number.isInteger(n) && n >= 0)) throw new Fault('a size is a whole number.')
  if (Math.max(rows, columns ?? 1) > MOST) throw new Fault(`at most ${MOST} states are shown here.`)
  if (rows === 0) throw new Fault('is empty.')
  const entry = (/** @type {number} */ i, /** @type {number} */ j) => (!square || i === j ? value : 0)
  // In numpy one size makes a row of numbers.
  if (columns === undefined && numpy && !square) return line(made(1, rows, entry))
  return made(rows, columns ?? rows, entry)
}
/** @param {(x: number) => number} f @returns {Call} */
const entries =
  (f) =>
  ([m]) =>
    each(m, f)
/** @type {Call} */
const as = ([m]) => m
/** @type {Call} */
const product = ([a, b]) => times(a, b)
/** @type {Call} */
const blocks = (all) =>
  all.reduce((whole, m) => {
    const [left, right] = [whole[0].length, m[0].length]
    const zeros = (/** @type {number} */ n) => Array(n).fill(0)
    return [...whole.map((row) => [...row, ...zeros(right)]), ...m.map((row) => [...zeros(left), ...row])]
  })
const radians = entries((x) => (x * Math.PI) / 180)

/** @typedef {(args: Matrix[], numpy: boolean) => Matrix} Call */
/**
 * Functions by name, each with the least and the most values that it takes.
 * @type {Record<string, [number, number, Call]>}
 */
export const FUNCTIONS = {
  ...Object.fromEntries(
    ['array', 'asarray', 'matrix', 'mat', 'double', 'float', 'atleast_2d'].map((name) => [name, [1, 1, as]]),
  ),
  ...Object.fromEntries(['eye', 'identity', 'I'].map((name) => [name, [1, 2, filled(1, true)]])),
  zeros: [1, 2, filled(0, false)],
  ones: [1, 2, filled(1, false)],
  fill: [3, 3, ([value, ...size]) => filled(value[0][0], false)(size, false)],
  diag: [1, 2, ([m, k], numpy) => diagonal(m, k?.[0][0] ?? 0, numpy)],
  ...Object.fromEntries(['Diagonal', 'diagm'].map((name) => [name, [1, 1, ([m]) => diagonal(m, 0, false)]])),
  kron: [2, 2, ([a, b]) => kron(a, b)],
  blkdiag: [1, MOST, blocks],
  block_diag: [1, MOST, blocks],
  block: [1, 1, as],
  horzcat: [1, MOST, beside],
  vertcat: [1, MOST, (all) => all.flat()],
  size: [1, 2, ([m, k]) => (k ? [[[m.length, m[0].length][k[0][0] - 1] ?? 1]] : [[m.length, m[0].length]])],
  length: [1, 1, ([m]) => [[Math.max(m.length, m[0].length)]]],
  len: [1, 1, ([m]) => [[isLine(m) ? m[0].length : m.length]]],
  zeros_like: [1, 1, entries(() => 0)],
  ones_like: [1, 1, entries(() => 1)],
  inv: [1, 1, ([m]) => inverse(m)],
  expm: [1, 1, ([m]) => exponential(m)],
  dot: [2, 2, product],
  matmul: [2, 2, product],
  outer: [
    2,
    2,
    ([a, b]) =>
      times(
        a.flat().map((entry) => [entry]),
        [b.flat()],
      ),
  ],
  transpose: [1, 1, ([m]) => transposed(m)],
  matrix_power: [2, 2, ([m, by]) => raised(m, by[0][0])],
  sqrt: [1, 1, entries(Math.sqrt)],
  square: [1, 1, entries((x) => x * x)],
  exp: [1, 1, entries(Math.exp)],
  log: [1, 1, entries(Math.log)],
  sin: [1, 1, entries(Math.sin)],
  cos: [1, 1, entries(Math.cos)],
  tan: [1, 1, entries(Math.tan)],
  abs: [1, 1, entries(Math.abs)],
  deg2rad: [1, 1, radians],
  radians: [1, 1, radians],
}
