// Stills first: without scripts, without WebAssembly, or when the module cannot be fetched, every figure is a picture
// with words, and a failed one can be tried again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { PHONE, dist, open } from './harness.mjs'

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

// A figure's script is a part of the page's without a name; what tells it is the custom element it defines.
const chunkOf = (word) => {
  const folder = path.join(dist, 'assets')
  const [name, ...more] = readdirSync(folder).filter((file) => /^[\w-]+\.js$/.test(file) && !file.startsWith('page-') && readFileSync(path.join(folder, file), 'utf8').includes(word))
  assert.ok(name && more.length === 0, `one part holds ${word}`)
  return `**/${name}`
}

for (const [what, word] of [['its own script', 'tag:"observer-bench"'], ['the script of all figures', 'customElements.define(']]) {
  test(`a figure without ${what} says so, and comes to life when it is there again`, async (t) => {
    const chunk = chunkOf(word)
    const page = await open(t, {
      expected: [/part-|Failed to load|ERR_FAILED/],
      prepare: (it) => it.route(chunk, (route) => route.abort()),
    })
    const bench = page.locator('observer-bench').first()
    await bench.scrollIntoViewIfNeeded()
    const again = bench.getByRole('button', { name: /try again/i })
    await again.waitFor()
    judge(await stills(page))
    await again.press('Enter')
    await page.waitForTimeout(300)
    assert.equal(await bench.getAttribute('data-state'), 'failed', 'and fails again')
    await page.unroute(chunk)
    await again.press('Enter')
    await page.locator('observer-bench[data-state="live"]').first().waitFor({ timeout: 8000 })
    assert.equal(await again.count(), 0)
    await page.waitForFunction(() => document.activeElement?.closest('observer-bench .live'))
  })
}

test('with the script of the page lost it is a page without scripts', async (t) => {
  const page = await open(t, {
    viewport: PHONE, touch: true,
    expected: [/page-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      await it.addInitScript(() => localStorage.setItem('notation', 'thrun'))
      await it.route('**/page-*.js', (route) => route.abort())
    },
  })
  await page.locator('.toc a').first().waitFor({ timeout: 4000 })
  assert.equal(await page.locator('button:visible, input:visible, select:visible').count(), 0, 'nothing to press that would not answer')
  assert.equal(await page.locator('html').getAttribute('data-notation'), 'choset', 'the notation of the formulas in the page')
  judge(await stills(page))
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
  // Before anyone scrolls, with the page at rest.
  await page.waitForLoadState('networkidle')
  assert.deepEqual(await page.locator('.widget').evaluateAll((all) => all.filter((it) => it.getBoundingClientRect().top < innerHeight + 900).length), 0, 'no figure is near')
  assert.deepEqual(fetched, [])
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  await bench.getByRole('button', { name: 'Play' }).click()
  const step = () => bench.evaluate((it) => it.frame.step)
  const start = await step()
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, start)
  // A hidden tab: here the document only says so, and frames would go on.
  const hide = (hidden) => page.evaluate((it) => {
    Object.defineProperty(document, 'hidden', { configurable: true, get: () => it })
    document.dispatchEvent(new Event('visibilitychange'))
  }, hidden)
  await hide(true)
  await page.waitForTimeout(200)
  const hidden = await step()
  await page.waitForTimeout(1500)
  assert.equal(await step(), hidden, 'it rests while the tab is hidden')
  await hide(false)
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, hidden)
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight))
  await page.waitForTimeout(500)
  const left = await step()
  await page.waitForTimeout(1500)
  assert.ok((await step()) - left <= 1, 'it rests while it is out of sight')
  assert.equal(new Set(fetched).size, 1)
  assert.equal(fetched.length, 1)
})

test('questions and search whose scripts are lost leave nothing to press in vain, and say so', async (t) => {
  const [quizzes, search] = [chunkOf('"quiz:"'), chunkOf('search.json')]
  const page = await open(t, {
    expected: [/part-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      for (const chunk of [quizzes, search]) await it.route(chunk, (route) => route.abort())
    },
  })
  await page.waitForFunction(() => document.querySelectorAll('.quiz[data-answered]').length > 0)
  assert.equal(await page.locator('.quiz button:visible').count(), 0)
  assert.ok(await page.locator('.quiz-answer summary').first().isVisible(), 'the answers can be opened')
  await page.locator('[data-open-search]').first().click()
  await page.getByText('The search could not be fetched.').waitFor()
})
