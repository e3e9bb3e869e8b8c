/** Numbers as they are written in programs: `T^2/2`, `-2*pi*f`, `sqrt(q)`, with names that were given before. */

const NUMBER = /^(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?/i

/** @type {Record<string, number>} */
const CONSTANTS = { pi: Math.PI }
/** @type {Record<string, (x: number) => number>} */
const FUNCTIONS = {
  sqrt: Math.sqrt,
  exp: Math.exp,
  log: Math.log,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  abs: Math.abs,
  deg2rad: (x) => (x * Math.PI) / 180,
  radians: (x) => (x * Math.PI) / 180,
  float: Number,
}

/** @typedef {(name: string) => number | undefined} Names what a name stands for, and notes that it was of use */

/** A scalar that is being read. */
class Scalar {
  /** @param {string} text @param {Names} names */
  constructor(text, names) {
    this.rest = text
    this.names = names
  }

  /** @param {RegExp} pattern @returns {string | undefined} what the pattern's bracket holds, or all of it */
  take(pattern) {
    const match = pattern.exec(this.rest)
    if (match) this.rest = this.rest.slice(match[0].length)
    return match ? (match[1] ?? match[0]) : undefined
  }

  /** @returns {number} */
  sum() {
    let value = this.product()
    for (let sign; (sign = this.take(/^\s*([-+])/)); ) value += (sign === '-' ? -1 : 1) * this.product()
    return value
  }

  /** @returns {number} */
  product() {
    let value = this.signed()
    for (let sign; (sign = this.take(/^\s*(\.?[*/])(?![*/])/)); ) {
      const next = this.signed()
      value = sign.endsWith('*') ? value * next : next === 0 ? NaN : value / next
    }
    return value
  }

  /** @returns {number} */
  signed() {
    const sign = this.take(/^\s*([-+])/)
    if (sign) return (sign === '-' ? -1 : 1) * this.signed()
    const base = this.factor()
    return this.take(/^\s*\.?(?:\^|\*\*)/) === undefined ? base : base ** this.signed()
  }

  /** @returns {number} */
  factor() {
    this.take(/^\s+/)
    const digits = this.take(NUMBER)
    if (digits !== undefined) {
      // A number too small for a double would be zero without a word.
      const lost = Number(digits) === 0 && /[1-9]/.test(digits.replace(/e.*/i, ''))
      return lost ? NaN : Number(digits)
    }
    const name = this.take(/^(?:(?:np|numpy|math|jnp)\.)?([A-Za-z_]\w*)/)
    const open = this.take(/^\s*\(/) !== undefined
    if (open) {
      const inner = this.sum()
      if (this.take(/^\s*\)/) === undefined) return NaN
      if (name === undefined) return inner
      return Object.hasOwn(FUNCTIONS, name) ? FUNCTIONS[name](inner) : NaN
    }
    if (name === undefined) return NaN
    return this.names(name) ?? (Object.hasOwn(CONSTANTS, name) ? CONSTANTS[name] : NaN)
  }
}

/**
 * The number that a text stands for; NaN of what is none.
 * @param {string} text @param {Names} names
 */
export function scalarOf(text, names) {
  const scalar = new Scalar(text.replace(/[−–]/g, '-'), names)
  const value = scalar.sum()
  return scalar.rest.trim() === '' ? value : NaN
}

/**
 * A row's entries. They stand between commas or blanks; `[1 -T]` are two, and `[1 - T]` is one, as in MATLAB.
 * @param {string} line
 */
export function entriesOf(line) {
  const all = []
  let [word, depth] = ['', 0]
  const text = line.trim().replace(/\s*,$/, '')
  for (let i = 0; i < text.length; i += 1) {
    const letter = text[i]
    if ('(['.includes(letter)) depth += 1
    if (')]'.includes(letter)) depth -= 1
    if (depth > 0 || !/[\s,]/.test(letter)) {
      word += letter
      continue
    }
    const gap = /^\s*,?\s*/.exec(text.slice(i))?.[0] ?? letter
    const next = text.slice(i + gap.length)
    const goesOn =
      !gap.includes(',') && (/[-+*/^]$/.test(word) ? !/e[-+]$/i.test(word) : /^(?:\.?[*/^]|[-+]\s)/.test(next))
    if (goesOn) word += ' '
    else {
      all.push(word)
      word = ''
    }
    i += gap.length - 1
  }
  return [...all, word]
}
