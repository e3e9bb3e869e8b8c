// The same digits everywhere: a run of 10,000 steps of each lab, as it opens and with the rest of its algebra at work, has
// one hash, natively, in Node and, where a figure shows it, in Chromium.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { openFigure, root } from './harness.mjs'

const LABS = {
  'observer-bench': 'ObserverBench', 'odometry-hook': 'OdometryHook', 'observability-probe': 'ObservabilityProbe',
  'loop-closure': 'LoopClosure', tune: 'Tune',
}
const native = execFileSync('cargo', ['run', '--quiet', '--locked', '--example', 'digests', '-p', 'labs'], { cwd: root, encoding: 'utf8' })
  .trim().split('\n').map((line) => line.split(' '))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

for (const [tag, hash, given] of native) {
  const shown = existsSync(path.join(root, `web/widgets/${tag}.js`))
  test(`10,000 steps of ${tag} with ${given} have the hash ${hash} in Node${shown ? ' and in Chromium' : ''}`, async (t) => {
    const params = JSON.parse(given)
    const lab = new core[LABS[tag]](params)
    lab.run(10_000)
    assert.equal(lab.digest(), hash, 'in Node')
    lab.free()
    if (!shown) return
    const { it: element } = await openFigure(t, tag)
    const there = await element.evaluate((it, asked) => {
      const Lab = it.figure.lab.constructor
      const own = new Lab(asked)
      own.run(10_000)
      return own.digest()
    }, params)
    assert.equal(there, hash, 'in Chromium')
  })
}
