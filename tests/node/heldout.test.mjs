// The module's verdicts on systems whose truth exact arithmetic has told: tests/heldout/README.md says how. The rules
// are those of tests/heldout_systems.rs.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const SYSTEMS = JSON.parse(readFileSync(new URL('../heldout/systems.json', import.meta.url), 'utf8'))
const [TOLERANCE, NEAR] = [1e-9, 1e-8]

test('the module gives the verdicts of exact arithmetic, and leaves open only what the tolerance leaves open', () => {
  const faults = []
  for (const system of SYSTEMS) {
    const { name, F, G, H, V, W } = system
    const margin = (what) => Math.max(system.margin[what], system.margin_scaled[what])
    const hardly = (what) => system[what] && margin(what) < TOLERANCE
    const { observable, detectable } = core.detectability(F, H, TOLERANCE)
    const { stabilizable } = core.noiseReach(F, V, TOLERANCE)
    const { reachable: controllable } = core.stabilizability(F, G, TOLERANCE)
    for (const [what, found] of Object.entries({ observable, detectable, stabilizable, controllable })) {
      const right = { yes: system[what], no: !system[what] || hardly(what), undecided: margin(what) < NEAR }[found]
      if (!right) faults.push(`${name}: ${what} is ${system[what]}, found ${found}`)
    }
    if (hardly('detectable') || hardly('stabilizable')) continue
    const limit = core.riccatiLimit({ F, G, H, V, W }, TOLERANCE)
    const expected = system.detectable
      ? system.stabilizable
        ? 'from-every-start'
        : 'from-large-start'
      : system.stabilizable
        ? 'none'
        : 'depends-on-start'
    if (limit !== expected && !(limit === 'undecided' && Math.min(margin('detectable'), margin('stabilizable')) < NEAR))
      faults.push(`${name}: ${limit}, ${expected} expected`)
  }
  assert.ok(SYSTEMS.length > 120)
  assert.deepEqual(faults, [])
})
