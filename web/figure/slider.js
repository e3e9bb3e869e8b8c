/**
 * A slider: a native range with named places on it and its value in words beside it.
 */

import { SVG } from '../draw/dom.js'
import { Pen } from '../draw/pen.js'

/** @typedef {import('./controls.js').RangeControl} RangeControl */
/** @typedef {import('./controls.js').Made} Made */
/** @typedef {import('estimate-wasm').Parameter} Parameter */

/** So many letters have room beside every slider, and from so many values the longest words are found. */
const [LETTERS, SAMPLES] = [4, 40]

/**
 * @param {Document} document
 * @param {RangeControl} control
 * @param {(value: number) => void} change
 * @param {Parameter} limits
 * @returns {Made}
 */
export function slider(document, control, change, limits) {
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
