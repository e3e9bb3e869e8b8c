/**
 * Numbers and symbols as a reader sees them: in a readout, a label, an announcement.
 *
 * A label may use a small notation: `*R*_1` is an italic R with a lower 1, `_{12}` and `^{⊤}` take more than one letter.
 * Where the two conventions differ a label is `{ choset, thrun }`; both are written and the page's style shows one.
 */

/** @typedef {string | { choset: string, thrun: string }} Words */
/** @typedef {{ kind: 'plain' | 'symbol' | 'sub' | 'sup', text: string }} Piece */

const MINUS = '\u2212'

/**
 * With a fixed number of decimals and a true minus sign; what is not finite is said so.
 * @param {number | null | undefined} value
 * @param {number} [decimals]
 */
export function fixed(value, decimals = 2) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–'
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`
  if (Math.abs(value) >= 1e5) return value.toExponential(1).replace('-', MINUS).replace('e+', ' × 10^').replace(/\^(\d+)$/, (_, power) => raised(power))
  const text = value.toFixed(decimals)
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', MINUS)
}

/** @param {string} digits */
function raised(digits) {
  return [...digits].map((digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)]).join('')
}

/**
 * A complex number: `0.634 ± 0.097 i` is a pair, so one is `0.634 + 0.097 i`.
 * @param {{ re: number, im: number }} value
 * @param {number} [decimals]
 */
export function complex(value, decimals = 3) {
  if (Math.abs(value.im) < 10 ** -decimals / 2) return fixed(value.re, decimals)
  return `${fixed(value.re, decimals)} ${value.im < 0 ? MINUS : '+'} ${fixed(Math.abs(value.im), decimals)} i`
}

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
 * Without marks, for a name a screen reader says.
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

export const SVG = 'http://www.w3.org/2000/svg'

/**
 * @param {Words} words
 * @returns {[string, string | null][]}
 */
function variants(words) {
  if (typeof words === 'string') return [[words, null]]
  if (words.choset === words.thrun) return [[words.choset, null]]
  return [[words.choset, 'in-choset'], [words.thrun, 'in-thrun']]
}
