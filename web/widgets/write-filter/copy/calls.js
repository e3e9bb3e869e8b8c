/** Formulas where matrices have functions and numbers have operators: JavaScript and C. */

import { isNumber } from './node.js'
import { written } from './typed.js'

/** @typedef {import('./node.js').Node} Node */

/**
 * What differs: a number, an entry of a matrix, a matrix by its entries, a function of numbers, and the name of a name.
 * @typedef {{
 *   number: (x: number) => string, entry: (m: string, i: number, j: number) => string,
 *   literal: (rows: string[][]) => string, scalar: (word: string) => string, name: (name: string) => string,
 * }} Language
 */

/** @type {Record<string, [string, number]>} */
const SIGNS = { plus: ['+', 1], minus: ['-', 1], times: ['*', 2], over: ['/', 2] }
/** @type {Record<string, string>} */
const FUNCTIONS = {
  plus: 'add',
  minus: 'subtract',
  times: 'multiply',
  scale: 'scale',
  transpose: 'transposed',
  solve: 'solve',
  det: 'determinant',
  trace: 'trace',
  norm: 'norm',
  chol: 'cholesky',
  sym: 'symmetric',
  f: 'f',
  h: 'h',
}
const MAPS = ['sqrt', 'sin', 'cos', 'exp', 'abs', 'wrap']

/** A printer, and the functions that it has called. @param {Language} language */
export function caller(language) {
  /** @type {Set<string>} */
  const called = new Set()
  const call = (/** @type {string} */ name, /** @type {(string | number)[]} */ ...of) => {
    called.add(name)
    return `${name}(${of.join(', ')})`
  }

  /** @param {Node} it @param {number} [least] the rank below which it stands in brackets */
  function text(it, least = 0) {
    const [found, rank] = ranked(it)
    return rank < least ? `(${found})` : found
  }
  /** A part of a matrix that is put together: a number in it is a matrix of one entry. @param {Node} it */
  const matrix = (it) => (isNumber(it) ? language.literal([[text(it)]]) : text(it))

  /** @param {Node} it @returns {[string, number]} */
  function ranked(it) {
    const { word, parts, sides, ends = [] } = it
    const [a, b] = parts
    const scalar = isNumber(it)
    if (word === 'number') return [language.number(it.number), 5]
    if (word === 'pi') return [language.scalar('pi'), 5]
    if (word === 'name') return [language.name(it.name), 5]
    if (word === 'item') return [language.entry(text(a), 0, 0), 5]
    if (word === 'entry') return [language.entry(text(a.parts[0]), a.ends?.[0] ?? 0, a.ends?.[2] ?? 0), 5]
    if (word === 'lift') return [language.literal([[text(a)]]), 5]
    if (SIGNS[word] && parts.every(isNumber)) {
      const [sign, rank] = SIGNS[word]
      return [`${text(a, rank)} ${sign} ${text(b, rank + 1)}`, rank]
    }
    if (word === 'negative') return scalar ? [`-${text(a, 4)}`, 3] : [call('scale', language.number(-1), text(a)), 5]
    if (word === 'shrink') return [call('scale', `${language.number(1)} / ${text(b, 3)}`, text(a)), 5]
    if (word === 'inv') return [call('solve', text(a), call('identity', sides[0])), 5]
    if (word === 'eye') return [call('identity', sides[0]), 5]
    if (word === 'zeros') return [call('zeros', ...sides), 5]
    if (word === 'part') return [call('block', text(a), ...ends), 5]
    if (word === 'power') return [scalar ? `${language.scalar('pow')}(${text(a)}, ${it.number})` : powers(it), 5]
    if (word === 'diag') return [call(a.sides[1] === 1 ? 'diagonal' : 'diagonalOf', text(a)), 5]
    if (word === 'row' || word === 'stack') {
      const rows = written(it)
      if (rows) return [language.literal(rows.map((row) => row.map((part) => text(part)))), 5]
      return [parts.map(matrix).reduce((all, part) => call(word === 'row' ? 'beside' : 'below', all, part)), 5]
    }
    if (MAPS.includes(word) && !scalar) {
      if (word === 'wrap') called.add('wrap')
      return [call('each', language.scalar(word), text(a)), 5]
    }
    if (FUNCTIONS[word] && !(scalar && word === 'scale'))
      return [call(FUNCTIONS[word], ...parts.map((part) => text(part))), 5]
    if (word === 'wrap') called.add('wrap')
    return [`${language.scalar(word)}(${parts.map((part) => text(part)).join(', ')})`, 5]
  }
  /** @param {Node} it */
  const powers = ({ parts: [a], number }) =>
    Array.from({ length: number }, () => text(a)).reduce((all, one) => call('multiply', all, one))

  return { text, called }
}
