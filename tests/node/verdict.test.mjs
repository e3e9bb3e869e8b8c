// The verdict on a log in words: each sentence says what the core has found, on logs with a known fault; and the run
// asks for it once it stands at the end of a log of the reader's own.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { Server } from '../../web/widgets/robot-log/server.js'
import { RemoteRun } from '../../web/widgets/robot-log/remote-run.js'
import { judgement, suspect } from './verdicts.mjs'
import { ranked } from '../../web/widgets/robot-log/verdict.js'
import { verdict } from '../../web/widgets/robot-log/words.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const mower = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')

function judged(text, params = {}) {
  const judging = new core.LogVerdict(core.RobotLog.parse(text), params)
  while (judging.step());
  const found = judging.found()
  judging.free()
  return found
}

/** A drive in loops that reads its landmarks; `see` spoils what is seen. @param {(one: any) => any} see */
function drive(see, start = [0, 0, 0]) {
  const places = [
    [6, 8],
    [-7, 5],
    [4, -9],
  ]
  const rows = [...places.map(([x, y], id) => `L,${id},${x},${y}`), `G,0,${start.join(',')}`]
  let [x, y, theta] = [0, 0, 0]
  for (let i = 0; i < 600; i++) {
    const [v, omega] = [1 + 0.5 * Math.sin(i / 9), 0.2 + 0.3 * Math.sin(i / 17)]
    const id = i % 3
    const [dx, dy] = [places[id][0] - x, places[id][1] - y]
    const noise = (much, phase) => much * (Math.sin(12.9898 * (i + phase)) * 1.4)
    const range = Math.hypot(dx, dy) + noise(0.2, 0.3)
    const bearing = Math.atan2(dy, dx) - theta + noise(0.05, 7.7)
    const seen = see({ v, omega, range, bearing, i })
    rows.push(`V,${i / 10},${seen.v},${seen.omega}`, `B,${i / 10},${id},${Math.max(0, seen.range)},${seen.bearing}`)
    x += v * 0.1 * Math.cos(theta)
    y += v * 0.1 * Math.sin(theta)
    theta += omega * 0.1
  }
  return rows.join('\n')
}

const params = { sigmaRange: 0.2, sigmaBearing: 0.05 }
const words = (text, log = { rows: 1200, truth: true }) => ranked(judged(text, params), log)

test('a turned camera, a bias, a scale, outliers and a wrong start are told with their sizes and remedies', () => {
  assert.match(
    words(drive((one) => ({ ...one, bearing: one.bearing + 0.06 }))),
    /^The camera is turned by 3\.\d+ ± 0\.\d+°: set .* to 3\.[345]\d*°\. 0\.61° of that may be .* of a step\. The log-/,
  )
  assert.match(
    words(drive((one) => ({ ...one, omega: one.omega + 0.05 }))),
    /^The turn rate reads 0\.0(4[89]|5\d)\d* ± [\d.]+ rad\/s too much: let the filter learn its bias\./,
  )
  assert.match(
    words(drive((one) => ({ ...one, v: one.v / 1.1 }))),
    /^The speed reads (9|10|11)\.?\d* ± [\d.]+ % too low: let the filter learn its scale\./,
  )
  assert.match(
    words(drive((one) => ({ ...one, range: one.range + (one.i % 40 === 5 ? 2 : 0) }))),
    /^2\.\d+ ± \d\.\d+ % of the ranges with a bearing are outliers: switch their gate on/,
  )
  assert.match(
    words(drive((one) => one, [0.7, 0.3, 0.5])),
    /^The robot did not start at the first true pose, but 0\.\d+ m beside, and turned by \d+°: mend that row/,
  )
})

test('the mower’s ranges read seven per cent long, and mending them brings the estimate to the truth', () => {
  const said = ranked(judged(mower), { rows: 13_186, truth: true })
  assert.match(said, /^The ranges read 7\.0\d+ ± 0\.0\d+ % too long: set their scale to 7\.0\d+ %\. The log-likelihood/)
  assert.match(
    said,
    /is wrong shows once this is mended, and may bend this size by more than its ±\. Against the truth the NEES/,
  )
  assert.match(said, /Mended so, the RMS error goes from 3\.47 to 0\.37 m and the NEES to 2\.2\.$/)
  const gated = ranked(judged(mower, { gate: 0.999 }), { rows: 13_186, truth: true })
  assert.match(gated, /^The gate refuses more than one reading in ten, .*\. The ranges read 7\./)
})

/** Numbers of mean 0 and variance 1: the sum of twelve is nearly normal. @param {number} seed */
function normals(seed) {
  let state = seed
  const unit = () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0
    return state / 2 ** 32
  }
  return () => Array.from({ length: 12 }, unit).reduce((sum, one) => sum + one, -6)
}

test('what is counted beside a larger σ is said so: the page’s own sum rises by more', () => {
  // The speed is 0.6 s late, and the robot is pushed about by more than σ of the distance says.
  const speed = (/** @type {number} */ time) => 2 + 1.5 * Math.sin(time / 3)
  const normal = normals(3)
  const rows = []
  let [x, y, theta] = [0, 0, 0]
  for (let i = 0; i < 3000; i++) {
    const turn = 0.04 * Math.cos(i / 71)
    rows.push(`V,${i / 10},${speed(i / 10 - 0.6)},${10 * turn}`)
    if (i % 10 === 0) rows.push(`P,${i / 10},${x + 0.4 * normal()},${y + 0.4 * normal()}`)
    const way = 0.1 * speed(i / 10) + 0.09 * normal()
    theta += turn
    x += way * Math.cos(theta)
    y += way * Math.sin(theta)
  }
  const pushed = rows.join('\n')
  const found = judged(pushed, { sigmaFix: 0.4 })
  assert.ok(found.beside && found.thinning === null)
  const log = { rows: rows.length, truth: false }
  assert.match(
    ranked(found, log),
    /^The speed comes .* Even with a σ so large that it allows for the other errors, the log-/,
  )
  const sums = [0, found.suspects[0].sizes[0].value].map((delaySpeed) => {
    const log = core.RobotLog.parse(pushed)
    const { steps } = log.contents()
    return core.RobotLog.from(log, {
      version: 1,
      lab: 'robot-log',
      params: { delaySpeed, sigmaFix: 0.4 },
      step: steps,
    }).frame().summary.logLikelihood
  })
  assert.ok(sums[1] - sums[0] > 2 * found.suspects[0].gain, `${sums}`)
  assert.doesNotMatch(ranked({ ...found, beside: false }, log), /Even with/)
})

test('two beacons of the copy are exchanged, and the settings of the exercise do not hide it', () => {
  const copied = readFileSync(new URL('../../content/logs/plaza1-copied.csv', import.meta.url), 'utf8')
  const said = ranked(judged(copied, { scale: 0.07, gate: 0.999 }), { rows: 13_186, truth: true })
  assert.match(
    said,
    / Landmarks 1 and 6 are taken for one another: exchange their numbers where .* from 11\.14 to 0\.37 m/,
  )
  assert.doesNotMatch(said, /did not start/)
})

test('the worker judges suspect by suspect, and a change of the settings ends it', async () => {
  const acts = []
  const server = new Server(
    core,
    () => {},
    (act) => acts.push(act),
  )
  await server.answer({ kind: 'files', files: [new File([mower], 'log.csv')] })
  const goOn = async (answer) => {
    /** @type {any} */
    let said = null
    answer.then((it) => {
      said = it
    })
    while (said === null) {
      acts.shift()?.()
      await new Promise((resolve) => setImmediate(resolve))
    }
    return said
  }
  const said = await goOn(server.answer({ kind: 'verdict', params: {} }))
  assert.deepEqual([said.kind, said.found], ['verdict', judged(mower)])
  const given = server.answer({ kind: 'verdict', params: {} })
  server.take({ kind: 'go', id: 1, params: { scale: 0.07 }, step: 10 })
  assert.deepEqual(await goOn(given), { kind: 'no-verdict', message: 'The verdict was given up.' })
  const none = await goOn(server.answer({ kind: 'verdict', params: { sightings: false } }))
  assert.equal(none.kind, 'no-verdict')
})

test('a run asks for the verdict at the end of a log of the reader’s own, and shows it beside its frame', async () => {
  const lab = core.RobotLog.from(core.RobotLog.parse(mower), {
    version: 1,
    lab: 'robot-log',
    params: {},
    step: 13_186,
  })
  const asked = []
  /** @type {any} */
  const port = {
    onmessage: null,
    post: () => {},
    ask: (message) => new Promise((answer) => asked.push({ message, answer })),
  }
  const run = new RemoteRun(port, 200)
  const there = () => {
    run.change({ scale: 0 })
    run.turn(0, 16, false)
    run.hear({ kind: 'there', id: run.sent?.id, frame: lab.frame(), digest: '' })
    run.turn(0, 16, false)
  }
  run.frame = lab.frame()
  run.goal = run.frame.step
  there()
  assert.equal(asked.length, 0, 'what the figure opens with is its reader’s to find out')
  run.judging.on = true
  there()
  there()
  assert.deepEqual(
    asked.map(({ message }) => message.kind),
    ['verdict', 'verdict'],
  )
  assert.ok(run.busy)
  // What the innovations say by themselves would be replaced a moment later.
  assert.match(verdict(run.frame), /dead reckoning\. Still looking for what may be wrong …$/)
  const found = judged(mower)
  asked[0].answer({ kind: 'verdict', found: null })
  asked[1].answer({ kind: 'verdict', found })
  await new Promise((resolve) => setImmediate(resolve))
  assert.equal(run.turn(0, 16, false).moved, 'replay')
  assert.ok(run.frame.judgement === found && !run.busy)
  assert.match(verdict(run.frame), /^The RMS error .* dead reckoning\. The ranges read 7\.0/)
  there()
  asked[2].answer({ kind: 'no-verdict', message: '' })
  await new Promise((resolve) => setImmediate(resolve))
  assert.equal(run.turn(0, 16, false).moved, 'replay')
  assert.match(verdict(run.frame), / The innovations’ mean is /, 'none has come of it')
  assert.equal(run.turn(0, 16, false).moved, 'nothing')
})

test('a log that asks how it is read is judged once it is answered, and one of an exercise is not', async () => {
  const log = { kind: 'log', contents: { steps: 2 }, parameters: [] }
  const answers = []
  /** @type {any} */
  const port = { onmessage: null, post: () => {}, ask: async () => answers.shift() }
  const run = new RemoteRun(port, 200)
  run.frame = { step: 0, params: {} }
  const read = async (question, answer) => {
    answers.push(answer)
    await run.read(question)
    return run.judging.on
  }
  const files = []
  assert.equal(await read({ kind: 'files', files }, { ...log, set: 1 }), false, 'what the figure opens with')
  assert.equal(await read({ kind: 'files', files }, { kind: 'no-log', set: 2 }), false, 'the log before stays')
  assert.equal(await read({ kind: 'reading', set: 2, change: {} }, { ...log, set: 2 }), true, 'asked and answered')
  assert.equal(await read({ kind: 'files', files, exercise: true }, { ...log, set: 3 }), false, 'an exercise')
  assert.equal(await read({ kind: 'reading', set: 3, change: {} }, { ...log, set: 3 }), false, 'read otherwise')
})

test('beside rows of distances a verdict without a fault says what it has not looked for', () => {
  /** @type {any} */
  const sound = {
    suspects: [{ standing: 'cleared' }],
    readings: 90,
    rows: 1,
    gaps: [],
    arcs: null,
    against: null,
    ungated: false,
    other: false,
    noise: { nis: null, refused: null, correlated: null },
  }
  assert.match(
    ranked(sound, { rows: 1, truth: false, log: { motion: 'odometry', names: [] } }),
    / A scale of odometry’s distances is not among/,
  )
  assert.doesNotMatch(ranked(sound, { rows: 1, truth: false }), /not among/)
})

test('a compass that is off is told beside the offset that is set', () => {
  const off = (now) => ({
    fault: 'turned',
    name: 'headingOffset',
    sizes: [{ now, value: 0, sigma: 0.002, end: false }],
  })
  const said = (now) => ranked(judgement([suspect(off(now))]), { rows: 100, truth: false })
  assert.match(said(-0.21), /reads 12\.\d+ ± 0\.\d+° too far counter-clockwise, beside the offset that is set: set the/)
})
