// A time line: several sensors, each reading at the time at which it was measured.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { dice as seeded } from './nonsense.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

const eye = [
  [1, 0],
  [0, 1],
]
/** Position and speed; the acceleration is the input. */
const cart = {
  A: [
    [0, 1],
    [0, -0.1],
  ],
  B: [[0], [1]],
  Q: [
    [0.01, 0],
    [0, 0.2],
  ],
}
const belief = { x: [0, 1], P: eye }
const sensors = {
  fix: { H: [[1, 0]], W: [[0.04]], delay: 0.5 },
  wheel: { H: [[0, 1]], W: [[0.25]], gate: 4 },
  both: { H: eye, W: eye, gate: null },
}
const line = (options) => new core.Timeline(cart, belief, { time: 10, window: 100, sensors, ...options })

/** Events on quarters of a second, so that many have the same time; no two are the same. */
function events(dice, count) {
  const all = new Map()
  while (all.size < count) {
    const at = 10.5 + 0.25 * dice.below(count)
    const name = dice.pick(['u', ...Object.keys(sensors)])
    const id = name === 'u' ? 0 : dice.below(2)
    const part = () => (dice.uniform() < 0.3 ? null : 2 * dice.normal())
    const y = name === 'both' ? [2 * dice.normal(), part()] : [2 * dice.normal()]
    all.set([at, name, id].join(), { at, name, id, y })
  }
  return [...all.values()]
}
const tell = (it, { at, name, id, y }) =>
  name === 'u' ? it.input(at, y) : it.reading(name, at + (sensors[name].delay ?? 0), y, id)

test('whatever order readings come in, the belief has the same bits', () => {
  const dice = seeded(3)
  for (let round = 0; round < 20; round++) {
    const drawn = events(dice, 30)
    const orders = [drawn, drawn.toSorted((a, b) => a.at - b.at), drawn.toSorted((a, b) => b.at - a.at)]
    const answers = orders.map((order) => {
      const it = line({})
      for (const event of order) assert.match(tell(it, event).outcome, /^(accepted|rejected)$/)
      assert.equal(it.length, 30)
      const beliefs = [10, 11.3, it.newest, it.newest + 2].map((t) => it.at(t))
      it.free()
      return beliefs
    })
    assert.deepEqual(answers[1], answers[0])
    assert.deepEqual(answers[2], answers[0])
  }
})

test('a reading is compared with what was expected at its time', () => {
  const it = line({})
  // Stamped 10.5 and measured at 10: before the cart has moved.
  const { outcome, innovation, S, chi2 } = it.reading('fix', 10.5, [0.2])
  assert.deepEqual([outcome, innovation, S], ['accepted', [0.2], [[1.04]]])
  assert.ok(Math.abs(chi2 - 0.04 / 1.04) < 1e-15)
  const far = it.reading('wheel', 10, Float64Array.of(50))
  assert.equal(far.outcome, 'rejected')
  assert.ok(far.chi2 > 4)
  assert.equal(it.reading('both', 10, [null, 1]).S.length, 1)
  it.free()
})

test('what finds no place says why, and changes nothing', () => {
  const it = line({ window: 1, capacity: 2 })
  const aside = (outcome, ...reading) => {
    const before = [it.at(11), it.length, it.newest]
    assert.deepEqual(it.reading(...reading), { outcome, innovation: null, S: null, chi2: null })
    assert.deepEqual([it.at(11), it.length, it.newest], before)
  }
  aside('too-late', 'wheel', 9.99, [1])
  aside('too-late', 'fix', 10.49, [1])
  aside('ahead', 'wheel', 1e9, [1])
  assert.deepEqual(it.input(10, [0.5]), { outcome: 'accepted' })
  assert.deepEqual(it.input(10, [0.7]), { outcome: 'duplicate' })
  assert.equal(it.reading('wheel', 10.5, [1], 7).outcome, 'accepted')
  aside('duplicate', 'wheel', 10.5, [2], 7)
  aside('full', 'wheel', 10.5, [1])
  assert.deepEqual(it.input(10.2, [0.7]), { outcome: 'full' })
  // What is older than the window makes room.
  assert.equal(it.reading('wheel', 11.4, [1]).outcome, 'accepted')
  aside('too-late', 'wheel', 10.3, [1])
  it.free()
})

test('a hundred thousand readings at one time are answered, and the belief of 10⁹ s later is a finite one', () => {
  const it = line({ capacity: 10_000 })
  const told = { accepted: 0, full: 0 }
  for (let id = 0; id < 1e5; id++) told[it.reading('wheel', 11, [1], id).outcome] += 1
  assert.deepEqual([told, it.length], [{ accepted: 10_000, full: 90_000 }, 10_000])
  const finite = ({ x, P }) => [...x, ...P.flat()].every(Number.isFinite)
  assert.ok(finite(it.at(1e9)))
  it.free()
  const empty = new core.Timeline(cart, belief, { window: 1, sensors })
  assert.ok(finite(empty.at(0)) && finite(empty.at(1e9)))
  empty.free()
})

test('a refusal names what is to blame, and leaves the line as it was', () => {
  const refused = (call, code, argument) =>
    assert.throws(call, (/** @type {any} */ error) => {
      assert.deepEqual([error.name, error.code, error.argument], ['EstimateError', code, argument])
      return true
    })
  const it = line({})
  it.reading('wheel', 11, [1])
  const before = [it.at(12), it.length]
  refused(() => it.reading('compass', 11, [1]), 'index', 'name')
  refused(() => it.reading(1, 11, [1]), 'type', 'name')
  refused(() => it.reading('x'.repeat(61), 11, [1]), 'limit', 'name')
  refused(() => it.reading('wheel', NaN, [1]), 'not-finite', 't')
  refused(() => it.reading('wheel', 11, [1, 2]), 'shape', 'y')
  refused(() => it.reading('wheel', 11, [null]), 'shape', 'y')
  refused(() => it.reading('wheel', 11, [Infinity]), 'not-finite', 'y')
  refused(() => it.reading('wheel', 11, [1], 0.5), 'type', 'id')
  refused(() => it.input(11, []), 'shape', 'u')
  refused(() => it.input('11', [1]), 'type', 't')
  refused(() => it.at(9), 'limit', 't')
  refused(() => it.at(), 'type', 't')
  assert.deepEqual([it.at(12), it.length], before)
  it.free()
  const bent = (sensor) => line({ sensors: { ...sensors, wheel: { ...sensors.wheel, ...sensor } } })
  refused(() => bent({ delay: 11 }), 'limit', 'options.sensors.wheel.delay')
  refused(() => bent({ delay: '1' }), 'type', 'options.sensors.wheel.delay')
  refused(() => bent({ gate: -1 }), 'limit', 'options.sensors.wheel.gate')
  refused(() => bent({ H: [[1]] }), 'shape', 'options.sensors.wheel.H')
  refused(() => bent({ lag: 1 }), 'type', 'options.sensors.wheel.lag')
  refused(() => line({ sensors: { wheel: 7 } }), 'type', 'options.sensors.wheel')
  refused(() => line({ sensors: {} }), 'shape', 'options.sensors')
  refused(() => line({ sensors: [] }), 'type', 'options.sensors')
  refused(() => line({ window: 0 }), 'limit', 'options.window')
  refused(() => line({ window: undefined }), 'type', 'options.window')
  refused(() => line({ capacity: 1e6 }), 'limit', 'options.capacity')
  refused(() => line({ now: 1 }), 'type', 'options.now')
})

test('statistics are of each sensor, whatever the order and however short the window', () => {
  const dice = seeded(5)
  const drawn = events(dice, 60).toSorted((a, b) => a.at - b.at)
  const [long, short, mixed] = [line({}), line({ window: 2 }), line({})]
  const counts = { fix: [0, 0], wheel: [0, 0], both: [0, 0] }
  for (const event of drawn) {
    tell(short, event)
    const { outcome } = tell(long, event)
    if (event.name !== 'u') counts[event.name][outcome === 'accepted' ? 0 : 1] += 1
  }
  for (const event of drawn.toReversed()) tell(mixed, event)
  const found = long.statistics()
  assert.deepEqual(short.statistics(), found)
  assert.deepEqual(mixed.statistics(), found)
  assert.deepEqual(Object.keys(found), Object.keys(sensors))
  for (const [name, { used, refused, nis, meanInnovation }] of Object.entries(found)) {
    assert.deepEqual([used, refused], counts[name])
    assert.ok(used > 3 && nis > 0 && meanInnovation.length === sensors[name].H.length)
  }
  const prototype = JSON.parse('{"__proto__":{"H":[[1,0]],"W":[[1]]}}')
  const odd = new core.Timeline(cart, belief, { window: 1, sensors: prototype })
  const [name, { used, nis, meanInnovation }] = Object.entries(odd.statistics())[0]
  assert.deepEqual([name, used, nis, meanInnovation], ['__proto__', 0, null, [null]])
})
