// A system in continuous time, over spans of many lengths.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { refused } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** Position and speed; the acceleration is the input, and is disturbed. */
const cart = {
  A: [
    [0, 1],
    [0, 0],
  ],
  B: [[0], [1]],
  Q: [
    [0, 0],
    [0, 3],
  ],
}

test('a constant speed is exact over any span', () => {
  for (const dt of [0, 1e-12, 0.5, 1e9]) {
    const { F, G, V } = core.discretize(cart, dt)
    assert.deepEqual(F, [
      [1, dt],
      [0, 1],
    ])
    assert.deepEqual(G, [[(dt * dt) / 2], [dt]])
    assert.equal(V[0][1], V[1][0])
    const exact = [dt ** 3, 1.5 * dt ** 2, 3 * dt]
    for (const [i, found] of [V[0][0], V[0][1], V[1][1]].entries())
      assert.ok(Math.abs(found - exact[i]) <= 1e-15 * exact[i], `${found} against ${exact[i]}`)
  }
})

test('what it answers is a system that a filter takes as it is', () => {
  const { F, G, V } = core.discretize(cart, 0.1)
  const belief = {
    x: [0, 0],
    P: [
      [1, 0],
      [0, 1],
    ],
  }
  const filter = new core.KalmanFilter({ F, G, V, H: [[1, 0]], W: [[0.01]] }, belief)
  filter.step([1], [0.005])
  assert.ok(Math.abs(filter.x[1] - 0.1) < 1e-12)
  filter.free()
})

test('a refusal names what is to blame', () => {
  refused(() => core.discretize(cart, -1), 'limit', 'dt')
  refused(() => core.discretize(cart, NaN), 'not-finite', 'dt')
  refused(() => core.discretize(cart, '1'), 'type', 'dt')
  refused(() => core.discretize({ ...cart, A: [[1]] }, 1), 'shape', 'system.B')
  refused(
    () =>
      core.discretize(
        {
          ...cart,
          Q: [
            [0, 0],
            [0, -1],
          ],
        },
        1,
      ),
    'not-positive-semidefinite',
    'system.Q',
  )
  refused(() => core.discretize({ A: [[1]], B: [[]], Q: [[1]] }, 1e9), 'not-finite', 'dt')
})
