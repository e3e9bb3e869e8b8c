// The class KalmanFilter is kalmanStep with the belief kept inside, to the last bit, and reads its arguments as
// strictly.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { runInNewContext } from 'node:vm'
import { belief, rail, refused } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

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
const three = {
  F: [
    [1, 0.5, 0.1],
    [0, 1, 0.5],
    [0, 0, 0.9],
  ],
  G: [
    [0, 0.1],
    [0.5, 0],
    [0, 1],
  ],
  H: [[1, 0, 0]],
  V: [
    [0.1, 0, 0],
    [0, 0.1, 0],
    [0, 0, 0.1],
  ],
  W: [[0.3]],
}
const wide = {
  x: [1, 2, 3],
  P: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
}

test('its steps are those of kalmanStep, and its likelihood that of kalmanReplay', () => {
  for (const [system, start] of [
    [rail, belief],
    [both, belief],
    [three, wide],
  ]) {
    const [m, p, steps] = [system.G[0].length, system.H.length, 30]
    const inputs = Float64Array.from({ length: steps * m }, (_, k) => Math.sin(k))
    const readings = Float64Array.from({ length: steps * p }, (_, k) => 2 + Math.cos(0.3 * k))
    const [whole, halves] = [new core.KalmanFilter(system, start), new core.KalmanFilter(system, start)]
    assert.deepEqual([whole.x, whole.P, whole.logLikelihood, whole.nis], [start.x, start.P, 0, null])
    let state = start
    for (let k = 0; k < steps; k++) {
      const [u, y] = [inputs.slice(k * m, (k + 1) * m), readings.slice(k * p, (k + 1) * p)]
      state = core.kalmanStep(system, state, [...u], [...y])
      whole.step(u, y)
      halves.predict([...u])
      assert.deepEqual([halves.x, halves.P], [state.predicted.x, state.predicted.P])
      halves.update([...y])
      assert.deepEqual([whole.x, whole.P], [state.x, state.P])
      assert.deepEqual([halves.x, halves.P, halves.nis], [whole.x, whole.P, whole.nis])
      if (p === 1) assert.ok(Math.abs(whole.nis - state.innovation[0] ** 2 / state.S[0][0]) < 1e-13)
    }
    assert.equal(whole.logLikelihood, core.kalmanReplay(system, start, inputs, readings).logLikelihood)
    whole.free()
    halves.free()
  }
})

test('a system without inputs is predicted without one', () => {
  const free = { ...rail, G: [[], []] }
  const [left, given] = [new core.KalmanFilter(free, belief), new core.KalmanFilter(free, belief)]
  left.predict()
  given.predict([])
  assert.deepEqual([left.x, left.P], [given.x, given.P])
  assert.deepEqual(left.x, [4, 4])
  refused(() => new core.KalmanFilter(rail, belief).predict(), 'shape', 'u')
})

test('a number, a text, a hole or a wrong length is refused by name, and the filter is as it was', () => {
  const filter = new core.KalmanFilter(rail, belief)
  filter.step([0.1], [3])
  const shown = () => [filter.x, filter.P, filter.logLikelihood, filter.nis]
  const before = shown()
  const throwing = new Proxy([], {
    get() {
      throw new Error('no')
    },
  })
  for (const [call, code, argument] of /** @type {[() => unknown, string, string][]} */ ([
    [() => filter.predict(0.1), 'type', 'u'],
    [() => filter.predict(null), 'type', 'u'],
    [() => filter.predict('0.1'), 'type', 'u'],
    [() => filter.predict([1, 2]), 'shape', 'u'],
    [() => filter.predict(['1']), 'type', 'u[0]'],
    [() => filter.update(new Array(1)), 'type', 'y[0]'],
    [() => filter.update(Float32Array.of(1)), 'type', 'y'],
    [() => filter.update(Float64Array.of(NaN)), 'not-finite', 'y'],
    [() => filter.update([Infinity]), 'not-finite', 'y'],
    [() => filter.update(new Float64Array(17)), 'limit', 'y'],
    [() => filter.update(new Float64Array(16)), 'shape', 'y'],
    [() => filter.step(throwing, [1]), 'type', 'u'],
    [() => filter.step([0]), 'type', 'y'],
  ])) {
    refused(call, code, argument)
    assert.deepEqual(shown(), before)
  }
  refused(() => new core.KalmanFilter({ ...rail, W: [[-1]] }, belief), 'not-positive-semidefinite', 'system.W')
  refused(() => new core.KalmanFilter(rail, { x: [1], P: [[1]] }), 'shape', 'belief')
})

test('a step whose correction is refused after its prediction leaves the filter as it was before both', () => {
  const filter = new core.KalmanFilter({ ...rail, H: [[0, 1]] }, belief)
  refused(() => filter.step([1e308], [-1.7e308]), 'not-finite', 'y')
  assert.deepEqual([filter.x, filter.P, filter.nis], [belief.x, belief.P, null])
})

test('a getter that calls back into the filter finds it whole, and a typed array of another realm is read', () => {
  const filter = new core.KalmanFilter(rail, belief)
  const u = new Proxy([0.1], {
    get: (of, key) => {
      if (key === '0') filter.update([3])
      return of[key]
    },
  })
  filter.predict(u)
  const twin = new core.KalmanFilter(rail, belief)
  twin.update(runInNewContext('Float64Array.of(3)'))
  twin.predict([0.1])
  assert.deepEqual([filter.x, filter.P], [twin.x, twin.P])
})

test('a part of a reading that is null was not read', () => {
  const first = { ...both, H: [both.H[0]], W: [[both.W[0][0]]] }
  const second = { ...both, H: [both.H[1]], W: [[both.W[1][1]]] }
  for (const [narrow, y, whole] of [
    [first, [2.5], [2.5, null]],
    [second, [3], [null, 3]],
  ]) {
    const [alone, partly] = [new core.KalmanFilter(narrow, belief), new core.KalmanFilter(both, belief)]
    alone.step([0.1], y)
    partly.step([0.1], whole)
    assert.deepEqual([partly.x, partly.P], [alone.x, alone.P])
    assert.deepEqual([partly.nis, partly.logLikelihood], [alone.nis, alone.logLikelihood])
    const { x, P, logLikelihood } = partly
    partly.update([null, null])
    assert.deepEqual([partly.x, partly.P, partly.nis, partly.logLikelihood], [x, P, null, logLikelihood])
    refused(() => partly.update([null]), 'shape', 'y')
    refused(() => partly.update(null), 'type', 'y')
    refused(() => partly.update([undefined, 1]), 'type', 'y[0]')
    refused(() => partly.update([null, NaN]), 'not-finite', 'y')
    refused(() => partly.predict([null]), 'type', 'u[0]')
    alone.free()
    partly.free()
  }
})
