/** A number as a reader types it, and what is said where it is none. */

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i

export class Fault extends Error {}

/** A decimal; NaN of one that a double would hold as zero or as infinite, without a word. @param {string} text */
function decimalOf(text) {
  const number = NUMBER.test(text) ? Number(text) : NaN
  const lost = number === 0 && /[1-9]/.test(text.replace(/e.*/i, ''))
  return lost || !Number.isFinite(number) ? NaN : number
}

/**
 * A decimal, also by a true minus sign, or a fraction of two; NaN of what is none.
 * @param {string} text
 */
export function numberOf(text) {
  const [above, below = '1', more] = text
    .trim()
    .replace(/[−–]/g, '-')
    .split(/\s*\/\s*/)
  const under = decimalOf(below)
  return more !== undefined || under === 0 ? NaN : decimalOf(above) / under
}

/** A word in quotes of a fault: of a long one the beginning. @param {string} word @param {number} [most] */
export const begun = (word, most = 20) => (word.length > most ? `${word.slice(0, most)}…` : word)

/** What is wrong with a text that is no number. @param {string} text */
export function faultOf(text) {
  const word = text.trim()
  if (word === '') return 'a number is missing.'
  const instead = /^[-+−]?\d*,\d+$/.test(word) ? ` Write ${word.replace(',', '.')}.` : ''
  return `“${begun(word)}” is not a number.${instead}`
}

/** A decimal; of what is none, the fault. @param {string} word */
export function numberIn(word) {
  const number = decimalOf(word)
  if (Number.isNaN(number)) throw new Fault(faultOf(word))
  return number
}

/** Numbers like 0,5 are two numbers here. @param {string} text */
export const hintOf = (text) =>
  /\d,\d/.test(text) && !/\d\.\d|,\s|\[\s*\[/.test(text) ? ' A comma stands between numbers: write 0.5 for 0,5.' : ''

/** @param {string} words @returns {never} */
export function refuse(words) {
  const [word] = words.trim().split('\n')
  throw new Fault(`“${begun(word)}” is not understood here; write the numbers that come of it.`)
}
