// A module that met a fault of its own says so by name at once and at every further call, and can be loaded again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { belief, rail } from './rail.mjs'

const require = createRequire(import.meta.url)
const FACE = '../../target/pkg/node/estimate_wasm.js'

/** The module, loaded anew, and the memory of this load. */
function loaded() {
  const { Instance } = WebAssembly
  let memory = /** @type {any} */ (undefined)
  WebAssembly.Instance = class extends Instance {
    /** @param {WebAssembly.Module} module @param {WebAssembly.Imports} [imports] */
    constructor(module, imports) {
      super(module, imports)
      memory = this.exports.memory
    }
  }
  delete require.cache[require.resolve(FACE)]
  const core = require(FACE)
  WebAssembly.Instance = Instance
  return { core, memory }
}

test('a module that met a fault of its own says so by name at every call, frees in peace, and is loaded again', () => {
  const { core, memory } = loaded()
  const bench = new core.ObserverBench()
  const filter = new core.KalmanFilter(rail, belief)
  const expected = core.kalmanStep(rail, belief, [0], [2.7])
  // No input leads to a fault that we know of: the allocator's own lists are broken here.
  new Uint8Array(memory.buffer).fill(0xff)
  const named = {
    name: 'RuntimeError',
    message: /^the module met a fault of its own in \w+ \(.+\) and must be loaded again$/,
  }
  assert.throws(() => core.kalmanStep(rail, belief, [0], [2.7]), named)
  const calls = [
    () => core.kalmanStep(rail, belief, [0], [2.7]),
    () => core.chapterCheck(1),
    () => new core.ObserverBench(),
    () => bench.frame(),
    () => bench.digest(),
    () => filter.x,
    () => core.ObserverBench.lastStep(),
    // Refused even before it is decoded: its refusal would take memory too.
    () => filter.predict('nonsense'),
  ]
  for (let i = 0; i < 1000; i++) for (const call of calls) assert.throws(call, named)
  assert.throws(calls[1], ({ message, cause }) => message.includes('in kalmanStep') && cause.message === message)
  bench.free()
  filter.free()
  const { core: again } = loaded()
  assert.deepEqual(again.kalmanStep(rail, belief, [0], [2.7]), expected)
})

test('a refusal is no fault: what an argument throws itself comes back as it did, and the module goes on', () => {
  const { core } = loaded()
  const bench = new core.ObserverBench()
  const thrown = new WebAssembly.RuntimeError('mine')
  const getter = {
    get gain() {
      throw thrown
    },
  }
  assert.throws(() => bench.set(getter), { name: 'EstimateError', code: 'type' })
  bench.step()
  assert.equal(bench.state().step, 1)
})
