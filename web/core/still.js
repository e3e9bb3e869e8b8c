/** A figure's default state without life: the same skeleton and the same drawing, for Node. */

import { drawHandle } from './handle.js'
import { buildShell } from './shell.js'

const nothing = () => {}

/**
 * @param {Document} document
 * @param {import('./spec.js').FigureSpec} spec
 * @param {any} frame
 * @returns {{ html: string, words: string }}
 */
export function drawStill(document, spec, frame) {
  const into = document.createElement('div')
  const orders = { play: nothing, step: nothing, reset: nothing, speed: nothing, change: nothing, link: nothing, download: nothing }
  const shell = buildShell(document, spec, into, orders)
  const view = {
    previous: null, beat: /** @type {const} */ ({ name: 'rest', t: 1 }), elapsed: Infinity, memory: {},
    handle: (/** @type {any} */ pen, /** @type {string} */ key, /** @type {any} */ handle) => void drawHandle(pen, key, handle),
  }
  for (const { name, draw } of spec.panels) draw(shell.panels[name], frame, view)
  shell.show(frame, { rate: 1, playing: false })
  for (const { svg } of Object.values(shell.panels)) {
    svg.removeAttribute('role')
    svg.setAttribute('aria-hidden', 'true')
    svg.setAttribute('focusable', 'false')
  }
  for (const part of into.querySelectorAll('.controls, .readouts, .figure-tools, .verdict')) part.setAttribute('aria-hidden', 'true')
  for (const input of into.querySelectorAll('button, input, select')) input.setAttribute('disabled', '')
  const said = Object.values(spec.describe(frame)).join(' ')
  return { html: into.innerHTML, words: `${said} ${spec.verdict?.(frame) ?? ''}`.trim() }
}
