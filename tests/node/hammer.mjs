// The worker of the fuzz test: calls one export again and again with nonsense, and says before each call what it does,
// so that the watchdog outside can name a call that never comes back.
import { createRequire } from 'node:module'
import { isDeepStrictEqual } from 'node:util'
import { parentPort, workerData } from 'node:worker_threads'
import { CLASSES } from './class-exports.mjs'
import { FUNCTIONS } from './function-exports.mjs'
import { dice as seeded, matrices, notCovariance, spoil } from './nonsense.mjs'

const { name, cases, seed, beat } = workerData
const ticks = new Int32Array(beat)
const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const CODES = new Set([
  'not-finite',
  'shape',
  'not-symmetric',
  'not-positive-semidefinite',
  'innovation-not-positive-definite',
  'unobservable',
  'poles',
  'tolerance',
  'index',
  'at-landmark',
  'not-placeable',
  'limit',
  'type',
  'did-not-converge',
  'log',
])

const say = (value) => {
  try {
    return JSON.stringify(value, (_, inner) =>
      typeof inner === 'number' && !Number.isFinite(inner)
        ? String(inner)
        : typeof inner === 'bigint' || typeof inner === 'symbol' || typeof inner === 'function'
          ? String(inner)
          : inner,
    )?.slice(0, 600)
  } catch {
    return String(value)
  }
}
const port = /** @type {import('node:worker_threads').MessagePort} */ (parentPort)
const fault = (what, call) => port.postMessage({ fault: `${what}\n    in ${call}` })
let accepted = 0,
  refused = 0
/** How often each outcome, each code and each method's answer has come up. */
const tally = {}
const count = (what) => {
  tally[what] = (tally[what] ?? 0) + 1
}

/** Calls, and judges how it came back; undefined where it threw as it should. */
function judged(call, run) {
  Atomics.add(ticks, 0, 1)
  port.postMessage({ call })
  try {
    const answer = run()
    accepted++
    return { answer }
  } catch (error) {
    refused++
    if (CODES.has(error?.code)) count(error.code)
    if (error?.name !== 'EstimateError') fault(`threw ${error?.name ?? typeof error}: ${error?.message ?? error}`, call)
    else if (!CODES.has(error.code)) fault(`unknown code ${error.code}`, call)
    else if (typeof error.argument !== 'string' || error.argument === '') fault('no argument named', call)
    else if (typeof error.message !== 'string' || error.message.length < 10)
      fault(`says too little: ${error.message}`, call)
    return undefined
  }
}

function holds(covariances, call) {
  for (const p of covariances) {
    const why = notCovariance(p)
    if (why) fault(`a covariance is ${why}: ${say(p)}`, call)
  }
}

/** One array ten thousand times: nothing to make, and a hundred million numbers to read. */
const VAST = new Array(10_000).fill(new Array(10_000).fill(0))

/**
 * Puts a vast matrix, and one of a vast row, in the place of each matrix in the arguments: each is refused, before it
 * is read.
 */
function vast(args, of, run) {
  for (const { place, put } of matrices(args)) {
    for (const [size, value] of [
      ['10 000 × 10 000', VAST],
      ['1 × 10 000', VAST.slice(0, 1)],
    ]) {
      const call = `${of} with ${size} for ${place}`
      if (judged(call, () => run(put(value)))) fault('read a vast matrix', call)
    }
  }
}

const dice = seeded(seed)
if (FUNCTIONS[name]) {
  vast(FUNCTIONS[name].args(dice), name, (args) => core[name](...args))
  const { args, covariances = () => [] } = FUNCTIONS[name]
  for (let i = 0; i < cases; i++) {
    const given = spoil(args(dice), dice)
    const call = `${name}(${say(given)})`
    const back = judged(call, () => core[name](...given))
    if (back) holds(covariances(back.answer), call)
  }
} else {
  const Class = core[name]
  const {
    make,
    methods,
    look,
    covariances,
    answered = () => [],
    outcomes = () => [],
    chain = 12,
    spoilt = 1,
    often = [],
    lab,
  } = CLASSES[name]
  // What stands before the arguments that are spoilt: a log.
  const before = CLASSES[name].before?.(core) ?? []
  const construct = CLASSES[name].construct?.(core) ?? ((...args) => new Class(...before, ...args))
  const fresh = () => construct()
  vast(make(dice, fresh), `new ${name}`, (args) => construct(...args))
  for (const [method, args] of Object.entries(methods)) {
    const meant = make(dice, fresh)
    const it = construct(...meant)
    vast(args(dice, fresh, it, meant), `${name}.${method}`, (args) => it[method](...args))
    it.free()
  }
  for (let i = 0; i < cases; ) {
    const meant = make(dice, fresh)
    const given = dice.uniform() < spoilt ? spoil(meant, dice) : meant
    i++
    const made = judged(`new ${name}(${say(given)})`, () => construct(...given))
    if (!made) continue
    const it = made.answer
    let told = `new ${name}(${say(given)})`
    for (let turns = dice.below(chain); turns > 0; turns--, i++) {
      const method = dice.pick([...Object.keys(methods), ...often])
      if (typeof it[method] !== 'function') {
        fault('no such method', `${name}.${method}`)
        continue
      }
      const valid = methods[method](dice, fresh, it, meant)
      const args = dice.uniform() < spoilt ? spoil(valid, dice) : valid
      const shown = look(it)
      const call = `${told}; .${method}(${say(args)})`
      const back = judged(call, () => it[method](...args))
      if (back) {
        count(`${method}()`)
        outcomes(back.answer, it).forEach(count)
        holds([...covariances(it), ...answered(back.answer)], call)
        if (method === 'set' || method === 'run') told = call.slice(-900)
      } else if (!isDeepStrictEqual(look(it), shown)) fault('changed by a call it refused', call)
    }
    if (lab) {
      const state = it.state()
      const [bent] = spoil([state], dice)
      const restored = judged(`${name}.from(${say(bent)})`, () => Class.from(...before, bent))
      restored?.answer.free()
      const twin = judged(`${name}.from(${say(state)})`, () => Class.from(...before, state))
      if (twin) CLASSES[name].again?.(twin.answer, it)
      if (!twin) fault('does not take back its own state', say(state))
      else if (!isDeepStrictEqual(twin.answer.frame(), it.frame()))
        fault('its state restores another frame', say(state))
      twin?.answer.free()
    }
    it.free()
  }
}
port.postMessage({ done: true, accepted, refused, tally })
