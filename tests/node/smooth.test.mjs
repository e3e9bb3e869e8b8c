// The best track afterwards: a filter forward, a smoother back.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { belief, rail, refused } from './rail.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const us = Array.from({ length: 12 }, (_, k) => [Math.sin(k)])
/** @type {((number | string | null)[] | null)[]} */
const ys = us.map((_, k) => ((k > 3 && k < 9) || k === 11 ? null : [2 + 0.3 * k]))

test('a gap is closed from both ends, and after the last reading the track is the filter’s', () => {
  const track = core.kalmanSmooth(rail, belief, us, ys)
  const filter = new core.KalmanFilter(rail, belief)
  for (const [k, { x, P }] of track.entries()) {
    filter.step(us[k], ys[k] ?? [null])
    if (k >= 10) assert.deepEqual([x, P], [filter.x, filter.P])
    else for (const i of [0, 1]) assert.ok(P[i][i] < filter.P[i][i], `row ${k}`)
    assert.equal(P[0][1], P[1][0])
  }
  filter.free()
  // In the middle of the gap less is known than at its ends.
  assert.ok(track[6].P[0][0] > track[3].P[0][0] && track[6].P[0][0] > track[9].P[0][0])
})

test('a point pushed about is smoothed as by hand', () => {
  const point = { F: [[1]], G: [[]], H: [[1]], V: [[1]], W: [[1]] }
  const track = core.kalmanSmooth(point, { x: [0], P: [[0]] }, [], [[0], null, [4]])
  for (const [k, x] of [4 / 7, 12 / 7, 20 / 7].entries()) assert.ok(Math.abs(track[k].x[0] - x) < 1e-14, `row ${k}`)
})

test('a refusal names the row', () => {
  refused(() => core.kalmanSmooth(rail, belief, [], []), 'limit', 'ys')
  refused(() => core.kalmanSmooth(rail, belief, us.slice(1), ys), 'shape', 'us')
  refused(() => core.kalmanSmooth(rail, belief, us.with(2, [1, 2]), ys), 'shape', 'us[2]')
  refused(() => core.kalmanSmooth(rail, belief, us.with(2, /** @type {any} */ (null)), ys), 'type', 'us[2]')
  refused(() => core.kalmanSmooth(rail, belief, us, ys.with(1, [NaN])), 'not-finite', 'ys[1]')
  refused(() => core.kalmanSmooth(rail, belief, us, ys.with(1, ['2'])), 'type', 'ys[1][0]')
  refused(() => core.kalmanSmooth(rail, belief, us, ys.with(1, [null, null])), 'shape', 'ys[1]')
  const still = { F: [[1]], G: [[]], H: [[1]], V: [[0]], W: [[1]] }
  const known = { x: [0], P: [[0]] }
  refused(() => core.kalmanSmooth(still, known, [], [[1], [1]]), 'innovation-not-positive-definite', 'V')
})
