/** Reads one matrix of a paste, in JSON, MATLAB or numpy notation. What is wrong is named with the matrix it is in. */

import { entriesOf, scalarOf } from './expression.js'

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i
/** The most rows and columns of what is made by `eye`, `zeros` and `ones`. */
const MOST = 9

export class Fault extends Error {}

/** @typedef {{ get: (name: string) => number[][] | undefined, numpy: boolean }} Scope what names stand for */

/**
 * A number as a reader types it: a decimal, also by a true minus sign, or a fraction of two.
 * @param {string} text
 * @returns {number} NaN of what is none
 */
export function numberOf(text) {
  const [above, below, more] = text
    .trim()
    .replace(/[−–]/g, '-')
    .split('/')
    .map((part) => part.trim())
  if (more !== undefined || !NUMBER.test(above)) return NaN
  // A number too small for a double would be zero without a word.
  if (Number(above) === 0 && /[1-9]/.test(above.replace(/e.*/i, ''))) return NaN
  if (below === undefined) return Number(above)
  return NUMBER.test(below) && Number(below) !== 0 ? Number(above) / Number(below) : NaN
}

/** What is wrong with a text that is no number. @param {string} text */
export function faultOf(text) {
  const word = text.trim()
  if (word === '') return 'a number is missing.'
  const instead = /^[-+−]?\d*,\d+$/.test(word) ? ` Write ${word.replace(',', '.')}.` : ''
  return `“${word.slice(0, 20)}” is not a number.${instead}`
}

/** Numbers like 0,5 are two numbers here. @param {string} text */
export const hintOf = (text) =>
  /\d,\d/.test(text) && !/\d\.\d|,\s|\[\s*\[/.test(text) ? ' A comma stands between numbers: write 0.5 for 0,5.' : ''

/** @param {number[][]} m */
export const transposed = (m) => m[0].map((_, j) => m.map((row) => row[j]))

/** @param {number[][]} m */
const isScalar = (m) => m.length === 1 && m[0].length === 1

/**
 * The value behind `name =`: a matrix in brackets or without, `eye(2)` and its like, sums, products and transposes of
 * these, and what was given before.
 */
export class Value {
  /** @param {string} text @param {string} name @param {Scope} [scope] */
  constructor(text, name, scope = { get: () => undefined, numpy: false }) {
    this.name = name
    this.rest = text
    this.scope = scope
  }

  /** @param {RegExp} pattern @returns {RegExpExecArray | null} */
  take(pattern) {
    const match = pattern.exec(this.rest)
    if (match) this.rest = this.rest.slice(match[0].length)
    return match
  }

  read() {
    // As MATLAB prints a matrix: rows of numbers below the name, and above them a factor of all, if there is one.
    const printed = this.take(
      /^[^\S\n]*\n\s*(?:([-+.\deE]+)\s*\*[^\S\n]*\n\s*)?(?=[-+.\d])((?:[-+.\deE \t]+(?:\n|$))+)/,
    )
    if (printed) {
      const factor = printed[1] === undefined ? 1 : this.entry(printed[1], 1, 1)
      return this.rows(printed[2].trim().split('\n')).map((row) => row.map((entry) => factor * entry))
    }
    const value = this.sum()
    // Behind a value stands its end, or the next name.
    if (!/^[^\S\n]*(?:$|[\n;,})]|(["']?)[A-Za-z]\w*\1\s*[:=](?!=))/.test(this.rest)) this.refuse(this.rest)
    return value
  }

  /** @param {string} words @returns {never} */
  refuse(words) {
    throw new Fault(
      `${this.name}: “${words.trim().split('\n')[0].slice(0, 20)}” is not understood here; write ` +
        'the numbers that come of it.',
    )
  }

  /** @returns {number[][]} */
  sum() {
    let value = this.product()
    for (let sign; (sign = this.take(/^[^\S\n]*\.?([-+])(?!=)\s*/)?.[1]); ) {
      const next = this.product()
      if (next.length !== value.length || next[0].length !== value[0].length) this.refuse(sign)
      const by = sign === '-' ? -1 : 1
      value = value.map((row, i) => row.map((entry, j) => entry + by * next[i][j]))
    }
    return value
  }

  /** @returns {number[][]} */
  product() {
    let value = this.factor()
    for (let sign; (sign = this.take(/^[^\S\n]*(\.?[*/@])(?![*/=])\s*/)?.[1]); ) {
      const next = this.factor()
      if (isScalar(next) && sign !== '@') {
        const by = sign.endsWith('/') ? 1 / next[0][0] : next[0][0]
        if (!Number.isFinite(by)) this.refuse(`${sign} ${next[0][0]}`)
        value = value.map((row) => row.map((entry) => (sign.endsWith('/') ? entry / next[0][0] : entry * by)))
      } else if (isScalar(value) && /^\.?\*$/.test(sign)) {
        const [[by]] = value
        value = next.map((row) => row.map((entry) => by * entry))
      } else value = this.matrices(value, next, sign)
    }
    return value
  }

  /**
   * The product of two matrices. With numpy, `*` multiplies entry by entry, and `@` does this.
   * @param {number[][]} one @param {number[][]} other @param {string} sign
   */
  matrices(one, other, sign) {
    if (sign !== '@' && (sign !== '*' || this.scope.numpy)) this.refuse(sign)
    if (one[0].length !== other.length)
      throw new Fault(`${this.name}: a ${one.length} × ${one[0].length} and a ${other.length} × ${other[0].length} \
matrix have no product.`)
    return one.map((row) => other[0].map((_, j) => row.reduce((sum, entry, k) => sum + entry * other[k][j], 0)))
  }

  /** @returns {number[][]} */
  factor() {
    this.take(/^\s+/)
    const minus = this.take(/^[-−–]\s*(?![\d.])/)
    let value = this.made() ?? (this.rest.startsWith('[') ? this.bracketed() : (this.known() ?? this.scalar()))
    while (this.take(/^(?:\.?'|\.T\b|\.transpose\(\))/)) value = transposed(value)
    const power = this.take(/^[^\S\n]*\.?(?:\^|\*\*)\s*(-?[\w.]+|\([^()\n]*\))/)
    if (power) {
      const by = this.number(power[1])
      if (!isScalar(value) || !Number.isFinite(by)) this.refuse(power[0])
      value = [[value[0][0] ** by]]
    }
    return minus ? value.map((row) => row.map((entry) => -entry)) : value
  }

  /** A matrix that was given before. */
  known() {
    const name = /^(?:[A-Za-z_]\w*\.(?!T\b|transpose\b))*([A-Za-z_]\w*)(?!\s*[\w(])/.exec(this.rest)
    const value = name ? this.scope.get(name[1]) : undefined
    if (!name || !value || isScalar(value)) return null
    this.rest = this.rest.slice(name[0].length)
    return value.map((row) => [...row])
  }

  /**
   * `np.array([…])`, `eye(2)`, `diag([1 2])`, `zeros(2, 1)` or `(…)`; null where nothing of the kind stands.
   * @returns {number[][] | null}
   */
  made() {
    const call = this.take(/^(?:(np|numpy|jnp)\.)?(array|matrix|asarray|mat|eye|identity|diag|zeros|ones)?\s*\(\s*/)
    if (!call) return null
    const [, numpy, kind = ''] = call
    if (/eye|identity|zeros|ones/.test(kind)) return this.filled(kind, numpy !== undefined)
    const inner = this.sum()
    if (!this.take(/^\s*(?:,\s*dtype\s*=\s*[\w.]+\s*)?,?\s*\)/)) {
      if (this.rest.includes(')')) this.refuse(this.rest)
      throw new Fault(`${this.name}: a bracket is not closed.`)
    }
    if (kind !== 'diag') return inner
    const entries = inner.flat()
    if (inner.length > 1 && inner[0].length > 1) this.refuse('diag')
    return entries.map((entry, i) => entries.map((_, j) => (i === j ? entry : 0)))
  }

  /** @param {string} kind @param {boolean} numpy */
  filled(kind, numpy) {
    const size = /\s*(\w+)(?:\s*,\s*(\w+))?\s*/.source
    const before = this.rest
    const sizes = this.take(new RegExp(`^\\(${size},?\\s*\\)\\s*\\)`)) ?? this.take(new RegExp(`^${size}\\)`))
    const count = (/** @type {string} */ text) => {
      const value = this.number(text)
      if (!Number.isInteger(value) || value > MOST) this.refuse(`${kind}(${before.slice(0, 8)}`)
      return value
    }
    if (!sizes) this.refuse(`${kind}(${before.slice(0, 8)}`)
    const square = kind === 'eye' || kind === 'identity'
    const first = count(sizes[1])
    // In numpy one size makes a row of numbers.
    const [rows, columns] = sizes[2] ? [first, count(sizes[2])] : numpy && !square ? [1, first] : [first, first]
    if (rows < 1 || columns < 1) throw new Fault(`${this.name} is empty.`)
    return Array.from({ length: rows }, (_, i) =>
      Array.from({ length: columns }, (_, j) => (kind === 'ones' || (square && i === j) ? 1 : 0)),
    )
  }

  scalar() {
    // A call or a name; else a number ends where a factor or a transpose begins, and a fraction of two is one number.
    const call = this.take(/^[-+−–]?(?:[A-Za-z_]\w*\.)*[A-Za-z_]\w*(?:\s*\([^()\n]*(?:\([^()\n]*\)[^()\n]*)*\))?/)
    const word = call ?? this.take(/^[^\s,;(){}\]*'/^@]*(?:\/(?=[-+.\d])[^\s,;(){}\]*'/^@]*)?/)
    return [[this.entry(word?.[0] ?? '', 1, 1)]]
  }

  bracketed() {
    let depth = 0
    let end = 0
    for (; end < this.rest.length; end += 1) {
      if (this.rest[end] === '[') depth += 1
      if (this.rest[end] === ']' && (depth -= 1) === 0) break
    }
    if (depth !== 0) throw new Fault(`${this.name}: a bracket is not closed.`)
    const inner = this.rest.slice(1, end)
    this.rest = this.rest.slice(end + 1)
    const nested = inner.includes('[')
    // Two rows side by side are one row in MATLAB, and two in numpy only with a comma or on two lines.
    const beside = /\][^\S\n]*\[/.test(inner)
    if (nested && (beside || inner.replace(/\[[^[\]]*\]/g, '').replace(/[\s,;]/g, '') !== ''))
      throw new Fault(`${this.name} is not a list of rows.`)
    return this.rows(
      nested
        ? [...inner.matchAll(/\[([^[\]]*)\]/g)].map(([, line]) => line)
        : inner.split(/;|\n/).filter((line) => line.trim() !== ''),
    )
  }

  /** @param {string[]} lines */
  rows(lines) {
    const rows = lines.map((line, i) => entriesOf(line).map((word, j) => this.entry(word, i + 1, j + 1)))
    if (rows.length === 0) throw new Fault(`${this.name} is empty.`)
    const uneven = rows.findIndex((row) => row.length !== rows[0].length)
    if (uneven > 0)
      throw new Fault(
        `${this.name}: row ${uneven + 1} has ${rows[uneven].length} ` +
          `${rows[uneven].length === 1 ? 'number' : 'numbers'}, row 1 has ${rows[0].length}.${hintOf(lines.join(';'))}`,
      )
    return rows
  }

  /** @param {string} text */
  number(text) {
    return scalarOf(text, (name) => {
      const value = this.scope.get(name)
      return value && isScalar(value) ? value[0][0] : undefined
    })
  }

  /** @param {string} word @param {number} row @param {number} column */
  entry(word, row, column) {
    const number = this.number(word)
    if (!Number.isFinite(number)) throw new Fault(`${this.name}, row ${row}, column ${column}: ${faultOf(word)}`)
    return number
  }
}
