// Access: no axe violation on any page in either theme, and everything a hand can do the keyboard can.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
import { PAGES, open, walkDown } from './harness.mjs'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

for (const at of PAGES) {
  for (const theme of ['light', 'dark']) {
    test(`axe finds nothing on /${at} in ${theme}`, async (t) => {
      const page = await open(t, { at, theme })
      await walkDown(page)
      // Closed blocks are read too.
      await page.evaluate(() => document.querySelectorAll('details').forEach((block) => { block.open = true }))
      await page.evaluate(axe)
      const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ['violations'] }))
      const found = violations.map((rule) => `${rule.id}: ${rule.help}\n` + rule.nodes.slice(0, 4).map((node) => `    ${node.target.join(' ')} ${node.any.concat(node.all, node.none)[0]?.message ?? ''}`).join('\n'))
      assert.equal(found.length, 0, found.join('\n'))
    })
  }
}
