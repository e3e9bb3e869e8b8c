/** Files of a figure: its panels as one SVG that holds its own styles, and its series as CSV. */

import { SVG } from '../draw/dom.js'

const STYLES = [
  'fill',
  'fill-opacity',
  'stroke',
  'stroke-width',
  'stroke-opacity',
  'stroke-dasharray',
  'stroke-linecap',
  'stroke-linejoin',
  'opacity',
  'font-family',
  'font-size',
  'font-style',
  'font-weight',
  'font-variant-numeric',
  'text-anchor',
  'display',
  'paint-order',
]

/**
 * @param {Element} shell
 * @param {string} title
 */
export function asSvg(shell, title) {
  const { ownerDocument: document } = shell
  const frame = shell.getBoundingClientRect()
  const root = document.createElementNS(SVG, 'svg')
  root.setAttribute('xmlns', SVG)
  const name = root.appendChild(document.createElementNS(SVG, 'title'))
  name.textContent = title
  const paper = root.appendChild(document.createElementNS(SVG, 'rect'))
  paper.setAttribute('width', '100%')
  paper.setAttribute('height', '100%')
  paper.setAttribute('fill', getComputedStyle(document.body).backgroundColor)
  let [right, bottom] = [0, 0]
  for (const panel of shell.querySelectorAll('svg.panel:not([hidden])')) {
    const box = panel.getBoundingClientRect()
    const copy = /** @type {Element} */ (panel.cloneNode(true))
    inline(panel, copy)
    const place = { x: box.left - frame.left, y: box.top - frame.top, width: box.width, height: box.height }
    for (const [key, value] of Object.entries(place)) copy.setAttribute(key, String(Math.round(value)))
    root.append(copy)
    right = Math.max(right, place.x + box.width)
    bottom = Math.max(bottom, place.y + box.height)
  }
  root.setAttribute('viewBox', `0 0 ${Math.ceil(right)} ${Math.ceil(bottom)}`)
  return new XMLSerializer().serializeToString(root)
}

/** @param {Element} from @param {Element} to */
function inline(from, to) {
  const style = getComputedStyle(from)
  for (const name of STYLES) {
    const value = style.getPropertyValue(name)
    if (value) to.setAttribute(name, value)
  }
  for (const name of ['class', 'tabindex', 'role', 'style']) to.removeAttribute(name)
  for (let i = 0; i < from.children.length; i += 1) inline(from.children[i], to.children[i])
}

/** @param {Record<string, number[]>} series */
export function asCsv(series) {
  const names = Object.keys(series)
  const rows = Math.max(0, ...names.map((name) => series[name].length))
  const lines = [names.join(',')]
  for (let i = 0; i < rows; i += 1) lines.push(names.map((name) => series[name][i] ?? '').join(','))
  return `${lines.join('\n')}\n`
}
