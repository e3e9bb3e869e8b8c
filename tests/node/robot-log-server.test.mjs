// The server of logs, which a worker runs.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { Server } from '../../web/widgets/robot-log/server.js'
import { faultWords, othersWords } from '../../web/page/log-file-words.js'

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
  const read = await server.answer({ kind: 'files', files: [new File([log], 'log.csv')] })
  const finish = () => {
    while (acts.length) acts.shift()()
  }
  return { server, read, told, acts, finish }
}

test("the server answers with the lab's own frame, however it is led there", async () => {
  const { server, read, told, finish } = await served()
  assert.equal(read.contents.steps, 13_186)
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
  let said = await server.answer({ kind: 'files', files: [new File(['O,1,2,3\nR,1,2,x\n'], 'mine.csv')] })
  const { kind, file, line, column, shown } = said
  assert.deepEqual([kind, file, line, column, shown], ['no-log', 0, 2, 7, 'R,1,2,x'])
  said = await server.answer({ kind: 'files', files: [new File([Uint8Array.of(0xff, 0xfe, 0x4f, 0)], 'strange')] })
  assert.equal(said.kind, 'no-log')
  said = await server.answer({
    kind: 'files',
    files: [{ name: 'folder', arrayBuffer: () => Promise.reject(new Error('a folder')) }],
  })
  assert.match(said.message, /could not be read/)
  assert.deepEqual([said.name, said.line], ['folder', 1])
  const many = Array.from({ length: 17 }, (_, i) => new File([text], `f${i}.csv`))
  said = await server.answer({ kind: 'files', files: many })
  assert.deepEqual([said.kind, said.line, said.name], ['no-log', 0, ''], 'no file of them is at fault')
  assert.match(said.message, /^a log has at most 16 files/)
  assert.match(said.mend, /^Open fewer files/)
  server.take({ kind: 'go', id: 9, params: {}, step: null })
  finish()
  assert.equal(told.at(-1).frame.rows, 13_186)
})

test('a table in another encoding is read and said to be; a file that is no text is refused', async () => {
  const { server } = await served()
  const table = 'time [s];v;yaw rate [°/s]\r\n0;0,5;1\r\n1;0,5;2\r\n'
  const wide = Buffer.from(`\ufeff${table}`, 'utf16le')
  const files = {
    'utf-16le': wide,
    'utf-16be': Buffer.from(wide).swap16(),
    'windows-1252': Buffer.from(table, 'latin1'),
    'utf-8': Buffer.from(table),
  }
  for (const [encoding, bytes] of Object.entries(files)) {
    const said = await server.answer({ kind: 'files', files: [new File([bytes], 'wheels.csv')] })
    const { kind, contents, message } = said
    const [shown] = said.files
    const units = shown.values?.map(({ unit }) => unit)
    assert.equal(kind, 'log', `${encoding}: ${message}`)
    assert.deepEqual([contents.rows, units?.[2], shown.header[2]], [2, 'deg/s', 'yaw rate [°/s]'], encoding)
    assert.deepEqual(
      contents.notes,
      encoding === 'utf-8' ? [] : [`wheels.csv is no UTF-8 and was read as ${encoding.toUpperCase()}.`],
    )
  }
  for (const bytes of [
    [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13],
    [0x4f, 0, 0x2c, 0, 0xd8, 0],
  ]) {
    const files = [new File([Uint8Array.from(bytes)], 'picture.png')]
    const { kind, message } = await server.answer({ kind: 'files', files })
    assert.equal(kind, 'no-log')
    assert.match(message, /plain text in UTF-8/)
  }
})

test('a faulty line that a carriage return ends is shown', async () => {
  const { server } = await served()
  const said = await server.answer({ kind: 'files', files: [new File(['O,0,0,0\rO,1,x,0\rO,2,0,0\r'], 'mac.csv')] })
  const { kind, line, column, shown } = said
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

test('a file that is guessed wrongly is read otherwise, and its log replayed', async () => {
  const { server, told, finish } = await served()
  const wheels = `a,b,c\n${Array.from({ length: 50 }, (_, i) => `${100 * i},${500},${i % 3}`).join('\n')}\n`
  let said = await server.answer({ kind: 'files', set: 1, files: [new File([wheels], 'run.csv')] })
  assert.deepEqual([said.kind, said.files[0].role, said.files[0].header], ['no-log', 'unused', ['a', 'b', 'c']])
  for (const change of [
    { file: 0, role: 'velocities' },
    { file: 0, value: 'v', unit: 'mm/s' },
    { file: 0, value: 'time', unit: 'ms' },
    { file: 0, value: 'omega', unit: 'deg/s' },
  ]) {
    said = await server.answer({ kind: 'reading', set: 1, change })
    // Five hundred of what is asked, and nothing is read before that is said.
    if (change.role) assert.match(said.message, /run\.csv asks: In which unit is “b”/)
    else assert.equal(said.kind, 'log')
  }
  assert.equal(said.files[0].follows, '10 Hz, 0 to 4.9 s, v 0.5 … 0.5 m/s, 2.45 m of way, turned 0.0133 turns')
  assert.deepEqual(said.files[0].values[0].samples, ['0', '2500', '4900'])
  assert.deepEqual(said.contents.span, [0, 4.9])
  assert.deepEqual(
    said.files[0].values.map(({ column }) => column),
    [0, 1, 2, null, null],
  )
  said = await server.answer({ kind: 'reading', set: 1, change: { file: 0, value: 'v', column: null } })
  assert.match(said.message, /no column has been chosen for v/)
  server.take({ kind: 'go', id: 3, params: {}, step: null })
  finish()
  assert.equal(told.at(-1).frame.rows, 50, 'the log that was read last')
})

test('what a file asks is told in no line, and what encoders need is taken', async () => {
  const { server } = await served()
  const encoders = 'time_ms,left_ticks,right_ticks\n0,0,0\n50,40,42\n100,80,84\n'
  let said = await server.answer({ kind: 'files', set: 4, files: [new File([encoders], 'encoders.csv')] })
  assert.deepEqual([said.kind, said.line, said.mend], ['no-log', 0, 'Answer below'])
  assert.match(said.message, /^encoders\.csv asks: Encoders need how many ticks/)
  for (const change of [
    { file: 0, wheel: 'ticks', number: 1000 },
    { file: 0, wheel: 'radius', number: 0.1 },
    { file: 0, wheel: 'base', number: 0.4 },
    { file: 0, counting: 'total' },
  ])
    said = await server.answer({ kind: 'reading', set: 4, change })
  assert.deepEqual([said.kind, said.contents.steps, said.contents.motion], ['log', 2, 'odometry'])
  assert.deepEqual(said.files[0].wheels, { ticks: 1000, radius: 0.1, base: 0.4, counting: 'total' })
})

test('what is missing or wrong comes before a question, and is told of each file', async () => {
  const { server } = await served()
  const rows = Array.from({ length: 60 }, (_, i) => `${i / 10},1,${i === 50 ? 'abc' : 0}\n`).join('')
  const compass = new File(['time_s,heading_deg\n0,10\n1,12\n'], 'compass.csv')
  const wheels = new File([`time_s,v_mps,omega_radps\n${rows}`], 'wheels.csv')
  const missing = await server.answer({ kind: 'files', set: 5, files: [compass] })
  assert.match(missing.message, /^the robot's motion is missing: compass\.csv has neither/)
  assert.deepEqual([missing.mend, missing.files[0].asks.length, missing.files[0].fault], ['', 1, null])
  assert.equal(othersWords(missing.files, -1), 'Besides, compass.csv asks something: see below.')
  const wrong = await server.answer({ kind: 'files', set: 6, files: [compass, wheels] })
  assert.deepEqual([wrong.file, wrong.line, wrong.column, wrong.mend], [1, 52, 5, ''])
  assert.equal(othersWords(wrong.files, 1), 'Besides, compass.csv asks something: see below.')
  assert.equal(othersWords(wrong.files, 0), 'Besides, wheels.csv is wrong in line 52: see below.')
  const { fault } = wrong.files[1]
  assert.equal(faultWords(fault), "Line 52, character 5: omega is 'abc'; a finite number was expected.")
  const speeds = new File(['time_s,left_mps,right_mps\n0,1,1\n0.1,1,1\n'], 'wheels.csv')
  const asked = await server.answer({ kind: 'files', set: 7, files: [speeds] })
  assert.deepEqual([asked.files[0].needs, asked.mend], [['base'], 'Answer below'])
})

test('a fit is told of, ends, can be given up, and finds what the log was made with', async () => {
  const rows = []
  for (let i = 0; i < 600; i++) {
    const t = i / 10
    // A robot whose speed swings, and whose fixes are half a second late and off by 0.3 m.
    rows.push(`V,${t},${1 + Math.sin(t)},0`)
    const late = t - 0.5
    if (i % 5 === 0 && late >= 0)
      rows.push(`P,${t},${late + 1 - Math.cos(late) + 0.3 * Math.sin(17 * i)},${0.3 * Math.cos(23 * i)}`)
  }
  const { server, told, acts } = await served(rows.join('\n'), () => 0)
  const drive = async (answered) => {
    /** @type {any} */
    let said
    answered.then((answer) => {
      said = answer
    })
    while (!said) {
      while (acts.length) acts.shift()()
      await new Promise((resolve) => setImmediate(resolve))
    }
    return said
  }
  const { kind, found } = await drive(server.answer({ kind: 'fit', params: { startSigma: 1 } }))
  assert.equal(kind, 'fit')
  const { value, sigma } = found.numbers.find(({ name }) => name === 'delayFix')
  const { value: speed } = found.numbers.find(({ name }) => name === 'delaySpeed')
  assert.ok(Math.abs(value - speed - 0.5) < 0.1 && sigma > 0, `${value} ${speed} ${sigma}`)
  assert.ok(found.logLikelihood[1] > found.logLikelihood[0] && found.settled)
  const givenUp = server.answer({ kind: 'fit', params: {} })
  server.take({ kind: 'stop-fit' })
  const said = await drive(givenUp)
  assert.deepEqual(said, { kind: 'no-fit', message: 'The fit was given up.' })
  assert.equal((await drive(server.answer({ kind: 'fit', params: { sigmaFix: -1 } }))).kind, 'no-fit')
  assert.ok(told.every(({ kind }) => kind !== 'fault'))
})

test('a replay is written as a table while wishes are answered', async () => {
  const { server, told, acts, finish } = await served()
  const answered = server.answer({ kind: 'table', params: {}, table: 'innovations' })
  let done = false
  answered.then(() => {
    done = true
  })
  await Promise.resolve()
  server.take({ kind: 'go', id: 5, params: {}, step: 20 })
  while (!done) {
    finish()
    await new Promise((resolve) => setImmediate(resolve))
  }
  assert.ok(told.some(({ kind, id }) => kind === 'there' && id === 5))
  const { text } = await answered
  assert.equal((await text.text()).trim().split('\n').length, 1 + 3529)
  assert.equal(acts.length, 0)
})
