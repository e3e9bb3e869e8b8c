/** Whether a pasted system is of continuous time, and how long its step lasts. */

import { Expression } from './expression.js'
import { LETTERS } from './letters.js'
import { Fault } from './number.js'

/** What the length of a step is called: by a name that means nothing else before one that may. */
const CALLED = [/^(?:Ts|T_s|dt|delta_t)$/, /^T$/]
const STRING = /^(?:method\s*=\s*)?(["'])(.*)\1$/
const STEP = /^(?:dt|Ts|ts)\s*=\s*(.*)$/

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

export class Sampling {
  /** @param {import('./expression.js').Scope} scope */
  constructor(scope) {
    this.scope = scope
    this.continuous = false
    /** Whether it is given how the system is sampled. */
    this.sampled = false
    /** @type {{ name: string, step: number, rank: number }[]} */
    this.steps = []
  }

  /** @param {string} name @param {number} step */
  step(name, step) {
    this.steps.push({ name, step, rank: CALLED.findIndex((called) => called.test(name)) })
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
    const [, more] = /\)\s*\.\s*(?:to_discrete|sample)\s*(\([\s\S]*)$/.exec(call) ?? []
    if (more) return this.sample(more)
    const [step] = values.map((value) => STEP.exec(value)?.[1] ?? '').filter(Boolean)
    const positions = values.filter((value) => !/^\w+\s*=/.test(value) && !STRING.test(value))
    const last = step ?? positions[4]
    // A system of matrices that are not read says nothing of those that are.
    if (/^\w+$/.test(values[0] ?? '') && !LETTERS.includes(values[0])) return
    this.continuous = last === undefined || (last !== 'True' && this.length(last, 'ss') === 0)
  }

  /** `c2d(sys, T)` and its like: the last value that is no word is the length of a step. @param {string} call */
  sample(call) {
    const positions = valuesOf(call).filter((value) => {
      const [, , method] = STRING.exec(value) ?? []
      if (method !== undefined && method !== 'zoh')
        throw new Fault(`“${method.slice(0, 20)}” is not done here: an input is held over a step (“zoh”).`)
      return method === undefined
    })
    const [step] = positions.map((value) => STEP.exec(value)?.[1] ?? '').filter(Boolean)
    this.length(step ?? positions[positions.length - 1] ?? '', 'c2d')
    this.sampled = true
  }

  /** The length of a step, and the name that it has. */
  answer() {
    const continuous = this.continuous || this.sampled
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
