// How long a call of the module takes at the greatest size that it accepts: what a page that calls it has to wait for
// at most. Prints the milliseconds of each, the median of three; nothing fails on a time.
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** The greatest system: 16 states, 8 outputs, 8 inputs. */
const [N, P, M] = [16, 8, 8]
const diagonal = (rows, columns, value) =>
  Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (_, j) => (i === j ? value : 0)))
/** A chain of integrators that never settles within the tolerance 0. */
const F = diagonal(N, N, 1).map((row, i) => row.map((entry, j) => (j === i + 1 ? 1 : entry)))
/** Each state takes the place of the one before it: one output sees them all, and any poles can be had. */
const ring = diagonal(N, N, 0).map((row, i) => row.map((_, j) => (j === (i + 1) % N ? 1 : 0)))
const system = { F, G: diagonal(N, M, 1), H: diagonal(P, N, 1), V: diagonal(N, N, 0.1), W: diagonal(P, P, 0.5) }
const belief = { x: Array(N).fill(0), P: diagonal(N, N, 1) }

const pose = { x: [0, 0, 0], P: diagonal(3, 3, 0.01) }
const beacons = (count) =>
  Array.from({ length: count }, (_, id) => ({ id, x: 10 + (id % 40), y: Math.floor(id / 40) - 10 }))
const LOG = 1_000_000
const log = new Float64Array(4 * LOG).map((_, i) => [0, 0, 10, 3][i % 4])
const ids = new Uint32Array(LOG).map((_, i) => i % 1000)

/** A map of 500 landmarks, founded 100 at a time, and a step that sights 100 of them again. */
function greatMap() {
  const slam = new core.EkfSlam(pose, {
    W: [
      [0.01, 0],
      [0, 0.001],
    ],
    gate: 1000,
    found: 1000,
  })
  const sights = (from) =>
    Array.from({ length: 100 }, (_, i) => ({
      range: 10 + i,
      bearing: ((from + i) % 628) / 100 - 3.14,
      landmark: from + i,
    }))
  for (let from = 0; from < 500; from += 100) slam.update(sights(from))
  return () => slam.update(sights(0))
}

/** The greatest time line, but for one event: what comes late by all of them has them all replayed. */
function fullTimeline() {
  const sensors = { far: { H: system.H, W: system.W } }
  const A = diagonal(N, N, -1).map((row, i) => row.map((entry, j) => (j === i + 1 ? 1 : entry)))
  const make = () => {
    const line = new core.Timeline({ A, Q: system.V }, belief, { window: 100, capacity: 10_000, sensors })
    for (let k = 1; k < 10_000; k++) line.reading('far', k / 1000, Array(P).fill(k % 3))
    return line
  }
  // A call puts its reading into the line, so each has a line of its own.
  const lines = Array.from({ length: 3 }, make)
  return () => {
    const { outcome } = lines.pop().reading('far', 0.0005, Array(P).fill(0))
    if (outcome !== 'accepted') throw new Error(`the late reading is ${outcome}`)
  }
}

/** A filter of own models without Jacobians: each is found by differences. */
function ownModels(Filter) {
  const filter = new Filter(belief)
  return () => {
    filter.predict((x) => x.map((entry, i) => 0.9 * entry + 0.1 * Math.sin(x[(i + 1) % N])), system.V)
    filter.update(Array(P).fill(0), (x) => x.slice(0, P).map((entry) => entry + 0.1 * entry ** 2), system.W)
  }
}

/** Three landmarks so close together that ghosts of them have filled the Probe's map. */
function fullProbe() {
  const lab = new core.ObservabilityProbe({
    count: 3,
    forget: true,
    landmarks: [
      [2, 3],
      [2.3, 3],
      [2.6, 3],
    ],
  })
  lab.run(10_000)
  if (!lab.frame().slam.full) throw new Error('the map of the Probe is not full')
  return () => lab.frame()
}

const calls = {
  'steadyStateGain, 16 states, 10 000 iterations': () => core.steadyStateGain(system, belief.P, 10_000, 0),
  'gainSchedule, 16 states, 10 000 steps': () => core.gainSchedule(system, belief.P, 10_000),
  'kalmanReplay, 16 states, 10 000 steps': () =>
    core.kalmanReplay(system, belief, new Float64Array(10_000 * M), new Float64Array(10_000 * P)),
  'kalmanSmooth, 16 states, 8 outputs, 2160 rows': () =>
    core.kalmanSmooth(system, belief, Array(2160).fill(Array(M).fill(0)), Array(2160).fill(Array(P).fill(0))),
  'Timeline.reading, 16 states, 8 outputs, late by 9999': fullTimeline(),
  'ExtendedKalmanFilter, 16 states, 8 outputs, a step': ownModels(core.ExtendedKalmanFilter),
  'UnscentedKalmanFilter, 16 states, 8 outputs, a step': ownModels(core.UnscentedKalmanFilter),
  'observability, 16 states, 8 outputs': () => core.observability(F, system.H),
  'errorEigenvalues, 16 states': () => core.errorEigenvalues(system, diagonal(N, P, 0.3)),
  'placeObserverGain, 16 states': () =>
    core.placeObserverGain(
      ring,
      [diagonal(1, N, 1)[0]],
      Array.from({ length: N }, (_, i) => 0.9 - i / 40),
    ),
  'EkfLocalizer.replay, 1 000 000 steps, 1000 landmarks': () =>
    new core.EkfLocalizer(pose, beacons(1000), {
      W: [
        [1, 0],
        [0, 1],
      ],
      gate: null,
      sensor: 'range-bearing',
    }).replay(log, ids, diagonal(3, 3, 1e-4)),
  'EkfLocalizer.update, 1000 landmarks to choose from': () =>
    new core.EkfLocalizer(pose, beacons(1000), {
      W: [
        [1, 0],
        [0, 1],
      ],
      gate: null,
      sensor: 'range-bearing',
    }).update({ range: 10, bearing: 3 }),
  'EkfSlam.update, 500 landmarks, 100 sightings': greatMap(),
  'ObservabilityProbe.frame, its map full': fullProbe(),
  chapterChecks: () => core.chapterChecks(),
}
for (const [name, Lab] of Object.entries({
  OdometryHook: core.OdometryHook,
  ObserverBench: core.ObserverBench,
  Picture: core.Picture,
  ObservabilityProbe: core.ObservabilityProbe,
})) {
  calls[`${name}, 1000 steps of its default run`] = () => {
    const lab = new Lab()
    lab.run(1000)
    lab.free()
  }
}

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]
console.log('Calls at their greatest sizes, milliseconds')
for (const [name, call] of Object.entries(calls)) {
  const times = Array.from({ length: 3 }, () => {
    const start = process.hrtime.bigint()
    try {
      call()
    } catch (error) {
      return `refused: ${error.code} ${error.argument}`
    }
    return Number(process.hrtime.bigint() - start) / 1e6
  })
  const refused = times.find((time) => typeof time === 'string')
  console.log(`  ${name.padEnd(56)} ${refused ?? median(times).toFixed(1).padStart(8)}`)
}
