// Times a reading of a time line that comes in order, and one that comes late by ten others and is put in its place;
// beside them the class KalmanFilter, which takes readings in order alone, and npm's `kalman-filter`. First all are
// held against one another. Interleaved rounds, medians, ratios; nothing fails on a time.
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const { KalmanFilter: Npm } = createRequire(path.join(root, 'crates/peers/package.json'))('kalman-filter')
const ROUNDS = 7
/** Seconds between two readings, and how many readings come before one that is late. */
const [DT, LATE] = [0.1, 10]
const STEPS = (LATE + 1) * 1800

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
const read = (k) => (k % 7) * 0.3 - 0.9
const { F, V } = core.discretize(model, DT)

const inOrder = Array.from({ length: STEPS }, (_, k) => k)
/** The first of every eleven comes after the ten others. */
const late = inOrder.map((k) => (k % (LATE + 1) === LATE ? k - LATE : k + 1))

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

const bodies = {
  'Timeline, in order': () => timeline(inOrder),
  'Timeline, one in eleven late by ten': () => timeline(late),
  'KalmanFilter, in order': () => {
    const filter = new core.KalmanFilter({ F, H: sensor.H, V, W: sensor.W }, belief)
    const [none, y] = [new Float64Array(0), new Float64Array(1)]
    for (const k of inOrder) {
      y[0] = read(k)
      filter.step(none, y)
    }
    const { x } = filter
    filter.free()
    return x
  },
  "npm's kalman-filter, in order": () => {
    const filter = new Npm({
      observation: { dimension: 1, stateProjection: sensor.H, covariance: sensor.W },
      dynamic: {
        dimension: 2,
        transition: F,
        covariance: V,
        init: { mean: belief.x.map((entry) => [entry]), covariance: belief.P, index: -1 },
      },
    })
    let previousCorrected = null
    for (const k of inOrder) previousCorrected = filter.filter({ previousCorrected, observation: [read(k)] })
    return previousCorrected.mean.map(([entry]) => entry)
  },
}

const means = Object.values(bodies).map((body) => body())
if (means[0].some((entry, i) => entry !== means[1][i])) throw new Error('a late reading has left other bits')
for (const mean of means.slice(2)) {
  if (!mean.every((entry, i) => Math.abs(entry - means[0][i]) < 1e-9))
    throw new Error(`the filters disagree: ${JSON.stringify(means.map((m) => [...m]))}`)
}

const times = new Map(Object.keys(bodies).map((name) => [name, []]))
for (let round = -1; round < ROUNDS; round++) {
  for (const [name, body] of Object.entries(bodies)) {
    const start = process.hrtime.bigint()
    body()
    if (round >= 0) times.get(name).push(Number(process.hrtime.bigint() - start) / inOrder.length / 1000)
  }
}
const median = (name) => times.get(name).sort((a, b) => a - b)[ROUNDS >> 1]
const ours = median('Timeline, in order')
console.log("\n| a reading of two states | µs | of a time line's in order |\n|---|---:|---:|")
for (const name of times.keys()) {
  console.log(`| ${name} | ${median(name).toFixed(2)} | ${(median(name) / ours).toFixed(2)}× |`)
}
const perLate = (median('Timeline, one in eleven late by ten') - ours * (LATE / (LATE + 1))) * (LATE + 1)
console.log(`\nA late reading alone: ${perLate.toFixed(2)} µs, ${(perLate / ours).toFixed(1)} times one in order.`)
console.log(`It is put before ${LATE} others, which are replayed.`)
