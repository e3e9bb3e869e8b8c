// The map of a log's likelihood is filled in chunks, between which messages are read; a later log replaces an earlier
// one, and what the reader cancels is computed no further. Every value is the lab's own.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { Filling, likelihood } from '../../web/widgets/tune/likelihood.js'
import { Server } from '../../web/widgets/tune/server.js'

const estimate = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const lab = (params) => estimate.Tune.from({ version: 1, lab: 'tune', step: 0, params })

/** A server whose clock moves by `tick` at each look, with what it has told and what waits. */
function serving(tick) {
  /** @type {any[][]} */
  const [told, waiting] = [[], []]
  let now = 0
  const server = new Server(
    estimate,
    (message) => told.push(message),
    (act) => waiting.push(act),
    () => (now += tick),
  )
  return {
    server,
    told,
    waiting,
    run: () => {
      while (waiting.length) waiting.shift()()
    },
  }
}

test('a map is filled in chunks, by rows, from the least W on, to the bit', () => {
  const { server, told, waiting, run } = serving(10)
  server.take({ kind: 'fill', id: 4, params: { seed: 3, length: 30 }, size: 12 })
  assert.equal(waiting.length, 1, 'it waits between chunks')
  run()
  const [top, ...rows] = told
  const fit = lab({ seed: 3, length: 30, fit: true }).frame().fit
  assert.deepEqual(top, { kind: 'top', id: 4, top: fit.logLikelihood, limit: fit.limit })
  assert.ok(rows.length > 3 && rows.every(({ kind, id }) => kind === 'rows' && id === 4))
  const own = lab({ seed: 3, length: 30 })
  assert.deepEqual(
    rows.flatMap(({ values }) => values),
    Array.from({ length: 12 }, (_, row) => [...own.likelihoodRow(row, 12, 12)]).flat(),
  )
  assert.equal(server.work, null)
})

test('a later log replaces an earlier one, and a cancelled map is computed no further', () => {
  const { server, told, waiting, run } = serving(10)
  server.take({ kind: 'fill', id: 1, params: { seed: 1, length: 30 }, size: 40 })
  server.take({ kind: 'fill', id: 2, params: { seed: 2, length: 30 }, size: 40 })
  const before = told.filter(({ id }) => id === 1).length
  waiting.shift()()
  assert.equal(told.filter(({ id }) => id === 1).length, before)
  server.take({ kind: 'cancel' })
  const after = told.length
  run()
  assert.equal(told.length, after)
  server.take({ kind: 'fill', id: 3, params: { seed: -1, length: 30 }, size: 40 })
  const { message, ...rest } = told.at(-1)
  assert.deepEqual(rest, { kind: 'refused', id: 3 })
  assert.match(message, /seed/)
})

/** A map whose port is the test's. */
function filling() {
  const sent = []
  /** @type {any} */
  const port = { post: (message) => sent.push(message), onmessage: null }
  let changes = 0
  /** @type {any} */
  const map = new Filling(
    () => {
      changes += 1
    },
    async () => port,
  )
  return {
    map,
    sent,
    port,
    changes: () => changes,
    answer: (told) => port.onmessage(told),
    soon: () => new Promise((resolve) => setImmediate(resolve)),
  }
}
const frame = (params) => ({ params: { seed: 1, length: 200, fit: false, ...params } })

test('a figure asks for a map once for each log, and shows rows as they come', async () => {
  const { map, sent, answer, changes, soon } = filling()
  map.follow(frame({ logQ: 0 }))
  map.follow(frame({ logQ: 1 }))
  await soon()
  assert.deepEqual(
    sent.map(({ kind, params }) => [kind, params]),
    [['fill', { seed: 1, length: 200 }]],
  )
  const { id, size } = sent[0]
  assert.deepEqual(map.progress, { step: 0, of: size, unit: 'row' })
  answer({ kind: 'top', id, top: -5, limit: 6 })
  answer({ kind: 'rows', id, values: Array(2 * size).fill(-7) })
  answer({ kind: 'rows', id: id - 1, values: Array(size).fill(0) })
  assert.deepEqual([map.value.rows, map.value.top, map.progress.step, changes()], [2, -5, 2, 2])
  answer({ kind: 'rows', id, values: Array((size - 2) * size).fill(-7) })
  assert.equal(map.progress, null)
  map.follow(frame({ seed: 2 }))
  assert.equal(map.value, null, 'the map of another log is gone at once')
})

test('a cancelled map keeps its rows, and Fit or another log fills it again', async () => {
  const { map, sent, answer, soon } = filling()
  map.follow(frame({}))
  await soon()
  const { id, size } = sent[0]
  answer({ kind: 'top', id, top: -5, limit: 6 })
  answer({ kind: 'rows', id, values: Array(size).fill(-7) })
  map.cancel()
  await soon()
  assert.deepEqual([map.progress, map.value.rows, map.value.stopped, sent.at(-1).kind], [null, 1, true, 'cancel'])
  answer({ kind: 'rows', id, values: Array(size).fill(-7) })
  assert.equal(map.value.rows, 1, 'a late answer is not taken')
  map.follow(frame({ logQ: 1 }))
  assert.equal(map.progress, null)
  map.follow(frame({ fit: true }))
  await soon()
  assert.equal(sent.at(-1).kind, 'fill')
})

test('where nothing can compute the map the figure goes on without it', async () => {
  const map = new Filling(
    () => {},
    async () => {
      throw new Error('no worker')
    },
  )
  map.follow(frame({}))
  await new Promise((resolve) => setImmediate(resolve))
  assert.deepEqual([map.progress, map.value], [null, null])
})

test('the map of a still is the lab’s', () => {
  const own = lab({ seed: 1 })
  const { values, size, rows, top } = likelihood.whole(own)
  assert.deepEqual([values.length, rows], [size * size, size])
  assert.ok(Math.max(...values) < top && Math.max(...values) > top - 3)
})
