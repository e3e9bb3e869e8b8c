// A log replayed in one call is its steps one by one, to the last bit.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { belief, rail, refused } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** −½(ln det 2πS + νᵀS⁻¹ν) of one output or two, by the formulas for a 2×2. */
function logDensity(nu, S) {
  if (nu.length === 1) return -0.5 * (Math.log(2 * Math.PI * S[0][0]) + nu[0] ** 2 / S[0][0])
  const det = S[0][0] * S[1][1] - S[0][1] ** 2
  const square = (S[1][1] * nu[0] ** 2 - 2 * S[0][1] * nu[0] * nu[1] + S[0][0] * nu[1] ** 2) / det
  return -0.5 * (Math.log((2 * Math.PI) ** 2 * det) + square)
}

test('a log whose innovation is nearly singular is filtered and has no likelihood', () => {
  const copies = {
    F: [
      [1, 0],
      [0, 1],
    ],
    G: [[0], [0]],
    H: [
      [1, 0],
      [1, 1e-8],
    ],
    V: [
      [0, 0],
      [0, 0],
    ],
    W: [
      [1e-16, 0],
      [0, 1e-16],
    ],
  }
  const log = core.kalmanReplay(
    copies,
    {
      x: [0, 0],
      P: [
        [1, 0],
        [0, 1],
      ],
    },
    new Float64Array(1),
    Float64Array.of(0.3, 0.3),
  )
  assert.equal(log.logLikelihood, null)
  assert.ok(Number.isFinite(log.x[0]))
})

test('kalmanReplay is kalmanStep, for the rail robot and for another size', () => {
  const both = {
    ...rail,
    H: [
      [1, 0],
      [0, 1],
    ],
    W: [
      [0.5, 0.1],
      [0.1, 0.4],
    ],
  }
  for (const system of [rail, both]) {
    const steps = 40
    const outputs = system.H.length
    const inputs = Float64Array.from({ length: steps }, (_, k) => Math.sin(k))
    const readings = Float64Array.from({ length: steps * outputs }, (_, k) => Math.cos(0.3 * k))
    const log = core.kalmanReplay(system, belief, inputs, readings)
    let [state, likelihood] = [belief, 0]
    for (let k = 0; k < steps; k++) {
      state = core.kalmanStep(system, state, [inputs[k]], [...readings.slice(k * outputs, (k + 1) * outputs)])
      likelihood += logDensity(state.innovation, state.S)
      assert.deepEqual([...log.x.slice(2 * k, 2 * k + 2)], state.x)
      assert.deepEqual([...log.variances.slice(2 * k, 2 * k + 2)], [state.P[0][0], state.P[1][1]])
    }
    assert.deepEqual(log.P, state.P)
    assert.equal(log.x.length, 2 * steps)
    assert.ok(Math.abs(log.logLikelihood / likelihood - 1) < 1e-13, `${log.logLikelihood} against ${likelihood}`)
  }
})

test('kalmanReplay takes typed arrays only, and names what does not fit', () => {
  refused(() => core.kalmanReplay(rail, belief, [0], new Float64Array(1)), 'type', 'inputs')
  refused(() => core.kalmanReplay(rail, belief, new Float64Array(2), new Float64Array(1)), 'shape', 'inputs')
  refused(() => core.kalmanReplay(rail, belief, new Float64Array(1), Float64Array.of(NaN)), 'not-finite', 'readings[0]')
  refused(
    () => core.kalmanReplay(rail, belief, new Float64Array(100_001), new Float64Array(100_001)),
    'limit',
    'readings',
  )
})

test('EkfLocalizer.replay is predict and update', () => {
  const made = () =>
    new core.EkfLocalizer(
      {
        x: [1.5, 1.5, 0],
        P: [
          [0.01, 0, 0],
          [0, 0.01, 0],
          [0, 0, 0.01],
        ],
      },
      [
        { id: 1, x: 6, y: 6 },
        { id: 2, x: 0, y: 6 },
      ],
      {
        W: [
          [0.01, 0],
          [0, 0.001],
        ],
        gate: 50,
      },
    )
  const V = [
    [1e-4, 0, 0],
    [0, 1e-4, 0],
    [0, 0, 1e-4],
  ]
  const [logged, stepped] = [made(), made()]
  const log = Float64Array.from([0.1, 0.05, 6.3, -2.4, 0.1, 0.05, 4.8, -1.3, 0.1, 0.05, 6.1, -2.5])
  const ids = Uint32Array.from([1, 2, 1])
  const poses = logged.replay(log, ids, V)
  for (let k = 0; k < ids.length; k++) {
    const [ds, dtheta, range, bearing] = log.slice(4 * k, 4 * k + 4)
    stepped.predict([ds, dtheta], V)
    stepped.update({ range, bearing, landmark: ids[k] })
    assert.deepEqual([...poses.slice(3 * k, 3 * k + 3)], stepped.belief().x)
  }
  assert.deepEqual(logged.belief(), stepped.belief())
})

test('a log with gaps is its steps one by one, to the last bit', () => {
  const readings = [[2.1], null, [null], new Float64Array([4]), [5.5]]
  const inputs = Float64Array.from(readings, (_, k) => Math.sin(k))
  const log = core.kalmanReplay(rail, belief, inputs, readings)
  const filter = new core.KalmanFilter(rail, belief)
  for (const [k, y] of readings.entries()) {
    filter.step([inputs[k]], y ?? [null])
    assert.deepEqual([...log.x.slice(2 * k, 2 * k + 2)], filter.x)
    assert.deepEqual([...log.variances.slice(2 * k, 2 * k + 2)], [filter.P[0][0], filter.P[1][1]])
  }
  assert.deepEqual([log.P, log.logLikelihood, log.conditioned], [filter.P, filter.logLikelihood, true])
  const whole = [[1], [2], [3]]
  const flat = core.kalmanReplay(rail, belief, inputs.slice(0, 3), Float64Array.of(1, 2, 3))
  assert.deepEqual(core.kalmanReplay(rail, belief, inputs.slice(0, 3), whole), flat)
  const refused = (rows, code, argument) =>
    assert.throws(
      () => core.kalmanReplay(rail, belief, new Float64Array(rows.length), rows),
      (/** @type {any} */ error) => {
        assert.deepEqual([error.code, error.argument], [code, argument], error.message)
        return true
      },
    )
  refused([], 'limit', 'readings')
  refused([[1], [1, 2]], 'shape', 'readings[1]')
  refused([[1], [Number.NaN]], 'not-finite', 'readings[1]')
  refused([[1], ['2']], 'type', 'readings[1][0]')
  refused([[1], undefined], 'type', 'readings[1]')
})
