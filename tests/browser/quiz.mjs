// A question as a reader meets it.
import { comeTo } from './fixture.mjs'

/** A question on the screen, with the controls that it gets there. */
export const quiz = async (page, id) => {
  const form = page.locator(`#quiz-${id}`)
  await comeTo(page, `#quiz-${id}`, `form#quiz-${id} input`)
  return {
    form,
    commit: form.getByRole('button', { name: 'Commit' }),
    again: form.getByRole('button', { name: 'Try again' }),
    verdict: form.locator('.quiz-verdict'),
    answer: form.locator('details.quiz-answer'),
    input: form.getByRole('textbox', { name: 'Your answer' }),
  }
}
/** What the page compares an answer with. */
export const keyOf = (form) =>
  form.evaluate(({ dataset }) =>
    JSON.parse(new TextDecoder().decode(Uint8Array.from(dataset.key.match(/../g), (byte) => parseInt(byte, 16)))),
  )
/** What a reader sees: the explanation is open, or it is not. */
export const shown = ({ answer }) =>
  answer.evaluate((block) => block.open && block.querySelector('.quiz-why').checkVisibility())
export const kept = (page) =>
  page.evaluate(() => Object.fromEntries(Object.entries(localStorage).filter(([key]) => key.startsWith('quiz:'))))
