/** The reasons for the answers of a question: marked, the reader's own first, the others folded. */

import { part } from '../draw/dom.js'

/** The marks of the answers, on the choices too. @param {HTMLElement} form */
export function markChoices(form) {
  for (const [i, label] of form.querySelectorAll('.quiz-choice').entries()) {
    const mark = form.querySelector(`[data-choice="${i}"] .quiz-mark`)
    if (mark) label.append(mark.cloneNode(true))
  }
}

/**
 * The reader's own reason stands first, and the others are folded.
 * @param {HTMLElement} form
 * @param {number} mine
 * @param {boolean} folded
 */
export function fold(form, mine, folded) {
  const list = /** @type {Element} */ (form.querySelector('.quiz-reasons'))
  const reasons = [...list.children]
  reasons[mine]?.classList.add('is-yours')
  if (!folded) return
  const others = document.createElement('details')
  others.className = 'quiz-others'
  part(document, others, 'summary', '').textContent = mine < 0 ? 'Answers that are often given' : 'The other answers'
  part(document, part(document, others, 'div', 'details-body'), 'ul', 'quiz-reasons').append(
    ...reasons.filter((_, i) => i !== mine),
  )
  list.after(others)
}

/** @param {HTMLElement} form */
export function unfold(form) {
  const list = form.querySelector('.quiz-reasons')
  const reasons = [...form.querySelectorAll('[data-choice]')]
  reasons.sort((a, b) => Number(a.getAttribute('data-choice')) - Number(b.getAttribute('data-choice')))
  list?.append(...reasons)
  form.querySelector('.quiz-others')?.remove()
}
