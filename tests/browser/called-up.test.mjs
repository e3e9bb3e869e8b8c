// Access to what a reader calls up over a chapter, whatever stands in it: no axe violation in either theme.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { isAccessible } from './axe.mjs'
import { comeTo, open, PHONE, quiet, walkDown } from './fixture.mjs'
import { quiz } from './quiz.mjs'

/** What a reader can call up, and what it is read with. */
const CALLED_UP = {
  'the search open': async (page) => {
    await page.locator('[data-open-search]').first().click()
    await page.locator('dialog.search input').fill('innovation')
    await page.locator('dialog.search li a').first().waitFor()
  },
  "Thrun's letters": async (page) => {
    await page.locator('[data-set-notation="thrun"]').click()
    await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
    // Parts of the text are laid out, and what scrolls in them gets its name, when a reader comes near them.
    await walkDown(page)
  },
  'a term explained and its kin lit': async (page) => {
    const term = page.locator('.term-prediction.term, .term-posterior.term, .term-measurement.term').first()
    await term.focus()
    await page.locator('.popover:not([hidden])').waitFor()
    await page.locator('.widget[data-lit]').waitFor({ state: 'attached' })
    // The others fade.
    await quiet(page)
    assert.ok((await page.locator('.popover').isVisible()) && (await page.locator('.widget[data-lit]').isVisible()))
  },
}
for (const [what, act] of Object.entries(CALLED_UP)) {
  test(`axe finds nothing with ${what}, in both themes`, async (t) => {
    const page = await open(t)
    await page.waitForLoadState('networkidle')
    await act(page)
    await isAccessible(page)
  })
}

test('axe finds nothing with the contents called up on a phone, in both themes', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await page.waitForLoadState('networkidle')
  await page.locator('[data-open-contents]').tap()
  await page.locator('.toc[data-open]').waitFor()
  // The text under them is covered: axe would measure its colours against the paper of the contents.
  await page.evaluate(() => {
    for (const section of document.querySelectorAll('.chapter > section')) section.hidden = true
  })
  await isAccessible(page)
})

test('axe finds nothing in answered questions, their exercises and the progress, in both themes', async (t) => {
  const page = await open(t)
  const answer = async (id, give) => {
    const { form, commit, input } = await quiz(page, id)
    await give(form, input)
    await commit.click()
    return form.getAttribute('data-answered')
  }
  const type = (text) => (_, input) => input.fill(text)
  const choose = (form) => form.getByRole('radio', { name: /Straight down/ }).check()
  assert.equal(await answer('which-foot', choose), 'wrong')
  assert.equal(await answer('unseen-direction', type('1 2 -1')), 'right')
  assert.equal(await answer('constant', type('7')), null, 'a wrong number may be mended once')
  assert.equal(await answer('constant', type('8')), 'wrong')
  await comeTo(page, '[data-score]', '[data-score] h2')
  await isAccessible(page, ['#quiz-which-foot', '#ex-unseen', '#ex-constant', '[data-score]'])
})
