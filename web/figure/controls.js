/**
 * Builds native controls with a visible label; screen readers say their value in words.
 *
 * A control shows one parameter and reports the value that the reader chooses. It computes nothing. The lab says how
 * far the parameter goes, and in which steps.
 */

import { SVG } from '../draw/dom.js'
import { Pen } from '../draw/pen.js'
import { writeHtml } from '../draw/words.js'

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
 * @typedef {RangeControl | ChoiceControl | ToggleControl | WholeControl | ActionControl | CustomControl} Control
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

/** @param {Document} document @param {ActionControl} control @param {Function} change @returns {Shown} */
function action(document, control, change) {
  const button = document.createElement('button')
  button.type = 'button'
  button.className = 'button'
  writeHtml(button, control.label)
  button.addEventListener('click', () => change({}, control.change))
  return {
    element: button,
    show(params, frame) {
      button.disabled = control.enabled ? !control.enabled(params) : false
      reveal(button, control.shown?.(frame) ?? true)
    },
  }
}

/**
 * Shows a control or hides it. The focus of one that goes is taken by the first that is there.
 * @param {HTMLElement} element @param {boolean} there
 */
function reveal(element, there) {
  if (element.hidden === !there) return
  const focused = !there && element.contains(element.ownerDocument.activeElement)
  element.hidden = !there
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
const BUILD = { range, choice, toggle, whole }

/** So many letters have room beside every slider, and from so many values the longest words are found. */
const [LETTERS, SAMPLES] = [4, 40]

/**
 * @param {Document} document
 * @param {RangeControl} control
 * @param {(value: number) => void} change
 * @param {Parameter} limits
 * @returns {Made}
 */
function range(document, control, change, limits) {
  const { scale = (/** @type {number} */ value) => value } = control
  const [min, max] = control.ends ?? [scale(limits.least, limits), scale(limits.greatest, limits)]
  const step = control.step ?? scale(limits.step, limits)
  const body = document.createElement('span')
  body.className = 'control-body'
  const input = document.createElement('input')
  input.setAttribute('type', 'range')
  for (const [key, value] of Object.entries({ min, max, step })) input.setAttribute(key, String(value))
  const value = document.createElement('span')
  value.className = 'control-value'
  value.setAttribute('aria-hidden', 'true')
  const track = document.createElement('span')
  track.className = 'control-track'
  const notches = document.createElementNS(SVG, 'svg')
  notches.setAttribute('class', 'notches')
  notches.setAttribute('aria-hidden', 'true')
  track.append(input, notches)
  body.append(track, value)
  const pen = new Pen(notches)
  let said = ''
  let room = 0
  /**
   * The slider is as wide at one value as at another, or the thumb would run away from the finger.
   * @param {number} letters
   */
  const keepRoom = (letters) => {
    if (letters <= room) return
    room = letters
    if (room > LETTERS) value.setAttribute('style', `min-width:${room}ch`)
  }
  /** The longest words, of values all along the slider. @param {any} frame */
  const longest = (frame) =>
    Math.max(
      ...Array.from(
        { length: SAMPLES + 1 },
        (_, i) =>
          control.words(Math.min(max, min + step * Math.round(((max - min) * i) / SAMPLES / step)), frame).length,
      ),
    )

  input.addEventListener('input', () => change(Number(input.value)))
  // A finger that comes down here to scroll the page moves the thumb before the browser knows better: it is put back.
  let before = input.value
  input.addEventListener('pointerdown', () => {
    before = input.value
  })
  input.addEventListener('pointercancel', () => {
    input.value = before
    change(Number(before))
  })
  input.addEventListener('keydown', (event) => {
    const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key]
    if (!sign || !event.shiftKey) return
    event.preventDefault()
    input.value = String(Number(input.value) + sign * step * 10)
    change(Number(input.value))
  })
  return {
    body,
    input,
    show(parameter, frame) {
      const now = scale(parameter, limits)
      if (Number(input.value) !== now || !input.hasAttribute('value')) {
        input.setAttribute('value', String(now))
        input.value = String(now)
      }
      const words = control.words(now, frame)
      if (said !== words) {
        if (said === '') keepRoom(longest(frame))
        keepRoom(words.length)
        said = value.textContent = words
        input.setAttribute('aria-valuetext', words)
      }
      const share = (/** @type {number} */ at) => `${Math.round(((at - min) / (max - min)) * 1e4) / 100}%`
      pen.draw(() => {
        for (const [i, notch] of (control.notches?.(frame) ?? []).entries()) {
          if (notch.at < min || notch.at > max) continue
          const x = share(notch.at)
          // A name at an end of the slider stays over the slider.
          const part = (notch.at - min) / (max - min)
          const anchor = part < 0.12 ? 'start' : part > 0.88 ? 'end' : 'middle'
          pen.mark('line', `line${i}`, { class: `notch ${notch.kind ?? 'plain'}`, x1: x, x2: x, y1: 0, y2: 6 })
          pen.text(
            `name${i}`,
            {
              class: `notch-name ${notch.kind ?? 'plain'}`,
              x,
              y: 18,
              'text-anchor': anchor,
              dx: anchor === 'start' ? -6 : anchor === 'end' ? 6 : null,
            },
            notch.name,
          )
        }
      })
    },
  }
}

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
