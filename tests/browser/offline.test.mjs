// After one visit the site needs no network. A second copy of the book on the same host keeps its own store, and a new
// edition of one copy takes the place of the old edition's store when no page of the old edition is open.
import { after, test } from 'node:test'
import assert from 'node:assert/strict'
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist, figure, HANGS_MS, keptOffline, launch, pageOf, quiet, watch } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

const copies = mkdtempSync(path.join(tmpdir(), 'book-copies-'))
after(() => rmSync(copies, { recursive: true, force: true }))

/**
 * A browser that lets workers in, before the site of `folder`; what the page complains of must be nothing in the end.
 */
async function visit(folder, base, act) {
  const site = await serve({ folder, base })
  const browser = await launch()
  try {
    const context = await browser.newContext({ reducedMotion: 'reduce' })
    const page = await context.newPage()
    const complaints = watch(page, site.url)
    // The network goes away for good: no server is left to ask.
    const unplug = async () => {
      await context.setOffline(true)
      await site.close()
    }
    await act({ page, url: site.url, unplug })
    assert.deepEqual(complaints, [])
  } finally {
    await browser.close()
    await site.close().catch(() => {})
  }
}

const waitFor = async (page, met) => {
  for (const deadline = Date.now() + HANGS_MS; Date.now() < deadline && !(await met()); ) await quiet(page, 3)
}
const stores = async (page) => (await page.evaluate(() => caches.keys())).sort()

/** Another version of the copy in `folder`, as a deploy would bring it. */
function deploy(folder, version) {
  const edit = (file, change) =>
    writeFileSync(path.join(folder, file), change(readFileSync(path.join(folder, file), 'utf8')))
  edit('index.html', (html) => html.replace(/<h1>[^<]*/, `<h1>Version ${version}`))
  edit('sw.js', (script) => script.replace(/VERSION = (['"])[^'"]*/, `VERSION = $1${version}`))
}

test('after one visit every page, figure and check works without a network, in both letters', async () => {
  await visit(dist, BASE, async ({ page, url, unplug }) => {
    await page.goto(`${url}kalman/`)
    await keptOffline(page)
    await unplug()
    const files = JSON.parse(readFileSync(path.join(dist, 'precache.json'), 'utf8')).map((file) => file.url)
    const pages = files.filter((at) => /(\/|\.html)$/.test(at))
    assert.ok(pages.length > 10, `${pages}`)
    // Every page is there, byte by byte; the pages of the sources, of one kind, are not all shown.
    for (const at of pages) {
      const kept = await page.evaluate(async (address) => (await fetch(address)).text(), url + at)
      assert.ok(
        kept === readFileSync(path.join(dist, at.endsWith('.html') ? at : `${at}index.html`), 'utf8'),
        `/${at} is kept as it is`,
      )
    }
    const sources = pages.filter((at) => at.startsWith('source/'))
    for (const at of pages.filter((one) => !sources.slice(3).includes(one))) {
      await page.goto(url + at)
      assert.ok((await page.locator('h1').first().textContent()).length > 3, `/${at}`)
    }
    for (const name of Object.keys(WIDGETS).sort((a, b) => pageOf(a).localeCompare(pageOf(b)))) {
      if (page.url() !== url + pageOf(name)) await page.goto(url + pageOf(name))
      await figure(page, name)
    }
    await page.goto(`${url}kalman/`)
    await page.locator('[data-set-notation="thrun"]').click()
    await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
    await page.locator('[data-open-search]').first().click()
    await page.locator('dialog.search input').fill('innovation')
    await page.locator('dialog.search li a').first().waitFor()
    await page.goto(`${url}check/`)
    await page.locator('[data-run-checks]').click()
    await page
      .getByRole('status')
      .filter({ hasText: /^13 of 13 checks pass/ })
      .waitFor()
  })
})

test('two copies on one origin keep a store each, and a new version takes the place of its own alone', async () => {
  const [one, two] = ['one', 'two'].map((name) => path.join(copies, name))
  for (const folder of [one, two]) cpSync(dist, folder, { recursive: true })
  deploy(one, 'first')
  deploy(two, 'other')
  await visit(copies, '/shelf/', async ({ page, url, unplug }) => {
    for (const at of ['one/', 'two/']) {
      await page.goto(url + at)
      await keptOffline(page)
    }
    assert.deepEqual(await stores(page), ['book-/shelf/one/#first', 'book-/shelf/two/#other'])

    deploy(one, 'second')
    await page.goto(`${url}one/`)
    await page.evaluate(async () => {
      await (await navigator.serviceWorker.ready).update()
    })
    const both = ['book-/shelf/one/#first', 'book-/shelf/one/#second', 'book-/shelf/two/#other']
    await waitFor(page, async () => (await stores(page)).length === both.length)
    await page.evaluate(async () => {
      const registration = await navigator.serviceWorker.ready
      while (!registration.waiting) await new Promise((resolve) => setTimeout(resolve, 50))
    })
    assert.deepEqual(await stores(page), both, 'a page is open that may need files of the first edition')
    // No page of that copy is open any more.
    await page.goto(`${url}two/`)
    await waitFor(page, async () => (await stores(page)).length < both.length)
    assert.deepEqual(await stores(page), ['book-/shelf/one/#second', 'book-/shelf/two/#other'])
    await unplug()
    for (const [at, version] of [
      ['one/', 'second'],
      ['two/', 'other'],
    ]) {
      await page.goto(url + at)
      assert.equal(await page.locator('h1').textContent(), `Version ${version}`)
      await page.goto(`${url}${at}kalman/`)
      await figure(page, 'observer-bench')
    }
  })
})
