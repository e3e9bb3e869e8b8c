/** What the items of a bracket make: a matrix of their rows, of lists, or of blocks. */

import { beside, isLine, isScalar, line } from './matrices.js'
import { Fault, hintOf } from './number.js'

/** @typedef {number[][]} Matrix */
/** @typedef {{ marks: Set<string>, nested: boolean }} List how the items of a bracket are parted */
/** @typedef {{ value: Matrix, list: List | null, key?: string }} Item `list` where the item is a bracket by itself */

/**
 * @param {Item[][]} rows @param {List} list
 * @param {{ numpy: boolean, blocks: boolean, text: string }} how `blocks` within `np.block`
 */
export function assembled(rows, { marks, nested }, { numpy, blocks, text }) {
  const all = rows.flat()
  if (all.length === 0) throw new Fault('is empty.')
  const array = numpy && !blocks
  const scalars = all.every(({ value }) => isScalar(value))
  const semicolons = marks.has(';')
  // Lists beside one another are rows, as in Python and JSON, and so are numpy’s rows without a direction.
  const lists =
    (!semicolons && all.every(({ list }) => list && !list.marks.has(';'))) ||
    (array && all.every(({ value }) => isLine(value)))
  const deep = nested && !blocks && !semicolons && all.some(({ list }) => list?.nested)
  const whole = array && !lists && !semicolons && !scalars
  if (deep || whole || (lists && marks.has(' '))) throw new Fault('is not a list of rows.')
  const strips = lists ? all.map((item) => [item]) : rows
  const matrix = below(
    strips.map((strip) => beside(strip.map(({ value }) => value))),
    text,
  )
  return line(matrix, numpy && !lists && strips.length === 1 && scalars)
}

/** Matrices below one another. @param {Matrix[]} strips @param {string} [text] where they stand @returns {Matrix} */
export function below(strips, text = '') {
  const [first, ...counts] = strips.map(([row]) => row.length)
  const uneven = counts.findIndex((count) => count !== first)
  if (uneven < 0) return strips.flat()
  const count = `${counts[uneven]} ${counts[uneven] === 1 ? 'number' : 'numbers'}`
  throw new Fault(`row ${uneven + 2} has ${count}, row 1 has ${first}.${hintOf(text)}`)
}

/** Whether the bracket that begins a text ends. @param {string} text */
export function closes(text) {
  let depth = 0
  for (const [mark] of text.matchAll(/[[\](){}]/g)) {
    depth += '([{'.includes(mark) ? 1 : -1
    if (depth === 0) return true
  }
  return false
}
