/**
 * Reads a system that was pasted: JSON, MATLAB or numpy notation. Nothing is passed over in silence: what is not
 * understood is a fault with its line, and what is of no use here is named.
 *
 *   {"F": [[1, 0.5], [0, 1]], …}      F = [1 0.5; 0 1]      F = np.array([[1, 0.5], [0, 1]])      V = 0.01 * eye(2)
 *   F = eye(2); F(1,2) = 0.5          F = np.eye(2)         F[0, 1] = 0.5
 */

import { Expression } from './expression.js'
import { LETTERS, spreadOf, systemOf } from './letters.js'
import { Fault, begun } from './number.js'
import { Sampling, THROUGH, isStep } from './sampling.js'

export { faultOf, numberOf } from './number.js'

/** So much is read while the reader types; the largest system with all its digits is a tenth of it. */
const MOST_LETTERS = 20_000
const TOO_LONG = `The text has more than ${MOST_LETTERS.toLocaleString('en')} letters. Paste the system alone.`
/** What the covariance of the start is called. */
const START = /^(?:P|P0|P_0|P00|Sigma0)$/

/** What may stand between matrices and says nothing of them: marks of structure, a prompt, a line that sets up. */
const BETWEEN = [
  /^[\s;,{}()]+/,
  /^(?:>>>?|In \[\d+\]:)\s*/,
  /^(?:import|from\s+[\w.]+\s+import)\s[^\n;]*/,
  /^(?:clear|clearvars|clc|close|format|hold|more)\b(?:[^\S\n]+(?:all|compact|long|on|off))?(?=\s*[\n;]|\s*$)/,
  /^(?:disp|print|console\.log)\s*\([^()\n]*\)/,
  /^(?:const|let|var|export|return)\s+(?=[A-Za-z_"'{])/,
]
/** Systems, and how they are sampled. */
const SPACE = /^(?:\[[\w\s,~]*\]|[A-Za-z_]\w*)\s*=\s*(?:[A-Za-z_]\w*\.)*(?:ss|StateSpace)\s*(?=\()/
const SAMPLED = new RegExp(
  /^(?:(?:\[[\w\s,~]*\]|[\w\s,]+?)\s*=\s*)?(?:[A-Za-z_]\w*\.)*/.source +
    /(?:c2d|cont2discrete|sample_system|to_discrete|sample)\s*(?=\()/.source,
)
/** `P *= 1000`, as filterpy's users write it. */
const TIMES = /^(?:[A-Za-z_]\w*\.)*([A-Za-z_]\w*)\s*\*=\s*/
/** What begins a statement that does more than give a value. */
const DOES = /^(?:class|def|do|elif|else|elseif|end|except|finally|for|from|function|if|try|while|with)\b/
/** The name of what is given, perhaps of an object's part: `F =`, `"F":`, `kf.F =`. */
const NAME = /^(?:[A-Za-z_]\w*\.)*(["']?)([A-Za-z_]\w*)\1\s*[:=](?!=)/
/** An entry by itself: `F(1,2) =` counts from 1, `F[0, 1] =` and `F[0][1] =` from 0, but in Julia from 1. */
const ENTRY =
  /^(?:[a-z_]\w*\.)*([a-z_]\w*)\s*(?:\(\s*(\d+)\s*,\s*(\d+)\s*\)|\[\s*(\d+)\s*(?:,|\]\s*\[)\s*(\d+)\s*\])\s*=(?!=)/i
/** What opens a list of matrices: `dict(`, `KalmanFilter(`. */
const OPENS = /^\s*[A-Za-z_][\w.]*\s*\(\s*(?=["']?[A-Za-z_]\w*["']?\s*[:=](?!=))/

/** Rows parted by semicolons in one pair of brackets: where its entries have square brackets, that is Julia. */
const ROWS_IN_ONE = /^\s*\[[^[\]]*;[^[\]]*\]/
/** What MATLAB ends with a comment, and Python computes: the rest of a division; not within a comment or a string. */
const REST_OR_COMMENT = /^((?:(?!\/\/|\/\*)[^%#"'\n])*?)(\d[\d.]*[^\S\n]*%[^\S\n]*\d[\d.]*)[^\S\n]*(?=[\n;,)\]]|$)/m

/**
 * @typedef {{ F: number[][], G: number[][], H: number[][], V: number[][], W: number[][] }} Matrices
 * @typedef {Matrices & { period?: number, continuous?: boolean, spread?: number[] }} Given
 * @typedef {import('./letters.js').Places} Places
 * @typedef {import('./letters.js').Noises} Noises
 * @typedef {{ ok: true, system: Given, unused: string[], as: string, noises: Noises | null, places: Places }} Good
 * @typedef {Good | { ok: false, fault: string, line: number }} Read `as`: which letters were read as which
 */

/**
 * @param {string} text
 * @param {import('./letters.js').Motion} [motion] of Q and R the noise of the motion, where their sizes do not tell
 * @returns {Read} `line` is 0 where the fault is in no line; `unused` are names that were given and are not needed
 */
export function readSystem(text, motion = 'Q') {
  if (text.length > MOST_LETTERS) return { ok: false, fault: TOO_LONG, line: 0 }
  const unsure = REST_OR_COMMENT.exec(text)
  if (unsure) {
    const line = text.slice(0, unsure.index).split(/\r\n?|\n/).length
    return {
      ok: false,
      fault: `“${unsure[2]}” is a comment in MATLAB and a rest in Python; write one number.`,
      line,
    }
  }
  const paste = new Paste(withoutComments(text), motion)
  try {
    return { ok: true, ...paste.system() }
  } catch (error) {
    if (!(error instanceof Fault)) return { ok: false, fault: 'The text could not be read.', line: 0 }
    return { ok: false, fault: error.message, line: paste.line }
  }
}

/**
 * Without comments, each line in its place: a line that goes on after `…` is joined to the next by a vertical tab.
 * @param {string} text
 */
function withoutComments(text) {
  const lines = (/** @type {string} */ gone) => gone.replace(/[^\n]/g, '')
  return (
    text
      .replace(/\r\n?/g, '\n')
      .replace(/\v/g, ' ')
      .replace(/^\s*%\{\s*\n[\s\S]*?^\s*%\}.*$/gm, lines)
      // One after the other, as they stand: a mark within a comment or a string begins nothing. 5//2 is no comment.
      .replace(
        /("(?:[^"\\\n]|\\.)*")|\/\*[\s\S]*?\*\/|(?:[%#]|\/\/(?!(?<=\d\/\/)\d)).*$/gm,
        (all, string) => string ?? lines(all),
      )
      // Python's prompt of a line that goes on; elsewhere the same dots join two lines.
      .replace(/^\.\.\.(?=\s)/gm, ' ')
      .replace(/(\.\.\.|…)[^\n]*\n/g, '\v')
  )
}

/** A text that is read from its beginning to its end. */
class Paste {
  /** @param {string} text @param {import('./letters.js').Motion} motion */
  constructor(text, motion) {
    this.text = text
    this.motion = motion
    this.at = 0
    /** The line where the present statement begins, counted from 1; 0 behind the last. */
    this.line = 1
    /** @type {import('./letters.js').Found} */
    this.found = {}
    /** @type {string[]} */
    this.unused = []
    /** What other names stand for. @type {Map<string, number[][]>} */
    this.values = new Map()
    /** @type {{ name: string, matrix: number[][], line: number } | null} */
    this.start = null
    this.scope = {
      numpy: /\b(?:np|numpy|jnp)\.|\barray\(|\b(?:from|import) numpy\b/.test(text),
      get: (/** @type {string} */ name) => {
        this.unused = this.unused.filter((each) => each !== name)
        return this.values.get(name) ?? this.found[name]?.matrix
      },
    }
    this.sampling = new Sampling(this.scope, {
      get: (letters) => letters.map((letter) => this.found[letter]?.matrix).find(Boolean),
      add: (letter, matrix) => void (this.found[letter] = { matrix, line: this.line, from: 1 }),
      leave: (words) => void this.unused.push(words),
    })
  }

  get rest() {
    return this.text.slice(this.at)
  }

  /** @param {RegExp} pattern @returns {RegExpExecArray | null} */
  take(pattern) {
    const match = pattern.exec(this.rest)
    if (match) this.at += match[0].length
    return match
  }

  system() {
    for (;;) {
      while (BETWEEN.some((pattern) => this.take(pattern)));
      this.line = 1 + (this.text.slice(0, this.at).match(/[\n\v]/g)?.length ?? 0)
      if (this.at === this.text.length) break
      this.statement()
    }
    this.line = 0
    return this.whole()
  }

  statement() {
    if (DOES.test(this.rest)) throw this.notUnderstood(this.rest)
    if (this.take(SPACE)) return this.sampling.space(this.skip())
    if (this.take(SAMPLED)) return this.sampling.sample(this.skip())
    const entry = this.take(ENTRY)
    if (entry) return this.entry(entry)
    const times = this.take(TIMES)
    if (times) return this.times(times[1])
    const named = this.take(NAME)
    if (!named) throw this.notUnderstood(this.rest)
    const [, , name] = named
    if (LETTERS.includes(name)) {
      if (this.found[name]) throw new Fault(`${name} is given twice.`)
      const from = ROWS_IN_ONE.test(this.rest) ? 1 : 0
      this.found[name] = { matrix: this.value(name), line: this.line, from }
    } else if (!this.take(OPENS)) this.other(name)
  }

  /** What is none of the matrices: a name for a number or a matrix, if it is one. @param {string} name */
  other(name) {
    const before = this.at
    this.unused = this.unused.filter((each) => each !== name)
    try {
      const matrix = this.value(name)
      this.values.set(name, matrix)
      if (isStep(name) && matrix.flat().length === 1) this.sampling.step(name, matrix[0][0])
      if (START.test(name)) {
        this.start = { name, matrix, line: this.line }
        return
      }
    } catch (error) {
      const number = isStep(name) && /^\s*[-+.\d]/.test(this.text.slice(before))
      if (!(error instanceof Fault) || number) throw error
      this.at = before
      this.skip()
    }
    this.unused.push(name)
  }

  /** `kf.Q *= 0.1`; of the start, which is 1 without a word, also where nothing was given. @param {string} name */
  times(name) {
    const start = START.test(name)
    const of = start ? (this.start?.matrix ?? [[1]]) : this.found[name]?.matrix
    const by = this.value(name)
    if (!of || by.flat().length !== 1) throw this.notUnderstood(`${name} *=`)
    const matrix = of.map((row) => row.map((entry) => entry * by[0][0]))
    if (start) this.start = { name, matrix, line: this.line }
    else this.found[name].matrix = matrix
  }

  /** @param {string} name */
  value(name) {
    const value = new Expression(this.rest, name, this.scope)
    const matrix = value.read()
    this.at = this.text.length - value.rest.length
    return matrix
  }

  /** @param {RegExpExecArray} found */
  entry([words, name, ...indices]) {
    const of = this.start?.name === name ? { matrix: this.start.matrix, from: 0 } : this.found[name]
    if (!of && (this.unused.includes(name) || this.values.has(name))) return void this.skip()
    if (!of) throw this.notUnderstood(words)
    const { matrix, from } = of
    const [row, column] = (indices[0] ? indices.slice(0, 2) : indices.slice(2)).map(
      (i) => Number(i) - (indices[0] ? 1 : from),
    )
    if (matrix[row]?.[column] === undefined)
      throw new Fault(`${words.replace(/\s*=$/, '')}: ${name} is ${matrix.length} × ${matrix[0].length}.`)
    const given = this.value(name)
    if (given.length !== 1 || given[0].length !== 1) throw this.notUnderstood(words)
    matrix[row][column] = given[0][0]
  }

  /** Goes behind a value, which it answers: to the end of its line or of its part, but not within brackets. */
  skip() {
    const before = this.at
    let depth = 0
    const marks = /"(?:[^"\\\n]|\\.)*"|(?<=[\s=([{,:])'[^'\n]*'|[[\](){}\n;,]/g
    for (const { 0: mark, index } of this.rest.matchAll(marks)) {
      if ('[({'.includes(mark)) depth += 1
      else if (depth > 0 && '])}'.includes(mark)) depth -= 1
      else if (depth === 0 && mark.length === 1) {
        this.at += index
        return this.text.slice(before, this.at)
      }
    }
    if (depth > 0) throw new Fault('A bracket is not closed.')
    this.at = this.text.length
    return this.text.slice(before)
  }

  /** @param {string} words */
  notUnderstood(words) {
    const [line] = words.trim().split(/[\n\v]/)
    return new Fault(`“${begun(line, 30)}” is not understood here; write each matrix as NAME = its numbers.`)
  }

  /** The system, if its matrices fit one another. */
  whole() {
    const at = (/** @type {number} */ line) => void (this.line = line)
    const { system, ...words } = systemOf(this.found, this.text, this.motion, at)
    const given = /** @type {Given} */ (system)
    const through = this.values.get('D')
    if (through?.flat().some((entry) => entry !== 0)) throw new Fault(THROUGH)
    const { continuous, period, name } = this.sampling.answer()
    if (period !== undefined) given.period = period
    if (continuous) given.continuous = true
    this.unused = this.unused.filter((each) => each !== 'D' && each !== name)
    if (this.start) {
      this.line = this.start.line
      given.spread = spreadOf(this.start.matrix, system.F.length, this.start.name)
      this.line = 0
    }
    return { system: given, ...words, unused: [...new Set(this.unused)] }
  }
}
