/**
 * How far the reader has come with the questions of the chapter: shown at its end, and given out as a file. The
 * chapter's list of exercises knows their questions; the page of the exercises shows how far they are, and leads to the
 * rest.
 */

import { save } from '../figure/save.js'
import { button, part } from '../draw/dom.js'
import { tried } from './answers-kept.js'
import { outlasts } from './storage.js'

/** An exercise, here or in the list of those on another page. */
const EXERCISE = '.exercise, .exercise-elsewhere'

/** Fills the place at the chapter's end. @param {() => void} reset forgets every answer */
export function score(reset) {
  const box = document.querySelector('[data-score]')
  if (!box || box.childElementCount > 0) return
  const title = part(document, box, 'h2', 'score-title')
  title.textContent = 'Your answers'
  const words = part(document, box, 'div', 'score-words')
  words.setAttribute('role', 'status')
  part(document, box, 'div', 'score-open')
  const note = part(document, box, 'p', 'score-note')
  note.textContent = outlasts()
    ? 'They are kept in this browser and sent nowhere. The file is for you, or for a teacher.'
    : 'This browser does not let the page keep anything: your answers last until you close the page. ' +
      'The file keeps them.'
  const actions = part(document, box, 'p', 'score-actions')
  const whole = box.getAttribute('data-score')
  if (whole) {
    const link = part(document, actions, 'a', '')
    link.setAttribute('href', whole)
    link.textContent = 'All your answers, and a file of them, are at the end of the chapter.'
    return showScore()
  }
  button(document, actions, 'Save my answers as a file', () => {
    const { slug } = chapter()
    save(`${slug}-answers.json`, 'application/json', `${JSON.stringify(report(), null, 2)}\n`)
  })
  actions.append(' ')
  button(document, actions, 'Forget my answers to the questions', reset)
  showScore()
}

/** Brings the place up to date, if it is filled. */
export function showScore() {
  const [words, open] = ['.score-words', '.score-open'].map((name) => document.querySelector(`[data-score] ${name}`))
  if (!words || !open) return
  const { predictions, exercises } = report()
  words.replaceChildren()
  for (const [what, all] of /** @type {const} */ ([
    ['Predictions', predictions],
    ['Exercises', exercises],
  ])) {
    if (all.length > 0) part(document, words, 'p', '').textContent = sentence(what, all)
  }
  for (const { id, answered } of exercises) document.getElementById(id)?.toggleAttribute('data-all-answered', answered)
  open.replaceChildren()
  const left = [...predictions, ...exercises].filter(({ answered }) => !answered)
  if (left.length === 0) return
  part(document, open, 'p', '').textContent = 'Not answered yet:'
  const list = part(document, open, 'ul', '')
  for (const { address, title } of left) {
    const link = part(document, part(document, list, 'li', ''), 'a', '')
    link.setAttribute('href', address)
    link.textContent = title
  }
}

/** @param {string} what @param {ReturnType<typeof summary>[]} all */
function sentence(what, all) {
  const many = (/** @type {(one: ReturnType<typeof summary>) => boolean} */ holds) => all.filter(holds).length
  const atOnce = many(({ right, atOnce }) => right && atOnce)
  return (
    `${what}: ${many(({ answered }) => answered)} of ${all.length} answered, ${atOnce} right at once, ` +
    `${many(({ right }) => right) - atOnce} right after more tries.`
  )
}

function chapter() {
  const article = /** @type {HTMLElement | null} */ (document.querySelector('[data-chapter]'))
  return { slug: article?.dataset.chapter ?? 'chapter', title: document.querySelector('h1')?.textContent?.trim() ?? '' }
}

/** What the file holds. */
export function report() {
  const questions = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('.quiz, .quiz-elsewhere')])
  const predictions = questions
    .filter((it) => !it.closest(EXERCISE))
    .map((it) => ({
      ...summary([it]),
      id: it.dataset.quiz ?? '',
      title: titleOf(it, 'legend .title'),
      address: `#${it.id}`,
    }))
  const blocks = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(EXERCISE)])
  const exercises = blocks.map((it) => {
    const checks = questions.filter((question) => it.contains(question))
    return {
      ...summary(checks),
      id: it.id,
      title: `${titleOf(it, '.label')}: ${titleOf(it, '.title')}`,
      address: it.querySelector('a.exercise-link')?.getAttribute('href') ?? `#${it.id}`,
      grade: Number(it.dataset.difficulty),
      checks: checks.map((check) => ({ id: check.dataset.quiz, ...tried(check) })),
    }
  })
  return { chapter: chapter(), date: new Date().toISOString(), exercises, predictions }
}

/** Questions that belong together are answered, or right, when each of them is. @param {HTMLElement[]} questions */
function summary(questions) {
  const all = questions.map(tried)
  const [answered, right] = [all.every((one) => one.answered), all.every((one) => one.right)]
  const tries = all.reduce((sum, one) => sum + one.tries, 0)
  return {
    answered,
    right,
    atOnce: right && all.every((one) => one.tries === 1),
    tries,
    shown: all.some((one) => one.shown),
  }
}

/** @param {HTMLElement} from @param {string} selector */
function titleOf(from, selector) {
  return (
    from
      .querySelector(selector)
      ?.textContent?.replace(/\u00a0/g, ' ')
      .trim() ?? ''
  )
}
