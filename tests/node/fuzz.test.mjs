// Bounded, seeded nonsense for every export of the module: it answers or throws an EstimateError, in time, and a
// refused call changes nothing. FUZZ_CASES=20000 digs deeper, FUZZ_SEED=7 elsewhere.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { Worker } from 'node:worker_threads'
import { CLASSES } from './class-exports.mjs'
import { FUNCTIONS } from './function-exports.mjs'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const CASES = Number(process.env.FUZZ_CASES ?? 1500)
const SEED = Number(process.env.FUZZ_SEED ?? 1)
/** Far more than any call needs: only a call that hangs is stopped. */
const PATIENCE = 30_000

// `start` is run by the loader itself.
const exported = Object.keys(core).filter(
  (name) => typeof core[name] === 'function' && !name.startsWith('_') && name !== 'start',
)

test('the fuzz knows every export', () => {
  assert.deepEqual(
    exported.filter((name) => !FUNCTIONS[name] && !CLASSES[name]),
    [],
  )
})

for (const name of exported.filter((name) => FUNCTIONS[name] || CLASSES[name])) {
  test(`${name} meets nonsense`, async (t) => {
    const cases = FUNCTIONS[name]?.cases ?? CASES
    const { accepted, refused, tally, faults } = await hammer(name, cases)
    t.diagnostic(`${accepted} answered, ${refused} refused: ${JSON.stringify(tally)}`)
    assert.equal(faults.length, 0, `${faults.length} faults, the first:\n${faults.slice(0, 5).join('\n')}`)
    assert.ok(accepted > 0, 'nothing was answered: the valid arguments of the test are not valid')
    for (const [what, least] of Object.entries(expected(name))) {
      assert.ok(
        (tally[what] ?? 0) >= (least * cases) / 1500,
        `${what} came up ${tally[what] ?? 0} times in ${cases} cases`,
      )
    }
  })
}

/** What must come up of a class, and how often in 1500 cases: its outcomes, and an answer of each of its methods. */
function expected(name) {
  const { methods = {}, least = {} } = CLASSES[name] ?? {}
  return { ...Object.fromEntries(Object.keys(methods).map((method) => [`${method}()`, 20])), ...least }
}

function hammer(name, cases) {
  return new Promise((resolve) => {
    const beat = new SharedArrayBuffer(4)
    const ticks = new Int32Array(beat)
    const worker = new Worker(new URL('./hammer.mjs', import.meta.url), {
      workerData: { name, cases, seed: SEED, beat },
    })
    const faults = []
    let call = 'nothing yet'
    let seen = -1
    const end = (counts) => {
      clearInterval(watch)
      worker.terminate()
      resolve({ faults, accepted: 0, refused: 0, tally: {}, ...counts })
    }
    const watch = setInterval(() => {
      const now = Atomics.load(ticks, 0)
      if (now === seen) {
        faults.push(`never came back: ${call}`)
        end({})
      }
      seen = now
    }, PATIENCE)
    worker.on('message', (message) => {
      if (message.call) call = message.call
      if (message.fault && faults.length < 50) faults.push(message.fault)
      if (message.done) end(message)
    })
    worker.on('error', (/** @type {any} */ error) => {
      faults.push(`the worker died: ${error.stack}\n    in ${call}`)
      end({})
    })
  })
}
