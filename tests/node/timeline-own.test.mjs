// Sensors of a time line that read a function of the caller's own.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const cart = {
  A: [
    [0, 1],
    [0, 0],
  ],
  Q: [
    [0, 0],
    [0, 0.1],
  ],
}
const belief = {
  x: [1, 1],
  P: [
    [1, 0.2],
    [0.2, 0.5],
  ],
}
/** The direction of a cart on its rail, from a mast one metre beside the start. */
const mast = { h: ([x]) => [Math.atan2(-1, -x)], W: [[0.01]], angles: [0], delay: 0.5, gate: 9 }
const wheel = { H: [[0, 1]], W: [[0.04]] }
const line = (sensors) => new core.Timeline(cart, belief, { window: 100, sensors })
const refusal = (act) => {
  try {
    act()
  } catch (error) {
    return error
  }
  return assert.fail('it was accepted')
}

test('a function whose Jacobian is found by differences is the linear sensor, in any order of arrival', () => {
  const readings = [
    ['wheel', 1, 1.1],
    ['own', 2, 2.2],
    ['wheel', 1.5, 0.9],
    ['own', 3, 3.4],
  ]
  const told = (own, order) => {
    const it = line({ own: { W: [[0.5]], ...own }, wheel })
    for (const i of order) {
      const [name, t, y] = readings[i]
      assert.equal(it.reading(name, t, [y]).outcome, 'accepted')
    }
    const answer = it.at(4)
    it.free()
    return [...answer.x, ...answer.P.flat()]
  }
  const linear = told({ H: [[1, 0.5]] }, [0, 1, 2, 3])
  const h = ([x, v]) => [x + 0.5 * v]
  const [first, ...others] = [
    [0, 1, 2, 3],
    [3, 2, 1, 0],
    [1, 3, 0, 2],
  ].map((order) => told({ h }, order))
  for (const other of others) assert.deepEqual(other, first)
  for (const [i, number] of first.entries()) assert.ok(Math.abs(number - linear[i]) < 1e-8)
  assert.deepEqual(told({ h, H: () => [[1, 0.5]] }, [2, 0, 1, 3]), linear)
})

test('an angle is compared the short way round, and its gate holds', () => {
  const it = line({ mast, wheel })
  // Measured at the start, where it stands at −135°: 177° are 48° away, across the half turn.
  const { innovation, outcome } = it.reading('mast', 0.5, [Math.PI - 0.05])
  assert.ok(Math.abs(innovation[0] - (-0.05 - Math.PI / 4)) < 1e-12)
  assert.equal(outcome, 'accepted')
  assert.equal(it.reading('mast', 0.6, [0]).outcome, 'rejected')
  assert.deepEqual([it.statistics().mast.used, it.statistics().mast.refused], [1, 1])
  it.free()
})

test('what a function throws comes through, what it answers is checked, and the time line is as it was', () => {
  let answer = ([x]) => [x]
  const it = line({ own: { h: (x) => answer(x), W: [[0.1]] } })
  it.reading('own', 2, [3])
  const before = [it.at(3), it.statistics(), it.length]
  const mine = new Error('mine')
  const cases = [
    [
      () => {
        throw mine
      },
      (error) => assert.equal(error, mine),
    ],
    [() => [Number.NaN], ({ code, argument }) => assert.deepEqual([code, argument], ['not-finite', 'h(x)[0]'])],
    [() => [1, 2], ({ code, argument }) => assert.deepEqual([code, argument], ['shape', 'h(x)'])],
    [() => undefined, ({ code, argument }) => assert.deepEqual([code, argument], ['type', 'h(x)'])],
    [
      () => [it.reading('own', 9, [9]).chi2],
      ({ code, argument }) => assert.deepEqual([code, argument], ['type', 'this']),
    ],
  ]
  for (const [bad, check] of /** @type {[any, any][]} */ (cases)) {
    answer = bad
    // It is late: what follows is replayed, and h asked again.
    check(refusal(() => it.reading('own', 1, [2])))
    answer = ([x]) => [x]
    assert.deepEqual([it.at(3), it.statistics(), it.length], before)
  }
  it.free()
})

test('what does not belong to an own sensor is named', () => {
  const named = (sensor) => {
    const { code, argument } = refusal(() => line({ own: sensor }))
    return [code, argument]
  }
  const h = ([x]) => [x]
  assert.deepEqual(named({ h: 3, W: [[1]] }), ['type', 'options.sensors.own.h'])
  assert.deepEqual(named({ h, H: [[1, 0]], W: [[1]] }), ['type', 'options.sensors.own.H'])
  assert.deepEqual(named({ h, W: [[1]], angles: [1] }), ['index', 'options.sensors.own.angles[0]'])
  assert.deepEqual(named({ h, W: [[1]], when: 1 }), ['type', 'options.sensors.own.when'])
  assert.deepEqual(named({ H: [[1, 0]], W: [[1]], angles: [0] }), ['type', 'options.sensors.own.angles'])
})
