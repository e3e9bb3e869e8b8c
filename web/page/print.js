/**
 * Before the page is printed every block is unfolded, and the answers go from their questions to the end, where a reader of paper
 * looks them up. Afterwards all is as it was.
 */

import { part } from '../core/element.js'

export function openForPrint() {
  /** @type {HTMLDetailsElement[]} */
  let opened = []
  let back = () => {}
  addEventListener('beforeprint', () => {
    opened = [...document.querySelectorAll('details')].filter((block) => !block.open)
    for (const block of opened) block.open = true
    back = answersApart()
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
    const of = answer.closest('.exercise') ?? answer.closest('.quiz')
    const words = [...of?.querySelectorAll('.exercise-head > span, legend > span') ?? []].slice(0, 2).map((name) => name.textContent?.trim())
    part(document, end, 'h3', 'answer-of').textContent = words.join(': ')
    end.append(answer)
    return { answer, place }
  })
  return () => {
    for (const { answer, place } of places) place.replaceWith(answer)
    end.remove()
  }
}
