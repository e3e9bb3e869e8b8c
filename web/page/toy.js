/**
 * The picture at a page's head, in the reader's hand. What it shows was computed when the book was built: the chapter's
 * moves along straight lines, and the cover's has a track for each place of its handle. Nothing is computed here.
 */

import { SVG } from '../draw/dom.js'
import { drag } from '../figure/drag.js'

/** Room for a finger, in the picture's own pixels. */
const REACH = 24

/** @typedef {{ svg: SVGSVGElement, handle: SVGElement, words: SVGElement }} Toy */

export function toys() {
  const touch = /** @type {SVGSVGElement | null} */ (document.querySelector('.vignette[data-toy=touch]'))
  if (touch) touching(touch)
  const lap = /** @type {SVGSVGElement | null} */ (document.querySelector('.vignette[data-toy=lap]'))
  if (lap) lapping(lap)
}

/**
 * A handle with its name for screen readers and a word beside it.
 * @param {SVGSVGElement} svg
 * @param {string} label
 * @param {string} shown
 * @returns {Toy}
 */
function hold(svg, label, shown) {
  const make = (
    /** @type {string} */ name,
    /** @type {Record<string, string>} */ given,
    /** @type {Element} */ into,
  ) => {
    const element = /** @type {SVGElement} */ (document.createElementNS(SVG, name))
    for (const [key, value] of Object.entries(given)) element.setAttribute(key, value)
    into.append(element)
    return element
  }
  svg.removeAttribute('aria-hidden')
  svg.setAttribute('role', 'group')
  svg.setAttribute('aria-label', 'A picture to touch')
  const handle = make('g', { class: 'handle', role: 'slider', tabindex: '0', 'aria-label': label }, svg)
  make('circle', { class: 'handle-reach', r: String(REACH) }, handle)
  make('circle', { class: 'handle-ring', r: '9' }, handle)
  const words = make('text', { class: 'handle-name' }, handle)
  words.textContent = shown
  return { svg, handle, words }
}

/** From the window's pixels to the picture's. @param {SVGSVGElement} svg */
const scaleOf = (svg) => svg.viewBox.baseVal.width / svg.getBoundingClientRect().width

/** The head of the chapter: the line moves, and the touching point slides. @param {SVGSVGElement} svg */
function touching(svg) {
  const { mean, foot, reading, expected } = Object.fromEntries(
    Object.entries(svg.dataset).map(([key, value]) => [key, (value ?? '').split(' ').map(Number)]),
  )
  const { handle, words } = hold(svg, 'The line of the reading', 'drag up or down')
  const far = foot[1] - mean[1]
  // The line stays in the picture, and the estimate too.
  const most = Math.min((svg.viewBox.baseVal.height - 18 - mean[1]) / far, mean[0] / Math.abs(foot[0] - mean[0]))
  const least = -(mean[1] - 18) / far
  let share = 1
  const place = () => mean[1] + share * far
  const show = () => {
    svg.style.setProperty('--share', String(share))
    handle.setAttribute('transform', `translate(22 ${place()})`)
    const value = expected[0] + share * (reading[0] - expected[0])
    handle.setAttribute('aria-valuetext', `${value.toFixed(1)} metres a second; the estimate goes with it`)
    handle.setAttribute('aria-valuenow', value.toFixed(1))
  }
  const set = (/** @type {number} */ next) => {
    svg.classList.add('is-held')
    words.textContent = ''
    share = Math.max(least, Math.min(most, next))
    show()
  }
  words.setAttribute('x', '14')
  words.setAttribute('y', '-12')
  drag(handle, svg, {
    at: () => [0, place() / scaleOf(svg)],
    move: (_, y) => set((y * scaleOf(svg) - mean[1]) / far),
    nudge: (dx, dy) => set(share - (0.05 * (dy || dx)) / Math.sign(far)),
    jump: (end) => set((end === 'home') === far > 0 ? most : least),
  })
  show()
}

/** The cover: the end of the track is the handle, and each place of it has its lap. @param {SVGSVGElement} svg */
function lapping(svg) {
  const tracks = [...svg.querySelectorAll('.lap')]
  const ends = tracks.map((track) => (track.getAttribute('data-end') ?? '').split(' ').map(Number))
  const { handle, words } = hold(svg, 'The wheel’s error', 'drag')
  let at = tracks.findIndex((track) => !track.hasAttribute('hidden'))
  words.setAttribute('x', '14')
  words.setAttribute('y', '-12')
  const show = () => {
    for (const [i, track] of tracks.entries()) track.toggleAttribute('hidden', i !== at)
    handle.setAttribute('transform', `translate(${ends[at].join(' ')})`)
    handle.setAttribute('aria-valuenow', String(at))
    handle.setAttribute('aria-valuetext', tracks[at].getAttribute('data-words') ?? '')
  }
  const set = (/** @type {number} */ next) => {
    at = Math.max(0, Math.min(tracks.length - 1, next))
    words.textContent = ''
    show()
  }
  drag(handle, svg, {
    at: () => /** @type {[number, number]} */ (ends[at].map((value) => value / scaleOf(svg))),
    move: (x, y) => {
      const off = ends.map(([ex, ey]) => Math.hypot(ex - x * scaleOf(svg), ey - y * scaleOf(svg)))
      set(off.indexOf(Math.min(...off)))
    },
    nudge: (dx, dy) => set(at + (dx || dy)),
    jump: (end) => set(end === 'home' ? 0 : tracks.length - 1),
  })
  show()
}
