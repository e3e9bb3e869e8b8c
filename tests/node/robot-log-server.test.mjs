// The server of logs, which a worker runs, and the run in the page that follows it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { RemoteRun } from '../../web/widgets/robot-log/remote-run.js'
import { Server } from '../../web/widgets/robot-log/server.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const text = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const { RobotLog } = core

/** A server whose chunks are run by hand. @param {string} [log] @param {() => number} [clock] */
async function served(log = text, clock = undefined) {
  const told = []
  const acts = []
  const server = new Server(
    core,
    (message) => told.push(structuredClone(message)),
    (act) => acts.push(act),
    clock,
  )
  server.take({ kind: 'files', files: [new File([log], 'log.csv')] })
  await server.reading
  const finish = () => {
    while (acts.length) acts.shift()()
  }
  return { server, told, acts, finish }
}

test("the server answers with the lab's own frame, however it is led there", async () => {
  const { server, told, finish } = await served()
  assert.equal(told[0].contents.steps, 13_186)
  for (const [params, step] of [
    [{ sightings: false }, null],
    [{}, 5000],
    [{}, 9000],
    [{}, 300],
    [{ gate: 0.99 }, null],
  ]) {
    server.take({ kind: 'go', id: told.length, params, step })
    finish()
    const { kind, frame, digest } = told.at(-1)
    assert.equal(kind, 'there')
    const lab = RobotLog.from(RobotLog.parse(text), { version: 1, lab: 'robot-log', params, step: step ?? 13_186 })
    assert.deepEqual([frame, digest], [structuredClone(lab.frame()), lab.digest()])
  }
})

test('a log that is wrong leaves the log before, and says where it is wrong', async () => {
  const { server, told, finish } = await served()
  server.take({ kind: 'files', files: [new File(['O,1,2,3\nR,1,2,x\n'], 'mine.csv')] })
  await server.reading
  const { kind, file, line, column, shown } = told.at(-1)
  assert.deepEqual([kind, file, line, column, shown], ['no-log', 0, 2, 7, 'R,1,2,x'])
  server.take({ kind: 'files', files: [new File([Uint8Array.of(0xff, 0xfe, 0x4f, 0)], 'strange')] })
  await server.reading
  assert.equal(told.at(-1).kind, 'no-log')
  server.take({ kind: 'files', files: [{ name: 'folder', arrayBuffer: () => Promise.reject(new Error('a folder')) }] })
  await server.reading
  assert.match(told.at(-1).message, /could not be read/)
  server.take({ kind: 'go', id: 9, params: {}, step: null })
  finish()
  assert.equal(told.at(-1).frame.rows, 13_186)
})

test('a table in another encoding is read and said to be; a file that is no text is refused', async () => {
  const { server, told } = await served()
  const table = 'time [s];v;yaw rate [°/s]\r\n0;0,5;1\r\n1;0,5;2\r\n'
  const wide = Buffer.from(`\ufeff${table}`, 'utf16le')
  const files = {
    'utf-16le': wide,
    'utf-16be': Buffer.from(wide).swap16(),
    'windows-1252': Buffer.from(table, 'latin1'),
    'utf-8': Buffer.from(table),
  }
  for (const [encoding, bytes] of Object.entries(files)) {
    server.take({ kind: 'files', files: [new File([bytes], 'wheels.csv')] })
    await server.reading
    const {
      kind,
      contents,
      files: [shown],
      message,
    } = told.at(-1)
    assert.equal(kind, 'log', `${encoding}: ${message}`)
    assert.deepEqual([contents.rows, shown.angle, shown.header[2]], [2, 'deg', 'yaw rate [°/s]'], encoding)
    assert.deepEqual(
      contents.notes,
      encoding === 'utf-8' ? [] : [`wheels.csv is no UTF-8 and was read as ${encoding.toUpperCase()}.`],
    )
  }
  for (const bytes of [
    [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13],
    [0x4f, 0, 0x2c, 0, 0xd8, 0],
  ]) {
    server.take({ kind: 'files', files: [new File([Uint8Array.from(bytes)], 'picture.png')] })
    await server.reading
    assert.deepEqual(
      [told.at(-1).kind, told.at(-1).message.includes('plain text in UTF-8')],
      ['no-log', true],
      told.at(-1).message,
    )
  }
})

test('a faulty line that a carriage return ends is shown', async () => {
  const { server, told } = await served()
  server.take({ kind: 'files', files: [new File(['O,0,0,0\rO,1,x,0\rO,2,0,0\r'], 'mac.csv')] })
  await server.reading
  const { kind, line, column, shown } = told.at(-1)
  assert.deepEqual([kind, line, column, shown], ['no-log', 2, 5, 'O,1,x,0'])
})

test('what the lab refuses is told, and the next wish is answered', async () => {
  const { server, told, finish } = await served()
  server.take({ kind: 'go', id: 1, params: { gate: 9.21 }, step: null })
  assert.deepEqual([told.at(-1).kind, told.at(-1).id], ['refused', 1])
  server.take({ kind: 'go', id: 2, params: {}, step: 10 })
  finish()
  assert.deepEqual([told.at(-1).kind, told.at(-1).id], ['there', 2])
})

test('a long replay is told of on its way, and cancelled between two chunks', async () => {
  const rows = [
    'L,1,0,10',
    ...Array.from({ length: 300_000 }, (_, i) => `O,${i / 10},0.1,0.01\nR,${i / 10},1,10`),
  ].join('\n')
  // Each look at this clock finds it ten milliseconds later, so that a chunk is short on every machine.
  let now = 0
  const { server, told, acts, finish } = await served(rows, () => (now += 10))
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
  const port = {
    sent: [],
    onmessage: null,
    postMessage(message) {
      this.sent.push(message)
    },
  }
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

test('a file that is guessed wrongly is read otherwise, and its log replayed', async () => {
  const { server, told, finish } = await served()
  const wheels = `a,b,c\n${Array.from({ length: 50 }, (_, i) => `${100 * i},${500},${i % 3}`).join('\n')}\n`
  server.take({ kind: 'files', files: [new File([wheels], 'run.csv')] })
  await server.reading
  assert.deepEqual(
    [told.at(-1).kind, told.at(-1).files[0].role, told.at(-1).files[0].header],
    ['no-log', 'unused', ['a', 'b', 'c']],
  )
  for (const change of [
    { file: 0, role: 'velocities' },
    { file: 0, unit: 'mm' },
    { file: 0, unit: 'ms' },
    { file: 0, unit: 'deg' },
  ]) {
    server.take({ kind: 'reading', change })
    await server.reading
    assert.equal(told.at(-1).kind, 'log')
  }
  assert.deepEqual(told.at(-1).contents.span, [0, 4.9])
  assert.deepEqual(
    told.at(-1).files[0].values.map(({ column }) => column),
    [0, 1, 2],
  )
  server.take({ kind: 'reading', change: { file: 0, value: 'v', column: null } })
  await server.reading
  assert.match(told.at(-1).message, /no column has been chosen for v/)
  server.take({ kind: 'go', id: 3, params: {}, step: null })
  finish()
  assert.equal(told.at(-1).frame.rows, 50, 'the log that was read last')
})

test('a replay is written as a table while wishes are answered', async () => {
  const { server, told, acts, finish } = await served()
  server.take({ kind: 'table', params: {}, table: 'innovations' })
  let done = false
  server.reading.then(() => {
    done = true
  })
  await Promise.resolve()
  server.take({ kind: 'go', id: 5, params: {}, step: 20 })
  while (!done) {
    finish()
    await new Promise((resolve) => setImmediate(resolve))
  }
  assert.ok(told.some(({ kind, id }) => kind === 'there' && id === 5))
  const { text } = told.find(({ kind }) => kind === 'table')
  assert.equal((await text.text()).trim().split('\n').length, 1 + 3529)
  assert.equal(acts.length, 0)
})

test('a run takes another log, and one that is wrong leaves it as it was', async () => {
  const port = {
    sent: [],
    onmessage: null,
    postMessage(message) {
      this.sent.push(message)
    },
  }
  const lab = RobotLog.from(RobotLog.parse(text), {
    version: 1,
    lab: 'robot-log',
    params: { gate: 0.99 },
    step: 13_186,
  })
  const run = new RemoteRun(port, lab.frame(), RobotLog.parameters(), 200)
  const wrong = run.read({ kind: 'files', files: [] })
  port.onmessage({ data: { kind: 'no-log', message: 'no' } })
  assert.equal((await wrong).kind, 'no-log')
  assert.ok(!run.busy)
  const right = run.read({ kind: 'files', files: [] })
  port.onmessage({ data: { kind: 'log', contents: { steps: 13_186 } } })
  await right
  assert.ok(run.busy, 'as many rows as before are replayed all the same')
  run.turn(0, 16, false)
  const { kind, id, params, step } = port.sent.at(-1)
  assert.deepEqual([kind, params.gate, step], ['go', 0.99, 13_186])
  port.onmessage({ data: { kind: 'there', id, frame: lab.frame(), digest: 'other' } })
  assert.equal(run.turn(16, 16, false).moved, 'reset')
})
