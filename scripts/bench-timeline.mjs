// Times a reading of a time line that comes in order, one that comes late by ten others and is put in its place, and a
// row of the smoother; beside them the class KalmanFilter, npm's `kalman-filter` and filterpy. These take readings in
// order alone: where one is late, the ten that came after it are filtered again by hand. First all are held against
// one another. The processor's time, so that what else runs counts little; interleaved rounds, medians, ratios. Prints
// tables of the module's README. Nothing fails on a time.
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { python } from '../tests/node/python.mjs'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const { KalmanFilter: Npm } = createRequire(path.join(root, 'crates/peers/package.json'))('kalman-filter')
const PYTHON = python({ numpy: 'numpy', filterpy: 'filterpy' })
const ROUNDS = 5
/** Seconds between two readings, and how many readings come before one that is late. */
const [DT, LATE] = [0.1, 10]
/** Each of its own number of readings: so many times eleven. */
const BLOCKS = { ours: 900, npm: 300, filterpy: 100 }

/** Position and speed, without an input; the position is read. */
const model = {
  A: [
    [0, 1],
    [0, 0],
  ],
  Q: [
    [0, 0],
    [0, 0.2],
  ],
}
const belief = {
  x: [2, 4],
  P: [
    [1, 0],
    [0, 2],
  ],
}
const sensor = { H: [[1, 0]], W: [[0.5]] }
const [one, two] = [core.discretize(model, DT), core.discretize(model, 2 * DT)]
const system = { F: one.F, H: sensor.H, V: one.V, W: sensor.W }

const read = (k) => (k % 7) * 0.3 - 0.9
const inOrder = (blocks) => Array.from({ length: blocks * (LATE + 1) }, (_, k) => k)
/** The first of every eleven comes after the ten others. */
const oneLate = (blocks) => inOrder(blocks).map((k) => (k % (LATE + 1) === LATE ? k - LATE : k + 1))

function timeline(order) {
  const line = new core.Timeline(model, belief, { window: 2 * LATE * DT, sensors: { a: sensor } })
  for (const k of order) {
    const { outcome } = line.reading('a', (k + 1) * DT, [read(k)])
    if (outcome !== 'accepted') throw new Error(`reading ${k}: ${outcome}`)
  }
  const { x } = line.at(order.length * DT)
  line.free()
  return x
}

function kalmanFilter(order) {
  const filter = new core.KalmanFilter(system, belief)
  const [none, y] = [new Float64Array(0), new Float64Array(1)]
  for (const k of order) {
    y[0] = read(k)
    filter.step(none, y)
  }
  const { x } = filter
  filter.free()
  return x
}

/** npm's filter over one step of time. @param {{ F: number[][], V: number[][] }} step */
const npmOver = ({ F, V }) =>
  new Npm({
    observation: { dimension: 1, stateProjection: sensor.H, covariance: sensor.W },
    dynamic: {
      dimension: 2,
      transition: F,
      covariance: V,
      init: { mean: belief.x.map((entry) => [entry]), covariance: belief.P, index: -1 },
    },
  })

/** @param {number} blocks @param {boolean} late whether the first of each block comes last */
function npm(blocks, late) {
  const [filter, afterGap] = [npmOver(one), npmOver(two)]
  let known = null
  const take = (by, k) => (known = by.filter({ previousCorrected: known, observation: [read(k)] }))
  for (let first = 0; first < blocks * (LATE + 1); first += LATE + 1) {
    if (late) {
      const kept = known
      take(afterGap, first + 1)
      for (let k = first + 2; k <= first + LATE; k++) take(filter, k)
      known = kept
    }
    for (let k = first; k <= first + LATE; k++) take(filter, k)
  }
  return known.mean.map(([entry]) => entry)
}

/** The first row afterwards. */
function smooth(blocks) {
  const readings = inOrder(blocks).map((k) => [read(k)])
  return core.kalmanSmooth(
    system,
    belief,
    readings.map(() => []),
    readings,
  )[0].x
}

/** What filterpy says of each row of the tables. @param {number} blocks */
const filterpy = (blocks) =>
  JSON.parse(
    execFileSync(PYTHON, [path.join(root, 'scripts/bench-timeline.py')], {
      encoding: 'utf8',
      stdio: ['pipe', 'pipe', 'ignore'],
      input: JSON.stringify({
        ...system,
        ...belief,
        Ftwo: two.F,
        Vtwo: two.V,
        readings: inOrder(blocks).map(read),
        late: LATE,
      }),
    }),
  )

/** In each table: who, and what it does with so many blocks of readings. */
const tables = {
  'in order': {
    '`Timeline`': timelineOf(inOrder),
    '`KalmanFilter`': (blocks) => kalmanFilter(inOrder(blocks)),
    "npm's `kalman-filter`": (blocks) => npm(blocks, false),
  },
  'one late': {
    '`Timeline`': timelineOf(oneLate),
    "npm's `kalman-filter`, by hand": (blocks) => npm(blocks, true),
  },
  smoothed: { '`kalmanSmooth`': smooth },
}
const PEER = { 'in order': 'filterpy', 'one late': 'filterpy, by hand', smoothed: 'filterpy' }
function timelineOf(arrive) {
  return (blocks) => timeline(arrive(blocks))
}

const peers = filterpy(20)
for (const [table, bodies] of Object.entries(tables)) {
  for (const [who, body] of Object.entries(bodies)) {
    const [mean, theirs] = [body(20), peers[table].x]
    if (!mean.every((entry, i) => Math.abs(entry - theirs[i]) < 1e-9))
      throw new Error(`${table}: ${who} has ${mean}, filterpy ${theirs}`)
  }
}
if (timeline(inOrder(20)).some((entry, i) => entry !== timeline(oneLate(20))[i]))
  throw new Error('a late reading has left other bits')

/** @type {Record<string, Map<string, number[]>>} microseconds a reading */
const times = Object.fromEntries(Object.keys(tables).map((table) => [table, new Map()]))
const note = (table, who, us) => times[table].set(who, [...(times[table].get(who) ?? []), us])
for (let round = -1; round < ROUNDS; round++) {
  for (const [table, bodies] of Object.entries(tables)) {
    for (const [who, body] of Object.entries(bodies)) {
      const blocks = who.startsWith('npm') ? BLOCKS.npm : BLOCKS.ours
      const start = process.cpuUsage()
      body(blocks)
      const { user, system } = process.cpuUsage(start)
      // The first round is for the engine to compile what it runs.
      if (round >= 0) note(table, who, (user + system) / blocks / (LATE + 1))
    }
  }
  if (round < 0) continue
  for (const [table, { us }] of Object.entries(filterpy(BLOCKS.filterpy))) note(table, PEER[table], us)
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1]
const taken = (table, who) => median(times[table].get(who))
/** Prints a table: who, microseconds, and how many times those of the first. @param {Map<string, number>} all */
function print(head, all) {
  const [[first, own]] = all
  console.log(`\n| ${head} | µs | of ${first}'s |\n|---|---:|---:|`)
  for (const [who, us] of all) {
    const ratio = us / own
    console.log(`| ${who} | ${us.toFixed(2)} | ${ratio.toFixed(ratio < 1 ? 2 : 1)}× |`)
  }
}
const rows = (table) => new Map([...times[table].keys()].map((who) => [who, taken(table, who)]))
print('a reading of 2 states, in order', rows('in order'))
/** A late reading alone: what a block with one takes, without its other readings. */
const alone = (who) => taken('one late', who) * (LATE + 1) - taken('in order', who.replace(', by hand', '')) * LATE
print(
  `a reading that comes ${LATE} readings late`,
  new Map([...times['one late'].keys()].map((who) => [who, alone(who)])),
)
print('a row, filtered and smoothed', rows('smoothed'))
