// Several sensors in a robot's log: a car's against an independent replay's numbers, natively the same bits, and
// everything that is refused.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { fileURLToPath } from 'node:url'
import { acts } from '../../web/page/log-numbers.js'

const { RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const root = fileURLToPath(new URL('../..', import.meta.url))
const car = RobotLog.parse(readFileSync(new URL('../../content/logs/car.csv', import.meta.url), 'utf8'))
const BASE = { sigmaDistance: 0.3, sigmaTurn: 0.03, sigmaFix: 1, startSigma: 1, startSigmaHeading: 0.1 }
const SECOND = { ...BASE, every: { fix: 1 } }
const DELAYED = { ...SECOND, delaySpeed: 0.5 }
const LEARNING = { ...DELAYED, learnSpeed: true, learnBias: true }

/** The lab at the end of a log. */
function whole(log, params) {
  const lab = new RobotLog(log, params)
  lab.runAll()
  return lab
}
const near = (value, expected) => assert.ok(Math.abs(value - expected) < 1e-6, `${value} against ${expected}`)

/** Asserts that `call` throws an EstimateError with this code and argument. */
function refused(call, code, argument) {
  assert.throws(call, (/** @type {any} */ error) => {
    assert.deepEqual([error.name, error.code, error.argument], ['EstimateError', code, argument], error.message)
    return true
  })
}

// Each row: parameters; used, refused; NIS per output, log-likelihood; κ; final x, y, θ.
/** @type {any[][]} */
const REFERENCE = [
  ['speed and turn alone', { ...BASE, fixes: false }, [0, 0], null, null, [-80.814100043, -80.738533752, -3.06894598]],
  ['all fixes', BASE, [2067, 0], [0.633428672, -5331.045830071], null, [-47.122956758, 2.238019868, -3.121725242]],
  // The reference's x is another in the sixth decimal: docs/decisions/0049-the-smoother-goes-back-over-gaps.md.
  ['one a second', SECOND, [205, 0], [2.923664776, -1076.425374044], null, [NaN, 2.441176421, -3.134825471]],
  ['delayed', DELAYED, [205, 0], [2.214565029, -931.043172562], null, [-46.330742452, 2.447174459, -3.134785327]],
  [
    'learned',
    LEARNING,
    [205, 0],
    [1.972055499, -887.382748554],
    0.025213565,
    [-47.24092224, 2.466526691, -3.136164303],
  ],
  [
    'learned, and a gate',
    { ...LEARNING, gate: 0.999 },
    [162, 43],
    [1.068171749, -564.862994548],
    0.012048796,
    [-46.76588919, 2.461744927, -3.135947009],
  ],
]

for (const [name, params, counts, innovations, kappa, pose] of REFERENCE) {
  test(`${name}: the replay of the car meets the reference to 1e-6`, () => {
    const found = whole(car, params).summary()
    assert.deepEqual([found.used, found.refused], counts)
    if (innovations) [found.nis, found.logLikelihood].forEach((value, i) => near(value, innovations[i]))
    else assert.deepEqual([found.nis, found.logLikelihood], [null, null])
    if (kappa === null) assert.deepEqual([found.speedScale, found.turnBias, found.speedScaleSigma], [null, null, null])
    else near(found.speedScale, kappa)
    assert.equal(found.x.length, kappa === null ? 3 : 5)
    pose.forEach((expected, i) => Number.isNaN(expected) || near(found.x[i], expected))
    const { fix, ...others } = found.sensors
    assert.deepEqual(others, {}, 'the log has no other sensor')
    assert.deepEqual([fix.used, fix.refused, fix.nis], [found.used, found.refused, found.nis])
  })
}

test('withheld fixes are as far from filter and smoother as in the reference', () => {
  for (const [params, expected] of [
    [SECOND, [27.580167947, 48.340891009, 9.355070341, 13.977784991]],
    [DELAYED, [25.293633153, 45.793485498, 8.480097567, 13.275236013]],
  ]) {
    const lab = whole(car, { ...params, withheld: [100, 130] })
    const before = lab.summary().withheld
    assert.deepEqual([before.rows, before.rmsSmoothed, before.worstSmoothed], [311, null, null])
    lab.smooth()
    const { rms, worst, rmsSmoothed, worstSmoothed } = lab.summary().withheld
    ;[rms, worst, rmsSmoothed, worstSmoothed].forEach((value, i) => near(value, expected[i]))
    assert.equal(lab.summary().rmseSmoothed, null, 'there is no truth')
    lab.set({ fixes: false })
    assert.equal(lab.summary().withheld, null)
  }
})

test('the module has the bits of a native run', () => {
  for (const params of [LEARNING, { ...DELAYED, withheld: [100, 130], gate: { fix: 0.99 }, start: [1, 2, 0.1] }]) {
    const lab = whole(car, params)
    lab.smooth()
    const of = execFileSync('cargo', ['run', '-q', '--locked', '-p', 'labs', '--example', 'log_digest'], {
      cwd: root,
      encoding: 'utf8',
      input: JSON.stringify(lab.state().params),
    })
    assert.deepEqual(JSON.parse(of), { digest: lab.digest(), frame: lab.frame() })
  }
})

test('the mower’s smoothed track is nearer to the truth, and gone with the next row or setting', () => {
  const plaza = RobotLog.parse(readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8'))
  const lab = new RobotLog(plaza, { learn: true })
  lab.run(13_000)
  lab.smooth()
  const { rmse, rmseSmoothed, withheld } = lab.summary()
  assert.ok(rmseSmoothed < 0.9 * rmse, `${rmseSmoothed} of ${rmse}`)
  assert.equal(withheld, null)
  const { smoothed, errors } = lab.frame()
  assert.deepEqual(smoothed.time, errors.time)
  smoothed.bound.forEach((bound, i) => assert.ok(bound <= errors.bound[i] * (1 + 1e-9)))
  lab.run(1)
  assert.deepEqual([lab.frame().smoothed, lab.summary().rmseSmoothed], [null, null])
  lab.smooth()
  lab.set({ learn: false })
  assert.equal(lab.frame().smoothed, null)
  lab.smooth()
  const twin = RobotLog.from(plaza, lab.state())
  assert.equal(twin.frame().smoothed, null, 'a state is that of the replay')
  twin.smooth()
  assert.deepEqual(twin.frame(), lab.frame())
  new RobotLog(plaza).smooth()
})

test('the likelihood of the car’s fixes is greatest where the speed is 0.58 s late', () => {
  const of = (delaySpeed) => RobotLog.logLikelihood(car, { ...SECOND, delaySpeed }, 2)
  const [before, best, after] = [0.48, 0.58, 0.68].map(of)
  assert.ok(best.logLikelihood > before.logLikelihood && best.logLikelihood > after.logLikelihood)
  assert.deepEqual([before.used, best.used, after.used], [203, 203, 203])
  const all = RobotLog.logLikelihood(car, SECOND, -1)
  assert.deepEqual(all, { logLikelihood: whole(car, SECOND).summary().logLikelihood, used: 205 })
  refused(() => RobotLog.logLikelihood({}, {}, 0), 'type', 'log')
  refused(() => RobotLog.logLikelihood(car, { gate: 2 }, 0), 'limit', 'params.gate')
  refused(() => RobotLog.logLikelihood(car, {}, NaN), 'not-finite', 'from')
  refused(() => RobotLog.logLikelihood(car, 5, 0), 'type', 'params')
})

test('a value for all sensors and an object by sensor are one parameter', () => {
  const gates = (gate) => new RobotLog(car, { gate }).state().params.gate
  assert.equal(gates({ fix: 0.9, heading: 0.9, range: 0.9, bearing: 0.9 }), 0.9)
  assert.equal(gates({}), null)
  assert.deepEqual(gates({ fix: 0.9 }), { fix: 0.9, heading: null, range: null, bearing: null })
  const lab = new RobotLog(car, SECOND)
  lab.set({ gate: 0.99 })
  assert.deepEqual(lab.state().params.every, { fix: 1, heading: 0, range: 0, bearing: 0 }, 'set leaves the others')
  assert.deepEqual(RobotLog.from(car, lab.state()).state(), lab.state())
})

test('what acts on a speed or a turn rate is there for logs that read one', () => {
  const names = ['delaySpeed', 'learnSpeed', 'delayTurn', 'learnBias']
  const there = (text) => {
    const contents = RobotLog.parse(text).contents()
    return [contents.lacks, ...names.filter((name) => acts(contents, name))]
  }
  assert.deepEqual(there('V,0,1,0\nV,1,1,0'), [null, ...names])
  assert.deepEqual(there('S,0,1\nT,0,0'), [null, ...names])
  assert.deepEqual(there('S,0,1\nS,1,1'), ['turn rate', 'delaySpeed', 'learnSpeed'])
  assert.deepEqual(there('T,0,0\nT,1,0'), ['speed', 'delayTurn', 'learnBias'])
  assert.deepEqual(there('O,0,0,0\nO,1,1,0'), [null])
})

test('a log says which sensors it has', () => {
  assert.deepEqual(car.contents().readings, { fix: 2067 })
  assert.equal(car.contents().motion, 'velocity')
  const log = RobotLog.parse('L,1,5,0\nS,0,1\nT,0,0\nH,1,0\nH,2,0,0.1\nR,1,1,4\nB,2,1,3,0\nP,0,0,0,2\n')
  assert.deepEqual(log.contents().readings, { fix: 1, heading: 2, range: 1, bearing: 1 })
  const { sensors } = whole(log, {}).summary()
  assert.deepEqual(
    Object.entries(sensors).map(([name, { used }]) => [name, used]),
    [
      ['fix', 1],
      ['heading', 2],
      ['range', 1],
      ['bearing', 1],
    ],
  )
  assert.deepEqual(Object.keys(sensors.bearing).slice(-2), ['meanBearing', 'lag1Bearing'])
  assert.deepEqual(Object.keys(sensors.fix).slice(-2), ['meanAlong', 'meanAcross'])
})

test('steps are rows, also of velocities whose speed and turn have other delays', () => {
  const rows = Array.from({ length: 50 }, (_, i) => `V,${i},1,0.1\nP,${i},${i},0`).join('\n')
  const log = RobotLog.parse(rows)
  const params = { delaySpeed: 1.5, delayTurn: -0.5 }
  const lab = new RobotLog(log, params)
  for (let step = 1; step <= 100; step++) {
    lab.run(1)
    assert.equal(lab.state().step, step)
  }
  lab.run(1)
  assert.equal(lab.state().step, 100)
  assert.equal(lab.digest(), whole(log, params).digest())
})

test('parameters of several sensors are taken strictly, and a refusal changes nothing', () => {
  const lab = new RobotLog(car, DELAYED)
  lab.run(500)
  const before = [lab.state(), lab.digest(), lab.frame()]
  const faults = [
    [{ gate: { fix: 9.21 } }, 'limit', 'gate.fix'],
    [{ gate: { fix: '0.9' } }, 'type', 'gate.fix'],
    [{ gate: { fix: NaN } }, 'not-finite', 'gate.fix'],
    [{ gate: { gps: 0.9 } }, 'type', 'gate.gps'],
    [{ every: -1 }, 'limit', 'every'],
    [{ every: { heading: -1 } }, 'limit', 'every.heading'],
    [{ every: { fix: null } }, 'type', 'every.fix'],
    [{ every: null }, 'type', 'every'],
    [{ sigmaFix: 0 }, 'limit', 'sigmaFix'],
    [{ sigmaHeading: -1 }, 'limit', 'sigmaHeading'],
    [{ startSigma: 0 }, 'limit', 'startSigma'],
    [{ startSigmaHeading: Infinity }, 'not-finite', 'startSigmaHeading'],
    [{ start: [0, 0] }, 'shape', 'start'],
    [{ start: [0, 0, NaN] }, 'not-finite', 'start[2]'],
    [{ start: 0 }, 'type', 'start'],
    [{ delaySpeed: 10.01 }, 'limit', 'delaySpeed'],
    [{ delayTurn: -11 }, 'limit', 'delayTurn'],
    [{ delayFix: null }, 'type', 'delayFix'],
    [{ delayHeading: NaN }, 'not-finite', 'delayHeading'],
    [{ delaySighting: 1e9 }, 'limit', 'delaySighting'],
    [{ speedScale: -1 }, 'limit', 'speedScale'],
    [{ turnBias: '0' }, 'type', 'turnBias'],
    [{ learnSpeed: 1 }, 'type', 'learnSpeed'],
    [{ fixes: null }, 'type', 'fixes'],
    [{ withheld: [130, 100] }, 'limit', 'withheld'],
    [{ withheld: [100] }, 'shape', 'withheld'],
    [{ withheld: [100, Infinity] }, 'not-finite', 'withheld[1]'],
  ]
  for (const [params, code, argument] of faults) {
    refused(() => lab.set(params), code, `params.${argument}`)
    refused(() => new RobotLog(car, params), code, `params.${argument}`)
    refused(() => RobotLog.from(car, { ...before[0], params }), code, `state.params.${argument}`)
  }
  assert.deepEqual([lab.state(), lab.digest(), lab.frame()], before)
  refused(() => RobotLog.prototype.smooth.call(car), 'type', 'this')
})

test('a log of O rows is not asked for what speeds and turn rates have', () => {
  const log = RobotLog.parse('O,0,1,0\nP,1,1,0\n')
  for (const params of [
    { speedScale: 0.1 },
    { turnBias: 0.1 },
    { learnSpeed: true },
    { learnBias: true },
    { delaySpeed: 0.1 },
    { delayTurn: 0.1 },
  ])
    refused(() => new RobotLog(log, params), 'limit', `params.${Object.keys(params)[0]}`)
  assert.equal(whole(log, { delayFix: 0.1, delayHeading: 1 }).summary().used, 1, 'fixes have a delay there too')
})

test('a covariance that cannot be factored names its row and leaves the lab', () => {
  // A fix without any noise, and a motion without any: x is known exactly.
  const log = RobotLog.parse('V,0,1,0\nP,0,0,0,1e-200\nV,1,1,0\nP,1,1,0\nV,2,1,0\n')
  const lab = whole(log, { sigmaDistance: 0, sigmaTurn: 0 })
  const before = [lab.state(), lab.digest(), lab.frame()]
  assert.throws(
    () => lab.smooth(),
    ({ name, code, message }) =>
      name === 'EstimateError' &&
      code === 'innovation-not-positive-definite' &&
      /row [1-4] of the replay/.test(message),
  )
  assert.deepEqual([lab.state(), lab.digest(), lab.frame()], before)
})
