// One site, one Chromium, and pages that tell on themselves: a page opened here fails its test on any console error,
// uncaught error, policy violation, failed or foreign request.
import { after } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { readState, withState } from '../../web/figure/state-in-url.js'
import { stillness } from './rest.mjs'
import { BASE, CHROMIUM_FLAGS, chromiumPath, DESKTOP, dist, HANGS_MS, STANDS_STILL_MS, tagOf } from './places.mjs'

export * from './places.mjs'
export * from './rest.mjs'

/** A Chromium whose pages wait as long as a busy machine may need. */
export async function launch(options = {}) {
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: CHROMIUM_FLAGS,
    timeout: HANGS_MS,
    ...options,
  })
  const fresh = browser.newContext.bind(browser)
  browser.newContext = async (wishes) => {
    const context = await fresh(wishes)
    context.setDefaultTimeout(HANGS_MS)
    context.setDefaultNavigationTimeout(HANGS_MS)
    return context
  }
  return browser
}

let folder = dist
/** Has the tests of this file open another site than the book. @param {string} site its folder */
export function serveInstead(site) {
  assert.ok(existsSync(site), `no ${site}: node tests/browser/run.mjs NAME builds it`)
  folder = site
}

let started
/** The served site and the browser of this test file; both end with it. */
export function stage() {
  started ??= (async () => {
    const site = await serve({ folder, base: BASE })
    const browser = await launch()
    return { site, browser }
  })()
  return started
}
after(async () => {
  if (!started) return
  const { site, browser } = await started
  await browser.close()
  await site.close()
})

/**
 * Opens a page of the site for the test `t`, watched.
 * @param {import('node:test').TestContext} t
 * @param {{ at?: string, theme?: 'light' | 'dark', viewport?: { width: number, height: number }, touch?: boolean,
 *   scripts?: boolean, motion?: 'reduce' | 'no-preference', worker?: boolean, expected?: RegExp[],
 *   prepare?: (page: import('playwright-core').Page) => Promise<unknown> }} [wishes]
 *   `expected`: complaints that the test itself brings about; `worker`: let the service worker in
 */
export async function open(t, wishes = {}) {
  const {
    at = 'kalman/',
    theme = 'light',
    viewport = DESKTOP,
    touch = false,
    scripts = true,
    motion = 'reduce',
    worker = false,
    expected = [],
  } = wishes
  const { site, browser } = await stage()
  const context = await browser.newContext({
    viewport,
    colorScheme: theme,
    hasTouch: touch,
    isMobile: touch,
    javaScriptEnabled: scripts,
    reducedMotion: motion,
    serviceWorkers: worker ? 'allow' : 'block',
    deviceScaleFactor: 1,
    locale: 'en-GB',
    acceptDownloads: true,
    permissions: ['clipboard-read', 'clipboard-write'],
  })
  const page = await context.newPage()
  const complaints = watch(page, site.url)
  // What a test awaits inside a page has no limit of its own. A page that is gone ends the wait, and the test that
  // stood still is named, before the limit of its whole file names none.
  const limit = setTimeout(async () => {
    complaints.push(`the test stood still for ${STANDS_STILL_MS / 1000} s`)
    t.diagnostic(`${complaints.at(-1)}; ${await stillness(page)}`)
    context.close()
  }, STANDS_STILL_MS)
  t.after(async () => {
    clearTimeout(limit)
    await context.close()
    assert.deepEqual(
      complaints.filter((line) => !expected.some((pattern) => pattern.test(line))),
      [],
      'the page complained',
    )
  })
  await wishes.prepare?.(page)
  await page.goto(site.url + at, { waitUntil: 'load' })
  return page
}

/**
 * Opens the page of one figure, watched, with the figure alive: for tests whose subject is the figure and not the
 * chapter.
 * @param {import('node:test').TestContext} t
 * @param {string} name the figure's element
 * @param {Parameters<typeof open>[1] & { query?: string }} [wishes]
 */
export async function openFigure(t, name, { query = '', ...wishes } = {}) {
  const page = await open(t, { ...wishes, at: `figure/${name}/${query}` })
  return { page, it: await figure(page, name) }
}

/** Collects everything a page should never say or ask for. @param {string[]} homes where it may ask */
export function watch(page, ...homes) {
  const complaints = []
  page.on('console', (message) => {
    // Said by the driver where a test keeps the service worker out.
    if (/registration blocked by Playwright/.test(message.text())) return
    if (message.type() === 'error' || message.type() === 'warning') complaints.push(`console: ${message.text()}`)
  })
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.message}`))
  page.on('crash', () => complaints.push('the page crashed'))
  page.on('request', (request) => {
    const url = request.url()
    if (!homes.some((home) => url.startsWith(home)) && !/^(data|blob|about):/.test(url))
      complaints.push(`foreign request: ${url}`)
  })
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`)
  })
  page.on('requestfailed', (request) => {
    const why = request.failure()?.errorText ?? ''
    if (why !== 'net::ERR_ABORTED') complaints.push(`failed: ${request.url()} ${why}`)
  })
  return complaints
}

/**
 * A figure's custom element, scrolled to, alive (its module loaded, its controls there) and in the state of its link.
 */
export async function figure(page, name) {
  const tag = tagOf(name)
  const element = page.locator(tag).first()
  await element.scrollIntoViewIfNeeded()
  // A word that was pressed before may scroll once more, away from it: far from the window it does not come alive.
  await page.waitForFunction((of) => {
    const it = document.querySelector(of)
    if (it.dataset.state === 'live') return true
    const { top, bottom } = it.getBoundingClientRect()
    if (bottom < 0 || top > innerHeight) it.scrollIntoView({ block: 'nearest', behavior: 'instant' })
    return false
  }, tag)
  // One that opens small in the text is looked at as a whole; how it grows is a test of its own.
  await element.evaluate((it) => {
    if (it.dataset.stage) it.dataset.stage = '3'
  })
  await page.waitForFunction((of) => document.querySelector(of).settled, tag)
  return element
}

/** Waits until nothing is left to compute in a figure, and what was computed is on the screen. */
export const settled = (it) =>
  it.evaluate(async (host) => {
    do await new Promise((resolve) => requestAnimationFrame(resolve))
    while (host.figure.asked || !host.settled)
  })

/** A state as an address holds it. */
export const codeOf = (lab, step, params = {}) =>
  new URL(withState('https://any/', 'it', { version: 1, lab, step, params })).searchParams.get('it')

/** The state that a link holds for the figure `id`. @param {string | URL} link @param {string} id */
export function stateIn(link, id) {
  const state = readState(String(link), id)
  assert.ok(state && state !== 'mangled', `a state of ${id} in ${link}`)
  return state
}

/** Commits to some answer where a question locks the figure `id`. */
export async function unlock(page, id) {
  const form = page.locator(`.quiz[data-unlocks="${id}"]`)
  if (!(await form.count())) return
  // A question gets its controls when it comes near the screen.
  await comeTo(page, `.quiz[data-unlocks="${id}"]`, `form.quiz[data-unlocks="${id}"] input`)
  await form.locator('input').first().check()
  await form.locator('[type=submit]').click()
  await page.locator(`#${id} .widget:not([inert])`).waitFor()
}

/**
 * Scrolls to a part of the page until it is on the screen and what waits for that is there: laying out the parts above
 * may move it away again.
 */
export async function comeTo(page, selector, sign) {
  const there = page.locator(sign).first()
  for (const deadline = Date.now() + HANGS_MS; ; assert.ok(Date.now() < deadline, `${sign} does not come`)) {
    const onScreen = await page.evaluate(async (target) => {
      const part = document.querySelector(target)
      part.scrollIntoView({ block: 'center', behavior: 'instant' })
      for (let i = 0; i < 3; i++) await new Promise((resolve) => requestAnimationFrame(resolve))
      const { top, bottom } = part.getBoundingClientRect()
      return bottom > 0 && top < innerHeight
    }, selector)
    if (onScreen && (await there.isVisible())) return
  }
}

/**
 * Scrolls through the whole page, so that everything that waits for the screen has been on it, and every figure is
 * alive.
 */
export async function walkDown(page) {
  // What the page does when it is idle comes first: some of its scripts begin to watch the screen then. On a machine
  // that is never idle they do not wait for ever either (web/page/page.js).
  await page.evaluate(() => new Promise((resolve) => requestIdleCallback(resolve, { timeout: 5000 })))
  await page.waitForLoadState('networkidle')
  await page.evaluate(async () => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve))
    // A screen at each frame. The page grows and shrinks as its parts are laid out: each step goes on from where the
    // last one led.
    for (let from = -1, screens = 0; scrollY > from; screens++) {
      if (screens > 5000) throw new Error(`the page grows without end: ${document.body.scrollHeight} px`)
      from = scrollY
      scrollBy({ top: innerHeight, behavior: 'instant' })
      await frame()
    }
  })
  // A figure comes to life only while it is near the screen.
  for (const widget of await page.locator('.widget').all()) {
    await widget.scrollIntoViewIfNeeded()
    await widget.and(page.locator('[data-state="live"]')).waitFor()
  }
  await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }))
}

/** Lays out the whole page at its width: what is closed is open, and the parts that wait for the screen do not wait. */
export const layOut = (page) =>
  page.evaluate(async () => {
    for (const block of document.querySelectorAll('details')) block.open = true
    for (const part of document.querySelectorAll('main > article > section, .end-matter'))
      part.style.contentVisibility = 'visible'
    await document.fonts.ready
    // Sizes are looked at once a frame.
    for (let i = 0; i < 3; i++) await new Promise((resolve) => requestAnimationFrame(resolve))
  })

/** The frame on a figure's screen, and its state. */
export const frameOf = (element) => element.evaluate((it) => it.frame)
export const stateOf = (element) => element.evaluate((it) => it.state)

/** Waits until the figure's frame satisfies `wanted` (a function of the frame, run here), and gives that frame. */
export async function until(element, wanted, what) {
  const deadline = Date.now() + HANGS_MS
  for (;;) {
    // The next look is taken when there may be something new to see.
    const { frame, settled } = await element.evaluate(async (it) => {
      await new Promise((resolve) => requestAnimationFrame(resolve))
      return { frame: it.frame, settled: it.settled }
    })
    if (frame && settled && wanted(frame)) return frame
    if (Date.now() > deadline)
      assert.fail(`${what}; the frame's parameters are ${JSON.stringify(frame?.params)} at step ${frame?.step}`)
  }
}

/** Drags a native slider's thumb to `value` with the mouse. */
export async function dragSlider(page, slider, value) {
  await slider.scrollIntoViewIfNeeded()
  const { x, y, width, height } = await slider.boundingBox()
  const { min, max, now } = await slider.evaluate((input) => ({
    min: Number(input.min),
    max: Number(input.max),
    now: Number(input.value),
  }))
  // A thumb's middle runs from half a thumb inside one end to half a thumb inside the other.
  const thumb = 16
  const at = (v) => x + thumb / 2 + ((width - thumb) * (v - min)) / (max - min)
  await page.mouse.move(at(now), y + height / 2)
  await page.mouse.down()
  await page.mouse.move((at(now) + at(value)) / 2, y + height / 2, { steps: 4 })
  await page.mouse.move(at(value), y + height / 2, { steps: 4 })
  await page.mouse.up()
}
