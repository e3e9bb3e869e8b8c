// A veil on a figure far above the place where a page comes up moves nothing: in the chapter, where such figures are.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { open, PHONE, quiet } from './harness.mjs'

test('a veil on a page that comes up at a place below it moves nothing', async (t) => {
  const page = await open(t, {
    at: 'kalman/#bugs',
    viewport: { width: 390, height: 844 },
    touch: true,
    prepare: (it) =>
      it.addInitScript(() => {
        globalThis.shifts = 0
        new PerformanceObserver((list) =>
          list.getEntries().forEach(({ value }) => {
            globalThis.shifts += value
          }),
        ).observe({ type: 'layout-shift', buffered: true })
      }),
  })
  await page.locator('#fig-museum .figure-locked').waitFor({ state: 'attached' })
  await quiet(page)
  const { shifts, top } = await page.evaluate(() => ({
    shifts: globalThis.shifts,
    top: document.querySelector('#bugs').getBoundingClientRect().top,
  }))
  assert.ok(shifts < 0.01 && Math.abs(top - 24) < 2, `shifts ${shifts}, the heading at ${top}`)
  assert.ok(
    await page.locator('#fig-loop .widget').evaluate((widget) => !widget.hasAttribute('data-short')),
    'what stands above keeps its height',
  )
})

test('a figure keeps its height when it is answered, and a reader who skips at its veil still sees it', async (t) => {
  const page = await open(t, { at: 'kalman/#fig-museum' })
  const skip = page.locator('#fig-museum .figure-locked').getByRole('button', { name: 'Skip, show me' })
  await skip.waitFor()
  const box = () => page.locator('#fig-museum').evaluate((figure) => figure.getBoundingClientRect().toJSON())
  await quiet(page)
  const before = await box()
  await skip.click()
  await page.locator('#quiz-museum-gate[data-answered="shown"]').waitFor()
  await quiet(page)
  const after = await box()
  assert.ok(Math.abs(after.height - before.height) < 2, `${before.height} px, then ${after.height}`)
  assert.ok(Math.abs(after.top - before.top) < 2, `its top at ${before.top}, then at ${after.top}`)
})

test('on a phone a reader who skips in the question keeps the figure in sight', async (t) => {
  const page = await open(t, { at: 'kalman/#fig-museum', viewport: PHONE, touch: true })
  const form = page.locator('#quiz-museum-gate')
  await form.getByRole('button', { name: /^Skip/ }).scrollIntoViewIfNeeded()
  await quiet(page)
  const top = () => page.locator('#fig-museum .widget').evaluate((it) => it.getBoundingClientRect().top)
  await form.getByRole('button', { name: /^Skip/ }).tap()
  await page.locator('#quiz-museum-gate[data-answered="shown"]').waitFor()
  await quiet(page)
  const at = await top()
  assert.ok(at >= 0 && at < PHONE.height - 150, `the figure begins at ${at} px`)
})
