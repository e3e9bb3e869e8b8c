/** A figure that would give an answer away waits under a veil until the reader has answered, or asked to be shown. */

import { button, part } from '../draw/dom.js'
import { readState } from '../figure/state-in-url.js'
import { onceNear } from './when-near.js'

/**
 * @param {HTMLElement} question
 * @param {boolean} on
 * @param {() => void} skip
 */
export function lock(question, on, skip = () => {}) {
  const id = question.dataset.unlocks
  const figure = id ? document.getElementById(id) : null
  const widget = figure?.querySelector('.widget')
  if (!id || !figure || !widget) return
  // Who follows a link to a state of the figure wants to see that state.
  const linked = readState(location.href, id)
  const locked = on && (linked === null || linked === 'mangled')
  widget.toggleAttribute('data-locked', locked)
  widget.toggleAttribute('inert', locked)
  figure.querySelector('.figure-locked')?.remove()
  if (locked) widget.after(veil(question, skip))
}

/** @param {HTMLElement} question @param {() => void} skip */
function veil(question, skip) {
  const cover = document.createElement('div')
  cover.className = 'figure-locked'
  const words = part(document, cover, 'p', '')
  const title = question.querySelector('legend .title')?.textContent ?? 'the question'
  const link = document.createElement('a')
  link.href = `#${question.id}`
  link.textContent = title
  words.append('First answer “', link, '”, then try it here.')
  // A form control far below would have the browser lay its part of the text out.
  onceNear(cover, () => button(document, cover, 'Skip, show me', skip))
  return cover
}
