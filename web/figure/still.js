/**
 * Draws a figure's default state in Node, with the same elements and the same drawing code as in a browser. Where the
 * living figure has controls, a still has words.
 */

import { drawHandle } from './handle.js'
import { buildShell } from './shell.js'
import { plain } from '../draw/words.js'

const nothing = () => {}

/**
 * @param {Document} document
 * @param {import('./spec.js').FigureSpec} spec
 * @param {any} frame
 * @param {import('estimate-wasm').Parameter[]} parameters the lab's
 * @param {any} [aside] what is computed beside the run
 * @returns {{ still: Element, words: string }}
 */
export function drawStill(document, spec, frame, parameters, aside = null) {
  const into = document.createElement('div')
  into.className = 'still'
  const orders = {
    play: nothing,
    step: nothing,
    reset: nothing,
    speed: nothing,
    change: nothing,
    grow: nothing,
    link: nothing,
    embed: nothing,
    download: nothing,
  }
  const shell = buildShell(document, spec, into, orders, parameters)
  const view = {
    previous: null,
    beat: /** @type {const} */ ({ name: 'rest', t: 1 }),
    elapsed: Infinity,
    memory: {},
    aside,
    limits: shell.limits,
    handle: (/** @type {any} */ pen, /** @type {string} */ key, /** @type {any} */ handle) =>
      void drawHandle(pen, key, handle),
  }
  shell.fit(frame)
  for (const { name, draw, shown } of spec.panels) if (shown?.(frame) ?? true) draw(shell.panels[name], frame, view)
  shell.show(frame, { rate: 1, playing: false })
  for (const { svg } of Object.values(shell.panels)) {
    svg.removeAttribute('role')
    svg.setAttribute('aria-hidden', 'true')
    svg.setAttribute('focusable', 'false')
  }
  for (const part of into.querySelectorAll(
    '.tries, .controls, .grow-list, .further, .readouts, .figure-tools, .verdict',
  ))
    part.setAttribute('aria-hidden', 'true')
  // What is in a hidden part needs no name, and need not be hidden again.
  for (const part of into.querySelectorAll('[aria-hidden] *'))
    for (const name of ['aria-hidden', 'aria-label', 'role']) part.removeAttribute(name)
  for (const part of into.querySelectorAll('.invite, .more dl')) part.remove()
  for (const control of into.querySelectorAll('button, input, select, textarea'))
    control.replaceWith(likeness(document, control))
  for (const more of into.querySelectorAll('.more')) more.replaceWith(closed(document, more))
  const said = Object.values(spec.describe(frame)).filter(Boolean).join(' ')
  return { still: into, words: `${said} ${plain(spec.verdict?.(frame) ?? '')}`.trim() }
}

/** What stands for a block that cannot be unfolded. @param {Document} document @param {Element} block */
function closed(document, block) {
  const likeness = document.createElement('div')
  likeness.setAttribute('class', block.getAttribute('class') ?? '')
  likeness.append(...(block.querySelector('summary')?.childNodes ?? []))
  return likeness
}

/**
 * What looks like a control and takes the same room, but is none: a browser lays out every part of a page that holds a
 * form control as soon as the page is read, and a reader's tools would offer what does not answer.
 * @param {Document} document
 * @param {Element} control
 */
function likeness(document, control) {
  const span = document.createElement('span')
  for (const name of ['hidden', 'data-at', 'data-from'])
    if (control.hasAttribute(name)) span.setAttribute(name, control.getAttribute(name) ?? '')
  const kind = control.localName === 'input' ? control.getAttribute('type') : control.localName
  span.setAttribute('class', `${control.getAttribute('class') ?? ''} like-${kind}`.trim())
  if (kind === 'textarea') span.append(control.textContent ?? '')
  if (kind === 'button') span.append(...control.childNodes)
  if (kind === 'number' || kind === 'text') span.append(control.getAttribute('value') ?? '')
  if (kind === 'checkbox' && control.hasAttribute('checked')) span.append('✓')
  if (kind === 'range') {
    const [min, max, value] = ['min', 'max', 'value'].map((name) => Number(control.getAttribute(name)))
    span.setAttribute('style', `--share:${Math.round((1e4 * (value - min)) / (max - min)) / 1e4}`)
  }
  // A list is as wide as its widest option.
  if (kind === 'select') {
    for (const option of control.querySelectorAll('option')) {
      const line = document.createElement('span')
      if (!option.hasAttribute('selected')) line.setAttribute('class', 'is-hidden')
      line.append(option.textContent ?? '')
      span.append(line)
    }
  }
  return span
}
