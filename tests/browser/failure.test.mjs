// Where the module or a script cannot be fetched, or there is no WebAssembly, the page says so, figures stay stills,
// and what failed can be tried again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { dist, open, PHONE } from './harness.mjs'
import { judge, stills } from './stills.mjs'

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
  assert.deepEqual(
    await bench.locator(':is(button, input, select):visible').allTextContents(),
    ['Try again'],
    'nothing else to press',
  )
  await page.unroute('**/*.wasm')
  await again.press('Enter')
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  assert.equal(await again.count(), 0)
  await page.waitForFunction(() => document.activeElement?.closest('observer-bench .live'))
})

// A figure's script is a part of the page's without a name; what tells it is a word that only it has.
const chunkOf = (word) => {
  const folder = path.join(dist, 'assets')
  const [name, ...more] = readdirSync(folder).filter(
    (file) =>
      /^[\w-]+\.js$/.test(file) &&
      !file.startsWith('page-') &&
      readFileSync(path.join(folder, file), 'utf8').includes(word),
  )
  assert.ok(name && more.length === 0, `one part holds ${word}`)
  return `**/${name}`
}

// Where the script that reloads a page is lost as well, the page is loaded again whatever is there.
for (const [what, word, reloads] of [
  ['its own script', 'Equivalent knob', false],
  ['the script of all figures', 'customElements.define(', true],
]) {
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
    // And fails again: the script is asked for once more, by this document or by the next.
    const name = chunk.slice('**/'.length)
    const lost = reloads
      ? page.waitForEvent('load')
      : page.waitForEvent('requestfailed', { predicate: (request) => request.url().endsWith(name) })
    await again.press('Enter')
    await lost
    await page.locator('observer-bench[data-state="failed"]').first().waitFor()
    await again.waitFor()
    await page.unroute(chunk)
    await again.press('Enter')
    // A browser that remembers the failure is not asked twice: the page is loaded again, at the figure.
    await page.locator('observer-bench[data-state="live"]').first().waitFor()
    assert.equal(await again.count(), 0)
    await page.waitForFunction(
      () => document.activeElement?.closest('observer-bench .live') || location.hash === '#fig-bench',
    )
    assert.ok(
      await bench.evaluate((it) => {
        const { top, bottom } = it.getBoundingClientRect()
        return top < innerHeight && bottom > 0
      }),
      'the reader is where the figure is',
    )
  })
}

test('with the script of the page lost it is a page without scripts', async (t) => {
  const page = await open(t, {
    viewport: PHONE,
    touch: true,
    expected: [/page-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      await it.addInitScript(() => localStorage.setItem('notation', 'thrun'))
      await it.route('**/page-*.js', (route) => route.abort())
    },
  })
  await page.locator('.toc a').first().waitFor()
  assert.equal(
    await page.locator('button:visible, input:visible, select:visible').count(),
    0,
    'nothing to press that would not answer',
  )
  assert.equal(
    await page.locator('html').getAttribute('data-notation'),
    'choset',
    'the notation of the formulas in the page',
  )
  judge(await stills(page))
})

test('where there is no WebAssembly the figures are stills', async (t) => {
  const page = await open(t, {
    prepare: (it) =>
      it.addInitScript(() => {
        Reflect.deleteProperty(globalThis, 'WebAssembly')
      }),
  })
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await bench.getByText(/WebAssembly/).waitFor()
  judge(await stills(page))
})

test('questions and search whose scripts are lost leave nothing to press in vain, and say so', async (t) => {
  const [quizzes, search] = [chunkOf('"quiz:"'), chunkOf('search.json')]
  const page = await open(t, {
    expected: [/part-|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      for (const chunk of [quizzes, search]) await it.route(chunk, (route) => route.abort())
    },
  })
  await page.locator('.quiz').first().scrollIntoViewIfNeeded()
  await page.waitForFunction(() => document.querySelectorAll('.quiz[data-answered]').length > 0)
  assert.equal(await page.locator('.quiz button:visible').count(), 0)
  assert.ok(await page.locator('.quiz-answer summary').first().isVisible(), 'the answers can be opened')
  await page.locator('[data-open-search]').first().click()
  await page.getByText(/^The search could not be fetched/).waitFor()
})
