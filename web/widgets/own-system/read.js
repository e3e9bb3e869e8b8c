/**
 * Reads a system that was pasted: JSON, MATLAB or numpy notation. Nothing is passed over in silence: what is not
 * understood is a fault with its line, and what is of no use here is named.
 *
 *   {"F": [[1, 0.5], [0, 1]], …}      F = [1 0.5; 0 1]      F = np.array([[1, 0.5], [0, 1]])      V = 0.01 * eye(2)
 *   F = eye(2); F(1,2) = 0.5          F = np.eye(2)         F[0, 1] = 0.5
 */

import { Fault, Value, hintOf, transposed } from './value.js'

export { faultOf, numberOf } from './value.js'

const NAMES = ['F', 'G', 'H', 'V', 'W']
const MOST = 4
const MEANT = /** @type {Record<string, string>} */ ({
  F: 'the dynamics',
  H: 'what a reading tells',
  V: 'the noise of the motion',
  W: 'the noise of a reading',
})
/** Letters that other books have for what is here F, G, H, V and W. */
const ELSEWHERE = ['A', 'B', 'C', 'Q', 'R']
const TRANSLATED =
  'What is called A, B and C elsewhere is F, G and H here; V and W are the covariances of the motion and of a reading.'

/** So much is read while the reader types; the largest system with all its digits is a tenth of it. */
const MOST_LETTERS = 20_000
const TOO_LONG = `The text has more than ${MOST_LETTERS.toLocaleString('en')} letters. Paste the system alone.`
const EXPECTED = 'Write F = …, G = …, H = …, V = …, W = …, in JSON, MATLAB or numpy notation.'

/** What may stand between matrices and says nothing of them: marks of structure, a prompt, a line that sets up. */
const BETWEEN = [
  /^[\s;,{}()]+/,
  /^(?:>>>?|In \[\d+\]:)\s*/,
  /^(?:import|from\s+[\w.]+\s+import)\s[^\n;]*/,
  /^(?:clear|clearvars|clc|close|format|hold|more)\b(?:[^\S\n]+(?:all|compact|long|on|off))?(?=\s*[\n;]|\s*$)/,
  /^(?:disp|print|console\.log)\s*\([^()\n]*\)/,
  /^(?:const|let|var|export|return)\s+(?=[A-Za-z_"'{])/,
]
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

/** @typedef {{ F: number[][], G: number[][], H: number[][], V: number[][], W: number[][] }} Matrices */
/** @typedef {{ ok: true, system: Matrices, unused: string[] } | { ok: false, fault: string, line: number }} Read */

/**
 * @param {string} text
 * @returns {Read} `line` is 0 where the fault is in no line; `unused` are names that were given and are not needed
 */
export function readSystem(text) {
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
  const paste = new Paste(withoutComments(text))
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
  /** @param {string} text */
  constructor(text) {
    this.text = text
    this.at = 0
    /** The line where the present statement begins, counted from 1; 0 behind the last. */
    this.line = 1
    /** @type {Record<string, { matrix: number[][], line: number, from: 0 | 1 }>} `from`: what `[ ]` count from */
    this.found = {}
    /** @type {string[]} */
    this.unused = []
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
    return { system: this.checked(), unused: [...new Set(this.unused)] }
  }

  statement() {
    if (DOES.test(this.rest)) throw this.notUnderstood(this.rest)
    const entry = this.take(ENTRY)
    if (entry) return this.entry(entry)
    const named = this.take(NAME)
    if (!named) throw this.notUnderstood(this.rest)
    const [, , name] = named
    if (NAMES.includes(name)) {
      if (this.found[name]) throw new Fault(`${name} is given twice.`)
      const from = ROWS_IN_ONE.test(this.rest) ? 1 : 0
      this.found[name] = { matrix: this.value(name), line: this.line, from }
    } else if (!this.take(OPENS)) {
      this.unused.push(name)
      this.skip()
    }
  }

  /** @param {string} name */
  value(name) {
    const value = new Value(this.rest, name)
    const matrix = value.read()
    this.at = this.text.length - value.rest.length
    return matrix
  }

  /** @param {RegExpExecArray} found */
  entry([words, name, ...indices]) {
    if (this.unused.includes(name)) return this.skip()
    if (!this.found[name]) throw this.notUnderstood(words)
    const { matrix, from } = this.found[name]
    const [row, column] = (indices[0] ? indices.slice(0, 2) : indices.slice(2)).map(
      (i) => Number(i) - (indices[0] ? 1 : from),
    )
    if (matrix[row]?.[column] === undefined)
      throw new Fault(`${words.replace(/\s*=$/, '')}: ${name} is ${matrix.length} × ${matrix[0].length}.`)
    const given = this.value(name)
    if (given.length !== 1 || given[0].length !== 1) throw this.notUnderstood(words)
    matrix[row][column] = given[0][0]
  }

  /** Goes behind a value that is not needed: to the end of its line or of its part, but not within brackets. */
  skip() {
    let depth = 0
    const marks = /"(?:[^"\\\n]|\\.)*"|(?<=[\s=([{,:])'[^'\n]*'|[[\](){}\n;,]/g
    for (const { 0: mark, index } of this.rest.matchAll(marks)) {
      if ('[({'.includes(mark)) depth += 1
      else if (depth > 0 && '])}'.includes(mark)) depth -= 1
      else if (depth === 0 && mark.length === 1) {
        this.at += index
        return
      }
    }
    if (depth > 0) throw new Fault('A bracket is not closed.')
    this.at = this.text.length
  }

  /** @param {string} words */
  notUnderstood(words) {
    const [line] = words.trim().split(/[\n\v]/)
    return new Fault(`“${line.slice(0, 30)}” is not understood here; write each matrix as NAME = its numbers.`)
  }

  /** The matrices, if they fit one another. @returns {Matrices} */
  checked() {
    const { text } = this
    const found = Object.fromEntries(Object.entries(this.found).map(([name, { matrix }]) => [name, matrix]))
    const elsewhere = this.unused.filter((name) => ELSEWHERE.includes(name))
    if (Object.keys(found).length === 0)
      throw new Fault(`No matrix was found. ${elsewhere.length ? TRANSLATED : EXPECTED}`)
    for (const [name, meant] of Object.entries(MEANT))
      if (!found[name]) throw new Fault(`${name}, ${meant}, is missing.${elsewhere.length ? ` ${TRANSLATED}` : ''}`)
    if (!found.G && this.unused.includes('B')) throw new Fault(`B is given and G is not. ${TRANSLATED}`)
    const n = found.F.length
    // In numpy a row of numbers has no direction: it is taken as the one that fits.
    if (found.G?.length === 1 && n > 1 && found.G[0].length === n) found.G = transposed(found.G)
    const p = found.H.length
    const m = found.G?.[0]?.length ?? 0
    const sizes = /** @type {Record<string, [number, number]>} */ ({
      F: [n, n],
      G: [n, m],
      H: [p, n],
      V: [n, n],
      W: [p, p],
    })
    for (const name of NAMES.filter((each) => found[each])) {
      this.line = this.found[name].line
      const [rows, columns] = [found[name].length, found[name][0].length]
      if (rows > MOST || columns > MOST)
        throw new Fault(`${name} is ${rows} × ${columns}; at most ${MOST} × ${MOST} are shown here.${hintOf(text)}`)
      const [height, width] = sizes[name]
      const why =
        name === 'F'
          ? 'it has to be square'
          : `with F ${n} × ${found.F[0].length} and H ${p} × ${found.H[0].length} it needs to be ${height} × ${width}`
      if (rows !== height || columns !== width)
        throw new Fault(`${name} is ${rows} × ${columns}; ${why}.${hintOf(text)}`)
    }
    return /** @type {any} */ ({ G: found.F.map(() => []), ...found })
  }
}
