/** Derivatives of columns as formulas, entry by entry: a copy needs no numbers that carry a derivative with them. */

import { Refusal, isNumber, node, number } from './node.js'

/** @typedef {import('./node.js').Node} Node */

/** @param {string} word @param {Node[]} parts */
const made = (word, ...parts) => node(word, parts, [1, 1])
/** @param {Node} it @param {number} value */
const is = (it, value) => it.word === 'number' && it.number === value

/** @param {Node} a @returns {Node} */
function negative(a) {
  if (is(a, 0)) return a
  return a.word === 'negative' ? a.parts[0] : made('negative', a)
}
/** @param {Node} a @param {Node} b @returns {Node} */
function plus(a, b) {
  if (is(a, 0)) return b
  if (is(b, 0)) return a
  return b.word === 'negative' ? made('minus', a, b.parts[0]) : made('plus', a, b)
}
/** @param {Node} a @param {Node} b @returns {Node} */
function minus(a, b) {
  if (is(b, 0)) return a
  if (is(a, 0)) return negative(b)
  return b.word === 'negative' ? plus(a, b.parts[0]) : made('minus', a, b)
}
/** @param {Node} a @param {Node} b @returns {Node} */
function times(a, b) {
  if (is(a, 0) || is(b, 1)) return a
  if (is(b, 0) || is(a, 1)) return b
  if (a.word === 'negative') return negative(times(a.parts[0], b))
  return b.word === 'negative' ? negative(times(a, b.parts[0])) : made('times', a, b)
}
/** @param {Node} a @param {Node} b @returns {Node} */
function over(a, b) {
  if (is(a, 0) || is(b, 1)) return a
  return a.word === 'negative' ? negative(over(a.parts[0], b)) : made('over', a, b)
}
/** @param {Node[]} terms */
const sum = (terms) => terms.reduce(plus, number(0))
/** The root of a sum of squares. @param {Node[]} terms */
const length = (terms) =>
  terms.length === 2 ? made('hypot', ...terms) : made('sqrt', sum(terms.map((a) => times(a, a))))

/** @param {number} rows @param {number} columns @param {(i: number, j: number) => Node} entry */
const grid = (rows, columns, entry) =>
  Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (_, j) => entry(i, j)))

/** What a formula is, entry by entry. @param {Node} it @returns {Node[][]} */
function entries(it) {
  const [rows, columns] = it.sides
  const parts = () => it.parts.map(entries)
  const each = (/** @type {(...entries: Node[]) => Node} */ f) => {
    const all = parts()
    return grid(rows, columns, (i, j) => f(...all.map((part) => part[i][j])))
  }
  switch (it.word) {
    case 'name':
      return grid(rows, columns, (i, j) => ({ ...node('part', [it], [1, 1]), ends: [i, i + 1, j, j + 1] }))
    case 'number':
    case 'pi':
      return [[it]]
    case 'eye':
      return grid(rows, columns, (i, j) => number(i === j ? 1 : 0))
    case 'zeros':
      return grid(rows, columns, () => number(0))
    case 'plus':
      return each(plus)
    case 'minus':
      return each(minus)
    case 'negative':
      return each(negative)
    case 'sqrt':
    case 'sin':
    case 'cos':
    case 'exp':
    case 'abs':
    case 'wrap':
    case 'atan2':
      return each((...of) => made(it.word, ...of))
    case 'times': {
      const [a, b] = parts()
      if (isNumber(it.parts[0])) return grid(rows, columns, (i, j) => times(a[0][0], b[i][j]))
      if (isNumber(it.parts[1])) return grid(rows, columns, (i, j) => times(a[i][j], b[0][0]))
      return grid(rows, columns, (i, j) => sum(b.map((row, k) => times(a[i][k], row[j]))))
    }
    case 'over':
    case 'under': {
      const [a, b] = it.word === 'over' ? parts() : parts().reverse()
      if (b.length > 1) break
      return grid(rows, columns, (i, j) => over(a[i][j], b[0][0]))
    }
    case 'inv':
      if (rows > 1) break
      return [[over(number(1), parts()[0][0][0])]]
    case 'power': {
      const [[[a]]] = parts()
      if (rows > 1 || it.number < 0) break
      return [[Array.from({ length: it.number }, () => a).reduce(times)]]
    }
    case 'transpose': {
      const [a] = parts()
      return grid(rows, columns, (i, j) => a[j][i])
    }
    case 'part': {
      const [a] = parts()
      const [top, , left] = it.ends ?? []
      return grid(rows, columns, (i, j) => a[top + i][left + j])
    }
    case 'row':
      return parts().reduce((left, right) => left.map((row, i) => [...row, ...right[i]]))
    case 'stack':
      return parts().flat()
    case 'norm':
      return [[length(entries(it.parts[0]).flat())]]
    case 'trace':
      return [[sum(entries(it.parts[0]).map((row, i) => row[i]))]]
    case 'f': {
      const [[[x], [y], [heading]], [[s], [turn]]] = parts()
      return [
        [plus(x, times(s, made('cos', heading)))],
        [plus(y, times(s, made('sin', heading)))],
        [made('wrap', plus(heading, turn))],
      ]
    }
    case 'h': {
      const [[[x], [y], [heading]], [[markX], [markY]]] = parts()
      const [dx, dy] = [minus(x, markX), minus(y, markY)]
      return [[length([dx, dy])], [made('wrap', minus(made('atan2', dy, dx), heading))]]
    }
  }
  throw new Refusal(`a copy has no words for the derivative of ${it.word}`)
}

/**
 * The derivative of a number by entry `j` of a name.
 * @param {Node} it @param {string} name @param {number} j @returns {Node}
 */
function derivative(it, name, j) {
  const d = (/** @type {Node} */ part) => derivative(part, name, j)
  const [a, b] = it.parts
  switch (it.word) {
    case 'part':
      return number(a.name === name && it.ends?.[0] === j ? 1 : 0)
    case 'plus':
      return plus(d(a), d(b))
    case 'minus':
      return minus(d(a), d(b))
    case 'negative':
      return negative(d(a))
    case 'times':
      return plus(times(d(a), b), times(a, d(b)))
    case 'over':
      return minus(over(d(a), b), over(times(a, d(b)), times(b, b)))
    case 'sqrt':
      return over(d(a), times(number(2), it))
    case 'sin':
      return times(made('cos', a), d(a))
    case 'cos':
      return negative(times(made('sin', a), d(a)))
    case 'exp':
      return times(it, d(a))
    case 'wrap':
      return d(a)
    case 'abs':
      return times(over(a, it), d(a))
    case 'hypot':
      return over(plus(times(a, d(a)), times(b, d(b))), it)
    case 'atan2':
      return over(minus(times(b, d(a)), times(a, d(b))), plus(times(a, a), times(b, b)))
    default:
      return number(0)
  }
}

/**
 * The derivative of a column by a name with so many entries.
 * @param {Node} of @param {string} name @param {number} count
 */
export function jacobian(of, name, count) {
  const rows = entries(of).map(([entry]) =>
    node(
      'row',
      Array.from({ length: count }, (_, j) => derivative(entry, name, j)),
      [1, count],
    ),
  )
  return node('stack', rows, [rows.length, count])
}
