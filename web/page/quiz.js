/**
 * Questions: the reader commits to an answer and then reads why it is right or wrong. An answer is kept under the question's id
 * and a hash of its content, so a changed question is asked again.
 */

import { button, part } from '../core/element.js'
import { whenNear } from './near.js'
import { forgetAll, recall, remember } from './storage.js'

const KEPT = 'quiz:'
/** Letters of the longest number that anybody needs to type. */
const LONGEST = 40

export function quizzes() {
  for (const question of questions()) lock(question, !isAnswer(question, recall(keyOf(question)) ?? ''))
  whenNear('.quiz', (question) => wake(asForm(/** @type {HTMLElement} */ (question))))
  document.querySelector('[data-quiz-reset-all]')?.addEventListener('click', () => {
    forgetAll(KEPT)
    for (const question of questions()) forget(question)
  })
}

/** Every question; those that have been near the screen are forms. */
function questions() {
  return /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.quiz'))
}

/** @param {HTMLElement} question */
function keyOf({ dataset }) {
  return `${KEPT}${dataset.quiz}:${dataset.hash}`
}

/** @param {HTMLFormElement} form */
function wake(form) {
  const kept = recall(keyOf(form))
  if (kept === null || !commit(form, kept)) lock(form, true)
  form.addEventListener('submit', (event) => {
    event.preventDefault()
    const answer = new FormData(form).get(form.dataset.kind === 'choice' ? (form.querySelector('input')?.name ?? '') : 'answer')
    if (typeof answer !== 'string' || answer.trim() === '') return say(form, 'Choose an answer first.')
    if (!commit(form, answer.trim())) return say(form, 'That is not a number.')
    remember(keyOf(form), answer.trim())
    // The button that had the focus is gone.
    const verdict = /** @type {HTMLElement | null} */ (form.querySelector('.quiz-verdict'))
    verdict?.setAttribute('tabindex', '-1')
    verdict?.focus({ preventScroll: true })
  })
  form.querySelector('[data-quiz-reset]')?.addEventListener('click', () => {
    remember(keyOf(form), null)
    forget(form)
    form.querySelector('input')?.focus()
  })
}

/**
 * The page is written without forms: Chromium lays out every part of a page that holds one as soon as the page is read, and
 * most questions are far below the screen then. So a question becomes a form when it comes near.
 * @param {HTMLElement} question
 */
function asForm(question) {
  const focused = question.contains(document.activeElement) ? document.activeElement : null
  const form = document.createElement('form')
  for (const { name, value } of question.attributes) form.setAttribute(name, value)
  form.append(...question.childNodes)
  addControls(form)
  question.replaceWith(form)
  if (focused instanceof HTMLElement) focused.focus({ preventScroll: true })
  return form
}

/** @param {HTMLFormElement} form */
function addControls(form) {
  for (const [i, label] of form.querySelectorAll('.quiz-choice').entries()) {
    const input = document.createElement('input')
    Object.assign(input, { type: 'radio', name: form.id, value: String(i) })
    label.prepend(input, ' ')
  }
  const label = form.querySelector('.quiz-number label')
  if (label) {
    const input = /** @type {HTMLInputElement} */ (part(document, label, 'input', ''))
    Object.assign(input, { type: 'text', inputMode: 'decimal', autocomplete: 'off', name: 'answer', maxLength: LONGEST })
  }
  const actions = form.querySelector('.quiz-actions')
  if (!actions) return
  const commit = part(document, actions, 'button', '')
  commit.setAttribute('type', 'submit')
  commit.textContent = 'Commit'
  actions.append(' ')
  const again = button(document, actions, 'Try again', () => {}, '')
  again.toggleAttribute('data-quiz-reset', true)
  again.hidden = true
}

/**
 * Shows the verdict on an answer; false when the text is not an answer to this question.
 * @param {HTMLFormElement} form
 * @param {string} answer
 */
function commit(form, answer) {
  const right = form.dataset.kind === 'choice' ? choose(form, answer) : estimate(form, answer)
  if (right === null) return false
  form.dataset.answered = right ? 'right' : 'wrong'
  say(form, right ? 'Right.' : 'Not this time. Here is why.')
  for (const input of form.querySelectorAll('input')) input.disabled = true
  toggle(form, true)
  const answers = form.querySelector('details')
  if (answers) answers.open = true
  lock(form, false)
  return true
}

/** Whether a kept text still answers this question. @param {HTMLElement} form @param {string} answer */
function isAnswer(form, answer) {
  if (form.dataset.kind !== 'choice') return number(answer) !== null
  return [...form.querySelectorAll('[data-choice]')].some((item) => item.getAttribute('data-choice') === answer)
}

/** @param {HTMLFormElement} form @param {string} answer */
function choose(form, answer) {
  const input = [...form.querySelectorAll('input')].find(({ value }) => value === answer)
  const reason = [...form.querySelectorAll('[data-choice]')].find((item) => item.getAttribute('data-choice') === answer)
  if (!input || !reason) return null
  input.checked = true
  reason.classList.add('is-yours')
  return reason.hasAttribute('data-right')
}

/** @param {HTMLFormElement} form @param {string} answer */
function estimate(form, answer) {
  const value = number(answer)
  if (value === null) return null
  const input = form.querySelector('input')
  if (input) input.value = answer
  const near = (/** @type {Element | null} */ item) => item !== null && Math.abs(value - Number(item.getAttribute('data-value'))) <= Number(item.getAttribute('data-tolerance'))
  const right = near(form.querySelector('.quiz-value'))
  if (!right) [...form.querySelectorAll('.quiz-reasons li')].find(near)?.classList.add('is-yours')
  return right
}

/**
 * A decimal with point or comma, or a fraction.
 * @param {string} text
 */
export function number(text) {
  if (text.length > LONGEST) return null
  const parts = text.replace(/\u2212/g, '-').replace(',', '.').split('/').map((word) => word.trim())
  if (parts.length > 2 || parts.some((word) => !/^[-+]?(\d+(\.\d*)?|\.\d+)(e[-+]?\d+)?$/i.test(word))) return null
  const value = parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0])
  return Number.isFinite(value) ? value : null
}

/** @param {HTMLElement} form */
function forget(form) {
  delete form.dataset.answered
  for (const input of form.querySelectorAll('input')) input.disabled = false
  for (const item of form.querySelectorAll('.is-yours')) item.classList.remove('is-yours')
  if (form instanceof HTMLFormElement) form.reset()
  say(form, '')
  toggle(form, false)
  const answers = form.querySelector('details')
  if (answers) answers.open = false
  lock(form, true)
}

/** @param {HTMLElement} form @param {boolean} answered */
function toggle(form, answered) {
  form.querySelector('[data-quiz-reset]')?.toggleAttribute('hidden', !answered)
  form.querySelector('[type="submit"]')?.toggleAttribute('hidden', answered)
}

/** @param {HTMLElement} form @param {string} words */
function say(form, words) {
  const verdict = form.querySelector('.quiz-verdict')
  if (verdict) verdict.textContent = words
}

/** @param {HTMLElement} form @param {boolean} on */
function lock(form, on) {
  const figure = form.dataset.unlocks ? document.getElementById(form.dataset.unlocks) : null
  const widget = figure?.querySelector('.widget')
  if (!widget) return
  widget.toggleAttribute('data-locked', on)
  widget.toggleAttribute('inert', on)
  widget.querySelector('.figure-locked')?.remove()
  if (!on) return
  const words = document.createElement('p')
  words.className = 'figure-locked'
  words.textContent = 'First commit to an answer; then try it here.'
  widget.append(words)
}
