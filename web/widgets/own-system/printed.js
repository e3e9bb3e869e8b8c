/** A matrix as a program prints it below its name: rows of numbers, perhaps in parts, perhaps with a factor of all. */

import { below } from './bracket.js'
import { beside, each } from './matrices.js'
import { Fault, numberIn } from './number.js'

/** The zeros of Octave’s diagonal matrices are printed too. */
const DIAGONAL = /^[^\S\n]*\n\s*Diagonal Matrix[^\S\n]*(?=\n)/
const FACTOR = /^[^\S\n]*\n\s*([-+.\deE]+)\s*\*[^\S\n]*(?=\n)/
const COLUMNS = /^[^\S\n]*\n?\s*Columns? \d[^\n]*(?=\n)/
const ROWS = /^[^\S\n]*\n\s*(?=[-+.\d])((?:[-+.\deE \t]+(?:\n|$))+)/
/** A display of MATLAB’s systems names states, inputs and readings. */
const LABELLED =
  /^[^\S\n]*\n(?:[^\S\n]+[xuy]\d+)+[^\S\n]*\n((?:[^\S\n]*[xy]\d+(?:[^\S\n]+[-+.\deE]+)+[^\S\n]*(?:\n|$))+)/

/** @param {string} text */
function rowsOf(text) {
  const rows = text.trim().split('\n')
  return below(
    rows.map((row) => [row.trim().split(/\s+/).map(numberIn)]),
    text,
  )
}

/** @param {(pattern: RegExp) => RegExpExecArray | null} take @returns {number[][] | null} */
export function printed(take) {
  const labelled = take(LABELLED)
  if (labelled) return rowsOf(labelled[1].replace(/^[^\S\n]*\w+/gm, ''))
  take(DIAGONAL)
  const factor = take(FACTOR)
  const parts = []
  while (take(COLUMNS) || parts.length === 0) {
    const rows = take(ROWS)
    if (!rows && (factor || parts.length > 0)) throw new Fault('the rows of a part are missing.')
    if (!rows) return null
    parts.push(rowsOf(rows[1]))
  }
  const by = factor ? numberIn(factor[1]) : 1
  return each(beside(parts), (x) => by * x)
}
