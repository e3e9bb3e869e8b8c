// The same digits everywhere: a run of 10,000 steps of each lab, as it opens and with the rest of its algebra at work,
// has one hash, natively, in Node and in Chromium.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import path from 'node:path'
import { FIGURES } from '../../target/figures.js'
import { carFrames, carStates, framesThere } from './car-frames.mjs'
import { openFigure, root, until } from './harness.mjs'

const native = execFileSync('cargo', ['run', '--quiet', '--locked', '--example', 'digests', '-p', 'labs'], {
  cwd: root,
  encoding: 'utf8',
})
  .trim()
  .split('\n')
  .map((line) => line.split(' '))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

const log = core.RobotLog.parse(readFileSync(path.join(root, 'content/logs/plaza1.csv'), 'utf8'))

for (const [tag, hash, given] of native.filter(([tag]) => tag === 'robot-log')) {
  test(`10,000 rows of the log with ${given} have the hash ${hash} in Node and in a worker of Chromium`, async (t) => {
    const state = { version: 1, lab: tag, params: JSON.parse(given), step: 10_000 }
    const lab = core.RobotLog.from(log, state)
    assert.equal(lab.digest(), hash, 'in Node')
    lab.free()
    const code = Buffer.from(JSON.stringify([1, tag, state.step, state.params])).toString('base64url')
    const { it } = await openFigure(t, tag, { query: `?fig-log=${code}` })
    await until(it, ({ step }) => step === state.step, 'the state of the link')
    assert.equal(await it.evaluate((element) => element.figure.run.digest), hash, 'in the worker')
  })
}

test('the car’s log has the frames in Chromium that Node computes, to the bit', async (t) => {
  const { page } = await openFigure(t, 'car-log')
  assert.deepEqual(JSON.parse(await page.evaluate(framesThere, carStates)), carFrames())
})

for (const { name, lab: known, world } of FIGURES) {
  const runs = native.filter(([of]) => of === name)
  test(`the native code has run the lab of ${name}`, () => assert.ok(runs.length > 0))
  // Those over a log are compared above.
  for (const [, hash, given] of world ? [] : runs) {
    test(`10,000 steps of ${name} with ${given} have the hash ${hash} in Node and in Chromium`, async (t) => {
      const params = JSON.parse(given)
      const lab = new core[known](params)
      lab.run(10_000)
      assert.equal(lab.digest(), hash, 'in Node')
      lab.free()
      const { it: element } = await openFigure(t, name)
      const there = await element.evaluate((it, asked) => {
        const Lab = it.figure.lab.constructor
        const own = new Lab(asked)
        own.run(10_000)
        return own.digest()
      }, params)
      assert.equal(there, hash, 'in Chromium')
    })
  }
}
