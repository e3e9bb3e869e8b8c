// What every figure prints of its state is a value, in any state. What each says in sentences is held to its frames in
// a file of its own (`*-words.test.mjs`).
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import path from 'node:path'
import { WIDGETS } from '../../web/widgets/index.js'
import { LOG, estimate } from './claims.mjs'

test('no readout of a figure is empty or wrong in kind, in any state', async () => {
  for (const load of Object.values(WIDGETS)) {
    const spec = await load()
    const open = (state) =>
      spec.log ? estimate[spec.lab].from(estimate[spec.lab].parse(LOG), state) : estimate[spec.lab].from(state)
    for (const step of spec.timeless ? [0] : [0, 1, 300]) {
      const lab = open({ version: 1, lab: spec.name, step, params: spec.start.params })
      for (const { key, value } of spec.readouts(lab.frame()))
        assert.doesNotMatch(`${key}: ${value}`, /undefined|NaN|null|: $/)
    }
  }
})

test('the sentences of each figure are claims in a file of its name', () => {
  const missing = Object.keys(WIDGETS).filter(
    (name) => !existsSync(path.join(import.meta.dirname, `${name}-words.test.mjs`)),
  )
  assert.deepEqual(missing, [])
})
