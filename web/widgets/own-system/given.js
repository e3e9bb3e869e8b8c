/** What a paste has given so far: matrices of the system, other names, the start, and how it is sampled. */

import { isScalar } from './matrices.js'
import { Fault } from './number.js'
import { Sampling, isStep } from './sampling.js'

/** What the covariance of the start is called. */
const START = /^(?:P|P0|P_0|P00|Sigma0|initial_state_covariance)$/
/** What a filter of filterpy has where nothing is given: 1, of so many rows. */
const DIMENSION = /** @type {Record<string, string>} */ ({ Q: 'dim_x', R: 'dim_z' })

const WEIGHTS = 'Q and R are weights of a controller here, and no noises; write the noises as V = … and W = ….'

/** @param {string} name */
export const isStart = (name) => START.test(name)

export class Given {
  /** @param {string} text */
  constructor(text) {
    /** The line where the present statement begins, counted from 1; 0 behind the last. */
    this.line = 1
    /** @type {import('./called.js').Found} */
    this.found = {}
    /** @type {string[]} */
    this.unused = []
    /** What other names stand for. @type {Map<string, number[][]>} */
    this.values = new Map()
    /** @type {{ name: string, matrix: number[][], line: number } | null} */
    this.start = null
    /** The names that the present value is made of. @type {Set<string>} */
    this.uses = new Set()
    /** Those that other names are made of. @type {Map<string, Set<string>>} */
    this.made = new Map()
    /** What their `[ ]` count from. @type {Map<string, import('./entry.js').From>} */
    this.counts = new Map()
    /** Names whose parts are given: `kf.F = …`. @type {Set<string>} */
    this.objects = new Set()
    this.scope = {
      numpy: /\b(?:np|numpy|jnp)\.|\barray\(|\b(?:from|import) numpy\b/.test(text),
      old: /\b(?:np|numpy)\.mat(?:rix)?\(/.test(text),
      get: (/** @type {string} */ name, object = '') => this.get(name, object),
    }
    this.sampling = new Sampling(this.scope, {
      get: (letters) => letters.map((letter) => this.found[letter]?.matrix).find(Boolean),
      add: (letter, matrix) => void (this.found[letter] = { matrix, line: this.line, from: 1, uses: new Set() }),
      leave: (words) => void this.unused.push(words),
    })
  }

  /** What a name stands for in a formula. @param {string} name @param {string} object of which it is a part */
  get(name, object) {
    const [of] = object.split('.')
    const fault = (/** @type {string} */ words) => new Fault(`“${object}${name}” is ${words}; write its numbers.`)
    if (this.sampling.made.has(of || name)) throw fault('made only after the text is read')
    if (of && this.unused.includes(of) && !this.objects.has(of)) throw fault('not known here')
    this.unused = this.unused.filter((each) => each !== name)
    for (const each of [name, ...(this.found[name]?.uses ?? this.made.get(name) ?? [])]) this.uses.add(each)
    return this.values.get(name) ?? this.found[name]?.matrix
  }

  /** @param {string} name @param {number[][]} matrix @param {import('./entry.js').From} from */
  matrix(name, matrix, from) {
    // Made of itself, it is set anew.
    if (this.found[name] && !this.uses.delete(name)) throw new Fault(`${name} is given twice.`)
    if (this.found[name] && this.sampling.of === name) this.sampling.of = `${name} before`
    this.found[name] = { matrix, line: this.line, from, uses: this.uses }
  }

  /**
   * What is none of the matrices.
   * @param {string} name @param {number[][]} matrix @param {import('./entry.js').From} from @param {boolean} [anew]
   */
  set(name, matrix, from, anew = false) {
    this.values.set(name, matrix)
    this.made.set(name, this.uses)
    this.counts.set(name, from)
    if (isStep(name) && matrix.flat().length === 1) this.sampling.step(name, matrix[0][0], anew)
    if (isStart(name)) this.start = { name, matrix, line: this.line }
  }

  /**
   * What a name stands for before `kf.Q *= 0.1`; filterpy’s start is 1 without a word, and so are its noises.
   * @param {string} name @param {string} sign
   */
  before(name, sign) {
    const scaled = /[*/]/.test(sign)
    const rows = this.values.get(DIMENSION[name])?.[0][0] ?? 0
    const usual =
      scaled && isStart(name)
        ? [[1]]
        : scaled && rows > 0 && rows < 10
          ? Array.from({ length: rows }, (_, i) => Array.from({ length: rows }, (_, j) => Number(i === j)))
          : undefined
    const start = this.start?.name === name ? this.start.matrix : undefined
    const matrix = this.found[name]?.matrix ?? start ?? this.values.get(name) ?? usual
    if (!matrix) throw new Fault(`${name} is changed before it is given; write ${name} = its numbers first.`)
    return matrix
  }

  /** What is set in part: its matrix is this very one. @param {string} name */
  partly(name) {
    const matrix = this.values.get(name)
    const uses = this.made.get(name)
    return matrix && uses ? { matrix, uses, from: this.counts.get(name) } : this.found[name]
  }

  /** What a name stood for is not known any more. @param {string} name */
  forget(name) {
    this.values.delete(name)
    this.unused.push(name)
  }

  /** Weights of a controller are no noises; whether any was given. @param {string} text */
  weigh(text) {
    const calls = [...text.matchAll(/\b(?:d?lqr|lqi|lqry)\s*\(([^()]*)\)/g)].map(([, words]) => words).join()
    const weights = ['Q', 'R'].filter((name) => this.found[name] && new RegExp(`\\b${name}\\b`).test(calls))
    for (const name of weights) delete this.found[name]
    if (weights.length > 0 && !(this.found.V && this.found.W)) throw new Fault(WEIGHTS)
  }

  /** @param {string} name @param {number[][]} matrix */
  change(name, matrix) {
    const now = this.found[name]?.matrix ?? this.values.get(name)
    // numpy changes a matrix where it stands, also under another name; a number has no other.
    if (this.scope.numpy && now && !isScalar(now) && matrix.length === now.length) {
      for (const [i, row] of matrix.entries()) now[i] = row
      matrix = now
    }
    if (isStart(name) || (this.values.has(name) && !this.found[name]))
      return this.set(name, matrix, this.counts.get(name), true)
    const { line, from, uses } = this.found[name] ?? { line: this.line, from: 0, uses: [] }
    this.found[name] = { matrix, line, from, uses: new Set([...uses, ...this.uses]) }
  }
}
