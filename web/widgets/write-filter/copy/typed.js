/**
 * A program’s lines for languages in which a number and a matrix of one entry are two types. Everything of one row and
 * one column is a number here, but for what the world gives and takes, which is a matrix of whatever size.
 */

import { all, isNumber, node, number } from './node.js'

/** @typedef {import('./node.js').Node} Node */
/** @typedef {import('./sized.js').Line} Line */

/** Of numbers these are something simpler. */
const PLAIN = ['transpose', 'sym', 'diag', 'trace', 'det']

/**
 * @param {Line[]} lines @param {Set<string>} matrices the names that are matrices even of one entry
 * @returns {Line[]}
 */
export function typed(lines, matrices) {
  /** What a line makes, as its name holds it. @param {Line} line */
  const value = ({ name, part, sides, value }) => {
    const it = of(value)
    const filled = part ? part[1] - part[0] === 1 && part[3] - part[2] === 1 : sides[0] === 1 && sides[1] === 1
    return filled && !part && matrices.has(name) ? node('lift', [it], [1, 1]) : it
  }
  /** @param {Node} it @returns {Node} */
  function of(it) {
    const parts = it.parts.map(of)
    const [a, b] = parts
    const scalar = isNumber(it)
    switch (it.word) {
      case 'name':
        return scalar && matrices.has(it.name) ? node('item', [it], [1, 1]) : it
      case 'eye':
        return scalar ? number(1) : it
      case 'zeros':
        return scalar ? number(0) : it
      case 'times':
        if (isNumber(a) || isNumber(b)) {
          if (isNumber(a) && isNumber(b)) return { ...it, parts }
          return node('scale', isNumber(a) ? [a, b] : [b, a], it.sides)
        }
        return scalar ? node('item', [{ ...it, parts }], [1, 1]) : { ...it, parts }
      case 'over':
        // a B⁻¹ is (B⁻ᵀ aᵀ)ᵀ.
        if (isNumber(b)) return isNumber(a) ? { ...it, parts } : node('shrink', [a, b], it.sides)
        return transposed(node('solve', [transposed(b), transposed(a)], [it.sides[1], it.sides[0]]))
      case 'under':
        if (isNumber(a)) return isNumber(b) ? node('over', [b, a], [1, 1]) : node('shrink', [b, a], it.sides)
        return node('solve', [a, b], it.sides)
      case 'inv':
        return scalar ? node('over', [number(1), a], [1, 1]) : { ...it, parts }
      case 'power':
        if (it.number < 0) {
          const inverse = scalar ? node('over', [number(1), a], [1, 1]) : node('inv', [a], it.sides)
          return it.number === -1 ? inverse : { ...it, number: -it.number, parts: [inverse] }
        }
        return { ...it, parts }
      case 'chol':
        return scalar ? node('sqrt', parts, [1, 1]) : { ...it, parts }
      case 'norm':
        return isNumber(a) ? node('abs', parts, [1, 1]) : { ...it, parts }
      case 'part': {
        // A number has but itself as a part; of a matrix of one entry it is read so already.
        if (isNumber(a)) return a
        return scalar ? node('entry', [{ ...it, parts }], [1, 1]) : { ...it, parts }
      }
      case 'row':
      case 'stack':
        if (scalar) return a
        return { ...it, parts }
    }
    if (isNumber(it) && a && isNumber(a) && PLAIN.includes(it.word)) return a
    return { ...it, parts }
  }
  return lines.map((line) => ({ ...line, value: value(line) }))
}

/** @param {Node} it */
function transposed(it) {
  if (isNumber(it)) return it
  if (it.word === 'transpose') return it.parts[0]
  return node('transpose', [it], [it.sides[1], it.sides[0]])
}

/**
 * The rows of a matrix that is written entry by entry; null of one that is put together from matrices.
 * @param {Node} it
 */
export function written(it) {
  const rows = it.word === 'stack' ? it.parts.map(({ word, parts }) => (word === 'row' ? parts : null)) : [it.parts]
  if (it.word === 'stack') rows.forEach((row, i) => (rows[i] = row ?? [it.parts[i]]))
  const full = /** @type {Node[][]} */ (rows)
  return full.every((row) => row.every(isNumber)) ? full : null
}

/** The words of all lines. @param {Line[]} lines */
export const words = (lines) => new Set(lines.flatMap(({ value }) => [...all(value)].map(({ word }) => word)))
