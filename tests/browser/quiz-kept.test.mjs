// Answers are remembered until the reader forgets them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { comeTo, figure, open } from './fixture.mjs'
import { kept, quiz, shown } from './quiz.mjs'

test('answers are remembered after a reload, and forgotten one by one or all at once', async (t) => {
  const page = await open(t)
  const [foot, third] = [await quiz(page, 'which-foot'), await quiz(page, 'third-step')]
  await foot.form.locator('input').nth(2).check()
  await foot.commit.click()
  await third.input.fill('0.7')
  // A wrong number has a second try.
  await third.commit.click()
  await third.commit.click()
  assert.equal(Object.keys(await kept(page)).length, 2)

  await page.reload()
  await quiz(page, 'which-foot')
  await page.locator('#quiz-which-foot[data-answered]').waitFor()
  assert.ok(await foot.form.locator('input').nth(2).isChecked())
  assert.ok(await shown(foot))
  await quiz(page, 'third-step')
  assert.equal(await third.input.inputValue(), '0.7')
  assert.ok(await shown(third))
  await figure(page, 'picture')
  assert.ok(!(await page.locator('#fig-picture .widget').evaluate((widget) => widget.inert)))

  await foot.again.click()
  assert.ok(!(await shown(foot)) && !(await foot.form.getAttribute('data-answered')))
  assert.equal(await foot.form.locator('input:checked').count(), 0)
  assert.equal(await foot.verdict.innerText(), '')
  assert.ok(
    await foot.form
      .locator('input')
      .first()
      .evaluate((input) => input === document.activeElement),
    'the focus is where to begin again',
  )
  assert.ok(await page.locator('#fig-picture .widget').evaluate((widget) => widget.inert))
  assert.equal(Object.keys(await kept(page)).length, 1)

  await comeTo(page, '[data-score]', '[data-score] h2')
  await page.getByRole('button', { name: 'Forget my answers to the questions' }).click()
  assert.deepEqual(await kept(page), {})
  assert.ok(!(await shown(third)))
  assert.equal(await third.input.inputValue(), '')
  await page.reload()
  await comeTo(page, '#fig-picture', '#fig-picture .widget[inert]')
  assert.equal(await page.locator('.quiz[data-answered]').count(), 0)
})

test('what is kept is checked: an answer that is none any more counts for nothing', async (t) => {
  const page = await open(t)
  await page.evaluate(() => {
    localStorage.setItem(`quiz:which-foot:${document.querySelector('#quiz-which-foot').dataset.hash}`, '<img src=x>')
    localStorage.setItem('quiz:third-step:0123456789abcdef', '0.7')
  })
  await page.reload()
  await comeTo(page, '#fig-picture', '#fig-picture .widget[inert]')
  assert.equal(await page.locator('.quiz[data-answered]').count(), 0)
})
