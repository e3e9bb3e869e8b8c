// Lighthouse's mobile run: access, best practices and SEO at 100 and no layout shift; performance is printed, not judged.
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { createServer } from 'node:net'
import { once } from 'node:events'
import { chromium } from 'playwright-core'
import lighthouse from 'lighthouse'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, PAGES, chromiumPath, dist } from './places.mjs'

let browser, site, port
before(async () => {
  const probe = createServer().listen(0, '127.0.0.1')
  await once(probe, 'listening')
  port = probe.address().port
  probe.close()
  site = await serve({ folder: dist, base: BASE })
  browser = await chromium.launch({ executablePath: chromiumPath(), args: [...CHROMIUM_FLAGS, `--remote-debugging-port=${port}`] })
})
after(async () => {
  await browser?.close()
  await site?.close()
})

for (const at of PAGES) {
  test(`Lighthouse on /${at}`, { timeout: 180_000 }, async (t) => {
    const run = await lighthouse(site.url + at, { port, output: 'json', logLevel: 'error' })
    const { categories, audits } = run.lhr
    const score = (name) => Math.round((categories[name].score ?? 0) * 100)
    t.diagnostic(`performance ${score('performance')}, accessibility ${score('accessibility')}, best practices ${score('best-practices')}, SEO ${score('seo')}, `
      + `first paint ${audits['first-contentful-paint'].displayValue}, largest ${audits['largest-contentful-paint'].displayValue}, blocking ${audits['total-blocking-time'].displayValue}, shift ${audits['cumulative-layout-shift'].displayValue}`)
    for (const name of ['accessibility', 'best-practices', 'seo']) {
      const failed = categories[name].auditRefs.map(({ id }) => audits[id]).filter((audit) => audit.score !== null && audit.score < 1 && audit.scoreDisplayMode !== 'informative')
      assert.equal(score(name), 100, `${name}: ${failed.map((audit) => audit.id + ' ' + JSON.stringify(audit.details?.items?.slice(0, 3) ?? '')).join('; ')}`)
    }
    assert.equal(audits['cumulative-layout-shift'].numericValue, 0, JSON.stringify(audits['layout-shifts']?.details?.items?.slice(0, 5)))
  })
}
