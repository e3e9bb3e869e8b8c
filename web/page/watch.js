/** Watches a figure until it is in the state that an exercise asks for, and leads there and back. */

import { part } from '../draw/dom.js'
import { unmet } from './answer.js'

const EVERY_MS = 400
const HERE = 'This is the state that the exercise asks for. '
const GONE = 'The figure has been in the state that the exercise asks for, and has moved on. '

/** @param {HTMLElement} status @param {string} words told once, however often they are true */
function say(status, words) {
  if (status.textContent !== words) status.textContent = words
}

/**
 * The frame on the screen of a question's figure; null while the figure is not running.
 * @param {HTMLElement} question
 */
export function frameOf(question) {
  const widget = /** @type {any} */ (
    document.getElementById(question.dataset.figureId ?? '')?.querySelector('.widget') ?? null
  )
  return widget?.settled ? widget.frame : null
}

/**
 * Leads to the figure of a question, and calls `met` when the figure comes into the wanted state.
 * @param {HTMLElement} question
 * @param {import('./answer.js').Key} key
 * @param {() => void} met
 */
export function lookAt(question, key, met) {
  const figure = document.getElementById(question.dataset.figureId ?? '')
  const widget = /** @type {HTMLElement | null} */ (figure?.querySelector('.widget') ?? null)
  if (!figure || !widget) return
  figure.querySelector('.quiz-watch')?.remove()
  const words = document.createElement('p')
  words.className = 'quiz-watch'
  const status = part(document, words, 'span', '')
  status.setAttribute('role', 'status')
  status.textContent = 'This line tells you when the figure is in the state that the exercise asks for. '
  const back = /** @type {HTMLAnchorElement} */ (part(document, words, 'a', ''))
  back.href = `#${question.id}`
  back.textContent = 'Back to the exercise'
  // Above the picture, where the page now goes to, and in sight as long as the figure is.
  widget.before(words)
  // The browser's way back leads to the exercise.
  location.hash = figure.id
  figure.scrollIntoView({ block: 'start' })
  widget.tabIndex = -1
  widget.focus({ preventScroll: true })
  let [before, reached] = [false, false]
  const timer = setInterval(() => {
    if (!words.isConnected) return clearInterval(timer)
    const frame = frameOf(question)
    if (!frame) return
    const here = unmet(key, frame).length === 0
    // A state that is only passed on the way is not yet found: the figure is in it at two looks in a row.
    if (here && before && !reached) {
      reached = true
      met()
    }
    before = here
    if (reached) say(status, here ? HERE : GONE)
  }, EVERY_MS)
}

/** @param {HTMLElement} question */
export function stopWatching(question) {
  document
    .getElementById(question.dataset.figureId ?? '')
    ?.querySelector('.quiz-watch')
    ?.remove()
}
