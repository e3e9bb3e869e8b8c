/**
 * Builds the elements of a figure: its panels, controls, readouts and tools. The same in a reader's browser and, for the
 * stills, in Node, where nothing answers.
 */

import { buildControl } from './controls.js'
import { SVG, button, part } from './element.js'
import { Pen } from './pen.js'
import { writeHtml } from './words.js'

/** @typedef {import('./words.js').Words} Words */
/** @typedef {{ svg: Element, pen: Pen, width: number, height: number }} Panel pixels */
/** @typedef {{ key: string, label: Words, value: string, unit?: string, kin?: import('./plot.js').Kin, note?: string }} Readout */

/**
 * What the reader does to a running figure.
 * @typedef {object} Orders
 * @property {() => void} play
 * @property {() => void} step
 * @property {() => void} reset
 * @property {(rate: number) => void} speed
 * @property {(patch: Record<string, unknown>, make?: (frame: any, lab: any) => Record<string, unknown>) => void} change
 * @property {() => void} link
 * @property {() => void} embed
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
  /** @type {import('./spec.js').Limits} */
  const limits = Object.fromEntries(parameters.map((parameter) => [parameter.name, parameter]))
  /** @type {Record<string, Panel>} */
  const panels = {}
  for (const { name, width, height, handles } of spec.panels) {
    const svg = document.createElementNS(SVG, 'svg')
    svg.setAttribute('class', `panel panel-${name}`)
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`)
    svg.setAttribute('width', String(width))
    svg.setAttribute('height', String(height))
    svg.setAttribute('role', handles ? 'group' : 'img')
    into.append(svg)
    panels[name] = { svg, pen: new Pen(svg), width, height }
  }

  const verdict = part(document, into, 'p', 'verdict')
  const controls = part(document, into, 'div', 'controls')
  const run = document.createElement('div')
  run.className = 'transport'
  run.setAttribute('role', 'group')
  run.setAttribute('aria-label', 'Run')
  const play = button(document, run, 'Play', orders.play, 'button play')
  button(document, run, 'Step', orders.step)
  button(document, run, 'Reset', orders.reset)
  if (!spec.timeless) controls.append(run)
  const change = orders.change
  const shown = spec.controls.map((control) => buildControl(document, control, change, limits))
  controls.append(...shown.map(({ element }) => element))
  const settings = document.createElement('div')
  settings.className = 'settings'
  const options = SPEEDS.map((value) => ({ value, label: `${value === 0.5 ? '½' : value}×` }))
  const speed = buildControl(document, { kind: 'choice', name: 'speed', label: 'Speed', options, set: (rate) => (orders.speed(rate), {}) }, (_, make) => void make?.({}, null), {})
  if (!spec.timeless) settings.append(speed.element)
  if (spec.seeded) {
    const seed = buildControl(document, { kind: 'whole', name: 'seed', label: 'Seed' }, change, limits)
    shown.push(seed)
    settings.append(seed.element)
  }
  if (settings.firstChild) controls.append(settings)

  const readouts = part(document, into, 'dl', 'readouts')
  /** @type {Map<string, { box: Element, value: Element, said: string }>} */
  const kept = new Map()
  let [playing, said] = [false, '']
  const tools = /** @type {HTMLElement} */ (part(document, into, 'div', 'figure-tools'))
  button(document, tools, 'Copy link to this state', orders.link, 'quiet')
  button(document, tools, 'Embed', orders.embed, 'quiet')
  const { download } = orders
  if (download) {
    button(document, tools, 'Download SVG', () => download('svg'), 'quiet')
    button(document, tools, 'Download CSV', () => download('csv'), 'quiet')
  }
  const note = part(document, tools, 'span', 'figure-note')

  return {
    panels,
    limits,
    play,
    note,
    tools,
    into,
    /**
     * @param {any} frame
     * @param {{ rate: number, playing: boolean }} life
     * @param {any} [params] what the controls show, where the frame is older than they are
     */
    show(frame, life, params = frame.params) {
      if (playing !== life.playing) play.textContent = life.playing ? 'Pause' : 'Play'
      playing = life.playing
      speed.show({ speed: life.rate }, frame)
      for (const control of shown) control.show(params, frame)
      const judged = spec.verdict?.(frame) ?? ''
      if (said !== judged) verdict.textContent = said = judged
      for (const readout of spec.readouts(frame)) {
        let held = kept.get(readout.key)
        if (!held) kept.set(readout.key, (held = buildReadout(document, readouts, readout)))
        const text = readout.unit ? `${readout.value} ${readout.unit}` : readout.value
        if (held.said === text) continue
        held.value.textContent = text
        held.said = text
      }
    },
  }
}

/** @param {Document} document @param {Element} into @param {Readout} readout */
function buildReadout(document, into, readout) {
  const box = part(document, into, 'div', `readout ${readout.kin ?? ''}`.trim())
  if (readout.kin) box.setAttribute('data-kin', readout.kin)
  writeHtml(part(document, box, 'dt', ''), readout.label)
  const value = part(document, box, 'dd', '')
  return { box, value, said: '' }
}
