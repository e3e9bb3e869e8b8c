// The lab that replays a robot's log: the real log against an independent replay's numbers, and everything that is
// refused.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'

const { ObserverBench, DriveLog, RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const text = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const plaza = RobotLog.parse(text)
const SMALL = 'L,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nR,1,7,4.8\n'

/** Runs `call`, which must throw an EstimateError, and answers it. */
function refusal(call) {
  try {
    call()
  } catch (error) {
    assert.equal(error.name, 'EstimateError', String(error))
    return error
  }
  return assert.fail('was not refused')
}
const refused = (call, code, argument) => {
  const error = refusal(call)
  assert.deepEqual([error.code, error.argument], [code, argument], error.message)
}

// Each row: parameters; used, refused; RMSE, worst; NIS per output, mean of ν/√S, lag 1; ε; final x, y, θ.
/** @type {any[][]} */
const REFERENCE = [
  [
    'dead reckoning',
    { sightings: false },
    [0, 0],
    [1.972405133, 4.411414428],
    null,
    null,
    [-1.231074134, 46.365827224, -0.387209386],
  ],
  [
    'raw ranges',
    {},
    [3529, 0],
    [3.472916746, 9.545768581],
    [12.793313313, 2.627121766, 0.361740195],
    null,
    [-3.247598325, 51.322558945, -0.305842423],
  ],
  [
    'raw ranges and a gate',
    { gate: 0.999 },
    [1481, 2048],
    [8.901160071, 28.988208637],
    [1.69715143, 0.152826045, 0.297909314],
    null,
    [-1.513115469, 48.706373309, -0.33678254],
  ],
  [
    'a scale of 0.069',
    { scale: 0.069 },
    [3529, 0],
    [0.366308386, 1.735936434],
    [0.814794255, 0.048866201, -0.009464274],
    null,
    [-4.93627287, 47.003442633, -0.371830407],
  ],
  [
    'the scale and a gate',
    { scale: 0.069, gate: 0.999 },
    [3528, 1],
    [0.366348337, 1.735936434],
    [0.812201472, 0.048147606, -0.010430903],
    null,
    [-4.955356755, 46.870176634, -0.387527295],
  ],
  [
    'a learned scale',
    { learn: true },
    [3529, 0],
    [0.366646474, 1.802262355],
    [0.811642113, 0.012109045, -0.010872128],
    0.070128279,
    [-4.961204184, 46.943034364, -0.373430604],
  ],
  [
    'a learned scale and a gate',
    { learn: true, gate: 0.999 },
    [3527, 2],
    [0.36799784, 1.801316503],
    [0.807041519, 0.01110715, -0.012413021],
    0.07011616,
    [-4.979744058, 46.811432669, -0.388993084],
  ],
]

for (const [name, params, counts, errors, innovations, epsilon, pose] of REFERENCE) {
  test(`${name}: the replay of the real log meets the reference to 1e-6`, () => {
    const lab = new RobotLog(plaza, { sigmaDistance: 0.05, sigmaTurn: 0.02, sigmaRange: 0.6, ...params })
    lab.runAll()
    const found = lab.summary()
    assert.deepEqual([found.used, found.refused], counts)
    const near = (value, expected) => assert.ok(Math.abs(value - expected) < 1e-6, `${value} against ${expected}`)
    near(found.rmse, errors[0])
    near(found.worst, errors[1])
    const statistics = [found.nis, found.meanInnovation, found.lag1]
    if (innovations) innovations.forEach((expected, i) => near(statistics[i], expected))
    else assert.deepEqual(statistics, [null, null, null])
    if (epsilon === null) assert.deepEqual([found.epsilon, found.epsilonSigma], [null, null])
    else near(found.epsilon, epsilon)
    pose.forEach((expected, i) => near(found.x[i], expected))
    assert.equal(found.x.length, epsilon === null ? 3 : 4)
    assert.deepEqual(lab.frame().summary, found)
    assert.equal(lab.state().step, 13_186)
    lab.free()
  })
}

test('a log says what it holds', () => {
  const contents = plaza.contents()
  assert.equal(contents.rows, 15_123)
  assert.equal(contents.steps, 13_186)
  assert.deepEqual(
    contents.landmarks.map(({ id }) => id),
    [0, 1, 6, 5],
  )
  assert.deepEqual([contents.motion, contents.bearings, contents.truth], ['odometry', false, true])
  assert.ok(contents.span[0] < 1 && contents.span[1] > 1900)
})

test('the defaults are those of the documentation', () => {
  assert.deepEqual(new RobotLog(plaza).state(), {
    version: 1,
    lab: 'robot-log',
    step: 0,
    params: {
      sigmaDistance: 0.05,
      sigmaTurn: 0.02,
      sigmaRange: 0.6,
      sigmaBearing: 0.05,
      sigmaFix: 1,
      fixSigmaScale: 1,
      headingSigmaScale: 1,
      sigmaHeading: 0.05,
      startSigma: 0.2,
      startSigmaHeading: 0.1,
      start: null,
      gate: null,
      every: 0,
      scale: 0,
      offset: 0,
      bearingOffset: 0,
      headingOffset: 0,
      antennaAhead: 0,
      antennaLeft: 0,
      learn: false,
      sightings: true,
      fixes: true,
      headings: true,
      delaySpeed: 0,
      delayTurn: 0,
      delayFix: 0,
      delayHeading: 0,
      delaySighting: 0,
      speedScale: 0,
      turnBias: 0,
      learnSpeed: false,
      learnBias: false,
      withheld: null,
    },
  })
})

test('one log serves many labs, also once it is freed', () => {
  const log = RobotLog.parse(SMALL)
  const [one, two] = [new RobotLog(log), new RobotLog(log, { learn: true })]
  log.free()
  one.runAll()
  two.run(3)
  assert.deepEqual([one.summary().used, two.summary().used], [2, 1])
  refused(() => new RobotLog(log), 'type', 'log')
  one.set({ sightings: false })
  assert.equal(one.summary().used, 0)
})

test('a state restores its lab to the bit', () => {
  const lab = new RobotLog(plaza, { gate: 0.99, scale: 0.05 })
  lab.run(7000)
  const twin = RobotLog.from(plaza, lab.state())
  assert.equal(twin.digest(), lab.digest())
  assert.deepEqual(twin.frame(), lab.frame())
  lab.run(2_000_000)
  assert.equal(lab.state().step, 13_186, 'the run ends with the log')
})

test('a text that is no log is refused with line and column', () => {
  const faults = [
    ['', 1, 1, /no motion/],
    ['L,1,0,0\n', 1, 1, /no motion/],
    ['O,0,1,0\nQ,1\n', 2, 1, /no row's letter/],
    ['O,0,1\n', 1, 6, /3 fields; 4/],
    ['O,0,1,x\n', 1, 7, /finite number/],
    ['O,0,1,NaN\n', 1, 7, /finite/],
    ['L,1,0,0\nL,1,2,2\nO,0,1,0\n', 2, 3, /second time/],
    ['O,0,1,0\nR,1,9,2\n', 2, 5, /no landmark 9/],
    ['L,9,0,0\nO,0,1,0\nR,1,9,-2\n', 3, 7, /at least 0/],
    ['O,0,1,0\nV,1,1,1\n', 2, 1, /O rows and V rows/],
    ['\u0000\u0001', 1, 1, /control character/],
    ['O;0;1;0\n', 1, 1, /';' was found/],
    ['"O",0,1,0\n', 1, 1, /quoted/],
    ['\ud800,1,2', 1, 1, /control character|letter/],
  ]
  for (const [bad, line, column, message] of faults) {
    const error = refusal(() => RobotLog.parse(bad))
    assert.deepEqual(
      [error.code, error.argument, error.line, error.column],
      ['log', 'text', line, column],
      `${JSON.stringify(bad)}: ${error.message}`,
    )
    assert.match(error.message, /** @type {RegExp} */ (message))
  }
  assert.equal(RobotLog.parse(`\ufeff${SMALL.replace(/\n/g, '\r\n')}`).contents().rows, 5)
})

test('what is no text, and what is no log, is refused by name', () => {
  for (const nothing of [undefined, null, 5, {}, [], new Uint8Array(4), new String('O,0,1,0')])
    refused(() => RobotLog.parse(nothing), 'type', 'text')
  const forged = { handle: () => 1e9 }
  const throwing = {
    handle() {
      throw new Error('no')
    },
  }
  for (const nothing of [
    undefined,
    null,
    text,
    {},
    new ObserverBench(),
    forged,
    throwing,
    { handle: () => Symbol('1') },
    { handle: 1 },
  ]) {
    refused(() => new RobotLog(nothing), 'type', 'log')
    refused(() => RobotLog.from(nothing, new RobotLog(plaza).state()), 'type', 'log')
  }
  refused(() => DriveLog.prototype.contents.call(new RobotLog(plaza)), 'type', 'this')
})

test('parameters are taken strictly, and a refusal changes nothing', () => {
  const lab = new RobotLog(plaza, { scale: 0.05 })
  lab.run(500)
  const before = [lab.state(), lab.digest(), lab.frame()]
  const faults = [
    [{ gate: 9.21 }, 'limit', 'gate'],
    [{ gate: 0 }, 'limit', 'gate'],
    [{ gate: 1 }, 'limit', 'gate'],
    [{ gate: NaN }, 'not-finite', 'gate'],
    [{ gate: '0.9' }, 'type', 'gate'],
    [{ sigmaRange: 0 }, 'limit', 'sigmaRange'],
    [{ sigmaDistance: -1 }, 'limit', 'sigmaDistance'],
    [{ sigmaTurn: Infinity }, 'not-finite', 'sigmaTurn'],
    [{ sigmaBearing: null }, 'type', 'sigmaBearing'],
    [{ scale: -1 }, 'limit', 'scale'],
    [{ offset: '1' }, 'type', 'offset'],
    [{ learn: 1 }, 'type', 'learn'],
    [{ sightings: undefined, other: 1 }, 'type', 'other'],
  ]
  for (const [params, code, argument] of faults) {
    refused(() => lab.set(params), code, `params.${argument}`)
    refused(() => new RobotLog(plaza, params), code, `params.${argument}`)
    refused(() => RobotLog.from(plaza, { ...before[0], params }), code, `state.params.${argument}`)
  }
  for (const [n, code] of [
    [0, 'limit'],
    [2_000_001, 'limit'],
    [1.5, 'type'],
    [NaN, 'not-finite'],
    ['1', 'type'],
    [undefined, 'type'],
  ])
    refused(() => lab.run(n), code, 'n')
  for (const [step, code] of [
    [-1, 'limit'],
    [13_187, 'limit'],
    [2_000_001, 'limit'],
    [0.5, 'type'],
  ])
    refused(() => RobotLog.from(plaza, { ...before[0], step }), code, 'state.step')
  refused(() => RobotLog.from(plaza, { ...before[0], lab: 'observer-bench' }), 'type', 'state.lab')
  assert.deepEqual([lab.state(), lab.digest(), lab.frame()], before)
})

test('a row that leaves the numbers leaves the lab before it', () => {
  const lab = new RobotLog(RobotLog.parse('L,1,0,5\nO,1,1,0\nR,1,1,5\nO,2,1e300,0\nR,2,1,5\n'))
  lab.run(2)
  const before = [lab.state(), lab.digest()]
  assert.match(refusal(() => lab.runAll()).code, /not-finite|innovation/)
  assert.deepEqual([lab.state(), lab.digest()], before)
})
