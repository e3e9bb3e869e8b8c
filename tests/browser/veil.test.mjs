// A veil on a figure far above the place where a page comes up moves nothing: in the chapter, where such figures are.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { open, quiet } from './harness.mjs'

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
