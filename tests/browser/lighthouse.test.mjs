// Lighthouse's mobile run: access, best practices and SEO at 100 and no layout shift. Performance is a matter of what
// else the machine does: `node tests/browser/tools/lighthouse.mjs` measures it.
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { tower } from './tools/lighthouse.mjs'
import { PAGES, RELEASE } from './places.mjs'

/** A page of each kind; a release is tried on all. axe looks at every page each time (access.test.mjs). */
const KINDS = ['', 'kalman/', 'kalman/exercises/', 'kalman/numbers/', 'log/', 'teaching/']
for (const at of KINDS) assert.ok(PAGES.includes(at), `there is no /${at}`)

let run, close
before(async () => {
  ;({ run, close } = await tower())
})
after(() => close?.())

for (const at of RELEASE ? PAGES : KINDS) {
  test(`Lighthouse on /${at}`, async () => {
    const { categories, audits, runtimeError } = await run(at)
    const judged = ['accessibility', 'best-practices', 'seo']
    // What could not be looked at has no score, and its category none.
    const looked = judged.flatMap((name) => categories[name].auditRefs).map(({ id }) => audits[id])
    const unseen = looked.filter(({ scoreDisplayMode }) => scoreDisplayMode === 'error')
    assert.deepEqual(
      unseen.map(({ id, errorMessage }) => `${id}: ${errorMessage}`),
      [],
      runtimeError?.message,
    )
    const score = (name) => Math.round((categories[name].score ?? 0) * 100)
    for (const name of judged) {
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
