/**
 * A program’s lines for printers of other languages: each part of a formula has its rows and columns, I is a matrix of
 * the size that its place takes, parts of a matrix are counted from 0, and derivatives are formulas.
 */

import { jacobian } from './derivative.js'
import { Refusal, eye, node, number } from './node.js'

/** @typedef {import('estimate-wasm').ProgramFormula} Formula */
/** @typedef {import('./node.js').Node} Node */
/** @typedef {{ name: string, part: number[] | null, sides: [number, number], value: Node, lines: number[] }} Line */

/** What is a multiple of I where its first part is one. */
const KEEPS = ['negative', 'transpose', 'array', 'sym', 'inv', 'power']

/**
 * @param {import('estimate-wasm').ProgramStatement[]} tree with sizes @param {number[]} sizes n, p and m
 * @returns {Line[]}
 */
export function sized(tree, sizes) {
  /** The names that are multiples of I, and the sides of the others. @type {Map<string, [number, number]>} */
  const known = new Map()
  const letters = new Map(['n', 'p', 'm'].map((letter, i) => [letter, sizes[i]]))

  /** A number of a row or a column. @param {Formula} it @param {number} last */
  function bound(it, last) {
    if (it.word === 'number') return it.number
    if (it.word === 'end') return last
    if (it.word === 'name' && letters.has(it.name)) return Number(letters.get(it.name))
    if (it.word === 'length') return sideOf(it)
    throw new Refusal('a row or a column is computed')
  }
  /** @param {Formula} it a length */
  function sideOf({ parts: [of, which] }) {
    if (!of.sides) throw new Refusal('I has no length')
    return of.sides[which?.number === 2 ? 1 : 0]
  }
  /** Top, bottom, left and right, from 0, each second one past the last. @param {Formula} it @returns {number[]} */
  function ends({ parts: [whole, ...bounds] }) {
    if (!whole.sides) throw new Refusal('I has no parts')
    const [rows, columns] = whole.sides
    const all = [0, rows, 0, columns]
    const skipped = bounds.length === 2 && columns !== 1 ? 2 : 0
    bounds.forEach((it, i) => {
      const at = i + skipped
      all[at] = bound(it, at < 2 ? rows : columns) - (at % 2 === 0 ? 1 : 0)
    })
    return all
  }
  /** Both sides of an operator, where I takes its size from the other. @param {Formula} it @returns {[Node, Node]} */
  function both({ word, parts: [a, b] }) {
    const [left, right] = { plus: [0, 0], minus: [0, 0], times: [0, 1], over: [0, 1], under: [0, 0] }[word] ?? [0, 0]
    return [whole(a, b.sides?.[left] ?? 1), whole(b, a.sides?.[right] ?? 1)]
  }
  /** @param {Formula} it @param {number} [side] of a multiple of I @returns {Node} */
  function whole(it, side = 1) {
    const { word, name, parts } = it
    const sides = /** @type {[number, number]} */ (it.sides ?? [side, side])
    switch (word) {
      case 'number':
        return number(it.number)
      case 'name':
        if (name === 'pi' || name === 'π') return node('pi', [], [1, 1])
        if (letters.has(name) && !known.has(name)) return number(Number(letters.get(name)))
        if (it.sides || (side === 1 && name !== 'I')) return { ...node('name', [], sides), name }
        if (name === 'I') return eye(side)
        return node('times', [{ ...node('name', [], [1, 1]), name }, eye(side)], sides)
      case 'length':
        return number(sideOf(it))
      case 'array':
        return whole(parts[0], side)
      case 'eye':
        return node('eye', [], sides)
      case 'zeros':
        return node('zeros', [], sides)
      case 'part':
        return { ...node('part', [whole(parts[0])], sides), ends: ends(it) }
      case 'jac':
        return jacobian(whole(parts[0]), name, sides[1])
      case 'plus':
      case 'minus':
      case 'times':
      case 'over':
      case 'under': {
        if (it.sides) return node(word, both(it), sides)
        const isNumber = (/** @type {Formula} */ part) => part.sides?.[0] === 1 && part.sides[1] === 1
        return node(
          word,
          parts.map((part) => whole(part, isNumber(part) ? 1 : side)),
          sides,
        )
      }
      default:
        if (parts.some((part) => !part.sides) && !KEEPS.includes(word))
          throw new Refusal(`${word} takes a matrix whose size is known, and here it takes I`)
        return {
          ...node(
            word,
            parts.map((part) => whole(part, side)),
            sides,
          ),
          number: it.number,
        }
    }
  }
  return tree.map(({ name, part, value, lines }) => {
    const sides = /** @type {[number, number]} */ (part ? part.parts[0].sides : (value.sides ?? [1, 1]))
    const line = { name, part: part && ends(part), sides, value: whole(value, part?.sides?.[0]), lines }
    known.set(name, sides)
    return line
  })
}
