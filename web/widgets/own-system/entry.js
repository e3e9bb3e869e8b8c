/** A matrix that is set in part: `F(1,2) = T`, `F(1:2, 3:4) = T*eye(2)`, `F[0, 1] = dt`, `F[:2, 2:] = …`. */

import { Fault } from './number.js'

/** Of few letters: a long run of blanks would be tried in every way. */
const INDEX = /[\d\s:end]{1,40}/.source
/** Both indices in one bracket, or each in its own. */
export const ENTRY = new RegExp(
  `^(?:[A-Za-z_]\\w*\\.)*([A-Za-z_]\\w*)\\s*(?:\\((${INDEX}),(${INDEX})\\)|` +
    `\\[(${INDEX})(?:,|\\]\\s*\\[)(${INDEX})\\])\\s*=(?!=)\\s*`,
)

/**
 * What `[ ]` count from, where the text tells: in numpy and for lists of lists from 0, in Julia from 1.
 * @typedef {0 | 1 | undefined} From
 */

/** Rows parted by semicolons in one pair of brackets: where its entries have square brackets, that is Julia. */
const ROWS_IN_ONE = /^\s*\[[^[\]]*;[^[\]]*\]/

/** @param {string} value how it is written @param {boolean} numpy @returns {From} */
export function countsFrom(value, numpy) {
  if (numpy || /^\s*(?:\w+\()*\[\s*\[/.test(value)) return 0
  return ROWS_IN_ONE.test(value) ? 1 : undefined
}

/**
 * One part of a matrix that is set.
 * @typedef {object} Part
 * @property {string} words the part as it is written
 * @property {[number, number][]} ranges of its rows and of its columns, each up to its end
 */

/**
 * @param {RegExpExecArray} found by `ENTRY` @param {number[][]} matrix @param {From} from @returns {Part}
 */
export function partOf([all, name, ...four], matrix, from) {
  const words = all.replace(/\s*=\s*$/, '')
  const sizes = [matrix.length, matrix[0].length]
  const round = four[0] !== undefined
  const indices = (round ? four.slice(0, 2) : four.slice(2)).map((index) => index.replace(/\s/g, ''))
  if (!indices.every((index) => /^(?:\d+|end|\d*:(?:\d+|end)?)$/.test(index)))
    throw new Fault(`“${words}” is not understood here; write the whole matrix.`)
  const first = round ? 1 : (from ?? told(words, indices, sizes))
  const ranges = indices.map((index, i) => {
    const [begin, end = begin] = index.split(':').map((word) => word.replace('end', String(sizes[i])))
    const span = index.includes(':')
    // Python’s range stops before its end.
    const last = first === 0 && span ? Number(end || sizes[i]) : Number(end || sizes[i]) + 1 - first
    return /** @type {[number, number]} */ ([begin === '' ? 0 : Number(begin) - first, last])
  })
  if (ranges.some(([begin, end], i) => begin < 0 || end > sizes[i] || end <= begin))
    throw new Fault(`${words}: ${name} is ${sizes.join(' × ')}.`)
  return { words, ranges }
}

/** @param {string} words @param {string[]} indices @param {number[]} sizes @returns {0 | 1} */
function told(words, indices, sizes) {
  if (indices.some((index) => /^0\b/.test(index))) return 0
  if (indices.some((index, i) => Number(index) === sizes[i])) return 1
  throw new Fault(`${words} counts from 0 in Python and from 1 in Julia; write the whole matrix.`)
}

/** @param {number[][]} matrix @param {Part} part @param {number[][]} value */
export function setPart(matrix, { words, ranges }, value) {
  const [[top, bottom], [left, right]] = ranges
  const [height, width] = [bottom - top, right - left]
  const flat = value.flat()
  const strip = (height === 1 || width === 1) && (value.length === 1 || value[0].length === 1)
  const same = value.length === height && value[0].length === width
  if (flat.length !== 1 && !same && !(strip && flat.length === height * width))
    throw new Fault(`${words} is ${height} × ${width}, and what it is set to ${value.length} × ${value[0].length}.`)
  for (let i = 0; i < height; i += 1)
    for (let j = 0; j < width; j += 1) matrix[top + i][left + j] = flat[flat.length === 1 ? 0 : i * width + j]
}
