/**
 * Builds the elements of a figure: its panels, controls, readouts and tools. The same in a reader's browser and, for
 * the stills, in Node, where nothing answers.
 */

import { buildControl } from './controls.js'
import { SVG, button, part } from '../draw/dom.js'
import { isLater, pinOf } from './layout.js'
import { Pen } from '../draw/pen.js'
import { Readouts } from './readouts.js'
import { held, writeHtml } from '../draw/words.js'

/** @typedef {import('../draw/words.js').Words} Words */
/** @typedef {{ svg: Element, pen: Pen, width: number, height: number }} Panel pixels */
/** @typedef {import('./readouts.js').Readout} Readout */

/**
 * What the reader does to a running figure.
 * @typedef {object} Orders
 * @property {() => void} play
 * @property {() => void} step
 * @property {() => void} reset
 * @property {(rate: number) => void} speed
 * @property {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} change
 * @property {(stage: number) => void} grow shows more of a figure that opens small
 * @property {() => void} link
 * @property {(() => void) | null} embed null where the figure shows what another page does not have
 * @property {((kind: 'svg' | 'csv') => void) | null} download null where the page may not save files
 */

/** @typedef {ReturnType<typeof buildShell>} Shell */

export const SPEEDS = [0.5, 1, 2, 5, 10]

/**
 * @param {Document} document
 * @param {import('./spec.js').FigureSpec} spec
 * @param {Element} into emptied first
 * @param {Orders} orders
 * @param {import('estimate-wasm').Parameter[]} parameters the lab's
 */
export function buildShell(document, spec, into, orders, parameters) {
  into.replaceChildren()
  const pin = pinOf(spec)
  into.toggleAttribute('data-pinned', Boolean(pin))
  into.toggleAttribute('data-slow', Boolean(spec.slow))
  const stage = (/** @type {Element} */ element, /** @type {string} */ name, where = spec.stages?.hand) => {
    if (where?.[name]) element.setAttribute('data-from', String(where[name]))
  }
  /** @type {import('./spec.js').Limits} */
  const limits = Object.fromEntries(parameters.map((parameter) => [parameter.name, parameter]))
  /** @type {Record<string, Panel>} */
  const panels = {}
  for (const { name, width, height: tall, handles } of spec.panels) {
    const height = typeof tall === 'function' ? 0 : tall
    const svg = document.createElementNS(SVG, 'svg')
    svg.setAttribute('class', `panel panel-${name}`)
    svg.setAttribute('style', `grid-area:${name}`)
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`)
    svg.setAttribute('width', String(width))
    svg.setAttribute('height', String(height))
    svg.setAttribute('role', handles ? 'group' : 'img')
    stage(svg, name, spec.stages?.panels)
    if (name === pin?.name) svg.toggleAttribute('data-pin', true)
    if (isLater(spec.layout, name)) svg.toggleAttribute('data-later', true)
    into.append(svg)
    panels[name] = { svg, pen: new Pen(svg), width, height }
  }

  const verdict = part(document, into, 'p', 'verdict')
  const change = orders.change
  /** @type {HTMLButtonElement | null} */
  let invitation = null
  if (spec.invite) {
    invitation = button(document, into, '', orders.play, 'button invite')
    invitation.setAttribute('style', `grid-area:${spec.panels[0].name}`)
    writeHtml(invitation, spec.invite)
  }
  const tries = spec.tries ?? []
  /** @type {HTMLElement[]} */
  const phrases = []
  if (tries.length > 0) {
    const list = part(document, into, 'p', 'tries')
    stage(list, 'tries')
    part(document, list, 'span', 'tries-lead').textContent = 'Try this:'
    for (const { label, change: make } of tries) {
      list.append(' ')
      const phrase = button(document, list, '', () => change({}, make), 'try')
      writeHtml(phrase, label)
      phrases.push(phrase)
    }
  }
  const controls = part(document, into, 'div', 'controls')
  const run = document.createElement('div')
  run.className = 'run'
  const transport = part(document, run, 'div', 'transport')
  transport.setAttribute('role', 'group')
  transport.setAttribute('aria-label', 'Run')
  const play = button(document, transport, 'Play', orders.play, 'button play')
  button(document, transport, 'Step', orders.step)
  button(document, transport, 'Reset', orders.reset)
  if (!spec.timeless) controls.append(run)
  const shown = spec.controls.map((control) => buildControl(document, control, change, limits))
  const elements = (/** @type {boolean} */ more) =>
    spec.controls.flatMap((control, i) => (Boolean(control.more) === more ? [shown[i].element] : []))
  part(document, controls, 'div', 'params').append(...elements(false))
  const waiting = elements(true)
  if (waiting.length > 0) {
    const fold = /** @type {HTMLDetailsElement} */ (part(document, controls, 'details', 'more'))
    part(document, fold, 'summary', '').textContent = 'More'
    part(document, fold, 'div', 'params').append(...waiting)
    // On a phone one word has all that waits.
    fold.addEventListener('toggle', () => into.toggleAttribute('data-further', fold.open))
  }
  if (spec.timeless && shown.length === 0) controls.remove()
  for (const [i, { name }] of spec.controls.entries()) {
    stage(shown[i].element, name)
    // Words in the text bring what comes with a stage into sight (web/page/show-part.js).
    if (spec.stages?.hand[name]) shown[i].element.dataset.control = name
  }
  const options = SPEEDS.map((value) => ({ value, label: `${value === 0.5 ? '½' : value}×` }))
  const speed = buildControl(
    document,
    { kind: 'choice', name: 'speed', label: 'Speed', options, set: (rate) => (orders.speed(rate), {}) },
    (_, make) => void make?.({}, null),
    {},
  )
  stage(speed.element, 'speed')
  run.append(speed.element)
  if (spec.seeded) {
    const seed = buildControl(document, { kind: 'whole', name: 'seed', label: 'Seed' }, change, limits)
    stage(seed.element, 'seed')
    shown.push(seed)
    run.append(seed.element)
  }

  if (spec.stages) {
    const list = part(document, into, 'p', 'grow-list')
    for (const [i, words] of spec.stages.grow.entries()) {
      const grow = button(document, list, '', () => orders.grow(i + 2), 'button')
      grow.setAttribute('data-at', String(i + 1))
      writeHtml(grow, words)
    }
  }
  if (waiting.length === 0) {
    const further = button(document, into, 'More: plots, numbers, speed, link', () => {
      further.setAttribute('aria-expanded', String(into.toggleAttribute('data-further')))
    })
    further.setAttribute('class', 'further')
    further.setAttribute('aria-expanded', 'false')
    stage(further, 'readouts')
  }
  const readouts = new Readouts(document, into)
  stage(readouts.into, 'readouts')
  let [playing, said] = [false, '']
  const tools = /** @type {HTMLElement} */ (part(document, into, 'div', 'figure-tools'))
  stage(tools, 'tools')
  button(document, tools, 'Copy link to this state', orders.link, 'quiet')
  if (orders.embed) button(document, tools, 'Embed', orders.embed, 'quiet')
  const { download } = orders
  if (download) {
    button(document, tools, 'Download SVG', () => download('svg'), 'quiet')
    button(document, tools, 'Download CSV', () => download('csv'), 'quiet')
  }
  const note = part(document, tools, 'span', 'figure-note')

  return {
    panels,
    /**
     * Gives the panels whose height goes with the frame their height, and hides those that it has not: in one turn, or
     * the figure would be of another height for a moment, and what the reader presses would move.
     * @param {any} frame
     */
    fit(frame) {
      if (pin && spec.layout.pins) into.toggleAttribute('data-pinned', spec.layout.pins(frame))
      for (const { name, width, height, shown: there } of spec.panels) {
        const panel = panels[name]
        const hidden = there ? !there(frame) : false
        if (panel.svg.hasAttribute('hidden') !== hidden) {
          panel.svg.toggleAttribute('hidden', hidden)
          // Nothing that is hidden is left for a key or a finger.
          if (hidden) panel.pen.draw(() => {})
        }
        if (typeof height !== 'function') continue
        const tall = String(height(frame))
        if (panel.svg.getAttribute('height') === tall) continue
        panel.svg.setAttribute('height', tall)
        panel.height = (panel.width * Number(tall)) / width
        panel.svg.setAttribute('viewBox', `0 0 ${panel.width} ${panel.height}`)
      }
    },
    limits,
    play,
    note,
    tools,
    into,
    verdict,
    /**
     * @param {any} frame
     * @param {{ rate: number, playing: boolean }} life
     * @param {any} [params] what the controls show, where the frame is older than they are
     */
    show(frame, life, params = frame.params) {
      if (playing !== life.playing) play.textContent = life.playing ? 'Pause' : 'Play'
      playing = life.playing
      if (invitation) invite(invitation, frame.step > 0 || playing, play)
      speed.show({ speed: life.rate }, frame)
      for (const control of shown) control.show(params, frame)
      for (const [i, { shown: fits }] of tries.entries()) if (fits) phrases[i].toggleAttribute('hidden', !fits(frame))
      const judged = spec.verdict?.(frame) ?? ''
      if (said !== judged) writeHtml(verdict, held((said = judged)).replaceAll('σ', '*σ*'))
      readouts.show(spec.readouts(frame))
    },
  }
}

/**
 * The one button of a figure that has not begun, over its first panel. When it goes, Play has the focus.
 * @param {HTMLButtonElement} button @param {boolean} gone @param {HTMLButtonElement} play
 */
function invite(button, gone, play) {
  if (button.hidden === gone) return
  const focused = gone && button.ownerDocument.activeElement === button
  button.hidden = gone
  if (focused) play.focus({ preventScroll: true })
}
