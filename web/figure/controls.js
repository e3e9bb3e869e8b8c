/**
 * Builds native controls with a visible label; screen readers say their value in words.
 *
 * A control shows one parameter and reports the value that the reader chooses. It computes nothing. The lab says how
 * far the parameter goes, and in which steps.
 */

import { writeHtml } from '../draw/words.js'
import { slider } from './slider.js'

/** @typedef {import('../draw/words.js').Words} Words */
/** @typedef {import('estimate-wasm').Parameter} Parameter */
/** @typedef {{ at: number, name: Words, kind?: 'limit' | 'plain' }} Notch a named place on a slider */

/**
 * @typedef {object} RangeControl
 * @property {'range'} kind
 * @property {string} name the parameter
 * @property {Words} label
 * @property {(value: number, limits: Parameter) => number} [scale] a number of the parameter as one of the slider; the
 * same if not given
 * @property {number} [step] in the slider's numbers; the parameter's if not given
 * @property {[number, number]} [ends] of the slider, in its numbers; the parameter's limits if not given
 * @property {boolean} [wide] whether it takes the room of two controls
 * @property {(value: number, frame: any) => string} words the value as shown and as said
 * @property {(frame: any) => Notch[]} [notches]
 * @property {(params: any, frame: any) => any} [get] what it shows, if not the parameter of its name
 * @property {(value: any, params: any, frame: any) => Record<string, unknown>} [set] the change it makes, likewise
 * @property {(params: any) => boolean} [enabled]
 * @property {(frame: any) => boolean} [shown] whether there is anything to set; always if not given
 *
 * @typedef {object} ChoiceControl
 * @property {'choice'} kind
 * @property {string} name
 * @property {Words} label
 * @property {{ value: any, label: string }[]} options
 * @property {(params: any, frame: any) => any} [get]
 * @property {(value: any, params: any, frame: any) => Record<string, unknown>} [set]
 * @property {(params: any) => boolean} [enabled]
 * @property {(frame: any) => boolean} [shown] whether there is anything to set; always if not given
 *
 * @typedef {object} ToggleControl
 * @property {'toggle'} kind
 * @property {string} name
 * @property {Words} label
 * @property {any} [on] true if not given
 * @property {any} [off] false if not given
 * @property {(params: any, frame: any) => any} [get]
 * @property {(value: any, params: any, frame: any) => Record<string, unknown>} [set]
 * @property {(params: any) => boolean} [enabled]
 * @property {(frame: any) => boolean} [shown] whether there is anything to set; always if not given
 *
 * @typedef {object} WholeControl
 * @property {'whole'} kind
 * @property {string} name
 * @property {Words} label
 * @property {(params: any, frame: any) => any} [get]
 * @property {(value: any, params: any, frame: any) => Record<string, unknown>} [set]
 * @property {(params: any) => boolean} [enabled]
 * @property {(frame: any) => boolean} [shown] whether there is anything to set; always if not given
 *
 * @typedef {object} ActionControl a button that changes parameters
 * @property {'action'} kind
 * @property {string} name unique; no parameter
 * @property {Words} label
 * @property {(frame: any, lab: any) => Record<string, unknown>} change computed by the lab, not here
 * @property {(params: any) => boolean} [enabled]
 * @property {(frame: any) => boolean} [shown] whether there is anything to set; always if not given
 *
 * @typedef {object} CustomControl what only one figure has, such as the matrices of a system
 * @property {'custom'} kind
 * @property {string} name unique; no parameter
 * @property {(document: Document, change: (patch: Record<string, unknown>, make?: (frame: any, lab: any) =>
 * Record<string, unknown>) => void) => Shown} build
 *
 * @typedef {(RangeControl | ChoiceControl | ToggleControl | WholeControl | ActionControl | CustomControl) & { more?:
 * boolean }} Control `more` where it waits in a fold below the others
 */

/** @typedef {{ element: HTMLElement, show: (params: any, frame: any) => void }} Shown */

/**
 * @param {Document} document
 * @param {Control} control
 * @param {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} change
 * @param {import('./spec.js').Limits} limits
 * @returns {Shown}
 */
export function buildControl(document, control, change, limits) {
  if (control.kind === 'action') return action(document, control, change)
  if (control.kind === 'custom') return control.build(document, change)
  const label = document.createElement('label')
  label.className = `control control-${control.kind}${control.kind === 'range' && control.wide ? ' is-wide' : ''}`
  const name = document.createElement('span')
  name.className = 'control-name'
  writeHtml(name, control.label)
  const made = BUILD[control.kind](
    document,
    /** @type {any} */ (control),
    (value) => change({}, (frame) => control.set?.(value, frame.params, frame) ?? { [control.name]: value }),
    limits[control.name],
  )
  if (control.kind === 'toggle') label.append(made.body, name)
  else label.append(name, made.body)
  return {
    element: label,
    show(params, frame) {
      const disabled = control.enabled ? !control.enabled(params) : false
      if (made.input.disabled !== disabled) made.input.disabled = disabled
      reveal(label, control.shown?.(frame) ?? true)
      made.show(control.get ? control.get(params, frame) : params[control.name], frame)
    },
  }
}

/** The row of the button that was pressed last, until what it brings is there. @type {Element | null} */
let pressed = null

/** @param {Document} document @param {ActionControl} control @param {Function} change @returns {Shown} */
function action(document, control, change) {
  const button = document.createElement('button')
  button.type = 'button'
  button.className = 'button'
  writeHtml(button, control.label)
  button.addEventListener('click', () => {
    pressed = button.parentElement
    change({}, control.change)
  })
  return {
    element: button,
    show(params, frame) {
      button.disabled = control.enabled ? !control.enabled(params) : false
      reveal(button, control.shown?.(frame) ?? true)
    },
  }
}

/**
 * Shows a control or hides it. The focus of one that goes is taken by the first that is there; one that a press of its
 * row brings comes into sight.
 * @param {HTMLElement} element @param {boolean} there
 */
function reveal(element, there) {
  if (element.hidden === !there) return
  const focused = !there && element.contains(element.ownerDocument.activeElement)
  element.hidden = !there
  if (there && pressed && pressed === element.parentElement) {
    element.scrollIntoView({ block: 'nearest', behavior: 'instant' })
    // Others come with it, in the same turn.
    queueMicrotask(() => {
      pressed = null
    })
  }
  if (!focused) return
  const other = /** @type {HTMLElement | null | undefined} */ (
    element.parentElement?.querySelector(
      ':scope > button:not([hidden], :disabled), :scope > :not([hidden]) :is(input, select):not(:disabled)',
    )
  )
  other?.focus({ preventScroll: true })
}

/**
 * @typedef {{ body: HTMLElement, input: HTMLInputElement | HTMLSelectElement, show: (value: any, frame: any) => void }}
 * Made
 * @type {Record<'range' | 'choice' | 'toggle' | 'whole', (document: Document, control: any, change: (value: unknown) =>
 * void, limits: Parameter) => Made>}
 */
const BUILD = { range: slider, choice, toggle, whole }

/**
 * @param {Document} document
 * @param {ChoiceControl} control
 * @param {(value: unknown) => void} change
 * @returns {Made}
 */
function choice(document, control, change) {
  const input = document.createElement('select')
  for (const [i, { label }] of control.options.entries()) {
    const option = document.createElement('option')
    option.setAttribute('value', String(i))
    option.textContent = label
    input.append(option)
  }
  input.addEventListener('change', () => change(control.options[Number(input.value)].value))
  return {
    body: input,
    input,
    show(now) {
      const chosen = control.options.findIndex(({ value }) => value === now)
      if (input.selectedIndex === chosen) return
      for (const [i, option] of [...input.options].entries()) option.toggleAttribute('selected', i === chosen)
      if (chosen >= 0) input.options[chosen].selected = true
    },
  }
}

/**
 * @param {Document} document
 * @param {ToggleControl} control
 * @param {(value: unknown) => void} change
 * @returns {Made}
 */
function toggle(document, control, change) {
  const { on = true, off = false } = control
  const input = document.createElement('input')
  input.setAttribute('type', 'checkbox')
  input.addEventListener('change', () => change(input.checked ? on : off))
  return {
    body: input,
    input,
    show(now) {
      if (input.hasAttribute('checked') !== (now === on)) input.toggleAttribute('checked', now === on)
      if (input.checked !== (now === on)) input.checked = now === on
    },
  }
}

/**
 * @param {Document} document
 * @param {WholeControl} _
 * @param {(value: number) => void} change
 * @param {Parameter} limits
 * @returns {Made}
 */
function whole(document, _, change, { least, greatest }) {
  const input = document.createElement('input')
  input.setAttribute('type', 'number')
  input.setAttribute('inputmode', 'numeric')
  input.setAttribute('min', String(least))
  input.setAttribute('max', String(greatest))
  input.setAttribute('step', '1')
  let newest = NaN
  const write = () => {
    if (Number.isNaN(newest) || (Number(input.value) === newest && input.value !== '')) return
    input.setAttribute('value', String(newest))
    input.value = String(newest)
  }
  input.addEventListener('blur', write)
  input.addEventListener('change', () => {
    const asked = Number(input.value)
    const kept = Number.isFinite(asked) ? Math.round(Math.min(greatest, Math.max(least, asked))) : least
    newest = kept
    input.value = String(kept)
    change(kept)
  })
  return {
    body: input,
    input,
    show(now) {
      newest = now
      // A reader who types here would lose what was typed.
      if (document.activeElement !== input) write()
    },
  }
}
