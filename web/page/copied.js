/**
 * What a reader copies holds each formula in one line of text, as the reader's own filter, numpy and a mail take it:
 * without this a browser hands over one sign a line, and every formula twice.
 */

const ACCENTS = new Map([
  ['^', '\u0302'],
  ['ˉ', '\u0304'],
  ['¯', '\u0304'],
  ['~', '\u0303'],
  ['˜', '\u0303'],
  ['˙', '\u0307'],
])
const OPERATORS = new Map([
  ['−', '-'],
  ['∣', '|'],
])
/** Stands between a function's name and what it is applied to, and is not seen. */
const APPLIED = '\u2061'
const SPACED = /^[=+\-<>≤≥≈≠∈→←⇒⇐⟸±×⊕⊞]$/u

/** From now on, formulas are copied as lines. */
export function copyLines() {
  document.addEventListener('copy', (event) => {
    const selection = getSelection()
    if (!event.clipboardData || !selection?.rangeCount) return
    const part = selection.getRangeAt(0).cloneContents()
    if (!part.querySelector('.formula')) return
    const page = document.createElement('div')
    page.append(part)
    const html = page.innerHTML
    // In a program the number of an equation is a remark, and so is the line that says what comes back.
    for (const remark of page.querySelectorAll('li > .from, li > strong:first-child')) remark.prepend('# ')
    for (const formula of page.querySelectorAll('.formula')) formula.replaceWith(lineOf(formula))
    // Where lines and cells end is told by the layout alone, and only of what is on the page.
    page.className = 'visually-hidden'
    document.body.append(page)
    event.clipboardData.setData('text/plain', page.innerText.trim())
    event.clipboardData.setData('text/html', html)
    page.remove()
    event.preventDefault()
  })
}

/**
 * A formula of the page as a line of text, in the letters that the page shows.
 * @param {Element} formula
 */
function lineOf(formula) {
  const letters = document.documentElement.dataset.letters
  const shown = (letters && formula.querySelector(`:scope > .in-${letters}`)) || formula.firstElementChild || formula
  const math = shown.querySelector('math')
  return math ? line(math) : plain(shown)
}

/** @param {Element} formula without MathML */
function plain(formula) {
  // A formula of letters only is set without MathML; two letters beside each other are a product.
  const copy = /** @type {Element} */ (formula.cloneNode(true))
  for (const low of copy.querySelectorAll('sub')) low.prepend('_')
  for (const high of copy.querySelectorAll('sup')) high.prepend('^')
  for (const factor of copy.querySelectorAll('i + i')) factor.prepend(' ')
  return [...(copy.textContent ?? '')].map((sign) => OPERATORS.get(sign) ?? sign).join('')
}

/** @param {Element} node @returns {string} */
function line(node) {
  const children = [...node.children]
  const [base, first, second] = children
  switch (node.localName) {
    case 'mi':
    case 'mn':
    case 'mo':
    case 'mtext': {
      const text = (node.textContent ?? '').trim()
      return OPERATORS.get(text) ?? text
    }
    case 'mover': {
      const accent = ACCENTS.get(line(first))
      return accent ? line(base) + accent : `${line(base)}^${grouped(first)}`
    }
    case 'msup':
      return `${line(base)}^${grouped(first)}`
    case 'msub':
    case 'munder':
      return `${line(base)}_${grouped(first, '{}')}`
    case 'msubsup':
    case 'munderover':
      return `${line(base)}_${grouped(first, '{}')}^${grouped(second)}`
    case 'mfrac':
      return `${grouped(base)} / ${grouped(first)}`
    case 'msqrt':
      return `sqrt(${row(children)})`
    case 'mtable':
      return children.map((cells) => [...cells.children].map(line).join(', ')).join('; ')
    case 'mspace':
    case 'annotation':
      return ''
    default:
      return row(children)
  }
}

/**
 * What stands high, low or in a fraction: in brackets where it is more than one sign.
 * @param {Element} node
 * @param {string} [brackets]
 */
function grouped(node, brackets = '()') {
  const text = node.localName === 'mrow' ? row([...node.children], true) : line(node)
  return /^([\p{L}\p{M}\d.]*|[+-])$/u.test(text) ? text : brackets[0] + text + brackets[1]
}

/**
 * Neighbours in a row: factors with a blank between, brackets and commas close, and what stands in round brackets as
 * close as a time is written, `x(k+1|k)`.
 * @param {Element[]} nodes
 * @param {boolean} [close] whether a plus stands close as well
 */
function row(nodes, close = false) {
  let [text, depth, glued] = ['', close ? 1 : 0, true]
  for (const node of nodes) {
    const next = line(node)
    if (!next || next === APPLIED) continue
    const operator = SPACED.test(next)
    // At the beginning, and behind a bracket, a comma or another operator, it is the sign of what follows.
    const sign = operator && (text === '' || /[([{,=]$/.test(text))
    const opens = next === '(' && /[\p{L}\p{M}\d)]$/u.test(text)
    text += (glued || opens || /^[)\]},|]/.test(next) || (operator && depth > 0) ? '' : ' ') + next
    glued = /[([{|]$/.test(next) || (operator && (sign || depth > 0))
    if (next === '(') depth++
    if (next.startsWith(')')) depth--
  }
  return text
}
