/** A number of the filter: a slider for the hand, and a field for its exact value. */

import { part } from '../draw/dom.js'
import { numberField } from './number-field.js'

/**
 * @typedef {object} Scale how far the slider goes; the field takes what lies beyond
 * @property {[number, number]} ends of a logarithmic one, decimal logarithms
 * @property {number} step
 * @property {boolean} [log]
 */

/** Digits that a slider's number has. */
const DIGITS = 3

/**
 * @param {Element} into
 * @param {string} words
 * @param {Scale} scale
 * @param {(value: number) => void} change
 * @param {() => [number, number] | null} bounds of the field
 */
export function numberSlider(into, words, { ends: [min, max], step, log }, change, bounds) {
  const box = part(document, into, 'div', 'log-number')
  const field = numberField(box, words, change, bounds)
  const slider = /** @type {HTMLInputElement} */ (part(document, box, 'input', ''))
  for (const [name, value] of Object.entries({ type: 'range', min, max, step, 'aria-label': `${words}, slider` }))
    slider.setAttribute(name, String(value))
  /** @param {number} place */
  const numberAt = (place) => Number((log ? 10 ** place : place).toPrecision(DIGITS))
  slider.addEventListener('input', () => change(numberAt(Number(slider.value))))
  // A finger that comes down here to scroll the page moves the thumb before the browser knows better.
  let before = slider.value
  slider.addEventListener('pointerdown', () => {
    before = slider.value
  })
  slider.addEventListener('pointercancel', () => {
    slider.value = before
    change(numberAt(Number(before)))
  })
  return {
    /** @param {number} value @param {boolean} [disabled] */
    show(value, disabled = false) {
      field.show(value)
      field.input.disabled = disabled
      slider.disabled = disabled
      const place = log ? Math.log10(Math.max(value, 10 ** min)) : value
      // What the hand holds stays where the hand is.
      if (numberAt(Number(slider.value)) !== numberAt(place)) slider.value = String(place)
      slider.setAttribute('aria-valuetext', String(Number(value.toPrecision(4))))
    },
  }
}
