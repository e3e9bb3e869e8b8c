/** A field for one number: a point or a comma as its decimal point, and marked where it holds none. */

import { part } from '../draw/dom.js'

/**
 * @param {Element} into
 * @param {string} words its label
 * @param {(value: number) => void} change called with a number that the reader has entered
 * @param {() => [number, number] | null} [bounds] from where to where it may be; another number is refused, and they
 * are said: what is set stays
 * @returns {{ input: HTMLInputElement, show: (value: number | null) => void }} `show` leaves alone what is being typed
 */
export function numberField(into, words, change, bounds = () => null) {
  const label = part(document, into, 'label', '')
  part(document, label, 'span', '').textContent = words
  const input = /** @type {HTMLInputElement} */ (part(document, label, 'input', ''))
  input.type = 'text'
  input.inputMode = 'decimal'
  const refused = part(document, label, 'span', 'field-refused')
  refused.setAttribute('role', 'status')
  /** @param {boolean} wrong @param {string} why */
  const mark = (wrong, why) => {
    input.toggleAttribute('aria-invalid', wrong)
    refused.textContent = why
  }
  input.addEventListener('change', () => {
    const value = numberOf(input.value)
    const [least, most] = bounds() ?? [-Infinity, Infinity]
    const beyond = value !== null && (value < least || value > most)
    const why = value === null ? 'A number is expected' : `${bound(least)} to ${bound(most)} are possible`
    const wrong = value === null || beyond
    mark(wrong, wrong ? why : '')
    if (!wrong) change(value)
  })
  return {
    input,
    show(value) {
      if (document.activeElement === input) return
      input.value = value === null ? '' : fieldText(value)
      mark(false, '')
    },
  }
}

/**
 * A number as a field shows it: six digits that count, and of a large one three decimals: places in metres are whole to
 * the millimetre wherever their origin is.
 * @param {number} value
 */
export function fieldText(value) {
  return String(Number(Math.abs(value) >= 1000 ? value.toFixed(3) : value.toPrecision(6)))
}

/** A bound as it is said. @param {number} value */
const bound = (value) => fieldText(value).replace('-', '−')

/** @param {string} text */
export function numberOf(text) {
  const plain = text.trim().replace('−', '-').replace(',', '.')
  const value = plain === '' ? Number.NaN : Number(plain)
  return Number.isFinite(value) ? value : null
}
