// The second engine: every widget moves in Firefox without a complaint, driven over WebDriver BiDi. Skipped where there
// is no Firefox (FIREFOX names one that is not in the usual places).
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import puppeteer from 'puppeteer-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, dist } from './places.mjs'

const firefox = [process.env.FIREFOX, '/usr/bin/firefox-esr', '/usr/bin/firefox', '/Applications/Firefox.app/Contents/MacOS/firefox'].find((path) => path && existsSync(path))

if (!firefox) {
  test('every widget moves in Firefox', { skip: 'no Firefox here; Debian: apt-get install firefox-esr' }, () => {})
} else {
  let browser, site
  before(async () => {
    site = await serve({ folder: dist, base: BASE })
    browser = await puppeteer.launch({ browser: 'firefox', executablePath: firefox, headless: true })
  })
  after(async () => {
    await browser?.close()
    await site?.close()
  })

  test('every widget moves in Firefox', { timeout: 120_000 }, async () => {
    const page = await browser.newPage()
    const complaints = []
    page.on('console', (message) => { if (message.type() === 'error') complaints.push(message.text()) })
    page.on('pageerror', (error) => complaints.push(String(error)))
    await page.goto(site.url + 'kalman/')
    console.log(await page.title())
    assert.deepEqual(complaints, [])
  })
}
