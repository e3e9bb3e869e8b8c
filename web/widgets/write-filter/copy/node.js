/** The parts of a formula that printers read, and how they are made. */

/**
 * A part of a formula whose size is known. `ends` are those of a `part`: first and one past the last row, then column,
 * from 0.
 * @typedef {{
 *   word: string, number: number, name: string, sides: [number, number], parts: Node[], ends?: number[],
 * }} Node
 */

/** What a copy has no words for. */
export class Refusal extends Error {}

/** @param {string} word @param {Node[]} parts @param {[number, number]} sides @returns {Node} */
export const node = (word, parts, sides) => ({ word, parts, sides, number: 0, name: '' })

/** @param {number} value @returns {Node} */
export const number = (value) =>
  value < 0 ? node('negative', [number(-value)], [1, 1]) : { ...node('number', [], [1, 1]), number: value }

/** @param {number} side */
export const eye = (side) => (side === 1 ? number(1) : node('eye', [], [side, side]))

/** @param {Node} it */
export const isNumber = ({ sides: [rows, columns] }) => rows === 1 && columns === 1

/** Each part of a formula, the formula first. @param {Node} it @returns {Generator<Node>} */
export function* all(it) {
  yield it
  for (const part of it.parts) yield* all(part)
}
