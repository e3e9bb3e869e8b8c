/**
 * Labels with symbols in them.
 *
 * A label may use a small notation: `*R*_1` is an italic R with the index 1; `_{12}` and `^{⊤}` take more than one letter.
 * Where the two books use different letters a label is `{ choset, thrun }`. Both are written into the page, and its style
 * shows one of them.
 */

import { SVG } from './element.js'

/** @typedef {string | { choset: string, thrun: string }} Words */
/** @typedef {{ kind: 'plain' | 'symbol' | 'sub' | 'sup', text: string }} Piece */

/**
 * @param {string} words
 * @returns {Piece[]}
 */
export function pieces(words) {
  const pattern = /\*([^*]+)\*|_\{([^}]+)\}|_(.)|\^\{([^}]+)\}|([^*_^]+)/gu
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
 * The words without their marks, as the name that a screen reader says.
 * @param {Words} words
 * @param {'choset' | 'thrun'} [notation]
 */
export function plain(words, notation = 'choset') {
  return pieces(typeof words === 'string' ? words : words[notation]).map((piece) => piece.text).join('')
}

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
      const at = kind === 'sub' ? 0.25 : kind === 'sup' ? -0.4 : 0
      const span = holder.appendChild(ownerDocument.createElementNS(SVG, 'tspan'))
      if (kind !== 'plain') span.setAttribute('class', kind)
      if (at !== lift) span.setAttribute('dy', `${Math.round((at - lift) * 100) / 100}em`)
      span.append(text)
      lift = at
    }
  }
}

/**
 * @param {Words} words
 * @returns {[string, string | null][]}
 */
function variants(words) {
  if (typeof words === 'string') return [[words, null]]
  if (words.choset === words.thrun) return [[words.choset, null]]
  return [[words.choset, 'in-choset'], [words.thrun, 'in-thrun']]
}
