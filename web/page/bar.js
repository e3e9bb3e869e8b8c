/**
 * A slim bar at the top of the window for a reader who has left the page's head behind: the section, contents, search
 * and letters. It comes when the reader scrolls up, and goes while the reader reads on; it lies over the text and moves
 * nothing.
 */

import { button, part } from '../draw/dom.js'

/** Pixels in one direction that tell reading on from going back. */
const TURN = 12
/** How long after the reader's hand a scroll is still the reader's, milliseconds. */
const HAND_MS = 1500
const UPWARDS = ['ArrowUp', 'PageUp', 'Home', ' ']

/** Builds the bar. @returns {(link: HTMLAnchorElement | undefined) => void} tells it the section */
export function bar() {
  const header = /** @type {HTMLElement} */ (document.querySelector('.site-header'))
  const box = document.createElement('nav')
  box.className = 'bar'
  box.setAttribute('aria-label', 'Section and tools')
  const section = /** @type {HTMLAnchorElement} */ (part(document, box, 'a', 'bar-section'))
  const contents = button(document, box, 'Contents', () => {}, '')
  contents.toggleAttribute('data-open-contents', true)
  contents.setAttribute('aria-expanded', 'false')
  const search = button(document, box, 'Search', () => {}, '')
  search.toggleAttribute('data-open-search', true)
  search.setAttribute('aria-haspopup', 'dialog')
  const notations = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('[data-set-notation]')])
  if (notations.length) {
    const chosen = () => notations.findIndex((it) => it.getAttribute('aria-pressed') === 'true')
    const letters = button(
      document,
      box,
      '',
      () => {
        notations[(chosen() + 1) % notations.length].click()
        name()
      },
      '',
    )
    letters.toggleAttribute('data-letters', true)
    const name = () => {
      const now = notations[chosen()].textContent
      letters.textContent = now
      letters.setAttribute('aria-label', `Letters: ${now}. Change them`)
    }
    name()
    header.addEventListener('click', name)
  }
  header.after(box)

  const root = document.documentElement
  let [last, turned, way] = [scrollY, scrollY, 0]
  const show = (/** @type {boolean} */ on) => {
    box.toggleAttribute('data-shown', on)
    root.toggleAttribute('data-bar', on)
  }
  // A page that finds its sizes scrolls too, after a jump: only the reader's own scrolling brings the bar.
  let hand = -Infinity
  const scrolls = (/** @type {Event} */ event) => {
    const upwards =
      event instanceof KeyboardEvent
        ? UPWARDS.includes(event.key)
        : event instanceof WheelEvent
          ? event.deltaY < 0
          : event.type === 'touchmove' || event.target === root
    if (upwards) hand = event.timeStamp
  }
  for (const kind of ['wheel', 'touchmove', 'keydown', 'pointerdown'])
    addEventListener(kind, scrolls, { passive: true })
  addEventListener(
    'scroll',
    () => {
      const y = scrollY
      // A jump, as a link makes one, is neither: the bar would cover what it led to.
      if (y < header.offsetHeight || Math.abs(y - last) > innerHeight * 0.8) show(false)
      else if (y - turned > TURN && !box.querySelector(':focus-visible')) show(false)
      else if (turned - y > TURN && performance.now() - hand < HAND_MS) show(true)
      // Where the direction last changed.
      if (Math.sign(y - last) !== way && y !== last) {
        way = Math.sign(y - last)
        turned = last
      }
      last = y
    },
    { passive: true },
  )
  addEventListener('hashchange', () => show(false))

  return (link) => {
    if (!link) return
    section.href = link.href
    section.replaceChildren(...[...link.childNodes].map((node) => node.cloneNode(true)))
  }
}
