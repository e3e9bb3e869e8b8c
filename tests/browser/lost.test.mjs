// An address that leads nowhere: the host serves 404.html there, at any depth and under any path, and it is a page all
// the same, with ways into the book that lead there.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist, open, stage, watch } from './harness.mjs'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')
/** The address itself is one that is not there, and so are those asked on the way up. */
const EXPECTED = [/404/]
const found = (page) => page.locator('html[data-found]').waitFor({ state: 'attached' })
const hrefs = (page) => page.locator('a').evaluateAll((links) => links.map((link) => link.href))

for (const at of [
  'none',
  'none.html',
  'kalman/none',
  'kalman/none/',
  'kalman/a/b/c/d?x=%3Cscript%3E#e',
  'source/crates/none.rs.html',
  'kalman//a//b',
  'a/b/c/d/e/f/g/h',
]) {
  test(`/${at} is a page with its style, and its links lead into the book`, async (t) => {
    const { site } = await stage()
    const page = await open(t, { at, expected: EXPECTED })
    await found(page)
    assert.equal(await page.locator('h1').innerText(), 'There is no such page')
    assert.deepEqual(await hrefs(page), [site.url, site.url, `${site.url}kalman/`])
    const style = await page.evaluate(() => {
      const { backgroundColor, maxWidth } = getComputedStyle(document.body)
      return { backgroundColor, maxWidth }
    })
    assert.equal(style.backgroundColor, 'rgb(255, 253, 248)', 'paper')
    assert.notEqual(style.maxWidth, 'none')
    await page.getByRole('link', { name: 'Start at its cover' }).click()
    await page.waitForURL(site.url)
    assert.equal(await page.locator('h1').innerText(), 'Robot Motion')
  })
}

test('it is dark in the dark, as the reader has set it, and axe finds nothing', async (t) => {
  const page = await open(t, { at: 'a/b/c', theme: 'dark', expected: EXPECTED })
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor)
  assert.equal(await paper(), 'rgb(20, 22, 26)')
  await page.evaluate(() => localStorage.setItem('theme', 'light'))
  await page.reload()
  assert.equal(await paper(), 'rgb(255, 253, 248)')
  await page.evaluate(() => localStorage.clear())
  for (const theme of /** @type {const} */ (['light', 'dark'])) {
    const other = await open(t, { at: 'a/b/c', theme, expected: EXPECTED })
    // The driver puts axe in from outside; the policy of the page does not concern it.
    await other.evaluate(axe)
    const { violations } = await other.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }))
    assert.deepEqual(
      violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
      [],
    )
  }
})

test('at the root of a host, and where a host answers every address with a page', async () => {
  const { browser } = await stage()
  const site = await serve({ folder: dist, base: '/' })
  const context = await browser.newContext({ serviceWorkers: 'block' })
  try {
    const page = await context.newPage()
    const complaints = watch(page, site.url)
    await page.goto(`${site.url}a/b/none`)
    await found(page)
    assert.deepEqual(await hrefs(page), [site.url, site.url, `${site.url}kalman/`])
    await page.route('**/a/**', (route) =>
      route.request().method() === 'HEAD'
        ? route.fulfill({ status: 200, contentType: 'text/html', body: '' })
        : route.continue(),
    )
    await page.reload()
    await found(page)
    assert.deepEqual(await hrefs(page), [site.url, site.url, `${site.url}kalman/`])
    assert.deepEqual(
      complaints.filter((line) => !/404/.test(line)),
      [],
    )
  } finally {
    await context.close()
    await site.close()
  }
})

test('without scripts it has its style, and the words', async (t) => {
  const page = await open(t, { at: 'kalman/none', scripts: false, expected: EXPECTED })
  assert.equal(await page.locator('h1').innerText(), 'There is no such page')
  const { site } = await stage()
  assert.equal(new URL(site.url).pathname, BASE)
  // One level down the nearest page is the chapter's.
  assert.equal(
    await page
      .locator('main a')
      .first()
      .evaluate((link) => link.href),
    `${site.url}kalman/`,
  )
  assert.equal(await page.locator('header').evaluate((header) => getComputedStyle(header).borderBottomStyle), 'solid')
})
