// The search: found by button and by key, walked through by keys, and nothing of a query is taken for markup.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { dist, open, quiet, stage } from './harness.mjs'

const index = JSON.parse(readFileSync(path.join(dist, 'search.json'), 'utf8'))
const dialog = (page) => page.getByRole('dialog', { name: 'Search' })
const field = (page) => dialog(page).getByRole('searchbox', { name: 'Search the book' })
const results = (page) => dialog(page).locator('.search-results li a')
/** Types a query, and waits until what is shown answers it. */
async function ask(page, words) {
  await field(page).fill(words)
  await dialog(page)
    .getByRole('status')
    .filter({ hasText: /\d+ places found/ })
    .waitFor({ state: 'attached' })
  await quiet(page)
}

test('a section is found by words of its title and by words of its text', async (t) => {
  const page = await open(t)
  await page.getByRole('button', { name: 'Search' }).click()
  await field(page).waitFor()
  for (const { title, id } of index
    .filter(({ page: where, title: name }) => where === 'kalman/' && name.length > 8)
    .slice(0, 12)) {
    await ask(page, title)
    const found = await results(page).evaluateAll((links) => links.map((link) => link.href))
    assert.ok(
      found.some((href) => href.endsWith(id)),
      `${title} leads to ${found}`,
    )
  }
  // A word misspelt, and the beginning of one.
  await ask(page, 'luenbergr')
  assert.ok((await results(page).count()) >= 1)
  await ask(page, 'mahalan')
  const [first] = await results(page).evaluateAll((links) =>
    links.map((link) => ({ href: link.href, words: link.innerText })),
  )
  assert.match(first.words, /mahalan/i)
  await results(page).first().click()
  await page.waitForURL(first.href)
  assert.ok(!(await dialog(page).isVisible()), 'it closes when it has done its work')
  assert.ok(await page.evaluate(() => document.querySelector(location.hash).checkVisibility()))
})

test('words of the text come before names in code, which are found too', async (t) => {
  const page = await open(t)
  await page.keyboard.press('/')
  await field(page).waitFor()
  await ask(page, 'innovation')
  const hits = await results(page).evaluateAll((links) => links.map((link) => link.innerText))
  assert.ok(hits.length >= 6, `${hits.length} hits`)
  assert.match(hits[0], /^Definition \d+ Innovation/, 'the definition comes before exercises that use the word')
  assert.deepEqual(
    hits.slice(0, 6).filter((words) => /\/\/\/|::|fn /.test(words)),
    [],
    'a reader who asks what an innovation is reads prose first',
  )
  await ask(page, 'associate_ml')
  assert.match(await results(page).first().innerText(), /associate_ml/)
})

test('the keys open it, walk through it, follow a place and close it', async (t) => {
  const page = await open(t)
  await page.keyboard.press('/')
  await field(page).waitFor()
  assert.ok(await field(page).evaluate((input) => input === document.activeElement))
  assert.equal(await field(page).inputValue(), '', 'the key itself is not typed')
  await page.keyboard.type('consistency')
  await results(page).first().waitFor()
  // Tab reaches every place in turn.
  await page.keyboard.press('Tab')
  await page.keyboard.press('Tab')
  assert.ok(
    await results(page)
      .first()
      .evaluate((link) => link === document.activeElement),
  )
  await page.keyboard.press('Tab')
  assert.ok(
    await results(page)
      .nth(1)
      .evaluate((link) => link === document.activeElement),
  )
  // Escape closes, the focus returns, and a second time the words are there to be changed.
  await page.keyboard.press('Escape')
  assert.ok(!(await dialog(page).isVisible()))
  await page.getByRole('button', { name: 'Search' }).focus()
  await page.keyboard.press('Enter')
  await field(page).waitFor()
  assert.equal(await field(page).inputValue(), 'consistency')
  await page.keyboard.type('riccati')
  assert.equal(await field(page).inputValue(), 'riccati')
  await dialog(page).getByText('Riccati').first().waitFor()
  // Escape in the field itself; and Enter there goes to the first place.
  await field(page).press('Escape')
  assert.ok(!(await dialog(page).isVisible()))
  assert.ok(await page.getByRole('button', { name: 'Search' }).evaluate((button) => button === document.activeElement))
  await page.keyboard.press('/')
  await field(page).waitFor()
  const goal = await results(page).first().getAttribute('href')
  await field(page).press('Enter')
  await page.waitForURL(goal)
  assert.ok(!(await dialog(page).isVisible()))
})

test('a slash typed into a field is a slash', async (t) => {
  const page = await open(t)
  await page.locator('#quiz-third-step').scrollIntoViewIfNeeded()
  const input = page.locator('#quiz-third-step').getByRole('textbox')
  await input.focus()
  await page.keyboard.type('1/2')
  assert.equal(await input.inputValue(), '1/2')
  assert.equal(await dialog(page).count(), 0)
})

test('whatever is typed stays words', async (t) => {
  const page = await open(t)
  await page.evaluate(() => {
    globalThis.struck = 0
  })
  await page.keyboard.press('/')
  await field(page).waitFor()
  const before = await page.evaluate(() =>
    [...document.querySelectorAll('dialog *')]
      .map((element) => element.localName)
      .sort()
      .join(' '),
  )
  for (const words of [
    '<img src=x onerror="struck=1">',
    '"><script>struck=1</script>',
    '<b>kalman</b>',
    '&lt;b&gt;',
    "'); struck=1; ('",
    '$& \\0 (',
    '%3Cb%3E',
    '.*+?^$' + '{}()|[]\\',
    '\u202e\u0000',
    'a'.repeat(5000),
  ]) {
    await field(page).fill(words)
    await quiet(page)
    const seen = await page.evaluate(() => ({
      struck: globalThis.struck,
      names: [...new Set([...document.querySelectorAll('dialog *')].map((element) => element.localName))].sort(),
    }))
    assert.equal(seen.struck, 0, words)
    assert.deepEqual(
      seen.names.filter(
        (name) => !['a', 'button', 'form', 'input', 'label', 'li', 'ol', 'p', 'span', 'strong'].includes(name),
      ),
      [],
      words,
    )
  }
  // Nothing found is said; an emptied field shows nothing.
  await field(page).fill('zzzzqqqq')
  await dialog(page).getByText('Nothing found.').waitFor()
  await field(page).fill('')
  await quiet(page)
  assert.equal(
    await page.evaluate(() =>
      [...document.querySelectorAll('dialog *')]
        .map((element) => element.localName)
        .sort()
        .join(' '),
    ),
    before,
  )
  assert.equal(await dialog(page).locator('.search-results').innerText(), '')
})

test('the search leads from every page to every other, and its text is as the reader sees it', async (t) => {
  const page = await open(t, { at: 'check/' })
  const { site } = await stage()
  await page.getByRole('button', { name: 'Search' }).click()
  await field(page).waitFor()
  await ask(page, 'compression')
  const href = await results(page)
    .first()
    .evaluate((link) => link.href)
  assert.equal(href, `${site.url}hosting/#compression`)
  await results(page).first().click()
  await page.waitForURL(href)
  // Code in the text is words too, never markup.
  const marked = index
    .filter(({ text, title }) => /<\/?[a-z]+[^>]*>/.test(title) || /<(script|img|span|div)/.test(text))
    .map(({ id }) => id)
  assert.deepEqual(marked, [])
})

test('where the index cannot be fetched the search says so', async (t) => {
  const page = await open(t, {
    expected: [/search\.json/, /ERR_FAILED/],
    prepare: (it) => it.route('**/search.json', (route) => route.abort()),
  })
  await page.getByRole('button', { name: 'Search' }).click()
  await field(page).fill('kalman')
  await page.locator('.search-results').filter({ hasText: 'are you offline?' }).waitFor()
  assert.match(await dialog(page).getByRole('status').textContent(), /could not be fetched/, 'and it is announced')
  await page.unroute('**/search.json')
  await field(page).fill('kalman filter')
  await results(page).first().waitFor()
})
