// The filters of one's own models ask the caller's functions, check what these answer, and stay as they were when they
// are refused.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const belief = {
  x: [2, 4],
  P: [
    [1, 0.2],
    [0.2, 2],
  ],
}
const F = [
  [1, 0.5],
  [0, 0.9],
]
const H = [
  [1, 0],
  [0.3, 1],
]
const V = [
  [0.2, 0.05],
  [0.05, 0.1],
]
const W = [
  [0.5, 0.1],
  [0.1, 0.4],
]
const times = (matrix) => (x) => matrix.map((row) => row[0] * x[0] + row[1] * x[1])
const READ = [[2.7, 4.1], [null, 4], [6.3, null], new Float64Array([8.4, 7])]
const make = {
  ExtendedKalmanFilter: (options) => new core.ExtendedKalmanFilter(belief, options),
  UnscentedKalmanFilter: (options) => new core.UnscentedKalmanFilter(belief, options),
}

function refused(call, code, argument) {
  assert.throws(call, (/** @type {any} */ error) => {
    assert.deepEqual([error.name, error.code, error.argument], ['EstimateError', code, argument], error.message)
    return true
  })
}

test('with linear models the extended filter is KalmanFilter, to the last bit', () => {
  const kf = new core.KalmanFilter({ F, G: [[], []], H, V, W }, belief)
  const ekf = new core.ExtendedKalmanFilter(belief)
  for (const y of READ) {
    kf.step([], y)
    ekf.predict(times(F), V, () => F)
    const update = ekf.update(y, times(H), W, { H: () => H, gate: null })
    assert.deepEqual([ekf.x, ekf.P], [kf.x, kf.P])
    assert.deepEqual([update.outcome, update.chi2], ['accepted', kf.nis])
    assert.equal(update.S.length, update.innovation.length)
  }
  assert.equal(ekf.conditioned, true)
})

test('without Jacobians both filters are near it', () => {
  const kf = new core.KalmanFilter({ F, G: [[], []], H, V, W }, belief)
  const both = [make.ExtendedKalmanFilter(), make.UnscentedKalmanFilter({ alpha: 1, beta: 0, kappa: 1 })]
  for (const y of READ) {
    kf.step([], y)
    for (const filter of both) {
      filter.predict(times(F), V)
      filter.update(y, times(H), W)
      for (const i of [0, 1]) assert.ok(Math.abs(filter.x[i] - kf.x[i]) < 1e-9)
    }
  }
})

for (const [name, of] of Object.entries(make)) {
  test(`${name}: angles go the short way round, in the state and in a reading`, () => {
    const compass = new core[name]({ x: [3.1], P: [[0.04]] }, { angles: [0] })
    const { innovation } = compass.update([-3.1], (x) => x, [[0.04]], { angles: [0] })
    assert.ok(Math.abs(innovation[0] - (2 * Math.PI - 6.2)) < 1e-6)
    compass.predict(([theta]) => [theta + 1], [[0.01]])
    assert.ok(compass.x[0] < 0 && compass.x[0] > -Math.PI)
  })

  test(`${name}: beyond the gate nothing is changed`, () => {
    const filter = of()
    const before = [filter.x, filter.P]
    assert.equal(filter.update([90], ([p]) => [p], [[1]], { gate: 9 }).outcome, 'rejected')
    assert.deepEqual([filter.x, filter.P], before)
  })

  test(`${name}: what a function throws comes through, what it answers is checked, and the filter stays`, () => {
    const filter = of()
    const before = [filter.x, filter.P]
    const own = new RangeError('of the caller')
    const throwing = () => {
      throw own
    }
    assert.throws(() => filter.predict(throwing, V), own)
    assert.throws(() => filter.update([1], throwing, [[1]]), own)
    for (const [answer, code, argument] of [
      [[1, Number.NaN], 'not-finite', '(x)[1]'],
      [[1, 'a'], 'type', '(x)[1]'],
      [[1], 'shape', '(x)'],
      [undefined, 'type', '(x)'],
      [null, 'type', '(x)'],
      ['text', 'type', '(x)'],
    ]) {
      refused(() => filter.predict(() => answer, V), code, `f${argument}`)
      refused(() => filter.update([1, 2], () => answer, W), code, `h${argument}`)
    }
    refused(() => filter.predict('f', V), 'type', 'f')
    refused(() => filter.predict(times(F), [[1]]), 'shape', 'V')
    refused(() => filter.update([1], (x) => x, [[1]]), 'shape', 'h(x)')
    refused(() => filter.update([null], ([p]) => [p], [[1]]), 'shape', 'y')
    refused(() => filter.update([1], ([p]) => [p], [[1]], { gate: -1 }), 'limit', 'options.gate')
    refused(() => filter.update([1], ([p]) => [p], [[1]], { angles: [1] }), 'index', 'options.angles[0]')
    refused(() => filter.update([1], ([p]) => [p], [[1]], { angels: [] }), 'type', 'options.angels')
    refused(() => new core[name](belief, { angles: [2] }), 'index', 'options.angles[0]')
    assert.deepEqual([filter.x, filter.P], before)
  })

  test(`${name}: a call from inside a function is refused, also one that reads`, () => {
    const filter = of()
    refused(() => filter.predict((x) => filter.x && x, V), 'type', 'this')
    refused(() => filter.update([1], (x) => filter.predict(times(F), V) ?? [x[0]], [[1]]), 'type', 'this')
    filter.predict(times(F), V)
    assert.notDeepEqual(filter.x, belief.x)
  })
}

test('a Jacobian of a wrong size is named', () => {
  const ekf = make.ExtendedKalmanFilter()
  refused(() => ekf.predict(times(F), V, () => [[1]]), 'shape', 'F(x)')
  refused(() => ekf.predict(times(F), V, []), 'type', 'F')
  refused(() => ekf.update([1], ([p]) => [p], [[1]], { H: () => [[1]] }), 'shape', 'H(x)')
  refused(() => ekf.update([1], ([p]) => [p], [[1]], { H: 1 }), 'type', 'options.H')
})

test('sigma points that cannot be placed, and a covariance without a root, are refused', () => {
  refused(() => make.UnscentedKalmanFilter({ alpha: 0 }), 'limit', 'options')
  refused(() => make.UnscentedKalmanFilter({ kappa: -2 }), 'limit', 'options')
  const flat = new core.UnscentedKalmanFilter({ x: [0], P: [[0]] })
  refused(() => flat.predict((x) => x, [[1]]), 'limit', 'P')
})
