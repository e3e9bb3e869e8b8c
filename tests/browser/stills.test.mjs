// Stills first: without scripts, without WebAssembly, or when the module cannot be fetched, every figure is a picture
// with words, and a failed one can be tried again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { open } from './harness.mjs'

const stills = (page) => page.evaluate(() => [...document.querySelectorAll('figure.figure-widget')].map((figure) => ({
  id: figure.id,
  drawn: [...figure.querySelectorAll('.still svg')].some((svg) => { const box = svg.getBoundingClientRect(); return box.width > 100 && box.height > 80 }),
  marks: figure.querySelectorAll('.still svg :is(path, line, circle)').length,
  words: figure.querySelector('.still-text')?.textContent.trim().length ?? 0,
  caption: figure.querySelector('figcaption')?.textContent.trim().length ?? 0,
})))

function judge(figures) {
  assert.ok(figures.length >= 1, 'there are figures')
  for (const { id, drawn, marks, words, caption } of figures) {
    assert.ok(drawn && marks > 5, `${id} is drawn`)
    assert.ok(words > 40, `${id} is described`)
    assert.ok(caption > 20, `${id} has a caption`)
  }
}

test('with scripts off every figure is a still with words, and the page is whole', async (t) => {
  const page = await open(t, { scripts: false })
  judge(await stills(page))
  assert.equal(await page.locator('button:visible, input:visible, select:visible').count(), 0, 'nothing to press that would not answer')
  const pictures = await page.locator('figure.figure-widget .still').evaluateAll((all) => all.map((still) => still.innerHTML))
  assert.equal(new Set(pictures).size, pictures.length, 'each figure shows its own state')
  assert.ok((await page.locator('main p').count()) > 30)
})

test('where the module cannot be fetched the figure says so, and tries again', async (t) => {
  const page = await open(t, {
    expected: [/\.wasm/, /failed to fetch|Failed to load|ERR_FAILED/i],
    prepare: (it) => it.route('**/*.wasm', (route) => route.abort()),
  })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  const again = bench.getByRole('button', { name: /try again/i })
  await again.waitFor()
  judge(await stills(page))
  assert.deepEqual(await bench.locator(':is(button, input, select):visible').allTextContents(), ['Try again'], 'nothing else to press')
  await page.unroute('**/*.wasm')
  await again.press('Enter')
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  assert.equal(await again.count(), 0)
  await page.waitForFunction(() => document.activeElement?.closest('observer-bench .live'))
})

test('where there is no WebAssembly the figures are stills', async (t) => {
  const page = await open(t, { prepare: (it) => it.addInitScript(() => { delete globalThis.WebAssembly }) })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await bench.getByText(/WebAssembly/).waitFor()
  judge(await stills(page))
})

test('a figure works while it is near the screen, and the module is fetched once, when it is needed', async (t) => {
  const fetched = []
  const page = await open(t, { motion: 'no-preference', prepare: async (it) => it.on('request', (request) => { if (request.url().endsWith('.wasm')) fetched.push(request.url()) }) })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  await bench.getByRole('button', { name: 'Play' }).click()
  const step = () => bench.evaluate((it) => it.frame.step)
  const start = await step()
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, start)
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight))
  await page.waitForTimeout(500)
  const left = await step()
  await page.waitForTimeout(1500)
  assert.ok((await step()) - left <= 1, 'it rests while it is out of sight')
  assert.equal(new Set(fetched).size, 1)
  assert.equal(fetched.length, 1)
})
