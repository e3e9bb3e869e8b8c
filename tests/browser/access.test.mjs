// Access: no axe violation on any page in either theme, nor in what a reader can call up over one.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
import { PAGES, PHONE, open, walkDown } from './harness.mjs'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

/** What axe finds on the page as it stands. */
async function faults(page) {
  await page.evaluate(axe)
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }))
  return violations.map((rule) => `${rule.id}: ${rule.help}\n` + rule.nodes.slice(0, 4).map((node) => `    ${node.target.join(' ')} ${node.any.concat(node.all, node.none)[0]?.message ?? ''}`).join('\n')).join('\n')
}

const SOURCE = 'source/crates/estimate/src/kf.rs.html'
for (const at of [...PAGES, SOURCE]) {
  for (const theme of ['light', 'dark']) {
    test(`axe finds nothing on /${at} in ${theme}`, async (t) => {
      const page = await open(t, { at, theme })
      await walkDown(page)
      // Closed blocks are read too.
      await page.evaluate(() => document.querySelectorAll('details').forEach((block) => { block.open = true }))
      assert.equal(await faults(page), '')
    })
  }
}

const CALLED_UP = {
  'the search open': async (page) => {
    await page.locator('[data-open-search]').click()
    await page.locator('dialog.search input').fill('innovation')
    await page.locator('dialog.search li a').first().waitFor()
  },
  'Thrun\'s letters': async (page) => {
    await page.locator('[data-set-notation="thrun"]').click()
    await page.waitForFunction(() => document.documentElement.classList.contains('two-notations'))
  },
  'a term explained and its kin lit': async (page) => {
    await walkDown(page)
    const term = page.locator('.term-prediction.term, .term-posterior.term, .term-measurement.term').first()
    await term.focus()
    await page.locator('.popover:not([hidden])').waitFor()
    await page.locator('.widget[data-lit]').waitFor({ state: 'attached' })
    // The others fade.
    await page.waitForTimeout(400)
  },
}
for (const theme of ['light', 'dark']) {
  for (const [what, act] of Object.entries(CALLED_UP)) {
    test(`axe finds nothing with ${what}, in ${theme}`, async (t) => {
      const page = await open(t, { theme })
      await page.waitForLoadState('networkidle')
      await act(page)
      assert.equal(await faults(page), '')
    })
  }
  test(`axe finds nothing with the contents called up on a phone, in ${theme}`, async (t) => {
    const page = await open(t, { theme, viewport: PHONE, touch: true })
    await page.waitForLoadState('networkidle')
    await page.locator('[data-open-contents]').tap()
    await page.locator('.toc[data-open]').waitFor()
    assert.equal(await faults(page), '')
  })
}
