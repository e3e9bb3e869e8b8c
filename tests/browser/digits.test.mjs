// The same digits everywhere: a run of 10,000 steps of each lab has one hash, natively, in Node and in Chromium.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import path from 'node:path'
import { figure, open, root } from './harness.mjs'

const LABS = { 'observer-bench': 'ObserverBench', 'odometry-hook': 'OdometryHook', 'observability-probe': 'ObservabilityProbe' }
const native = Object.fromEntries(execFileSync('cargo', ['run', '--quiet', '--profile', 'site', '--example', 'digests', '-p', 'labs'], { cwd: root, encoding: 'utf8' })
  .trim().split('\n').map((line) => line.split(' ')))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

for (const [tag, hash] of Object.entries(native)) {
  test(`10,000 steps of ${tag} have the hash ${hash} in Node and in Chromium`, async (t) => {
    const lab = new core[LABS[tag]]()
    lab.run(10_000)
    assert.equal(lab.digest(), hash, 'in Node')
    lab.free()
    const page = await open(t)
    const element = await figure(page, tag)
    const there = await element.evaluate((it) => {
      const Lab = it.figure.lab.constructor
      const own = new Lab()
      own.run(10_000)
      return own.digest()
    })
    assert.equal(there, hash, 'in Chromium')
  })
}
