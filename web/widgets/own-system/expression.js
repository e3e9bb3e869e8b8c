/**
 * Reads one value of a paste by recursive descent: a matrix in brackets, also of blocks, a number, what was given
 * before, and sums, products, powers, transposes and functions of these, as MATLAB and numpy take them.
 */

import { FUNCTIONS, added, beside, combined, each, isLine, isScalar, line, raised, transposed } from './matrices.js'
import { assembled, below, closes } from './bracket.js'
import { Fault, faultOf, numberIn, refuse } from './number.js'
import { multiplied } from './operators.js'
import { printed } from './printed.js'
import { isWhiteNoise, whiteNoise } from './white-noise.js'

/** @typedef {number[][]} Matrix */
/**
 * @typedef {object} Scope what names stand for
 * @property {(name: string, object?: string) => Matrix | undefined} get also of a part of an object: `sys.` of `sys.A`
 * @property {boolean} numpy @property {boolean} [old] whether there are matrices of numpy, whose product is that of `@`
 */
/** @typedef {import('./bracket.js').Item} Item */
/** @typedef {import('./bracket.js').List} List */

const DIGITS = /^(?:\d+(?:\.(?![*/^'\\])\d*)?|\.\d+)(?:e[+-]?\d+)?(?!\w)/i
const NAME = new RegExp(
  /^(?:(?:np|numpy|jnp|math|scipy|sp|linalg|la|LA)\.)*/.source +
    /((?:[A-Za-z_]\w*\.(?!(?:T|transpose|dot|copy|astype|shape)\b))*)([A-Za-z_]\w*)/.source,
)
/** Behind a value stands its end, or the next name. */
const END = /^[^\S\n]*(?:$|[\n;,})]|(["']?)[A-Za-z]\w*\1\s*[:=](?!=))/
/** The type of an array's numbers. */
const TYPE = /^(?:dtype\s*=\s*["']?[\w.]+["']?|(?:np\.)?float(?:32|64)?(?=\s*\)))/
/** What R’s `c(…)` and `<-` are answered with. */
export const OF_R = 'R’s notation is not read here; write each matrix by its rows, as F = [1 0.5; 0 1].'
/** So deep may brackets and powers be within one another. */
const DEEPEST = 60

export class Expression {
  /** @param {string} text @param {string} name @param {Scope} [scope] */
  constructor(text, name, scope = { get: () => undefined, numpy: false }) {
    this.name = name
    this.rest = text
    this.scope = scope
    /** The brackets that are open, with the rows that were read of each. @type {{ open: string, rows: Item[][] }[]} */
    this.open = []
    this.depth = 0
    /** Within `np.block`, where matrices stand beside one another. */
    this.blocks = false
    /** The bracket that was read last: the lengths of the text at its two ends. */
    this.last = { from: -1, to: -1, list: /** @type {List | null} */ (null) }
  }

  /** @param {RegExp} pattern */
  take(pattern) {
    const match = pattern.exec(this.rest)
    if (match) this.rest = this.rest.slice(match[0].length)
    return match
  }

  /** @param {(value: Matrix) => Matrix} [then] what is made of it @returns {Matrix} */
  read(then = (value) => value) {
    try {
      const value = each(then(printed((pattern) => this.take(pattern)) ?? this.value()), (x) => x)
      if (!value.flat().every(Number.isFinite)) throw new Fault('a number that comes of it is not finite.')
      return value
    } catch (error) {
      if (!(error instanceof Fault)) throw error
      throw new Fault(`${this.place()}${error.message.startsWith('is ') ? '' : ':'} ${error.message}`)
    }
  }

  /** The matrix, and where in it the reading stands. */
  place() {
    const [outer, inner] = this.open.filter(({ open }) => open === '[').map(({ rows }) => rows)
    if (!outer || (inner && outer.flat().some(({ list }) => !list))) return this.name
    const row = inner ? outer.flat().length + 1 : outer.length
    return `${this.name}, row ${row}, column ${(inner ?? outer)[(inner ?? outer).length - 1].length + 1}`
  }

  /** @returns {Matrix} */
  value() {
    // numpy's print below the name.
    this.take(/^\s*\n\s*(?=\[|array\()/)
    const value = this.sum()
    const comma = isScalar(value) ? this.take(/^,\d+/) : null
    if (comma) throw new Fault(faultOf(`${value[0][0]}${comma[0]}`))
    if (!END.test(this.rest)) refuse(this.rest)
    return value
  }

  /** Whether blanks part two entries: not within round brackets, nor in the code of Python. */
  get parting() {
    const round = this.open.map(({ open }) => open).lastIndexOf('(')
    return this.open.length > 0 && (this.scope.numpy ? round < 0 : round < this.open.length - 1)
  }

  /** An operator, over the blanks before it. @param {RegExp} pattern */
  operator(pattern) {
    const before = this.rest
    this.take(this.open[this.open.length - 1]?.open === '(' ? /^\s*/ : /^[^\S\n]*/)
    const found = this.take(pattern)
    if (!found) this.rest = before
    return found?.[1]
  }

  /** @returns {Matrix} */
  sum() {
    let value = this.product()
    // Within brackets `1 -T` are two entries, and `1 - T` is one.
    while (!this.parting || !/^[^\S\n]+[-+]\S/.test(this.rest)) {
      const sign = this.operator(/^\.?([-+])(?!=)\s*/)
      if (!sign) break
      value = added(value, this.product(), sign)
    }
    return value
  }

  /** @returns {Matrix} */
  product() {
    let value = this.signed()
    for (let sign; (sign = this.operator(/^(\.?[*/\\]|@)(?![*/=])\s*/)); )
      value = multiplied(value, this.signed(), sign, this.scope)
    return value
  }

  /** @param {() => Matrix} [of] @returns {Matrix} */
  signed(of = () => this.power()) {
    const signs = this.take(/^\s*(?:[-+]\s*)*/)?.[0] ?? ''
    const value = of()
    return signs.replace(/[^-]/g, '').length % 2 === 1 ? each(value, (x) => 0 - x) : value
  }

  /** @returns {Matrix} */
  power() {
    this.depth += 1
    if (this.depth > DEEPEST) throw new Fault(`more than ${DEEPEST} brackets or powers are within one another.`)
    let value = this.factor()
    for (let sign; ; ) {
      if (this.take(/^(?:\.?'|\.T\b|\.transpose\(\s*\))/)) value = transposed(value)
      else if (this.take(/^\.(?:copy\(\s*\)|astype\(\s*(?:np\.)?(?:float|float64|"float"|'float')\s*\))/)) continue
      else if ((sign = this.take(/^\.shape\s*\[\s*([01])\s*\]/)?.[1]))
        value = [[isLine(value) ? value[0].length : [value.length, value[0].length][Number(sign)]]]
      else if (this.take(/^\.dot(?=\()/)) value = this.called('dot', [value, ...this.values()])
      else if ((sign = this.operator(/^(\*\*|\.?\^)\s*/))) {
        if (sign === '^' && this.scope.numpy) refuse(sign)
        // Python's power is taken from the right, MATLAB's from the left.
        const by = this.signed(sign === '**' ? undefined : () => this.factor())
        const whole = sign === '^' && !isScalar(value)
        if (whole && !isScalar(by)) refuse(sign)
        value = whole ? raised(value, by[0][0]) : combined(value, by, (x, y) => x ** y, 'power')
      } else break
    }
    this.depth -= 1
    return value
  }

  /** @returns {Matrix} */
  factor() {
    this.take(/^\s+/)
    const digits = this.take(DIGITS)
    if (digits) return [[numberIn(digits[0])]]
    if (/^[[(]/.test(this.rest)) return this.bracketed()
    const found = this.take(NAME)
    if (!found) throw new Fault(faultOf(/^[^\s,;()[\]{}]*/.exec(this.rest)?.[0] ?? ''))
    const name = found[2]
    if (this.parting ? this.rest.startsWith('(') : /^\s*\(/.test(this.rest)) {
      this.take(/^\s+/)
      // I is a name for much else, and a function in Julia.
      const known = name === 'I' ? !this.scope.get(name) : Object.hasOwn(FUNCTIONS, name)
      if (known || /^[hv]stack$/.test(name) || isWhiteNoise(name)) return this.function(name)
      if (name === 'c') throw new Fault(OF_R)
      refuse(`${name}${this.rest}`)
    }
    const value = this.scope.get(name, found[1]) ?? (name === 'pi' ? [[Math.PI]] : undefined)
    if (!value) throw new Fault(faultOf(name))
    return value
  }

  /** @param {string} name */
  function(name) {
    if (isWhiteNoise(name)) return whiteNoise(name, this.items().rows.flat())
    const { blocks } = this
    this.blocks = name === 'block' || (blocks && !/array|mat/.test(name))
    if (name.endsWith('stack')) {
      if (!this.take(/^\(\s*(?=[[(])/)) refuse(name + this.rest)
      const all = this.items()
        .rows.flat()
        .map(({ value }) => value)
      if (!this.take(/^\s*,?\s*\)/) || all.length === 0) refuse(name)
      const even = name === 'vstack' ? below(all) : beside(all)
      return line(even, name === 'hstack' && all.every(isLine))
    }
    const all = this.values()
    this.blocks = blocks
    return this.called(name, all)
  }

  /** @param {string} name @param {Matrix[]} all */
  called(name, all) {
    const [least, most, call] = FUNCTIONS[name]
    if (all.length < least || all.length > most) throw new Fault(`“${name}” does not take ${all.length} values here.`)
    return call(all, this.scope.numpy)
  }

  /** What stands between the brackets of a function. */
  values() {
    const all = this.items().rows.flat()
    const named = all.find(({ key }) => key)
    if (named) refuse(`${named.key} =`)
    return all.map(({ value }) => value)
  }

  bracketed() {
    const text = this.rest
    const { rows, list } = this.items()
    const all = rows.flat()
    const named = all.find(({ key }) => key)
    if (named) refuse(`${named.key} =`)
    if (text[0] === '(' && !list.marks.has(',')) {
      if (all.length === 0) throw new Fault(faultOf(''))
      return all[0].value
    }
    const value = assembled(rows, list, {
      numpy: this.scope.numpy,
      blocks: this.blocks,
      text: text.slice(0, text.length - this.rest.length),
    })
    this.last = { from: text.length, to: this.rest.length, list }
    return value
  }

  /** The items of a bracket, by rows. @returns {{ rows: Item[][], list: List }} */
  items() {
    const rows = /** @type {Item[][]} */ ([[]])
    const marks = /** @type {Set<string>} */ (new Set())
    const open = this.rest[0]
    if (this.open.length === 0 && !closes(this.rest)) throw new Fault('a bracket is not closed.')
    // In a list within a list, and behind a comma of Python, a line only goes on.
    const whole = open === '(' || this.open[this.open.length - 1]?.open === '['
    this.open.push({ open, rows })
    this.rest = this.rest.slice(1)
    for (let before = ','; ; ) {
      const gap = this.take(/^\s+/)?.[0] ?? ''
      const row = rows[rows.length - 1]
      if (this.rest === '') {
        this.open = []
        throw new Fault('a bracket is not closed.')
      }
      if (this.take(open === '[' ? /^\]/ : /^\)/)) break
      if (gap.includes('\n') && !whole && row.length > 0 && !(before === ',' && this.scope.numpy)) {
        rows.push([])
        before = ';'
      }
      const mark = this.take(open === '[' ? /^[,;]/ : /^,/)?.[0]
      if (mark === ',' && before !== '') throw new Fault(faultOf(''))
      if (mark) marks.add(mark)
      if (mark === ';' && row.length > 0) rows.push([])
      if (mark) before = mark
      else if (before === '' && (gap === '' || !this.parting)) refuse(this.rest)
      else {
        if (before === '') marks.add(' ')
        if (open !== '(' || !this.take(TYPE)) rows[rows.length - 1].push(this.item(open === '('))
        before = ''
      }
    }
    this.open.pop()
    return { rows: rows.filter((row) => row.length > 0), list: { marks, nested: rows.flat().some(({ list }) => list) } }
  }

  /** @param {boolean} named whether it may have a name of its own @returns {Item} */
  item(named) {
    const key = named ? this.take(/^([A-Za-z_]\w*)\s*=(?!=)\s*/)?.[1] : undefined
    const truth = key && this.take(/^(?:True|False)\b/i)?.[0]
    if (truth) return { key, value: [[Number(/^t/i.test(truth))]], list: null }
    const from = this.rest.length
    const value = this.sum()
    const alone = this.last.from === from && this.last.to === this.rest.length
    return { key, value, list: alone ? this.last.list : null }
  }
}
