/** A program in the style of a notation: as the chapter writes formulas, or as they are typed in the common letters. */

import { printer } from './ranks.js'

/** @typedef {import('estimate-wasm').ProgramFormula} Formula */
/** @typedef {import('./ranks.js').Ranked} Ranked */
/** @typedef {(part: Formula, least?: number) => string} Text */

/** @param {string} one @param {number} [rank] @returns {Ranked} */
const of = (one, rank = 5) => [one, rank]
/** Greek letters, which the program’s reader writes out. */
const GREEK = /** @type {Record<string, string>} */ ({ nu: 'ν', mu: 'μ', Sigma: 'Σ', theta: 'θ' })
const spelt = (/** @type {string} */ name) => name.replace(/^[A-Za-z]+/, (word) => GREEK[word] ?? word)

/**
 * A pair of bounds: one number, or from and to.
 * @param {Formula} from @param {Formula} to @param {Text} text
 */
function range(from, to, text) {
  if (from.word === 'number' && from.number === 1 && to.word === 'end') return ':'
  const [first, last] = [from, to].map((it) => (it.word === 'end' ? 'end' : text(it)))
  return first === last ? first : `${first}:${last}`
}

/** The chapter’s ways, and those of a keyboard. */
const CHAPTER = { minus: '−', times: ' ', over: ' / ', under: ' \\ ', transpose: 'ᵀ', name: spelt, raised: true }
const TYPED = { minus: '-', times: '*', over: '/', under: '\\', transpose: "'", name: String, raised: false }

/** @param {typeof CHAPTER} style */
function words(style) {
  const infix = (/** @type {string} */ sign) => (/** @type {Formula} */ it, /** @type {Text} */ text) =>
    of(`${text(it.parts[0], 2)}${sign}${text(it.parts[1], sign === ' ' ? 4 : 3)}`, 2)
  const call = (/** @type {Formula} */ { word, parts }, /** @type {Text} */ text) =>
    of(`${word}(${parts.map((part) => text(part)).join(', ')})`)
  /** @param {Formula} it @param {Text} text */
  const parts = (it, text) => it.parts.map((part) => text(part)).join(', ')
  /** @type {Record<string, (it: Formula, text: Text) => Ranked>} */
  const all = {
    number: (it) => of(String(it.number)),
    name: (it) => of(style.name(it.name)),
    end: () => of('end'),
    // The core reads −a b as (−a) b.
    negative: ({ parts: [a] }, text) => of(`${style.minus}${text(a, 4)}`, 3),
    times: infix(style.times),
    over: infix(style.over),
    under: infix(style.under),
    transpose: ({ parts: [a] }, text) => of(`${text(a, 4)}${style.transpose}`, 4),
    inv: (it, text) => (style.raised ? of(`${text(it.parts[0], 4)}⁻¹`, 4) : call(it, text)),
    power: ({ parts: [a], number }, text) => {
      const raised = style.raised && (number === 2 ? '²' : number === 3 ? '³' : '')
      return of(`${text(a, 4)}${raised || `^${number < 0 ? `(${number})` : number}`}`, 4)
    },
    array: ({ parts: [a] }, text) => of(text(a, 5)),
    part: ({ parts: [whole, ...bounds] }, text) => {
      const pairs = [bounds.slice(0, 2), bounds.slice(2)].filter((pair) => pair.length > 0)
      return of(`${text(whole, 4)}[${pairs.map(([from, to]) => range(from, to, text)).join(', ')}]`, 4)
    },
    // Without a comma a blank would part a row’s entries.
    row: (it, text) => of(`[${it.parts.length > 1 ? parts(it, text) : text(it.parts[0], 4)}]`),
    stack: (it, text) => {
      const rows = it.parts.map((row) => (row.parts.length > 1 ? parts(row, text) : text(row.parts[0], 4)))
      return of(rows.length > 1 ? `[${rows.join('; ')}]` : `[[${rows[0]}]]`)
    },
    jac: ({ parts: [a], name }, text) => {
      // jac(f, x) is that of f(x, u), and jac(h, x) that of h(x, l).
      const [state, other] = a.parts
      const bare = state?.name === name && { f: 'u', h: 'l' }[a.word] === other?.name
      return of(`jac(${bare ? a.word : text(a)}, ${style.name(name)})`)
    },
  }
  for (const one of 'eye zeros diag sqrt sin cos atan2 exp wrap det trace norm chol sym abs f h'.split(' '))
    all[one] = call
  all.length = ({ parts: [a, which] }, text) => of(`size(${text(a)}, ${which ? text(which) : 1})`)
  return all
}

/**
 * The text with each formula in the style of a notation; the letters stay, and so do comments and empty lines.
 * @param {import('estimate-wasm').Program} program without faults @param {string} text what it was read from
 * @param {string} notation
 */
export function styled(program, text, notation) {
  const style = notation === 'common' ? TYPED : CHAPTER
  const written = printer(words(style), style.minus)
  const tree = program.tree()
  const lines = text.split('\n')
  const comment = (/** @type {string} */ line) => /(?:#|%|\/\/).*$/.exec(line)?.[0] ?? ''
  return lines
    .flatMap((line, i) => {
      const here = tree.filter(({ lines: [from, to] }) => from <= i + 1 && i + 1 <= to)
      if (here.length === 0) return [line]
      const begun = here.filter(({ lines: [from] }) => from === i + 1)
      const made = begun.map(({ name, part, value }) => {
        const filled = part ? written(part) : style.name(name)
        return `${filled} = ${written(value)}`
      })
      if (comment(line)) made.push(`${made.pop() ?? ''} ${comment(line)}`.trim())
      return made
    })
    .join('\n')
}
