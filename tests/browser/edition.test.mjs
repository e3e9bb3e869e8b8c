// A new edition of the book is published while a page is open, or the server fails or hangs: the open page goes on, or
// says what to do, and nothing is lost.
import { after, test } from 'node:test'
import assert from 'node:assert/strict'
import { cpSync, mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist, figure, keptOffline, launch, quiet, stateOf } from './harness.mjs'

const copies = mkdtempSync(path.join(tmpdir(), 'book-editions-'))
after(() => rmSync(copies, { recursive: true, force: true }))

/** Publishes another edition in `folder`: each script and module has another name, and the formulas other numbers. */
function publish(folder) {
  const assets = path.join(folder, 'assets')
  const names = readdirSync(assets).filter((name) => /-[A-Z0-9]{8}\.(js|wasm)$/.test(name))
  const renamed = new Map(
    names.map((name) => [name, name.replace(/-([A-Z0-9]{8})\./, (_, hash) => `-${[...hash].reverse().join('')}.`)]),
  )
  for (const [from, to] of renamed) renameSync(path.join(assets, from), path.join(assets, to))
  for (const file of readdirSync(folder, { recursive: true })
    .map(String)
    .filter((name) => /\.(html|js|json)$/.test(name))) {
    const at = path.join(folder, file)
    let text = readFileSync(at, 'utf8')
    for (const [from, to] of renamed) text = text.replaceAll(from, to)
    if (/(thrun|common)\.json$/.test(file)) text = text.replace(/"version":"[0-9a-f]/, (start) => `${start}0`)
    if (file.endsWith('.html'))
      text = text.replace(/data-readings="[0-9a-f]/, (start) => `${start}0`).replace(/<h1>/, '<h1 data-edition="new">')
    if (file === 'sw.js') text = text.replace(/VERSION = (['"])[^'"]*/, 'VERSION = $1second')
    writeFileSync(at, text)
  }
}

/** A copy of the site on a server of its own and a browser; `worker`: whether the service worker is let in. */
async function visit(worker, act) {
  const folder = mkdtempSync(path.join(copies, 'site-'))
  cpSync(dist, folder, { recursive: true })
  const site = await serve({ folder, base: BASE })
  const browser = await launch()
  try {
    const context = await browser.newContext({ reducedMotion: 'reduce', serviceWorkers: worker ? 'allow' : 'block' })
    const page = await context.newPage()
    await act({ page, context, folder, url: site.url, site })
  } finally {
    await browser.close()
    await site.close().catch(() => {})
  }
}

test('a page that is open while a new edition is published goes on whole', async () => {
  await visit(true, async ({ page, context, folder, url }) => {
    await page.goto(`${url}kalman/`)
    await keptOffline(page)
    await page.reload()
    publish(folder)
    // Another visit brings the new edition's worker.
    const other = await context.newPage()
    await other.goto(`${url}kalman/`)
    assert.equal(await other.locator('h1[data-edition=new]').count(), 1, 'who comes now sees the new edition')
    await other.evaluate(async () => {
      const registration = await navigator.serviceWorker.ready
      await registration.update()
      while (!registration.waiting && !(await caches.keys()).every((name) => name.endsWith('second')))
        await new Promise((resolve) => setTimeout(resolve, 50))
    })
    // Figures that slept, the search and the other letters.
    await figure(page, 'odometry-hook')
    await figure(page, 'picture')
    await page.locator('[data-set-notation=thrun]').click()
    await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
    assert.equal(await page.locator('[data-set-notation=thrun]').getAttribute('aria-pressed'), 'true')
    await page.keyboard.press('/')
    await page.locator('dialog.search input').fill('innovation')
    await page.locator('dialog.search li a').first().waitFor()
    // The new edition's page works too.
    await figure(other, 'observer-bench')
  })
})

test('without a store an open page says that there is a new edition, and a reload loses nothing', async () => {
  await visit(false, async ({ page, folder, url }) => {
    await page.goto(`${url}kalman/`)
    const hook = await figure(page, 'odometry-hook')
    await hook.getByRole('button', { name: 'Step' }).click()
    await quiet(page)
    const state = await stateOf(hook)
    publish(folder)
    const probe = page.locator('observability-probe').first()
    await probe.scrollIntoViewIfNeeded()
    await probe.getByText(/new edition/).waitFor()
    const top = () => probe.evaluate((it) => it.getBoundingClientRect().top)
    const reload = probe.getByRole('button', { name: 'Reload' })
    await reload.scrollIntoViewIfNeeded()
    await quiet(page)
    const before = await top()
    await reload.click()
    await page.locator('h1[data-edition=new]').waitFor({ state: 'attached' })
    await page.locator('observability-probe[data-state=live]').first().waitFor()
    await quiet(page)
    assert.ok(
      Math.abs((await top()) - before) < 29,
      `the place: ${await top()} px from the top after, ${before} before`,
    )
    assert.deepEqual(await stateOf(await figure(page, 'odometry-hook')), state, 'the figure as it was')
  })
})

/** Half of the chapter, and nothing after it. */
const half = (_, response) => {
  const whole = readFileSync(path.join(dist, 'kalman/index.html'))
  response.writeHead(200, { 'content-type': 'text/html', 'content-length': whole.length })
  response.write(whole.subarray(0, whole.length / 2))
}

for (const [what, answer] of /** @type {[string, import('node:http').RequestListener][]} */ ([
  ['hangs', () => {}],
  ['hangs in the middle of a page', half],
  ['fails', (_, response) => response.writeHead(503).end('Not now.')],
])) {
  test(`where the server ${what} the kept page is shown`, async (t) => {
    await visit(true, async ({ page, url, site }) => {
      await page.goto(`${url}kalman/`)
      await keptOffline(page)
      await site.close()
      const broken = createServer(answer).listen(Number(new URL(url).port), '127.0.0.1')
      try {
        for (const at of ['kalman/', 'hosting/']) {
          const began = Date.now()
          await page.goto(url + at, { waitUntil: 'commit' })
          t.diagnostic(`/${at} after ${((Date.now() - began) / 1000).toFixed(1)} s`)
          await page.locator('.site-footer').waitFor({ state: 'attached' })
          assert.ok(
            (await page.locator('h1').first().textContent()).length > 3 && !(await page.getByText('Not now.').count()),
          )
        }
        await page.goto(`${url}kalman/`)
        await figure(page, 'odometry-hook')
      } finally {
        broken.closeAllConnections()
        broken.close()
      }
    })
  })
}

test('a module that never answers is said, and comes when it is asked for again', async () => {
  await visit(false, async ({ page, url }) => {
    await page.route('**/*.wasm', () => {})
    await page.goto(`${url}kalman/`)
    const hook = page.locator('odometry-hook').first()
    await hook.scrollIntoViewIfNeeded()
    await hook.getByText(/does not answer/).waitFor()
    await page.unroute('**/*.wasm')
    await hook.getByRole('button', { name: 'Try again' }).click()
    await page.locator('odometry-hook[data-state=live]').first().waitFor()
  })
})

test('a script of a figure that never answers is said', async () => {
  await visit(false, async ({ page, url }) => {
    const chunk = readdirSync(path.join(dist, 'assets')).find(
      (name) =>
        name.endsWith('.js') &&
        readFileSync(path.join(dist, 'assets', name), 'utf8').includes('customElements.define('),
    )
    await page.route(`**/${chunk}`, () => {})
    await page.goto(`${url}kalman/`, { waitUntil: 'domcontentloaded' })
    const hook = page.locator('odometry-hook').first()
    await hook.scrollIntoViewIfNeeded()
    await hook.getByText(/could not be fetched/).waitFor()
  })
})
