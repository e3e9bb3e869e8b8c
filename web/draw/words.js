/**
 * Labels with symbols in them.
 *
 * A label may use a small notation: `*g*_1` is an italic g with the index 1; `_{12}` and `^{⊤}` take more than one
 * letter. A symbol that the notations write with different letters stands under its name in braces, as in `Gain {R}`.
 * Where a letter is a name that has to stay, as in a file's format, `*V*{also V}` adds the reader's own: V (Q). All
 * readings are written into the page, and its style shows one of them.
 */

import { SVG } from './dom.js'

/** @typedef {string} Words */
/** @typedef {{ kind: 'plain' | 'symbol' | 'sub' | 'sup', text: string }} Piece */

/** The notations that a page can be read in, as `crates/book/src/notation.rs` has them; the first is the page's own. */
const NOTATIONS = ['choset', 'thrun', 'common']

/** Symbols by their names in `content/macros.toml`, in the letters of each notation. */
export const SYMBOLS = /** @type {Record<string, string[]>} */ ({
  F: ['*F*', '*A*', '*F*'],
  G: ['*G*', '*B*', '*B*'],
  H: ['*H*', '*C*', '*H*'],
  V: ['*V*', '*R*', '*Q*'],
  W: ['*W*', '*Q*', '*R*'],
  K: ['*K*', '*L*', '*L*'],
  R: ['*R*', '*K*', '*K*'],
  Rk: ['*R*(*k*)', '*K*_t', '*K*_k'],
  y: ['*y*', '*z*', '*z*'],
  P: ['*P*', 'Σ', '*P*'],
  Pk: ['*P*(*k* | *k*)', 'Σ_t', '*P*_{k|k}'],
  Pstart: ['*P*(0 | 0)', 'Σ_0', '*P*_{0|0}'],
  innov: ['*ν*', '*ν*', '*ỹ*'],
  k: ['*k*', '*t*', '*k*'],
})

/** The words in the letters of each notation. @param {Words} words */
export function readings(words) {
  // Symbols beside each other are one word in italics.
  const read = (/** @type {number} */ n) =>
    words
      .replace(/\{(\w+)\}/g, (marked, name) => SYMBOLS[name]?.[n] ?? marked)
      .replace(/\{also (\w+)\}/g, (_, name) => (SYMBOLS[name][n] === SYMBOLS[name][0] ? '' : ` (${SYMBOLS[name][n]})`))
      .replaceAll('**', '')
  return NOTATIONS.map((_, n) => read(n))
}

/**
 * @param {string} words
 * @returns {Piece[]}
 */
export function pieces(words) {
  // A star with no letter behind it is a star, as in Ω*.
  const pattern = /\*(?![ .,:;)])([^*]+)\*|_\{([^}]+)\}|_(.)|\^\{([^}]+)\}|([^*_^]+|\*)/gu
  /** @type {Piece[]} */
  const found = []
  for (const [, symbol, subs, sub, sup, plain] of words.matchAll(pattern)) {
    if (symbol !== undefined) found.push({ kind: 'symbol', text: symbol })
    else if (sup !== undefined) found.push({ kind: 'sup', text: sup })
    else if (plain !== undefined) found.push({ kind: 'plain', text: plain })
    else found.push({ kind: 'sub', text: subs ?? sub })
  }
  return found
}

/**
 * The words without their marks, as the name that a screen reader says, in the page's own letters.
 * @param {Words} words
 */
export const plain = (words) => unmarked(readings(words)[0])

/** @param {string} words in the letters of one notation */
export const unmarked = (words) =>
  pieces(words)
    .map((piece) => piece.text)
    .join('')

/** Words in which a unit stays on the line of its number. @param {string} words */
export const held = (words) => words.replace(/(?<=\d) (?=(?:%|m|m\/s|m²|s|rad)(?![\p{L}\d]))/gu, '\u00a0')

/**
 * How far a piece of a label is lifted, in letters of the label, and how large its own are: `web/style/ink.css` says
 * the same.
 */
const LIFT = { plain: 0, symbol: 0, sub: 0.19, sup: -0.3 }
const SIZE = { plain: 1, symbol: 1.06, sub: 0.75, sup: 0.75 }

const ELEMENTS = { plain: 'span', symbol: 'i', sub: 'sub', sup: 'sup' }

/**
 * Writes words into an HTML element.
 * @param {Element} into
 * @param {Words} words
 */
export function writeHtml(into, words) {
  const { ownerDocument } = into
  into.replaceChildren()
  for (const [words_, name] of variants(words)) {
    const holder = name ? into.appendChild(ownerDocument.createElement('span')) : into
    if (name) holder.setAttribute('class', name)
    for (const { kind, text } of pieces(words_)) {
      if (kind === 'plain') holder.append(text)
      else holder.appendChild(ownerDocument.createElement(ELEMENTS[kind])).append(text)
    }
  }
}

/**
 * Writes words into an SVG text.
 * @param {Element} into
 * @param {Words} words
 */
export function writeSvg(into, words) {
  const { ownerDocument } = into
  into.replaceChildren()
  for (const [words_, name] of variants(words)) {
    const holder = name ? into.appendChild(ownerDocument.createElementNS(SVG, 'tspan')) : into
    if (name) holder.setAttribute('class', name)
    let lift = 0
    const parts = pieces(words_)
    if (parts.length === 1 && parts[0].kind === 'plain') {
      holder.append(parts[0].text)
      continue
    }
    for (const { kind, text } of parts) {
      const span = holder.appendChild(ownerDocument.createElementNS(SVG, 'tspan'))
      if (kind !== 'plain') span.setAttribute('class', kind)
      // An em of `dy` is one of the piece's own letters.
      if (LIFT[kind] !== lift)
        span.setAttribute('dy', `${Math.round(((LIFT[kind] - lift) / SIZE[kind]) * 100) / 100}em`)
      span.append(text)
      lift = LIFT[kind]
    }
  }
}

/**
 * @param {Words} words
 * @returns {[string, string | null][]}
 */
function variants(words) {
  const all = readings(words)
  if (all.every((one) => one === all[0])) return [[all[0], null]]
  return all.map((one, n) => [one, `in-${NOTATIONS[n]}`])
}
