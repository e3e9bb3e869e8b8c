// A Firefox on the chapter, driven over WebDriver BiDi; FIREFOX names one that is not in the usual places.
import { after, before } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import puppeteer from 'puppeteer-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist, HANGS_MS, tagOf } from './places.mjs'

export const firefox = [
  process.env.FIREFOX,
  '/usr/bin/firefox-esr',
  '/usr/bin/firefox',
  '/Applications/Firefox.app/Contents/MacOS/firefox',
].find((path) => path && existsSync(path))

export let browser, site, page
export const complaints = []
/** What Firefox says of a script that a page was still fetching through its service worker when it was left. */
const CUT_OFF = /Failed to load .* A ServiceWorker intercepted the request/
let leaving = false
/** Leaves the page for another of the site. @param {string} at its place there */
export async function go(at) {
  leaving = true
  await page.goto(site.url + at)
  leaving = false
}
if (firefox) {
  before(async () => {
    site = await serve({ folder: dist, base: BASE })
    // Firefox 140 has no command for the orientation of a screen, which setting a viewport would give.
    browser = await puppeteer.launch({
      browser: 'firefox',
      executablePath: firefox,
      headless: true,
      defaultViewport: null,
      args: ['--width=1280', '--height=900'],
      timeout: HANGS_MS,
      protocolTimeout: HANGS_MS,
    })
    page = await browser.newPage()
    page.setDefaultTimeout(HANGS_MS)
    page.setDefaultNavigationTimeout(HANGS_MS)
    page.on('console', (message) => {
      const text = message.text()
      if (message.type() === 'error' && !(leaving && CUT_OFF.test(text))) complaints.push(text)
    })
    page.on('pageerror', (error) => complaints.push(String(error)))
    await page.goto(`${site.url}kalman/`)
  })
  after(async () => {
    await browser?.close()
    await site?.close()
  })
}

/**
 * Asks again and again. Puppeteer's own way makes a function of a text, which the page's policy forbids in Firefox 140.
 */
export const wait = (check, ...given) => waitIn(page, check, ...given)
export const waitIn = async (where, check, ...given) => {
  for (const end = Date.now() + HANGS_MS; !(await where.evaluate(check, ...given)); ) {
    assert.ok(Date.now() < end, `waited for ${check}`)
    await new Promise((resolve) => setTimeout(resolve, 100))
  }
}
export const alive = async (figure) => {
  const tag = tagOf(figure)
  await page.evaluate((name) => document.querySelector(name).scrollIntoView({ block: 'center' }), tag)
  await wait((name) => document.querySelector(name).dataset.state === 'live', tag)
}
