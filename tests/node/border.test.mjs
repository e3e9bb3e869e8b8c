// What crosses the border the wrong way is refused, however often, and named as the caller wrote it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { FIGURES } from '../../target/figures.js'
import { rail, refused } from './rail.mjs'

// The module's face hides its table of references: it is taken from the instance.
const { Instance } = WebAssembly
/** @type {any} */
let raw
WebAssembly.Instance = class extends Instance {
  /** @param {ConstructorParameters<typeof Instance>} given */
  constructor(...given) {
    super(...given)
    raw = this.exports
  }
}
const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
WebAssembly.Instance = Instance

const pose = {
  x: [0, 0, 0],
  P: [
    [0.01, 0, 0],
    [0, 0.01, 0],
    [0, 0, 0.01],
  ],
}
const W = [
  [0.01, 0],
  [0, 0.001],
]
const LOG = core.RobotLog.parse('L,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nR,1,7,4.8\n')
/** Speeds that hold until the next: of such a log every parameter can be set. */
const HELD = core.CarLog.parse('L,7,3,4\nV,0,0.2,0.1\nP,0.5,0.1,0\nR,0.5,7,4.9\nV,1,0.2,0\nP,1,0.2,0\n')
/** A lab as it is at first, one of logs on that. */
const opened = ({ lab, world }) => (world ? new core[lab](HELD) : new core[lab]())
/** @type {Record<string, any>} */
const objects = {
  DriveLog: LOG,
  KalmanFilter: new core.KalmanFilter(rail, {
    x: [2, 4],
    P: [
      [1, 0],
      [0, 2],
    ],
  }),
  Timeline: new core.Timeline(
    { A: [[0]], B: [[1]], Q: [[1]] },
    { x: [0], P: [[1]] },
    { window: 1, sensors: { scale: { H: [[1]], W: [[1]] } } },
  ),
  LogFiles: new core.LogFiles(),
  LogFit: new core.LogFit(core.RobotLog.parse('L,7,3,4\nO,0,0,0\nO,9,0.1,0\nR,9,7,4.8\n'), {}),
  LogVerdict: new core.LogVerdict(core.RobotLog.parse('L,7,3,4\nO,0,0,0\nO,9,0.1,0\nR,9,7,4.8\n'), {}),
  LogTable: new core.LogTable(LOG, {}, 'track'),
  EkfLocalizer: new core.EkfLocalizer(pose, [{ id: 1, x: 2, y: 1 }], { W }),
  EkfSlam: new core.EkfSlam(pose, { W, gate: 9.21, found: 50 }),
  ...Object.fromEntries(FIGURES.map((figure) => [figure.lab, opened(figure)])),
}

test('a method or a property of one class refuses an object of every other', () => {
  let calls = 0
  const arguments_ = {
    set: [{}],
    run: [1],
    collinearPoint: [0],
    predict: [[0, 0], pose.P],
    step: [[0], [0]],
    update: [{ range: 1, bearing: 0 }],
    input: [0, [0]],
    reading: ['scale', 0, [0]],
    at: [0],
    replay: [new Float64Array(4), new Uint32Array(1), pose.P],
  }
  const own = { KalmanFilter: { predict: [[0]], update: [[0]] } }
  for (const name of Object.keys(objects)) {
    const methods = Object.getOwnPropertyNames(core[name].prototype).filter(
      (method) => !['constructor', 'free', '__destroy_into_raw'].includes(method),
    )
    for (const method of methods) {
      for (const [other, object] of Object.entries(objects)) {
        if (other === name) continue
        const { value, get } = Object.getOwnPropertyDescriptors(core[name].prototype)[method]
        refused(() => (value ?? get).call(object, ...(own[name]?.[method] ?? arguments_[method] ?? [])), 'type', 'this')
        calls += 1
      }
    }
  }
  assert.ok(calls > 100, `${calls} calls`)
  for (const object of Object.values(objects)) {
    const look =
      [object.frame, object.belief, object.contents, object.files, object.found, object.at?.bind(object, 0)].find(
        Boolean,
      ) ?? (() => object.x ?? object.next(1))
    look.call(object)
  }
})

test('a refusal leaves nothing behind in the table of references', () => {
  const { EkfLocalizer: ekf, ObserverBench: bench } = objects
  const throwing = {
    get gain() {
      throw new Error('no')
    },
  }
  const proxy = new Proxy(
    {},
    {
      ownKeys() {
        throw new Error('no')
      },
    },
  )
  const list = new Proxy([], {
    get() {
      throw new Error('no')
    },
  })
  const refusals = [
    () => ekf.replay([], [], []),
    () => bench.set(throwing),
    () => bench.set(proxy),
    () => bench.set({ gain: '1' }),
    () => bench.set({ other: 1 }),
    () => ekf.predict(list, pose.P),
    () => bench.run(0.5),
    () => core.ObserverBench.from({ version: 2 }),
    () => core.EkfSlam.prototype.belief.call(ekf),
  ]
  // A table that grew would double; a million refusals are far more than its length.
  const table = raw.__wbindgen_externrefs
  const once = () => {
    for (const refusal of refusals) {
      try {
        refusal()
      } catch (error) {
        if (error.name !== 'EstimateError') throw error
      }
    }
  }
  for (let i = 0; i < 1000; i++) once()
  const before = table.length
  const rounds = Number(process.env.REFUSALS ?? 1e6) / refusals.length
  for (let i = 0; i < rounds; i++) once()
  assert.equal(table.length, before)
})

test('a culprit is named as the caller wrote it', () => {
  const { ObserverBench: Bench, ObservabilityProbe: Probe } = core
  refused(() => new Bench({ gain: 7 }), 'limit', 'params.gain')
  refused(
    () => Bench.from({ version: 1, lab: 'observer-bench', step: 0, params: { gain: -1 } }),
    'limit',
    'state.params.gain',
  )
  refused(() => Bench.from({ version: 1, lab: 'observer-bench', step: -1, params: {} }), 'limit', 'state.step')
  refused(
    () =>
      new Probe({
        landmarks: [
          [1, 2],
          [3, '4'],
          [5, 6],
        ],
      }),
    'type',
    'params.landmarks[1][1]',
  )
  refused(
    () =>
      new Probe({
        landmarks: [
          [1, 2],
          [3, 4],
        ],
      }),
    'shape',
    'params.landmarks',
  )
  refused(() => new Probe({ landmarks: [[1, 2], [3, 4], [5]] }), 'shape', 'params.landmarks[2]')
  assert.throws(() => new Bench([]), /is an array; it must be an object/)
})

test('a huge name is shortened', () => {
  const name = 'x'.repeat(2 ** 20)
  refused(() => new core.ObserverBench({ [name]: 1 }), 'type', `params.${name.slice(0, 60)}…`)
  refused(() => new core.ObserverBench({ mode: name }), 'type', 'params.mode')
})

test('a lab says how far its parameters go, and takes what it says', () => {
  for (const figure of FIGURES) {
    const [name, lab] = [figure.lab, opened(figure)]
    const parameters = core[name].parameters()
    assert.deepEqual(Object.fromEntries(parameters.map((p) => [p.name, p.default])), lab.state().params)
    // What does not go together with the rest, as a noise with a size, is refused for that.
    const taken = (params) => {
      try {
        lab.set(params)
      } catch (error) {
        assert.ok(error.name === 'EstimateError' && error.code !== 'limit', `${name}: ${error.message}`)
      }
    }
    for (const p of parameters.filter(({ default: usual }) => typeof usual === 'number')) {
      for (const end of [p.least, p.greatest]) {
        if (Math.abs(end) < 1e300) taken({ [p.name]: end })
      }
      if (p.greatest < 2 ** 31)
        assert.throws(
          () => lab.set({ [p.name]: p.greatest + Math.max(1, p.step) }),
          ({ code }) => code === 'limit' || code === 'tolerance',
        )
    }
    for (const p of parameters.filter(({ words }) => words)) for (const word of p.words) lab.set({ [p.name]: word })
    lab.free()
  }
})
