/**
 * Before the page is printed every block is unfolded, and the answers go from their questions to the end, where a
 * reader of paper looks them up. Formulas that are wider than a column of paper are set smaller. Afterwards all is as
 * it was.
 */

import { part } from '../draw/dom.js'

/**
 * The width of a column of paper, of what is indented in it, and of an equation's number, in letters' heights
 * (web/style/print.css).
 */
const COLUMN = 26
const INDENTED = 24.4
const NUMBER = 2.9

export function openForPrint() {
  /** @type {HTMLDetailsElement[]} */
  let opened = []
  let back = () => {}
  addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll('details')].filter((block) => !block.open)
    for (const block of opened) block.open = true
    // Not every way of printing fetches what nobody has come near; the next print has it then.
    for (const image of /** @type {NodeListOf<HTMLImageElement>} */ (document.querySelectorAll('img[loading=lazy]')))
      image.loading = 'eager'
    back = answersApart()
    fitFormulas()
  })
  addEventListener('afterprint', () => {
    for (const block of opened) block.open = false
    opened = []
    back()
    back = () => {}
  })
}

/** Moves the answers into a part of their own. @returns {() => void} moves them back */
function answersApart() {
  const chapter = document.querySelector('.chapter')
  const answers = [...document.querySelectorAll('.chapter :is(.quiz-answer, .exercise > .answer)')]
  if (!chapter || answers.length === 0) return () => {}
  const end = part(document, chapter, 'section', 'answers')
  part(document, end, 'h2', '').textContent = 'Answers'
  const places = answers.map((answer) => {
    const place = document.createComment('')
    answer.before(place)
    part(document, end, 'h3', 'answer-of').textContent = nameOf(answer)
    end.append(answer)
    return { answer, place }
  })
  return () => {
    for (const { answer, place } of places) place.replaceWith(answer)
    end.remove()
  }
}

/**
 * What an answer belongs to: an exercise or a question, and of a question in an exercise the exercise's number.
 * @param {Element} answer
 */
function nameOf(answer) {
  const [exercise, question] = ['.exercise', '.quiz'].map((kind) => answer.closest(kind))
  const words = (/** @type {Element | null} */ of, /** @type {string} */ parts) =>
    [...(of?.querySelectorAll(parts) ?? [])].slice(0, 2).map((name) => name.textContent?.trim())
  const [asked, title] = words(question, 'legend > span')
  const [number] = words(exercise, '.exercise-head > span')
  return [number ?? asked, question ? title : 'worked answer'].filter(Boolean).join(': ')
}

/** Tells the style how much smaller each displayed formula has to be on paper; on a screen it makes no difference. */
function fitFormulas() {
  for (const box of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.chapter .equation-body'))) {
    const widths = [...box.querySelectorAll('.katex-html')].map((drawn) => {
      const range = document.createRange()
      range.selectNodeContents(drawn)
      return range.getBoundingClientRect().width
    })
    const wide = Math.max(0, ...widths) / Number.parseFloat(getComputedStyle(box).fontSize)
    const room =
      (box.closest('.derivation, .definition, .note, .quiz, details') ? INDENTED : COLUMN) -
      (box.parentElement?.matches('.numbered') ? NUMBER : 0)
    if (wide > room) box.style.setProperty('--on-paper', (Math.floor((100 * room) / wide) / 100).toString())
    // In another notation it may fit.
    else box.style.removeProperty('--on-paper')
  }
}
