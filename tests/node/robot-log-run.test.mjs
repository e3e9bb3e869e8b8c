// The run in the page that follows a worker's replays of a log.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { RemoteRun } from '../../web/widgets/robot-log/remote-run.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const text = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const { RobotLog } = core

/** A run whose port is the test's, at the frame of `lab`. @param {any} lab */
function running(lab) {
  const sent = []
  const port = {
    onmessage: null,
    post: (message) => sent.push(message),
    ask: (message) =>
      new Promise((resolve) => {
        sent.push({ ...message, answer: resolve })
      }),
    restart() {},
  }
  const run = new RemoteRun(port, 200)
  run.frame = lab.frame()
  run.goal = run.frame.step
  return { run, sent }
}

test('the run in the page follows the worker, and the newest wish wins', () => {
  const lab = RobotLog.from(RobotLog.parse(text), { version: 1, lab: 'robot-log', params: {}, step: 100 })
  const { run, sent } = running(lab)
  run.change({ scale: 0.05 })
  assert.equal(run.turn(0, 16, false).moved, 'nothing')
  run.change({ scale: 0.07 })
  run.turn(16, 16, false)
  const [first, second] = sent
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
  run.hear({ kind: 'refused', id: sent.at(-1).id, message: 'no' })
  assert.equal(run.turn(80, 16, false).refused, 'no')
  assert.ok(!run.busy && run.frame === answer)
  run.play(true)
  run.turn(96, 100, false)
  assert.equal(sent.at(-1).step, 120)
  run.cancel()
  assert.ok(!run.busy && !run.playing)
})

test('a run takes another log, and one that is wrong leaves it as it was', async () => {
  const lab = RobotLog.from(RobotLog.parse(text), {
    version: 1,
    lab: 'robot-log',
    params: { gate: 0.99 },
    step: 13_186,
  })
  const { run, sent } = running(lab)
  const wrong = run.read({ kind: 'files', files: [] })
  sent.at(-1).answer({ kind: 'no-log', message: 'no' })
  assert.equal((await wrong).kind, 'no-log')
  assert.ok(!run.busy)
  const right = run.read({ kind: 'files', files: [] })
  sent.at(-1).answer({ kind: 'log', contents: { steps: 13_186 } })
  await right
  assert.ok(run.busy, 'as many rows as before are replayed all the same')
  run.turn(0, 16, false)
  const { kind, id, params, step } = sent.at(-1)
  assert.deepEqual([kind, params.gate, step], ['go', 0.99, 13_186])
  run.hear({ kind: 'there', id, frame: lab.frame(), digest: 'other' })
  assert.equal(run.turn(16, 16, false).moved, 'reset')
})
