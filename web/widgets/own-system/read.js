/**
 * Reads a system that was pasted: JSON, MATLAB or numpy notation. Nothing is passed over in silence: what is not
 * understood is a fault with its line, and what is of no use here is named.
 *
 *   {"F": [[1, 0.5], [0, 1]], …}      F = [1 0.5; 0 1]      F = np.array([[1, 0.5], [0, 1]])      V = 0.01 * eye(2)
 *   F = eye(2); F(1,2) = 0.5          F = np.eye(2)         F[0, 1] = 0.5
 */

import { isInput, isMatrix, isStepwise, ofStep } from './called.js'
import { ENTRY, countsFrom, partOf, setPart } from './entry.js'
import { restOrComment, withoutComments } from './comments.js'
import { Expression, OF_R } from './expression.js'
import { Given, isStart } from './given.js'
import { spreadOf, systemOf } from './letters.js'
import { Fault, begun } from './number.js'
import { changed } from './operators.js'
import { THROUGH, isStep } from './sampling.js'

export { faultOf, numberOf } from './number.js'

/** So much is read while the reader types; the largest system with all its digits is a tenth of it. */
const MOST_LETTERS = 20_000
const TOO_LONG = `The text has more than ${MOST_LETTERS.toLocaleString('en')} letters. Paste the system alone.`

/** What may stand between matrices and says nothing of them: marks of structure, a prompt, a line that sets up. */
const BETWEEN = [
  /^[\s;,{}()]+/,
  /^(?:>>>?|In \[\d+\]:)\s*/,
  /^(?:import|using|from\s+[\w.]+\s+import)\s[^\n;]*/,
  /^(?:clear|clearvars|clc|close|format|hold|more)\b(?:[^\S\n]+(?:all|compact|long|on|off))?(?=\s*[\n;]|\s*$)/,
  /^(?:disp|print|console\.log|np\.set_printoptions)\s*\([^()\n]*\)/,
  /^(?:const|let|var|export|return)\s+(?=[A-Za-z_"'{])/,
]
/** Systems, and how they are sampled. */
const SPACE = /^(?:\[[\w\s,~]*\]|[A-Za-z_]\w*)\s*=\s*(?:[A-Za-z_]\w*\.)*(?:ss|StateSpace)\s*(?=\()/
const SAMPLED = new RegExp(
  /^(?:(?:\[[\w\s,~]*\]\s*|[\w\s,]+)=\s*)?(?:[A-Za-z_]\w*\.)*/.source +
    /(?:c2d|cont2discrete|sample_system|to_discrete|sample)\s*(?=\()/.source,
)
/** `P *= 1000`, as filterpy's users write it, and its like. */
const CHANGE = /^(?:[A-Za-z_]\w*\.)*([A-Za-z_]\w*)\s*\.?([-+*/@])=(?!=)\s*/
/** `continuous`, `continuous = true`, `"discrete": false`, as a line of its own. */
const TIME = new RegExp(
  /^(["']?)(continuous|discrete)(?:[ _-]?time)?\1(?:\s*[:=]\s*(true|false|[01]))?/.source +
    /(?=[^\S\n]*(?:[;\n,)}]|$))/.source,
  'i',
)
/** Several values of one call. */
const SEVERAL = /^\[?\s*([A-Za-z_]\w*(?:\s*,\s*[A-Za-z_~]\w*)+)\s*\]?\s*=(?!=)(?=\s*[A-Za-z_][\w.]*\s*\()/
const THROUGH_NAMES = ['D', 'Dd', 'D_d']
const NAME_ALONE = /^\s*((?:[A-Za-z_]\w*\.)*)([A-Za-z_]\w*)[^\S\n]*(?=[;\n]|$)/
/** No input at all. */
const NONE = /^\s*(?:\[\s*\]|None|null|nothing)(?=[^\S\n]*(?:[;\n,)}]|$))/
/** The same value as another name's. */
const SAME = /^\s*([A-Za-z_]\w*)(?:\.[A-Za-z]\w*)?[^\S\n]*(?=[;\n,]|$)/
/** What begins a statement that does more than give a value. */
const DOES = /^(?:class|def|do|elif|else|elseif|end|except|finally|for|from|function|if|try|while|with)\b/
/** The name of what is given, perhaps of an object's part: `F =`, `"F":`, `kf.F =`. */
const NAME = /^(?:[A-Za-z_]\w*\.)*(["']?)([A-Za-z_]\w*)\1\s*[:=](?!=)/
/** What opens a list of matrices: `dict(`, `KalmanFilter(`. */
const OPENS = /^\s*[A-Za-z_][\w.]*\s*\(\s*(?=["']?[A-Za-z_]\w*["']?\s*[:=](?!=))/

/**
 * @typedef {{ F: number[][], G: number[][], H: number[][], V: number[][], W: number[][] }} Matrices
 * @typedef {Matrices & { period?: number, continuous?: boolean, spread?: number[] }} System
 * @typedef {import('./letters.js').Places} Places
 * @typedef {import('./letters.js').Noises} Noises
 * @typedef {{ ok: true, system: System, unused: string[], as: string, noises: Noises | null, places: Places,
 *   variables: string[], held: string }} Good `as`: which letters were read as which; `variables`: what is in the
 *   formulas of others alone; `held`: what was read as G beside an F that is computed for a step, and is not
 * @typedef {Good | { ok: false, fault: string, line: number }} Read
 */

/**
 * @param {string} text
 * @param {import('./letters.js').Motion} [motion] of Q and R the noise of the motion, where their sizes do not tell
 * @returns {Read} `line` is 0 where the fault is in no line; `unused` are names that were given and are not needed
 */
export function readSystem(text, motion = 'Q') {
  if (text.length > MOST_LETTERS) return { ok: false, fault: TOO_LONG, line: 0 }
  const unsure = restOrComment(text)
  if (unsure) return { ok: false, ...unsure }
  const paste = new Paste(withoutComments(text), motion)
  try {
    return { ok: true, ...paste.system() }
  } catch (error) {
    if (!(error instanceof Fault)) return { ok: false, fault: 'The text could not be read.', line: 0 }
    return { ok: false, fault: error.message, line: paste.given.line }
  }
}

/** A text that is read from its beginning to its end. */
class Paste {
  /** @param {string} text @param {import('./letters.js').Motion} motion */
  constructor(text, motion) {
    this.text = text
    this.motion = motion
    this.at = 0
    this.given = new Given(text)
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
      this.given.line = 1 + (this.text.slice(0, this.at).match(/[\n\v]/g)?.length ?? 0)
      if (this.at === this.text.length) break
      this.statement()
    }
    this.given.line = 0
    return this.whole()
  }

  statement() {
    if (DOES.test(this.rest)) throw this.notUnderstood(this.rest)
    if (/^[A-Za-z_.][\w.]*\s*<-/.test(this.rest)) throw new Fault(OF_R)
    const space = this.take(SPACE)
    const call = space ?? this.take(SAMPLED)
    if (call) {
      this.given.sampling[space ? 'space' : 'sample'](this.skip())
      return this.given.sampling.makes(call[0])
    }
    const time = this.take(TIME)
    if (time)
      return this.given.sampling.says((time[2].toLowerCase() === 'continuous') !== /^(?:false|0)$/i.test(time[3]))
    const several = SEVERAL.exec(this.rest)?.[1].match(/\w+/g) ?? []
    if (several.length > 0 && !several.some((name) => isMatrix(name) || isStep(name))) {
      this.take(SEVERAL)
      this.skip()
      return void this.given.unused.push(...several)
    }
    const entry = this.take(ENTRY)
    if (entry) return this.entry(entry)
    const change = this.take(CHANGE)
    if (change) return this.change(change[1], change[2])
    const named = this.take(NAME)
    if (!named) throw this.notUnderstood(this.rest)
    const { given } = this
    const [words, , name] = named
    const [, object] = /^([A-Za-z_]\w*)\./.exec(words) ?? []
    if (object) given.objects.add(object)
    const same = SAME.exec(this.rest)
    if (isInput(name) && this.take(NONE)) return
    if (isMatrix(name)) {
      // What c2d makes is made here of what it is given.
      if (same && given.sampling.made.has(same[1])) return void (this.at += same[0].length)
      const from = countsFrom(this.rest, given.scope.numpy)
      given.matrix(name, this.value(name), from)
    } else if (!this.take(OPENS)) this.other(name)
  }

  /** What is none of the matrices: a name for a number or a matrix, if it is one. @param {string} name */
  other(name) {
    const { given } = this
    const before = this.at
    given.unused = given.unused.filter((each) => each !== name)
    try {
      const from = countsFrom(this.rest, given.scope.numpy)
      given.set(name, this.value(name), from)
      if (given.start?.name === name) return
    } catch (error) {
      const number = isStep(name) && /^\s*[-+.\d]/.test(this.text.slice(before))
      if (!(error instanceof Fault) || number) throw error
      this.at = before
      this.skip()
    }
    given.unused.push(name)
  }

  /** @param {string} name @param {string} sign */
  change(name, sign) {
    const before = this.given.before(name, sign)
    this.given.change(
      name,
      this.value(name, (by) => changed(before, by, sign, this.given.scope)),
    )
  }

  /** @param {string} name @param {(value: number[][]) => number[][]} [then] what is made of it */
  value(name, then) {
    const value = new Expression(this.rest, name, this.given.scope)
    this.given.uses = new Set()
    const [, object, other = ''] = (!then && NAME_ALONE.exec(this.rest)) || []
    const alone = other !== 'T' && this.given.scope.numpy
    const read = value.read(then)
    // In numpy two names may be of one matrix: what is set in the one is set in the other.
    const matrix = (alone && other && this.given.get(other, object ?? '')) || read
    this.at = this.text.length - value.rest.length
    return matrix
  }

  /** @param {RegExpExecArray} first */
  entry(first) {
    const { given } = this
    const all = [first]
    for (let more; (more = this.take(ENTRY)); ) all.push(more)
    const before = this.at
    try {
      this.parts(all)
    } catch (error) {
      // Of what is none of the matrices nothing is known any more.
      const known = all.every(([, name]) => given.values.has(name) || given.unused.includes(name))
      if (!(error instanceof Fault) || !known || all.some(([, name]) => isStart(name))) throw error
      this.at = before
      this.skip()
      for (const [, name] of all) given.forget(name)
    }
  }

  /** @param {RegExpExecArray[]} all */
  parts(all) {
    const parts = all.map((found) => {
      const of = this.given.partly(found[1])
      if (!of) throw this.notUnderstood(found[0])
      return { ...of, part: partOf(found, of.matrix, of.from) }
    })
    const value = this.value(all[0][1])
    for (const { matrix, part, uses } of parts) {
      setPart(matrix, part, value)
      for (const name of this.given.uses) uses.add(name)
    }
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
    const { given } = this
    const at = (/** @type {number} */ line) => void (given.line = line)
    given.weigh(this.text)
    const { system: matrices, of, idle, ...words } = systemOf(given.found, this.text, this.motion, at)
    const system = /** @type {System} */ (matrices)
    const through = THROUGH_NAMES.flatMap((name) => given.values.get(name)?.flat() ?? [])
    if (through.some((entry) => entry !== 0)) throw new Fault(THROUGH)
    const stepwise = ofStep(given.found, of.F)
    const { continuous, period, name } = given.sampling.answer(String(of.F), stepwise)
    const ofOne = [of.G, of.V].find((each) => each && isStepwise(each))
    if (continuous && ofOne) {
      at(given.found[ofOne].line)
      throw new Fault(`${ofOne} is of one step, and ${of.F} of continuous time: write both of one.`)
    }
    if (period !== undefined) system.period = period
    if (continuous) system.continuous = true
    const unused = [...given.unused, ...idle].filter((each) => ![...THROUGH_NAMES, name].includes(each))
    if (given.start) {
      at(given.start.line)
      system.spread = spreadOf(given.start.matrix, system.F.length, given.start.name)
      at(0)
    }
    const beside = stepwise && ['F', 'A'].some((name) => name !== of.F && given.found[name])
    const held = of.G && /^[BG]$/.test(of.G) && beside ? of.G : ''
    const computed = held && [...given.found[held].uses].some((each) => isStep(each) || isMatrix(each))
    return { system, ...words, held: computed ? '' : held, unused: [...new Set(unused)] }
  }
}
