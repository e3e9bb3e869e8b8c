/** Questions: the reader commits to an answer and then reads why it is right or wrong. */

import { button, part } from '../draw/dom.js'
import { LONGEST, judge, keyOf, unmet } from './answer.js'
import { lock } from './veil.js'
import { whenNear } from './when-near.js'
import { SHOWN, count, forgetRecords, keep, standing } from './answers-kept.js'
import { fold, markChoices, unfold } from './quiz-reasons.js'
import { score, showScore } from './score.js'
import { frameOf, lookAt, stopWatching } from './watch.js'

/** The answer to a question about a figure's state, once the figure has been in it. */
const MET = 'met'

export function quizzes() {
  for (const question of questions()) lock(question, !isAnswer(question, standing(question)), () => skip(question.id))
  whenNear('.quiz', (question) => wake(asForm(/** @type {HTMLElement} */ (question))))
  whenNear('[data-score]', () => score(forgetEverything))
}

function forgetEverything() {
  forgetRecords()
  for (const question of questions()) forget(question)
  showScore()
}

/** Every question; those that have been near the screen are forms. */
function questions() {
  return /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.quiz'))
}

/** @param {HTMLFormElement} form */
function wake(form) {
  const kept = standing(form)
  if (kept === null || !commit(form, kept)) lock(form, true, () => skip(form.id))
  form.addEventListener('submit', (event) => {
    event.preventDefault()
    if (form.dataset.kind === 'state') return check(form)
    const choice = form.dataset.kind === 'choice'
    const answer = String(
      new FormData(form).get(choice ? (form.querySelector('input')?.name ?? '') : 'answer') ?? '',
    ).trim()
    const wanted = entriesOf(form)
    if (answer === '')
      return say(
        form,
        choice ? 'Choose an answer first.' : wanted > 1 ? `Type ${wanted} numbers first.` : 'Type a number first.',
      )
    if (isFirstMiss(form, answer)) return
    if (!commit(form, answer))
      return say(form, wanted > 1 ? `That is not ${wanted} numbers, or all are zero.` : 'That is not a number.')
    count(form, form.dataset.answered === 'right')
    finish(form, answer)
  })
  form.querySelector('[data-quiz-skip]')?.addEventListener('click', () => skip(form.id))
  form.querySelector('[data-quiz-look]')?.addEventListener('click', () =>
    lookAt(form, keyOf(form), () => {
      if (!form.dataset.answered) solve(form)
    }),
  )
  form.querySelector('[data-quiz-reset]')?.addEventListener('click', () => {
    keep(form, null)
    forget(form)
    showScore()
    const first = /** @type {HTMLElement | null} */ (
      form.querySelector('input') ?? form.querySelector('[type="submit"]')
    )
    first?.focus()
  })
}

/**
 * A wrong number may be mended once before the answer is shown, and one that is well known is told what it is. The
 * right one in too few digits is not wrong: once, it is asked for more of them.
 * @param {HTMLFormElement} form
 * @param {string} answer
 */
function isFirstMiss(form, answer) {
  const verdict = form.dataset.kind === 'choice' ? null : verdictOn(form, answer)
  if (!verdict || verdict.right) return false
  const vague = verdict.nearly && !form.dataset.nearly
  if (!vague && form.dataset.missed) return false
  form.dataset[vague ? 'nearly' : 'missed'] = answer
  if (!vague) count(form, false)
  showScore()
  const missed = verdict.close ? 'Close, but that is not it' : 'Not yet'
  say(form, vague ? 'Nearly: give it with a digit more.' : `${missed}: try once more. `)
  const why = form.querySelector(`[data-choice="${verdict.mine}"] .quiz-reason`)?.cloneNode(true)
  form.querySelector('.quiz-verdict')?.append(...(why?.childNodes ?? []))
  const input = form.querySelector('input')
  input?.focus()
  input?.select()
  return true
}

/** Looks whether the figure is in the state that is asked for. @param {HTMLFormElement} form */
function check(form) {
  const frame = frameOf(form)
  if (!frame) return say(form, 'The figure does not run yet. Look at it first.')
  const missing = unmet(keyOf(form), frame)
  if (missing.length === 0) {
    solve(form)
    return focusVerdict(form)
  }
  count(form, false)
  showScore()
  say(form, 'Not yet. In the figure:')
  const list = part(document, /** @type {Element} */ (form.querySelector('.quiz-verdict')), 'ul', 'quiz-missing')
  for (const i of missing) part(document, list, 'li', '').append(...copyOf(form, i))
}

/** The words of a condition. @param {HTMLElement} form @param {number} i */
function copyOf(form, i) {
  return [...(form.querySelector(`[data-condition="${i}"]`)?.cloneNode(true).childNodes ?? [])]
}

/** @param {HTMLFormElement} form */
function solve(form) {
  if (form.dataset.answered) return
  commit(form, MET)
  count(form, true)
  keep(form, MET)
  showScore()
}

/** Shows the answer to a reader who does not want to try. @param {string} id */
function skip(id) {
  const question = /** @type {HTMLElement | null} */ (document.getElementById(id))
  if (!question) return
  keep(question, SHOWN)
  const figure = document.getElementById(question.dataset.unlocks ?? '')
  const top = () => figure?.getBoundingClientRect().top ?? 0
  const stood = top()
  const asked = question.contains(document.activeElement)
  if (question instanceof HTMLFormElement) {
    commit(question, SHOWN)
    if (asked) focusVerdict(question)
  } else lock(question, false)
  // Whoever asked at the figure goes on looking at it.
  if (!asked) scrollBy({ top: top() - stood, behavior: 'instant' })
  showScore()
}

/** @param {HTMLFormElement} form @param {string} answer */
function finish(form, answer) {
  keep(form, answer)
  showScore()
  focusVerdict(form)
}

/** The button that had the focus is gone. @param {HTMLElement} form */
function focusVerdict(form) {
  const verdict = /** @type {HTMLElement | null} */ (form.querySelector('.quiz-verdict'))
  verdict?.setAttribute('tabindex', '-1')
  verdict?.focus({ preventScroll: true })
}

/**
 * The page is written without forms: Chromium lays out every part of a page that holds one as soon as the page is read,
 * and most questions are far below the screen then. So a question becomes a form when it comes near.
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
    const entries = entriesOf(form)
    // No `inputMode` of numbers: a phone's keys for them may have no minus.
    Object.assign(input, { type: 'text', autocomplete: 'off', name: 'answer', maxLength: entries * LONGEST })
  }
  const actions = form.querySelector('.quiz-actions')
  if (!actions) return
  const state = form.dataset.kind === 'state'
  const commit = part(document, actions, 'button', '')
  commit.setAttribute('type', 'submit')
  commit.textContent = state ? 'Check the figure' : 'Commit'
  actions.append(' ')
  if (state) {
    button(document, actions, 'Look at the figure', () => {}, '').toggleAttribute('data-quiz-look', true)
    actions.append(' ')
  }
  button(document, actions, 'Skip, show me', () => {}, '').toggleAttribute('data-quiz-skip', true)
  actions.append(' ')
  const again = button(document, actions, 'Try again', () => {}, '')
  again.toggleAttribute('data-quiz-reset', true)
  again.hidden = true
}

/** How many numbers are asked for; 0 if none. @param {HTMLElement} form */
function entriesOf(form) {
  return Number(form.querySelector('.quiz-number')?.getAttribute('data-entries') ?? 0)
}

/**
 * Whether a text is an answer to this question, and if so, whether it is right.
 * @param {HTMLElement} form
 * @param {string} answer
 */
function verdictOn(form, answer) {
  const key = keyOf(form)
  const verdict = { right: true, mine: -1, nearly: false, close: false }
  if (form.dataset.kind === 'state') return answer === MET ? verdict : null
  if (form.dataset.kind === 'choice') {
    const mine = [...form.querySelectorAll('[data-choice]')].findIndex(
      (item) => item.getAttribute('data-choice') === answer,
    )
    return mine < 0 ? null : { ...verdict, right: mine === key.right, mine }
  }
  const judged = judge(key, answer)
  return judged && { ...judged, mine: judged.near }
}

/** @param {HTMLElement} form @param {string | null} answer */
function isAnswer(form, answer) {
  return answer !== null && (answer === SHOWN || verdictOn(form, answer) !== null)
}

/**
 * Shows the verdict on an answer; false when the text is not an answer to this question.
 * @param {HTMLFormElement} form
 * @param {string} answer
 */
function commit(form, answer) {
  const verdict = answer === SHOWN ? null : verdictOn(form, answer)
  if (answer !== SHOWN && !verdict) return false
  form.dataset.answered = verdict ? (verdict.right ? 'right' : 'wrong') : SHOWN
  const wrong = `Not this time. Here is ${verdict && verdict.mine < 0 ? 'the answer' : 'why'}.`
  say(form, verdict ? (verdict.right ? 'Right.' : wrong) : 'Here is the answer.')
  const inputs = [...form.querySelectorAll('input')]
  for (const input of inputs) {
    if (input.type === 'radio') input.checked = input.value === answer
    else if (verdict) input.value = answer
    input.disabled = true
  }
  if (form.dataset.kind === 'choice') markChoices(form)
  if (form.querySelector('.quiz-reasons')) fold(form, verdict?.mine ?? -1, verdict !== null)
  toggle(form, true)
  const answers = form.querySelector('details')
  // A reader who skips to a figure is shown it, and not pushed away from it by the reasons.
  if (answers) answers.open = verdict !== null || !form.dataset.unlocks
  lock(form, false)
  return true
}

/** @param {HTMLElement} form */
function forget(form) {
  delete form.dataset.answered
  delete form.dataset.missed
  delete form.dataset.nearly
  for (const input of form.querySelectorAll('input')) input.disabled = false
  for (const mark of form.querySelectorAll('.quiz-choice .quiz-mark')) mark.remove()
  for (const item of form.querySelectorAll('.is-yours')) item.classList.remove('is-yours')
  unfold(form)
  stopWatching(form)
  if (form instanceof HTMLFormElement) form.reset()
  say(form, '')
  toggle(form, false)
  const answers = form.querySelector('details')
  if (answers) answers.open = false
  lock(form, true, () => skip(form.id))
}

/**
 * The buttons to answer with stand before the verdict, the one to try again behind the answer.
 * @param {HTMLElement} form
 * @param {boolean} answered
 */
function toggle(form, answered) {
  const actions = form.querySelector('.quiz-actions')
  if (actions && answered) form.append(actions)
  else if (actions) form.querySelector('.quiz-verdict')?.before(actions)
  form.querySelector('[data-quiz-reset]')?.toggleAttribute('hidden', !answered)
  for (const control of form.querySelectorAll('[type="submit"], [data-quiz-skip]'))
    control.toggleAttribute('hidden', answered)
}

/** @param {HTMLElement} form @param {string} words */
function say(form, words) {
  const verdict = form.querySelector('.quiz-verdict')
  if (verdict) verdict.textContent = words
}
