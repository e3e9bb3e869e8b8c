/** The hand on the panels over time: a touch chooses a reading, a drag across a panel a stretch of time. */

import { SVG } from '../draw/dom.js'
import { readingAt, timeAt } from '../widgets/robot-log/history.js'
import { looksOf } from '../widgets/robot-log/looks.js'

/** Panels over time. */
const PANELS = ['innovations', 'errors', 'nis', 'bearings']
/** A hand that has moved less has touched, pixels. */
const TOUCH = 8

/**
 * @param {HTMLElement} live the figure's panels
 * @param {() => import('../widgets/robot-log/looks.js').Frame} frame
 * @param {(looks: any) => void} look
 */
export function handOnTime(live, frame, look) {
  for (const name of PANELS) {
    const svg = /** @type {SVGSVGElement | null} */ (live.querySelector(`.panel-${name}`))
    if (svg) onPanel(svg, name, frame, look)
  }
}

/**
 * @param {SVGSVGElement} svg @param {string} name
 * @param {() => import('../widgets/robot-log/looks.js').Frame} frame @param {(looks: any) => void} look
 */
function onPanel(svg, name, frame, look) {
  /** @type {{ id: number, x: number } | null} */
  let held = null
  const mark = document.createElementNS(SVG, 'rect')
  mark.setAttribute('class', 'band chosen')
  /** In the panel's own pixels. @param {PointerEvent} event */
  const placeOf = (event) => {
    const { left, top, width } = svg.getBoundingClientRect()
    const scale = svg.viewBox.baseVal.width / (width || 1)
    return [(event.clientX - left) * scale, (event.clientY - top) * scale]
  }
  const drop = () => {
    held = null
    mark.remove()
  }
  svg.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || /** @type {Element} */ (event.target).closest('.handle')) return
    held = { id: event.pointerId, x: placeOf(event)[0] }
    svg.setPointerCapture(event.pointerId)
  })
  svg.addEventListener('pointermove', (event) => {
    if (held?.id !== event.pointerId) return
    const [x] = placeOf(event)
    if (Math.abs(x - held.x) < TOUCH) return mark.remove()
    const { height } = svg.viewBox.baseVal
    const sides = { x: Math.min(x, held.x), width: Math.abs(x - held.x), y: 26, height: Math.max(0, height - 50) }
    for (const [key, value] of Object.entries(sides)) mark.setAttribute(key, String(value))
    if (!mark.parentNode) svg.append(mark)
  })
  svg.addEventListener('pointerup', (event) => {
    if (held?.id !== event.pointerId) return
    const [from] = [held.x]
    const [x, y] = placeOf(event)
    drop()
    const { width, height } = svg.viewBox.baseVal
    const now = frame()
    if (Math.abs(x - from) >= TOUCH) {
      const window = [from, x].map((at) => timeAt(now, at, width)).sort((a, b) => a - b)
      if (window[1] > window[0]) look({ window })
      return
    }
    const source = name === 'bearings' ? { sensor: 'bearing', landmark: null, bearing: true } : looksOf(now).source
    const i = readingAt(now, source, [x, name === 'errors' || name === 'nis' ? null : y], { width, height })
    if (i >= 0) look({ touched: now.innovations.time[i] })
  })
  svg.addEventListener('pointercancel', drop)
  svg.addEventListener('lostpointercapture', drop)
}
