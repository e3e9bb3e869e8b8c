/** Makes elements for figures and pages, in a browser and, for the stills, in Node. */

/** The namespace of SVG elements. */
export const SVG = 'http://www.w3.org/2000/svg'

/** @param {Document} document @param {Element} into @param {string} tag @param {string} name its class, if any */
export function part(document, into, tag, name) {
  const element = document.createElement(tag)
  if (name) element.setAttribute('class', name)
  into.append(element)
  return element
}

/**
 * @param {Document} document
 * @param {Element} into
 * @param {string} words
 * @param {() => void} press
 * @param {string} [name]
 */
export function button(document, into, words, press, name = 'button') {
  const element = part(document, into, 'button', name)
  element.setAttribute('type', 'button')
  element.textContent = words
  element.addEventListener('click', press)
  return /** @type {HTMLButtonElement} */ (element)
}

/** Moves the focus to the first control that shows: the control that had it is gone. @param {Element} host a figure */
export function focusFirst(host) {
  const controls = '.figure-failure button, .live :is(button, input, select, [tabindex]):not(:disabled)'
  // A figure that opens small hides some of its controls.
  const next = [...host.querySelectorAll(controls)].find((one) => one.getClientRects().length > 0)
  if (next instanceof HTMLElement || next instanceof SVGElement) next.focus({ preventScroll: true })
}
