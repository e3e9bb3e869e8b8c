// Values that answer otherwise than they look: refused by name, never coerced, and the module goes on working.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import { fileURLToPath } from 'node:url'
import { belief, rail, refused } from './rail.mjs'

const file = fileURLToPath(new URL('../../target/pkg/node/estimate_wasm.js', import.meta.url))
const core = createRequire(import.meta.url)(file)

test('an array is as long as a whole number says', () => {
  const long = (length) =>
    new Proxy(
      [
        [1, 0],
        [0, 1],
      ],
      { get: (rows, key) => (key === 'length' ? length : rows[key]) },
    )
  for (const length of [2.5, -1, Infinity, NaN, '2', undefined]) {
    refused(() => core.covarianceEllipse(long(length)), 'type', 'P', /no whole number/)
  }
  assert.equal(core.covarianceEllipse(long(2)).semiMajor, 1)
})

test('a typed array is what its class says, and as long', () => {
  const one = Float64Array.of(0)
  const replay = (readings) => core.kalmanReplay(rail, belief, one, readings)
  class Boastful extends Float64Array {
    get length() {
      return 1e9
    }
  }
  assert.deepEqual(replay(new Boastful([2.7])), replay(Float64Array.of(2.7)))
  const view = Object.setPrototypeOf(new DataView(new ArrayBuffer(8)), Float64Array.prototype)
  view[Symbol.iterator] = function* () {
    yield '2.7'
  }
  const bytes = Object.setPrototypeOf(new Uint8Array(1), Float64Array.prototype)
  for (const other of [view, bytes, new Float32Array(1), new Proxy(one, {}), null, undefined, '2.7']) {
    refused(() => replay(other), 'type', 'readings', /Float64Array/)
  }
  // An array is one of rows, as of a log with gaps.
  refused(() => replay([2.7]), 'type', 'readings[0]', /Float64Array/)
})

test('a row, and a vector, may be a Float64Array: the same bits', () => {
  const floats = (matrix) => matrix.map((row) => Float64Array.from(row))
  const typed = Object.fromEntries(Object.entries(rail).map(([letter, matrix]) => [letter, floats(matrix)]))
  const start = { x: Float64Array.from(belief.x), P: floats(belief.P) }
  const step = core.kalmanStep(rail, belief, [0], [2.7])
  assert.deepEqual(core.kalmanStep(typed, start, Float64Array.of(0), Float64Array.of(2.7)), step)
  const mixed = { ...rail, F: [rail.F[0], Float64Array.from(rail.F[1])], V: [Float64Array.from(rail.V[0]), rail.V[1]] }
  assert.deepEqual(core.kalmanStep(mixed, belief, [0], [2.7]), step)
  const filter = new core.KalmanFilter(typed, start)
  filter.step([0], [2.7])
  assert.deepEqual([filter.x, filter.P], [step.x, step.P])
  const [A, Q] = [
    [
      [0, 1],
      [0, 0],
    ],
    [
      [0, 0],
      [0, 1],
    ],
  ]
  assert.deepEqual(core.discretize({ A: floats(A), Q: floats(Q) }, 0.5), core.discretize({ A, Q }, 0.5))
  const own = (F) => {
    const ekf = new core.ExtendedKalmanFilter(belief)
    ekf.predict((x) => x, rail.V, F)
    return ekf.P
  }
  assert.deepEqual(
    own(() => floats(rail.F)),
    own(() => rail.F),
  )
  // What is nearly one is named as any other row.
  const P = (row) => core.covarianceEllipse([[4, 0], row])
  for (const row of [new Float32Array(2), new Proxy(Float64Array.of(0, 1), {}), { 0: 0, 1: 1, length: 2 }, null])
    refused(() => P(row), 'type', 'P[1]', /an array of numbers or a Float64Array/)
  refused(() => P(Float64Array.of(0)), 'shape', 'P', /ragged/)
  refused(() => P(Float64Array.of(0, NaN)), 'not-finite', 'P')
  refused(() => core.covarianceEllipse([new Float64Array(17)]), 'limit', 'P[0]', /at most 16/)
  refused(() => core.covarianceEllipse(Float64Array.of(4, 0)), 'type', 'P', /an array/)
  refused(() => core.kalmanStep(rail, { ...belief, x: new Float64Array(17) }, [0], [1]), 'limit', 'belief.x')
})

test('a getter may call the module, or throw', () => {
  const P = {
    get x() {
      return core.kalmanStep(rail, belief, [0], [2.7]).x
    },
    P: [
      [1, 0],
      [0, 2],
    ],
  }
  assert.deepEqual(core.kalmanStep(rail, P, [0], [2.7]), core.kalmanStep(rail, { ...P }, [0], [2.7]))
  refused(
    () =>
      core.kalmanStep(
        rail,
        {
          get x() {
            throw new Error('no')
          },
          P: [[1]],
        },
        [0],
        [2.7],
      ),
    'type',
    'belief.x',
    /threw/,
  )
})

test('a field is read once, whatever it answers', () => {
  for (const answer of [null, undefined, 3]) {
    const reads = []
    const noting = new Proxy({ gate: answer, W: rail.W }, { get: (of, key) => (reads.push(key), of[key]) })
    try {
      new core.EkfLocalizer(
        {
          x: [0, 0, 0],
          P: [
            [1, 0, 0],
            [0, 1, 0],
            [0, 0, 1],
          ],
        },
        [],
        noting,
      )
    } catch {}
    assert.deepEqual(
      reads.filter((key) => key === 'gate'),
      ['gate'],
      `a gate of ${answer}`,
    )
    let asked = 0
    const lab = new core.ObservabilityProbe({
      get stop() {
        asked++
        return answer
      },
    })
    assert.equal(asked, 1, `a getter that answers ${answer}`)
    assert.equal(lab.state().params.stop, answer ?? null)
    lab.free()
  }
  // A field that holds null is told from one that is not there.
  refused(() => core.covarianceEllipse(null), 'type', 'P', /is null/)
  refused(() => core.kalmanStep(rail, { x: null, P: [[1]] }, [0], [2.7]), 'type', 'belief.x', /is null/)
  refused(() => core.kalmanStep(rail, { P: [[1]] }, [0], [2.7]), 'type', 'belief.x', /is undefined/)
})

test('a getter within an array may make the memory of the module grow', () => {
  const still = {
    x: [0, 0, 0],
    P: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
  }
  const ekf = new core.EkfLocalizer(still, [{ id: 0, x: 1, y: 0 }], { W: [[1]], sensor: 'range' })
  // 32 MB are copied in before they are found not to fit.
  const grow = () => refused(() => ekf.replay(new Float64Array(4_000_000), new Uint32Array(1), still.P), 'shape', 'log')
  const row = Object.defineProperty([0, 1], 0, { get: () => (grow(), 0) })
  assert.deepEqual(
    core.covarianceEllipse([[4, 0], row]),
    core.covarianceEllipse([
      [4, 0],
      [0, 1],
    ]),
  )
})

test('of a matrix, every entry is a number of its own: nothing is coerced and nothing is skipped', () => {
  const hole = [0, 1]
  delete hole[0]
  for (const [entry, code] of [
    ['0', 'type'],
    [null, 'type'],
    [undefined, 'type'],
    [[0], 'type'],
    [{ valueOf: () => 0 }, 'type'],
    [0n, 'type'],
    [NaN, 'not-finite'],
    [Infinity, 'not-finite'],
  ]) {
    refused(
      () =>
        core.covarianceEllipse([
          [4, 0],
          [entry, 1],
        ]),
      String(code),
      code === 'type' ? 'P[1][0]' : 'P',
    )
  }
  refused(() => core.covarianceEllipse([[4, 0], hole]), 'type', 'P[1][0]')
  refused(() => core.covarianceEllipse([4, 0]), 'type', 'P[0]', /an array/)
  refused(() => core.covarianceEllipse([[4, 0], 0]), 'type', 'P[1]', /an array/)
  refused(() => core.covarianceEllipse([[4, 0], [0]]), 'shape', 'P', /ragged/)
  refused(() => core.euclideanFoot([[1, 0]], [[1, 2]], [3]), 'type', 'x[0]', /a number/)
})

test('a first call that ends without stack leaves a module that works', () => {
  const program = `
    const core = require(process.argv[1])
    const call = () => core.covarianceEllipse([[4, 0], [0, 1]])
    const down = () => { try { down() } catch (error) { try { call() } catch {} throw error } }
    try { down() } catch {}
    process.stdout.write(String(call().semiMajor))`
  for (let size = 300; size < 320; size += 2) {
    assert.equal(
      execFileSync(process.execPath, [`--stack-size=${size}`, '-e', program, file], { encoding: 'utf8' }),
      '2',
      `${size} kB`,
    )
  }
})

test('an object whose call the stack’s end cut short may be lost; its state, others and functions are not', () => {
  const program = `
    const core = require(process.argv[1])
    const lost = []
    for (let round = 0; round < 20; round++) {
      const bench = new core.ObserverBench({ gain: 0.7 })
      bench.run(50)
      const [state, digest] = [bench.state(), bench.digest()]
      let over = false
      // On the way up there is ever more stack: the call ends without any at several depths, and then it does not.
      const down = () => {
        try { down() } catch (error) {
          if (!over) try { bench.step(); over = true } catch (refusal) { over = refusal.name === 'EstimateError' }
          throw error
        }
      }
      try { down() } catch {}
      let answer = 'works'
      try { bench.frame() } catch ({ code, argument, message }) { answer = code + ' ' + argument + ' ' + message }
      lost.push(answer)
      const twin = core.ObserverBench.from(state)
      const { semiMajor } = core.covarianceEllipse([[4, 0], [0, 1]])
      if (twin.digest() !== digest || semiMajor !== 2) throw new Error('the module is lost')
      twin.free()
    }
    process.stdout.write(JSON.stringify(lost))`
  const answers = [300, 984].flatMap((size) =>
    JSON.parse(execFileSync(process.execPath, [`--stack-size=${size}`, '-e', program, file], { encoding: 'utf8' })),
  )
  const stuck = answers.filter((answer) => answer !== 'works')
  for (const answer of stuck) assert.match(answer, /^type this .*in the middle of a call/)
  assert.ok(stuck.length > 0, 'it is not lost any more: the note on RangeError in the types can go')
})
