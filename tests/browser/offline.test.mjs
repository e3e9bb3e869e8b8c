// After one visit the site needs no network.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist, figure, watch } from './harness.mjs'

test('after one visit every page and figure works without a network', { timeout: 120_000 }, async () => {
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
  try {
    const context = await browser.newContext({ reducedMotion: 'reduce' })
    const page = await context.newPage()
    const complaints = watch(page, site.url)
    await page.goto(site.url + 'kalman/')
    await page.evaluate(async () => {
      const { active } = await navigator.serviceWorker.ready
      while (active.state !== 'activated') await new Promise((resolve) => setTimeout(resolve, 50))
    })
    // The network goes away for good: no server is left to ask.
    await context.setOffline(true)
    await site.close()
    for (const at of ['kalman/', '', 'check/']) {
      await page.goto(site.url + at)
      assert.ok((await page.locator('h1').first().textContent()).length > 3, `/${at}`)
    }
    await page.goto(site.url + 'kalman/')
    await figure(page, 'observer-bench')
    assert.deepEqual(complaints, [])
  } finally {
    await browser.close()
    await site.close().catch(() => {})
  }
})
