/** Whether a pasted system is of continuous time, and how long its step lasts. */

import { Expression } from './expression.js'
import { CALLED as MATRICES, isMatrix } from './called.js'
import { Fault, begun } from './number.js'

/** What the length of a step is called: by a name that means nothing else before one that may. */
const CALLED = [/^(?:Ts|T_s|dt|delta_t)$/, /^T$/]
const STRING = /^(?:method\s*=\s*)?(["'])(.*)\1$/
const STEP = /^(?:dt|Ts|ts)\s*=\s*(.*)$/

/** What is said of a system whose readings depend on the input. */
export const THROUGH = 'D is not 0: a reading does not depend on the input here.'

/** Whether a name may be that of the length of a step. @param {string} name */
export const isStep = (name) => CALLED.some((called) => called.test(name))

/** What a call is given, parted by its own commas. @param {string} text that begins with its bracket */
function valuesOf(text) {
  const values = ['']
  let depth = 0
  for (const [mark] of text.matchAll(/"[^"\n]*"|'[^'\n]*'(?=\s*[,)])|[\s\S]/g)) {
    if (/^[)\]}]$/.test(mark) && (depth -= 1) === 0) break
    if (mark === ',' && depth === 1) values.push('')
    else if (depth > 0) values[values.length - 1] += mark
    if (/^[([{]$/.test(mark)) depth += 1
  }
  return values.map((value) => value.trim()).filter(Boolean)
}

/** The call of a system, and what it says of its matrices: of F, G and H, as `ss(A, B, C, D)` has them. */
const SPACE = /^(?:[A-Za-z_]\w*\.)*(?:ss|StateSpace)\s*(?=\()/
const SLOTS = /** @type {const} */ (['F', 'G', 'H'])

/**
 * @typedef {object} Given what the text has given besides
 * @property {(letters: string[]) => number[][] | undefined} get the matrix of one of these letters
 * @property {(letter: string, matrix: number[][]) => void} add
 * @property {(words: string) => void} leave names what is of no use
 */

export class Sampling {
  /** @param {import('./expression.js').Scope} scope @param {Given} given */
  constructor(scope, given) {
    this.scope = scope
    this.given = given
    this.continuous = false
    /** Whether the text says in words that the system is of continuous time; undefined where it says neither. */
    this.said = /** @type {boolean | undefined} */ (undefined)
    /** Whether it is given how the system is sampled. */
    this.sampled = false
    /** The first matrix of the system that is sampled, or of continuous time; empty where the text does not tell. */
    this.of = ''
    /** What a call that samples makes: it is made here after the text is read. @type {Set<string>} */
    this.made = new Set()
    /** @type {{ name: string, step: number, rank: number }[]} */
    this.steps = []
  }

  /** The names of what a call makes, which stand before it. @param {string} words */
  makes(words) {
    if (!this.sampled) return
    const [, names = ''] = /^([^=]*)=/.exec(words) ?? []
    for (const [name] of names.matchAll(/[A-Za-z_]\w*/g)) if (!isStep(name)) this.made.add(name)
  }

  /** @param {string} name @param {number} step @param {boolean} [anew] in place of what it was */
  step(name, step, anew = false) {
    if (anew) this.steps = this.steps.filter((one) => one.name !== name)
    this.steps.push({ name, step, rank: CALLED.findIndex((called) => called.test(name)) })
  }

  /** @param {boolean} continuous */
  says(continuous) {
    if (this.said === !continuous) throw new Fault('The text says both, continuous and discrete time; leave one out.')
    this.said = continuous
  }

  /** @param {string} text @param {string} from */
  length(text, from) {
    const [[step]] = new Expression(text, 'The length of a step', this.scope).read()
    if (step > 0) this.step(from, step)
    return step
  }

  /** `ss(A, B, C, D)` is of continuous time, and with a fifth value of discrete time. @param {string} call */
  space(call) {
    const values = valuesOf(call)
    this.matrices(values)
    const [, more] = /\)\s*\.\s*(?:to_discrete|sample)\s*(\([\s\S]*)$/.exec(call) ?? []
    if (more) return this.sample(more)
    const [step] = values.map((value) => STEP.exec(value)?.[1] ?? '').filter(Boolean)
    const positions = values.filter((value) => !/^\w+\s*=/.test(value) && !STRING.test(value))
    const last = step ?? positions[4]
    if (this.isAnother(values)) return
    this.continuous = last === undefined || (last !== 'True' && this.length(last, 'ss') === 0)
  }

  /** A system of matrices that are not read says nothing of those that are. @param {string[]} values */
  isAnother([first = '']) {
    return /^[A-Za-z_]\w*$/.test(first) && !isMatrix(first) && !this.scope.get(first)
  }

  /** Matrices that are written in the call itself, or have names of their own there. @param {string[]} values */
  matrices(values) {
    const slots = values.filter((value) => !/^\w+\s*=/.test(value))
    if (slots.length < 3 || this.isAnother(values)) return
    SLOTS.forEach((role, i) => {
      const [value, letter] = [slots[i], MATRICES[role][1]]
      const known = this.given.get(MATRICES[role])
      if (role === 'F') this.of = isMatrix(value) ? value : known ? '' : letter
      if (isMatrix(value) || /^\[\s*\]$/.test(value)) return
      const name = /^[A-Za-z_]\w*$/.test(value)
      if (name && !this.scope.get(value)) return known ? undefined : this.given.leave(value)
      if (!known) return this.given.add(letter, new Expression(value, letter, this.scope).read())
      if (String(this.valueOf(value)) !== String(known)) this.given.leave(name ? value : `${letter} of the call`)
    })
    const through = slots[3] === undefined ? undefined : this.valueOf(slots[3])
    if (through?.flat().some((entry) => entry !== 0)) throw new Fault(THROUGH)
  }

  /** @param {string} text @returns {number[][] | undefined} */
  valueOf(text) {
    try {
      return new Expression(text, '', this.scope).read()
    } catch (error) {
      if (error instanceof Fault) return undefined
      throw error
    }
  }

  /** `c2d(sys, T)` and its like: the last value that is no word is the length of a step. @param {string} call */
  sample(call) {
    const all = valuesOf(call)
    if (isMatrix(all[0] ?? '')) this.of = all[0]
    if (/^\(/.test(all[0] ?? '')) this.matrices(valuesOf(all[0]))
    else if (SPACE.test(all[0] ?? '')) this.matrices(valuesOf(all[0].replace(SPACE, '')))
    const positions = all.filter((value) => {
      const [, , method] = STRING.exec(value) ?? []
      if (method !== undefined && method !== 'zoh')
        throw new Fault(`“${begun(method)}” is not done here: an input is held over a step (“zoh”).`)
      return method === undefined
    })
    const [step] = positions.map((value) => STEP.exec(value)?.[1] ?? '').filter(Boolean)
    this.length(step ?? positions[positions.length - 1] ?? '', 'c2d')
    this.sampled = true
  }

  /**
   * The length of a step, and the name that it has.
   * @param {string} f the matrix that was taken for F @param {boolean} stepwise whether that is of one step
   */
  answer(f, stepwise) {
    const meant = this.of === '' ? !stepwise : this.of === f
    const continuous = meant && (this.said || this.continuous || this.sampled)
    if (this.said === false && continuous)
      throw new Fault('The text says discrete time, and has a system of continuous time; leave one out.')
    const rank = Math.min(...this.steps.map((one) => one.rank))
    const [first, ...others] = this.steps.filter((one) => one.rank === rank)
    const other = others.find(({ step }) => step !== first.step)
    if (other)
      throw new Fault(
        `${first.name} is ${first.step} and ${other.name} is ${other.step}, ` +
          'and both are the length of a step; give one.',
      )
    if (first && !(first.step > 0)) throw new Fault('The length of a step must be more than 0.')
    if (continuous && !first) throw new Fault('The length of a step is missing: write T = …, in seconds.')
    return { continuous, period: first?.step, name: first?.name }
  }
}
