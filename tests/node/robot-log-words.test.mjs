// What the figure of a log says is true in every state: its verdict is held against the frame over a grid of settings and moments,
// on the real log and on logs without truth, without ranges and with bearings. And the server of logs, which a worker runs.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { robotLog } from '../../web/widgets/robot-log.js'
import { RemoteRun } from '../../web/widgets/robot-log/remote-run.js'
import { Server } from '../../web/widgets/robot-log/server.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const text = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const { RobotLog } = core

const LOGS = {
  plaza: text,
  'no truth': text.replace(/^G.*\n/gm, ''),
  'no ranges': text.replace(/^R.*\n/gm, ''),
  bearings: ['L,1,5,5', 'L,2,-5,5', ...Array.from({ length: 60 }, (_, i) => `O,${i},0.1,0\nB,${i},${1 + (i % 2)},${7 - i / 50},${0.7 + i / 90}`)].join('\n'),
}
const GRID = [
  { sightings: false }, {}, { gate: 0.999 }, { gate: 0.95 }, { gate: 1e-9 }, { offset: 2.4 }, { scale: 0.069 }, { scale: 0.069, gate: 0.99 }, { scale: 0.069, sigmaRange: 0.54 },
  { learn: true }, { learn: true, gate: 0.999, sigmaRange: 0.1 }, { scale: -0.2 }, { sigmaRange: 10, sigmaDistance: 1 },
]

/** Each claim, and when it is made. */
function check(words, { params, step, summary, reckonedRmse, bands, correlation }) {
  const { used, refused, rmse, nis, meanInnovation, lag1, epsilon } = summary
  const says = (pattern, when) => assert.equal(pattern.test(words), Boolean(when), `${pattern}: ${words}`)
  const heard = step > 0 && params.sightings && used > 0
  says(/Before the first row/, step === 0)
  says(/Dead reckoning: odometry alone/, step > 0 && !params.sightings)
  says(/No range has been read/, step > 0 && params.sightings && used + refused === 0)
  says(/refused every range/, step > 0 && params.sightings && used === 0 && refused > 0)
  says(/ worse than /, heard && rmse !== null && rmse / reckonedRmse > 1.05)
  says(/ better than the .* dead reckoning/, heard && rmse !== null && rmse / reckonedRmse < 0.95)
  says(/a bias, not noise/, heard && Math.abs(meanInnovation) >= 0.2 && Math.abs(meanInnovation) > bands.mean)
  says(/ above its band/, heard && nis > bands.nis[1])
  says(/ below its band/, heard && nis < bands.nis[0])
  says(/ within its band/, heard && nis >= bands.nis[0] && nis <= bands.nis[1])
  says(/are correlated/, heard && lag1 !== null && Math.abs(lag1) > correlation.band)
  says(/The gate has refused [\d.]+ %/, heard && params.gate !== null)
  says(/The learned scale is/, heard && epsilon !== null)
  assert.ok(!/NaN|undefined|null|Infinity/.test(words), words)
}

for (const [name, log] of Object.entries(LOGS)) {
  test(`the words are true in every state of a log: ${name}`, () => {
    const drive = RobotLog.parse(log)
    const { steps } = drive.contents()
    let before = null
    for (const params of GRID) {
      for (const step of [0, 1, 7, Math.min(400, steps), steps]) {
        const lab = RobotLog.from(drive, { version: 1, lab: 'robot-log', params, step: Math.min(step, steps) })
        const frame = lab.frame()
        check(robotLog.verdict(frame), frame)
        const said = [...Object.values(robotLog.describe(frame)), ...robotLog.readouts(frame).map(({ value }) => value), robotLog.announce(frame, before ?? frame)]
        for (const words of said) assert.ok(words && !/NaN|undefined|null|Infinity/.test(words), words)
        const columns = Object.values(robotLog.series(frame))
        assert.ok(columns.every(({ length }) => length === columns[0].length), 'every column of the CSV has as many rows')
        before = frame
        lab.free()
      }
    }
  })
}

/** A server whose chunks are run by hand. @param {string} [log] @param {() => number} [clock] */
function served(log = text, clock = undefined) {
  const told = []
  const acts = []
  const server = new Server(core, (message) => told.push(structuredClone(message)), (act) => acts.push(act), clock)
  server.take({ kind: 'log', bytes: new TextEncoder().encode(log) })
  const finish = () => { while (acts.length) acts.shift()() }
  return { server, told, acts, finish }
}

test('the server answers with the lab\'s own frame, however it is led there', () => {
  const { server, told, finish } = served()
  assert.equal(told[0].contents.steps, 13_186)
  for (const [params, step] of [[{ sightings: false }, null], [{}, 5000], [{}, 9000], [{}, 300], [{ gate: 0.99 }, null]]) {
    server.take({ kind: 'go', id: told.length, params, step })
    finish()
    const { kind, frame, digest } = told.at(-1)
    assert.equal(kind, 'there')
    const lab = RobotLog.from(RobotLog.parse(text), { version: 1, lab: 'robot-log', params, step: step ?? 13_186 })
    assert.deepEqual([frame, digest], [structuredClone(lab.frame()), lab.digest()])
  }
})

test('a log that is wrong leaves the log before, and says where it is wrong', () => {
  const { server, told, finish } = served()
  server.take({ kind: 'log', bytes: new TextEncoder().encode('O,1,2,3\nR,1,2,x\n') })
  assert.deepEqual([told.at(-1).kind, told.at(-1).line, told.at(-1).column], ['no-log', 2, 7])
  server.take({ kind: 'log', bytes: Uint8Array.of(0xff, 0xfe, 0x4f, 0) })
  assert.equal(told.at(-1).kind, 'no-log')
  server.take({ kind: 'go', id: 9, params: {}, step: null })
  finish()
  assert.equal(told.at(-1).frame.rows, 13_186)
})

test('what the lab refuses is told, and the next wish is answered', () => {
  const { server, told, finish } = served()
  server.take({ kind: 'go', id: 1, params: { gate: 9.21 }, step: null })
  assert.deepEqual([told.at(-1).kind, told.at(-1).id], ['refused', 1])
  server.take({ kind: 'go', id: 2, params: {}, step: 10 })
  finish()
  assert.deepEqual([told.at(-1).kind, told.at(-1).id], ['there', 2])
})

test('a long replay is told of on its way, and cancelled between two chunks', () => {
  const rows = ['L,1,0,10', ...Array.from({ length: 300_000 }, (_, i) => `O,${i / 10},0.1,0.01\nR,${i / 10},1,10`)].join('\n')
  // Each look at this clock finds it ten milliseconds later, so that a chunk is short on every machine.
  let now = 0
  const { server, told, acts, finish } = served(rows, () => (now += 10))
  server.take({ kind: 'go', id: 1, params: {}, step: null })
  for (let i = 0; i < 5 && acts.length; i++) acts.shift()()
  assert.ok(acts.length > 0, 'it is still under way')
  assert.ok(told.some(({ kind, step, of }) => kind === 'progress' && step > 0 && step < of && of === 600_000))
  server.take({ kind: 'cancel' })
  finish()
  assert.ok(!told.some(({ kind }) => kind === 'there'))
  server.take({ kind: 'go', id: 2, params: {}, step: 5 })
  finish()
  assert.equal(told.at(-1).id, 2)
})

test('the run in the page follows the worker, and the newest wish wins', () => {
  const port = { sent: [], onmessage: null, postMessage(message) { this.sent.push(message) } }
  const lab = RobotLog.from(RobotLog.parse(text), { version: 1, lab: 'robot-log', params: {}, step: 100 })
  const run = new RemoteRun(port, lab.frame(), RobotLog.parameters(), 200)
  run.change({ scale: 0.05 })
  assert.equal(run.turn(0, 16, false).moved, 'nothing')
  run.change({ scale: 0.07 })
  run.turn(16, 16, false)
  const [first, second] = port.sent
  assert.deepEqual([first.params.scale, second.params.scale, second.step], [0.05, 0.07, 100])
  assert.equal(run.wanted.params.scale, 0.07, 'a control shows at once what was asked for')
  const answer = { ...lab.frame(), params: second.params }
  run.hear({ kind: 'there', id: first.id, frame: lab.frame(), digest: 'old' })
  assert.equal(run.turn(32, 16, false).moved, 'nothing', 'an answer to an older wish is dropped')
  run.hear({ kind: 'there', id: second.id, frame: answer, digest: 'new' })
  assert.equal(run.turn(48, 16, false).moved, 'replay')
  assert.ok(!run.busy && run.frame === answer)
  run.change({ scale: 0.1 })
  run.turn(64, 16, false)
  run.hear({ kind: 'refused', id: port.sent.at(-1).id, message: 'no' })
  assert.equal(run.turn(80, 16, false).refused, 'no')
  assert.ok(!run.busy && run.frame === answer)
  run.play(true)
  run.turn(96, 100, false)
  assert.equal(port.sent.at(-1).step, 120)
  run.cancel()
  assert.ok(!run.busy && !run.playing)
})
