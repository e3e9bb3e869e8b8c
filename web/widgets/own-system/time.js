/** How long a step lasts, and whether the matrices are of continuous time. */

import { button, part } from '../../draw/dom.js'
import { textBox, write } from './fields.js'
import { faultOf, numberOf } from './number.js'

/** The length of a step that a system in continuous time is given where the reader has given none, seconds. */
const USUAL = 0.1

/** What makes a system one of continuous time, or of steps. @param {boolean} continuous @param {any} params */
const timed = (continuous, { period }) => ({ continuous, ...(continuous && period === 0 ? { period: USUAL } : {}) })

/**
 * The question where F looks like one of a differential equation, beside a button that takes it as that.
 * @param {Document} document
 * @param {Element} into
 * @param {(name: string, make: (frame: any) => Record<string, unknown>) => void} propose
 * @param {() => void} taken
 */
export function buildQuestion(document, into, propose, taken) {
  const row = part(document, into, 'div', 'own-row own-asks')
  part(document, row, 'p', '').textContent =
    'Is F of a differential equation? It looks like one, and is taken as what one step does.'
  button(document, row, 'Take F as continuous in time', () => {
    propose('', ({ params }) => timed(true, params))
    taken()
  })
  return { show: (/** @type {boolean} */ asked) => row.toggleAttribute('hidden', !asked) }
}

/**
 * @param {Document} document
 * @param {Element} into
 * @param {(name: string, make: (frame: any) => Record<string, unknown>) => void} propose
 */
export function buildTime(document, into, propose) {
  const label = part(document, into, 'label', 'control own-period')
  part(document, label, 'span', 'control-name').textContent = 'Length of a step, s'
  const input = textBox(document, label)
  input.setAttribute('inputmode', 'decimal')
  input.setAttribute('placeholder', 'unknown')
  input.addEventListener('input', () =>
    propose('period', () => {
      const period = input.value.trim() === '' ? 0 : numberOf(input.value)
      if (!Number.isFinite(period)) throw new Error(`The length of a step: ${faultOf(input.value)}`)
      return { period }
    }),
  )
  const around = part(document, into, 'label', 'control control-toggle own-time')
  const box = /** @type {HTMLInputElement} */ (part(document, around, 'input', ''))
  box.setAttribute('type', 'checkbox')
  part(document, around, 'span', 'control-name').textContent = 'Continuous time'
  box.addEventListener('change', () => propose('', ({ params }) => timed(box.checked, params)))
  let wrong = false
  return {
    focus: () => box.focus(),
    /** @param {string} where the fault is */
    mark(where) {
      wrong = where === 'period'
      if (wrong) input.setAttribute('aria-invalid', 'true')
      else input.removeAttribute('aria-invalid')
    },
    /** @param {any} params @param {boolean} foreign */
    show({ period, continuous }, foreign) {
      if (box.hasAttribute('checked') !== continuous) box.toggleAttribute('checked', continuous)
      if (box.checked !== continuous) box.checked = continuous
      if (wrong || (document.activeElement === input && !foreign)) return
      const text = period === 0 ? '' : String(period)
      if (numberOf(input.value) !== period) write(input, text)
    },
  }
}
