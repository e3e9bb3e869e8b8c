// Lighthouse's mobile run: access, best practices and SEO at 100 and no layout shift; performance is printed, not
// judged.
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { performanceOf, tower } from './lighthouse.mjs'
import { PAGES } from './places.mjs'

let run, close
before(async () => {
  ;({ run, close } = await tower())
})
after(() => close?.())

for (const at of PAGES) {
  test(`Lighthouse on /${at}`, async (t) => {
    const report = await run(at)
    const { categories, audits } = report
    const score = (name) => Math.round((categories[name].score ?? 0) * 100)
    const performance = performanceOf(report)
    t.diagnostic(
      `performance ${performance.score} (${performance.words}), accessibility ${score('accessibility')}, ` +
        `best practices ${score('best-practices')}, SEO ${score('seo')}`,
    )
    for (const name of ['accessibility', 'best-practices', 'seo']) {
      const failed = categories[name].auditRefs
        .map(({ id }) => audits[id])
        .filter((audit) => audit.score !== null && audit.score < 1 && audit.scoreDisplayMode !== 'informative')
      const why = failed.map((audit) => `${audit.id} ${JSON.stringify(audit.details?.items?.slice(0, 3) ?? '')}`)
      assert.equal(score(name), 100, `${name}: ${why.join('; ')}`)
    }
    assert.equal(
      audits['cumulative-layout-shift'].numericValue,
      0,
      JSON.stringify(audits['layout-shifts']?.details?.items?.slice(0, 5)),
    )
  })
}
