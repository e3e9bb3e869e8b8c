// A KalmanFilter takes another step or sensor for one call, tells of its last reading, and is kept as plain values.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { belief, rail } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const speed = { H: [[0, 1]], W: [[0.3]] }
const shown = ({ x, P, nis, logLikelihood, conditioned, innovation, S, R }) => [
  ...[x, P, nis, logLikelihood, conditioned],
  ...[innovation, S, R],
]

function refused(call, code, argument, message = /./) {
  assert.throws(call, (/** @type {any} */ error) => {
    assert.deepEqual([error.name, error.code, error.argument], ['EstimateError', code, argument], error.message)
    assert.match(error.message, message)
    return true
  })
}

test('a step and a sensor of one call are those of a filter that has them', () => {
  const cart = {
    A: [
      [0, 1],
      [0, -0.1],
    ],
    B: [[0], [1]],
    Q: [
      [0, 0],
      [0, 0.2],
    ],
  }
  const filter = new core.KalmanFilter(rail, belief)
  for (const [dt, y] of [
    [0.1, [1]],
    [0.7, [2]],
  ]) {
    const { F, G, V } = core.discretize(cart, dt)
    const twin = new core.KalmanFilter({ F, G, V, ...speed }, { x: filter.x, P: filter.P })
    twin.step([0.2], y)
    filter.predict([0.2], { F, G, V })
    filter.update(y, speed)
    assert.deepEqual([filter.x, filter.P, filter.nis], [twin.x, twin.P, twin.nis])
    assert.deepEqual([filter.innovation, filter.S, filter.R], [twin.innovation, twin.S, twin.R])
  }
  const twin = new core.KalmanFilter(rail, { x: filter.x, P: filter.P })
  for (const it of [filter, twin]) it.step([0.1], [1])
  assert.deepEqual([filter.x, filter.P], [twin.x, twin.P])
})

test('innovation, S and gain are those of kalmanStep', () => {
  const filter = new core.KalmanFilter(rail, belief)
  assert.deepEqual([filter.innovation, filter.S, filter.R], [null, null, null])
  filter.step([0.1], [4.2])
  const step = core.kalmanStep(rail, belief, [0.1], [4.2])
  assert.deepEqual([filter.innovation, filter.S, filter.R], [step.innovation, step.S, step.R])
  filter.update([null])
  assert.deepEqual([filter.innovation, filter.S, filter.R, filter.nis], [null, null, null, null])
})

test('a filter is kept as JSON and goes on to the last bit, also where digits are lost', () => {
  for (const scale of [1, 1e7, 1e14]) {
    const wide = { x: [2, 4], P: belief.P.map((row) => row.map((p) => p * scale)) }
    const filter = new core.KalmanFilter({ ...rail, W: [[0.5 / scale]] }, wide)
    for (let k = 0; k < 12; k++) {
      const kept = core.KalmanFilter.from(JSON.parse(JSON.stringify(filter.state())))
      const copy = filter.clone()
      assert.deepEqual(shown(kept), shown(filter))
      for (const it of [filter, kept, copy]) k === 5 ? it.step([0.1], [null]) : it.step([0.1], [k])
      assert.deepEqual(shown(kept), shown(filter))
      assert.deepEqual(shown(copy), shown(filter))
      assert.deepEqual(kept.state(), filter.state())
    }
    assert.equal(filter.conditioned, scale < 1e14)
  }
})

test('a clone is another filter', () => {
  const filter = new core.KalmanFilter(rail, belief)
  const copy = filter.clone()
  copy.step([0], [9])
  assert.deepEqual(filter.x, belief.x)
  filter.free()
  assert.ok(copy.x[0] > 2)
})

test('a state that was changed is refused by name', () => {
  const filter = new core.KalmanFilter(rail, belief)
  filter.step([0.1], [4.2])
  for (const [change, code, argument] of [
    [{ version: 2 }, 'limit', 'state.version'],
    [{ belief: { x: [1], P: [[1]] } }, 'shape', 'state.belief'],
    [{ belief: { x: [1, 'a'], P: belief.P } }, 'type', 'state.belief.x[1]'],
    [{ system: { ...rail, W: [[-1]] } }, 'not-positive-semidefinite', 'state.system.W'],
    [{ logLikelihood: Number.NaN }, 'not-finite', 'state.logLikelihood'],
    [{ conditioned: 1 }, 'type', 'state.conditioned'],
    [{ rounding: 'all' }, 'type', 'state.rounding'],
    [{ rounding: [[1]] }, 'shape', 'state.rounding'],
    [{ last: { ...filter.state().last, R: [[1]] } }, 'shape', 'state.last.R'],
    [{ more: 1 }, 'type', 'state.more'],
  ]) {
    refused(() => core.KalmanFilter.from({ ...filter.state(), .../** @type {object} */ (change) }), code, argument)
  }
})

test('a step or a sensor that does not fit is refused by name, and the filter stays', () => {
  const filter = new core.KalmanFilter(rail, belief)
  const step = { F: rail.F, G: rail.G, V: rail.V }
  for (const [call, code, argument] of [
    [() => filter.predict([0], { ...step, F: [[1]] }), 'shape', 'step.F'],
    [
      () =>
        filter.predict([0], {
          ...step,
          V: [
            [1, 2],
            [3, 4],
          ],
        }),
      'not-symmetric',
      'step.V',
    ],
    [() => filter.predict([0], { F: rail.F, V: rail.V }), 'shape', 'step.G'],
    [() => filter.predict([0], { F: rail.F, G: rail.G }), 'type', 'step.V'],
    [() => filter.predict([0], null), 'type', 'step'],
    [() => filter.predict([], step), 'shape', 'u'],
    [() => filter.update([1, 2], speed), 'shape', 'y'],
    [() => filter.update([1], { H: [[1]], W: [[1]] }), 'shape', 'sensor.H'],
    [() => filter.update([1], { ...speed, W: [[-1]] }), 'not-positive-semidefinite', 'sensor.W'],
    [() => filter.update([1], { ...speed, gate: 9 }), 'type', 'sensor.gate'],
    [() => filter.update([1], { H: [[1, 0]] }), 'type', 'sensor.W'],
  ]) {
    refused(call, code, argument)
    assert.deepEqual([filter.x, filter.P], [belief.x, belief.P])
  }
})

test('a system without inputs needs no G, in continuous time no B', () => {
  const { G: _, ...free } = rail
  const filter = new core.KalmanFilter(free, belief)
  filter.step([], [4.2])
  const given = core.kalmanStep({ ...free, G: [[], []] }, belief, [], [4.2])
  assert.deepEqual([filter.x, filter.P], [given.x, given.P])
  assert.deepEqual(core.kalmanStep(free, belief, [], [4.2]).x, given.x)
  const drift = {
    A: [
      [0, 1],
      [0, 0],
    ],
    Q: [
      [0, 0],
      [0, 1],
    ],
  }
  assert.deepEqual(core.discretize(drift, 2), core.discretize({ ...drift, B: [[], []] }, 2))
  filter.predict([], { F: rail.F, V: rail.V })
})

test('filterpy’s letters are taken where they are named, and explained where they are not', () => {
  const { F, G: B, H, V: Q, W: R } = rail
  const filter = new core.KalmanFilter({ letters: 'filterpy', F, B, H, Q, R }, belief)
  const twin = new core.KalmanFilter(rail, belief)
  for (const it of [filter, twin]) it.step([0.1], [4.2])
  assert.deepEqual(shown(filter), shown(twin))
  refused(() => new core.KalmanFilter({ F, B, H, Q, R }, belief), 'type', 'system.V', /process noise is V.*filterpy/)
  refused(() => new core.KalmanFilter({ F, H, V: Q, R }, belief), 'type', 'system.W', /reading's noise W/)
  const theirs = (change) => () =>
    new core.KalmanFilter({ letters: 'filterpy', ...{ F, B, H, Q, R }, ...change }, belief)
  refused(theirs({ letters: 'thrun' }), 'type', 'system.letters')
  refused(theirs({ R: [[-1]] }), 'not-positive-semidefinite', 'system.R')
  refused(theirs({ Q: [[1]] }), 'shape', 'system.Q')
  refused(theirs({ B: [[1]] }), 'shape', 'system.B')
  refused(theirs({ V: Q }), 'type', 'system.V')
})
