/** The fields of the editor: lists to choose from and boxes to type in. */

import { part } from '../../draw/dom.js'

/**
 * @param {Document} document
 * @param {Element} into
 * @param {string} words
 * @param {string[]} options
 * @returns {HTMLSelectElement}
 */
export function select(document, into, words, options) {
  const label = part(document, into, 'label', 'control')
  part(document, label, 'span', 'control-name').textContent = words
  const input = /** @type {HTMLSelectElement} */ (part(document, label, 'select', ''))
  for (const words of options) part(document, input, 'option', '').textContent = words
  return input
}

/** @param {HTMLSelectElement} input @param {number} index */
export function choose(input, index) {
  for (const [i, option] of [...input.options].entries()) {
    if (option.hasAttribute('selected') !== (i === index)) option.toggleAttribute('selected', i === index)
  }
  if (input.selectedIndex !== index) input.options[index].selected = true
}

/** @param {Document} document @param {Element} into @returns {HTMLInputElement} */
export function textBox(document, into) {
  const input = /** @type {HTMLInputElement} */ (part(document, into, 'input', ''))
  input.setAttribute('type', 'text')
  input.setAttribute('autocomplete', 'off')
  input.setAttribute('spellcheck', 'false')
  return input
}

/** @param {HTMLInputElement} input @param {string} text */
export function write(input, text) {
  input.setAttribute('value', text)
  input.value = text
}
