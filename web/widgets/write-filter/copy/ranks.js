/** Formulas where matrices have operators, as numpy, MATLAB and the chapter write them. */

/**
 * How one thing is written: its text, and how strongly it holds together: 1 a sum, 2 a product, 3 a sign, 4 what stands
 * behind an operand, 5 a name, a number or a bracket.
 * @typedef {[string, number]} Ranked
 */

/**
 * A printer by how a language writes what is no sum. Each word gets its formula and `text`, which writes a part of it,
 * in brackets where it holds together less than `least`.
 * @template {{ word: string, parts: T[] }} T
 * @param {Record<string, (it: T, text: (part: T, least?: number) => string) => Ranked>} words
 * @param {string} [minus] the sign
 */
export function printer(words, minus = '-') {
  /** @type {Record<string, string>} */
  const sums = { plus: '+', minus }
  /** @param {T} it @param {number} [least] @returns {string} */
  function text(it, least = 0) {
    const [a, b] = it.parts
    const sign = sums[it.word]
    const [found, rank] = sign
      ? /** @type {Ranked} */ ([`${text(a, 1)} ${sign} ${text(b, 2)}`, 1])
      : words[it.word](it, text)
    return rank < least ? `(${found})` : found
  }
  return text
}
