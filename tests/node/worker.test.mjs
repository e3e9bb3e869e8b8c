// What computes beside the page: each question has one answer, in every order of what a reader may do while a file is
// slow; one that meets a fault is replaced, and the run goes on.
import { after, test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { Port } from '../../web/load/worker-port.js'
import { attend } from '../../web/load/worker-server.js'
import { RemoteRun } from '../../web/widgets/robot-log/remote-run.js'
import { Server } from '../../web/widgets/robot-log/server.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

// An open channel would keep this process alive.
const { MessageChannel: Channel } = globalThis
const channels = []
globalThis.MessageChannel = class extends Channel {
  constructor() {
    super()
    channels.push(this)
  }
}
after(() => {
  for (const { port1, port2 } of channels) {
    port1.close()
    port2.close()
  }
})

/** Two ends of a line: what is posted at one is heard at the other, later, unless the line has been ended. */
function line() {
  let cut = false
  const end = (other) => ({
    onmessage: null,
    postMessage: (message) => setImmediate(() => cut || other().onmessage?.({ data: message })),
  })
  const near = end(() => far)
  const far = end(() => near)
  return {
    near,
    far,
    end: () => {
      cut = true
    },
  }
}

/** A run over servers that are started as one ends. @param {any} [module] */
async function connected(module = core) {
  const servers = []
  const start = async () => {
    const { near, far, end } = line()
    const make = (given, tell, soon) => {
      servers.push(new Server(given, tell, soon))
      return servers.at(-1)
    }
    attend(far, async () => ({ ok: true, module }), make)
    return { channel: near, end }
  }
  /** @type {any} */
  const run = new RemoteRun(new Port(await start(), start), 2)
  const turns = async () => {
    let refused = null
    for (run.turn(0, 16, false); run.busy; refused ??= run.turn(0, 16, false).refused)
      await new Promise((resolve) => setImmediate(resolve))
    return refused
  }
  return { run, turns, servers }
}

const wheels = (rows) => `time,v,omega\n${Array.from({ length: rows }, (_, i) => `${i},0.5,1\n`).join('')}`
const file = (name, text) => new File([text], name)
/** @returns {any} */
const files = (...given) => ({ kind: 'files', files: given })
const orders = (all) =>
  all.length ? all.flatMap((one) => orders(all.filter((x) => x !== one)).map((rest) => [one, ...rest])) : [[]]

for (const book of [false, true])
  test(`drop, read as, cancel, drop again in every order: one answer each${book ? ', of logs' : ''}`, async () => {
    for (const order of orders(['drop', 'read as', 'cancel', 'drop again'])) {
      const words = order.join(', ')
      let release = () => {}
      const slow = new Promise((resolve) => {
        const rows = book ? Array.from({ length: 5 }, (_, i) => `O,${i},1,0\n`).join('') : wheels(5)
        release = () => resolve(new TextEncoder().encode(rows).buffer)
      })
      const { run, turns } = await connected()
      const { set, kind } = await run.read(files(file('first.csv', wheels(3))))
      assert.equal(kind, 'log')
      const acts = {
        drop: () => run.read(files({ name: 'slow.csv', size: 60, arrayBuffer: () => slow })),
        'read as': () => run.read({ kind: 'reading', set, change: { file: 0, role: 'unused' } }),
        cancel: () => run.giveUp(),
        'drop again': () => run.read(files(file('again.csv', wheels(9)))),
      }
      const asked = order.map((act) => acts[act]())
      const table = run.table('track')
      release()
      const told = Object.fromEntries((await Promise.all(asked)).map((answer, i) => [order[i], answer]))
      await table
      assert.equal(run.port.waiting.size, 0, words)
      // What was asked before the reading was given up has ended; what was asked after it is answered.
      const at = order.indexOf('cancel')
      for (const [i, act] of order.entries())
        if (act !== 'cancel' && i < at) assert.equal(told[act].kind, 'ended', `${words}: ${act}`)
      if (order.indexOf('drop') > at) assert.equal(told.drop.files[0].name, 'slow.csv', words)
      if (order.indexOf('drop again') > at) assert.equal(told['drop again'].contents.rows, 9, words)
      const after = order.slice(at + 1)
      const last = after.filter((act) => act.startsWith('drop')).at(-1)
      const rows = last === 'drop' ? 5 : last ? 9 : 3
      assert.equal(run.contents.rows, rows, words)
      // A change of the first file is of no use to those that came in between.
      if (after[0] === 'read as') assert.equal(told['read as'].files[0].role, 'unused', words)
      else if (after.includes('read as')) assert.equal(told['read as'].kind, 'log', words)
      assert.equal(await turns(), null, words)
      assert.deepEqual([run.frame.rows, run.frame.step], [rows, rows], words)
      assert.equal((await run.read(files(file('last.csv', wheels(4))))).contents.rows, 4, words)
    }
  })

/** The core, in which one call meets a fault of the module as long as `on` says so. */
function faulty() {
  const broken = { at: '' }
  const trap = () => {
    throw new WebAssembly.RuntimeError('unreachable')
  }
  const module = {
    ...core,
    LogFiles: class extends core.LogFiles {
      read() {
        return broken.at === 'read' ? trap() : super.read()
      }
      setRole(...given) {
        return broken.at === 'read as' ? trap() : super.setRole(...given)
      }
    },
    LogTable: class extends core.LogTable {
      next(...given) {
        return broken.at === 'table' ? trap() : super.next(...given)
      }
    },
    RobotLog: {
      parse: core.RobotLog.parse,
      parameters: core.RobotLog.parameters,
      from: (...given) => (broken.at === 'replay' ? trap() : core.RobotLog.from(...given)),
    },
  }
  return { module, broken }
}

test('what meets a fault is replaced: the reader is told, the log stays, and what comes next is answered', async () => {
  const { module, broken } = faulty()
  const { run, turns, servers } = await connected(module)
  const { set } = await run.read(files(file('first.csv', wheels(3))))
  await turns()
  const frame = run.frame
  const said = /met a fault of its own and was started anew/
  for (const [at, ask] of /** @type {[string, () => Promise<any>][]} */ ([
    ['read', () => run.read(files(file('other.csv', wheels(6))))],
    ['read as', () => run.read({ kind: 'reading', set, change: { file: 0, role: 'unused' } })],
    ['table', () => run.table('track')],
  ])) {
    broken.at = at
    const asked = ask()
    // The next program has no fault.
    const count = servers.length
    const mend = run.port.start
    run.port.start = () => {
      broken.at = ''
      return mend()
    }
    const { kind, message } = await asked
    assert.equal(kind, 'ended', at)
    assert.match(message, said, at)
    assert.equal(run.contents.rows, 3, at)
    await run.restored
    assert.equal(servers.length, count + 1, at)
    run.port.start = mend
  }
  broken.at = 'replay'
  run.change({ sigmaDistance: 0.5 })
  const { start } = run.port
  run.port.start = () => {
    broken.at = ''
    return start()
  }
  assert.match(await turns(), said)
  assert.deepEqual(run.wanted.params, frame.params, 'the run is as it was')
  run.change({ gate: 0.99 })
  assert.equal(await turns(), null)
  assert.equal(run.frame.params.gate, 0.99)
})

test('a fault of a table that is read once more has the line of its file', async () => {
  const { run } = await connected()
  const table = 't,v,omega,range1,range2\n0,1,0,5,6\n0.1,fast,0,5,6\n'
  const anchors = file('anchors.csv', 'id,x,y\n1,0,0\n2,9,0\n')
  const said = await run.read(files(file('run.csv', table), anchors))
  const { kind, file: at, line, shown } = /** @type {any} */ (said)
  assert.deepEqual([kind, said.files[at].name, line, shown], ['no-log', 'run.csv, its motion', 3, '0.1,fast,0,5,6'])
})

test('a fault that comes again before anything is answered is the last, and every question hears it', async () => {
  const { module, broken } = faulty()
  const { run, turns } = await connected(module)
  await run.read(files(file('first.csv', wheels(3))))
  await turns()
  broken.at = 'read'
  const both = await Promise.all([run.read(files(file('other.csv', wheels(6)))), run.table('track')])
  assert.deepEqual(
    both.map(({ kind }) => kind),
    ['ended', 'ended'],
  )
  await run.restored
  const { kind, message } = await run.read(files(file('third.csv', wheels(6))))
  assert.equal(kind, 'ended')
  assert.match(message, /Load the page again/)
  run.change({ gate: 0.99 })
  assert.match(await turns(), /Load the page again/)
})

test('a module that cannot be fetched is told to every question', async () => {
  const { near, far, end } = line()
  attend(
    far,
    async () => ({ ok: false, why: 'the server does not answer' }),
    () => assert.fail(),
  )
  const port = new Port({ channel: near, end }, () => assert.fail())
  const [one, other] = await Promise.all([port.ask({ kind: 'files' }), port.ask({ kind: 'table' })])
  assert.deepEqual([one.kind, one.why, other.kind], ['failed', 'the server does not answer', 'failed'])
})
