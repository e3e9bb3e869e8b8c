// The second engine: every widget comes alive, moves and keeps its digits in Firefox, without a complaint, driven over
// WebDriver BiDi with the keyboard. Skipped where there is no Firefox (FIREFOX names one that is not in the usual places).
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { once } from 'node:events'
import { existsSync } from 'node:fs'
import { createServer } from 'node:http'
import { createRequire } from 'node:module'
import path from 'node:path'
import puppeteer from 'puppeteer-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist, root } from './places.mjs'

const firefox = [process.env.FIREFOX, '/usr/bin/firefox-esr', '/usr/bin/firefox', '/Applications/Firefox.app/Contents/MacOS/firefox'].find((path) => path && existsSync(path))
const notice = 'no Firefox here; Debian: apt-get install firefox-esr'
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

// Before any test, since cargo may have to compile it, or to wait for another cargo: no test's time is spent on that.
const native = firefox ? execFileSync('cargo', ['run', '--quiet', '--locked', '--example', 'digests', '-p', 'labs'], { cwd: root, encoding: 'utf8' }) : ''

let browser, site, page
const complaints = []
if (firefox) {
  before(async () => {
    site = await serve({ folder: dist, base: BASE })
    browser = await puppeteer.launch({ browser: 'firefox', executablePath: firefox, headless: true })
    page = await browser.newPage()
    await page.setViewport({ width: 1280, height: 900 })
    page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()) })
    page.on('pageerror', (error) => complaints.push(String(error)))
    await page.goto(site.url + 'kalman/', { timeout: 60_000 })
  })
  after(async () => {
    await browser?.close()
    await site?.close()
  })
}

const wait = (check, ...given) => page.waitForFunction(check, { timeout: 30_000, polling: 100 }, ...given)
const alive = async (tag) => {
  await page.evaluate((name) => document.querySelector(name).scrollIntoView({ block: 'center' }), tag)
  await wait((name) => document.querySelector(name).dataset.state === 'live', tag)
}

for (const tag of ['odometry-hook', 'observer-bench', 'observability-probe']) {
  test(`${tag} steps in Firefox`, { skip: firefox ? false : notice, timeout: 120_000 }, async () => {
    await alive(tag)
    const step = await page.evaluate((name) => document.querySelector(name).frame.step, tag)
    await page.evaluate((name) => [...document.querySelectorAll(`${name} .live button`)].find((button) => button.textContent === 'Step').focus(), tag)
    await page.keyboard.press('Enter')
    await wait((name, n) => document.querySelector(name).frame.step > n, tag, step)
  })
}

test('the keys turn the knob in Firefox', { skip: firefox ? false : notice, timeout: 120_000 }, async () => {
  await alive('observer-bench')
  await page.evaluate(() => document.querySelector('observer-bench .live input[type=range]').focus())
  const gain = await page.evaluate(() => document.querySelector('observer-bench').frame.params.gain)
  await page.keyboard.press('ArrowRight')
  await wait((g) => document.querySelector('observer-bench').frame.params.gain > g, gain)
})

test('the keys move the prediction of kalman-picture in Firefox, to the frame that Node computes', { skip: firefox ? false : notice, timeout: 120_000 }, async () => {
  await alive('kalman-picture')
  // A question locks it until some answer is given.
  const id = await page.evaluate(() => document.querySelector('kalman-picture').dataset.figure)
  await page.evaluate((figure) => {
    document.querySelector(`.quiz[data-unlocks="${figure}"]`).scrollIntoView()
  }, id)
  await wait((figure) => document.querySelector(`.quiz[data-unlocks="${figure}"] input`), id)
  await page.evaluate((figure) => {
    const form = document.querySelector(`.quiz[data-unlocks="${figure}"]`)
    form.querySelector('input').click()
    form.querySelector('[type=submit]').click()
  }, id)
  await wait((figure) => document.querySelector(`#${figure} .widget:not([inert])`), id)
  await page.evaluate(() => document.querySelector('kalman-picture .live [role=slider][aria-label="Prediction"]').focus())
  const { mean: [x] } = await page.evaluate(() => document.querySelector('kalman-picture').frame.params)
  await page.keyboard.press('ArrowRight')
  await wait((from) => { const { frame, settled } = document.querySelector('kalman-picture'); return settled && frame.params.mean[0] > from }, x)
  const there = await page.evaluate(() => document.querySelector('kalman-picture').frame)
  const lab = new core.Picture()
  lab.set(there.params)
  assert.deepEqual(there, lab.frame())
})

test('a figure lives in a sandboxed frame of another origin in Firefox, and tells its height', { skip: firefox ? false : notice, timeout: 120_000 }, async () => {
  const html = `<!doctype html><title>Somebody else's page</title><iframe src="${site.url}figure/observer-bench/" title="A figure" sandbox="allow-scripts" width="800" height="900"></iframe>
    <script>heights = []; addEventListener('message', ({ data }) => heights.push(data.height))</script>`
  const server = createServer((_, response) => response.writeHead(200, { 'content-type': 'text/html' }).end(html)).listen(0, '127.0.0.1')
  await once(server, 'listening')
  const other = await browser.newPage()
  try {
    other.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()) })
    await other.goto(`http://127.0.0.1:${server.address().port}/`)
    const frame = other.frames()[1]
    await frame.waitForFunction(() => document.querySelector('observer-bench').settled, { timeout: 30_000, polling: 100 })
    assert.equal(await frame.evaluate(() => self.origin), 'null')
    await frame.evaluate(() => document.querySelector('observer-bench .live input[type=range]').focus())
    const gain = await frame.evaluate(() => document.querySelector('observer-bench').frame.params.gain)
    await other.keyboard.press('ArrowRight')
    await frame.waitForFunction((g) => document.querySelector('observer-bench').frame.params.gain > g, { timeout: 30_000, polling: 100 }, gain)
    assert.ok((await other.evaluate(() => heights)).every((height) => Number.isInteger(height) && height > 300))
  } finally {
    await other.close()
    server.closeAllConnections()
    server.close()
  }
})

test('10,000 steps have the same hash in Firefox', { skip: firefox ? false : notice, timeout: 120_000 }, async () => {
  const shown = ([tag]) => existsSync(path.join(root, `web/widgets/${tag}.js`))
  for (const [tag, hash, given] of native.trim().split('\n').map((line) => line.split(' ')).filter(shown)) {
    await alive(tag)
    const there = await page.evaluate((name, params) => {
      const lab = new (document.querySelector(name).figure.lab.constructor)(params)
      lab.run(10_000)
      return lab.digest()
    }, tag, JSON.parse(given))
    assert.equal(there, hash, `${tag} with ${given}`)
  }
})

test('Firefox had nothing to complain about', { skip: firefox ? false : notice }, async () => {
  // While the page still streams in, Firefox may lay a formula out between one of its children and the next, and says so.
  // What counts is the page as it stands.
  const parts = { msub: 2, msup: 2, msubsup: 3, mfrac: 2, munder: 2, mover: 2, munderover: 3 }
  const half = (complaint) => Object.keys(parts).some((tag) => complaint.includes(`Incorrect number of children for <${tag}/>`))
  assert.deepEqual(complaints.filter((complaint) => !half(complaint)), [])
  const lacking = await page.evaluate((wanted) => Object.entries(wanted).flatMap(([tag, count]) => [...document.querySelectorAll(tag)].filter((one) => one.children.length !== count)).length, parts)
  assert.equal(lacking, 0)
})
