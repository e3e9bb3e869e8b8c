// Times the module in Node against hand-unrolled JavaScript and against the same code run natively: five interleaved
// rounds, medians, ratios; where there is a goal, whether it is met.
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { bearing, ekfInJavaScript, kalmanInJavaScript, landmark, range, reading, start } from './bench-unrolled.mjs'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const ROUNDS = 5
const WARM = 8

/** Nanoseconds a call of `body(steps)`. */
function time(steps, body) {
  const start = process.hrtime.bigint()
  body(steps)
  return Number(process.hrtime.bigint() - start) / steps
}

// ── The 2-state Kalman step of the rail robot, position sensor ──
const system = {
  F: [
    [1, 0.5],
    [0, 1],
  ],
  G: [[0], [0.5]],
  H: [[1, 0]],
  V: [
    [0.2, 0.05],
    [0.05, 0.1],
  ],
  W: [[0.5]],
}

function kalmanPerCall(steps) {
  let belief = rail
  for (let step = 0; step < steps; step++) belief = core.kalmanStep(system, belief, [0.1], [reading(step)])
  return belief.x
}

const rail = {
  x: [2, 4],
  P: [
    [1, 0],
    [0, 2],
  ],
}
/** Short enough to stay near the processor. */
const LOG = 5_000
const drive = {
  inputs: new Float64Array(LOG).fill(0.1),
  readings: Float64Array.from({ length: LOG }, (_, k) => reading(k)),
}
const kalmanOfALog = () => core.kalmanReplay(system, rail, drive.inputs, drive.readings).x.subarray(-2)

{
  const [a, b, c] = [kalmanInJavaScript(LOG), kalmanPerCall(LOG), kalmanOfALog()]
  for (const other of [b, c]) {
    if (Math.hypot(a[0] - other[0], a[1] - other[1]) > 1e-9) throw new Error(`two filters disagree: ${a} and ${other}`)
  }
}

// ── The 3-state EKF step of the localizer: predict, and one range–bearing sighting of a named landmark ──
const noise = {
  V: [
    [1e-4, 0, 0],
    [0, 1e-4, 0],
    [0, 0, 1e-4],
  ],
  W: [
    [0.01, 0],
    [0, 0.001],
  ],
}
const localizer = () => new core.EkfLocalizer(start, [landmark], { W: noise.W, sensor: 'range-bearing' })
const log = (steps) => Float64Array.from({ length: 4 * steps }, (_, i) => [0, 0, range, bearing][i % 4])
const ids = (steps) => new Uint32Array(steps).fill(1)
/** At rest, every reading as expected: one filter can replay it for ever. */
const logs = { numbers: log(LOG), ids: ids(LOG), ekf: localizer() }

{
  const ekf = localizer()
  ekf.replay(log(500), ids(500), noise.V)
  const { x, P } = ekf.belief()
  const ours = [...x, P[0][0], P[0][1], P[0][2], P[1][1], P[1][2], P[2][2]]
  const theirs = ekfInJavaScript(500)
  if (!ours.every((value, i) => Math.abs(value - theirs[i]) < 1e-9))
    throw new Error(`the two EKFs disagree: ${ours} and ${theirs}`)
  ekf.free()
}

// ── SLAM: predict and one sighting with n landmarks in the map ──
const SIZES = [3, 30, 100, 300, 500]
const sighting = (j) => ({ range: 3 + 0.5 * j, bearing: 2.4 * j, landmark: j })
const still = [
  [1e-6, 0, 0],
  [0, 1e-6, 0],
  [0, 0, 1e-6],
]
const maps = SIZES.map((n) => {
  const slam = new core.EkfSlam(
    {
      x: [0, 0, 0],
      P: [
        [1e-4, 0, 0],
        [0, 1e-4, 0],
        [0, 0, 1e-4],
      ],
    },
    {
      W: [
        [0.01, 0],
        [0, 0.0009],
      ],
      gate: 9.21,
      found: 50,
    },
  )
  for (let j = 0; j < n; j++) slam.update(sighting(j))
  return slam
})
const mapping = (i) =>
  time(Math.floor(2_000_000 / (SIZES[i] ** 2 + 1000)) + 20, (steps) => {
    const reading = sighting(SIZES[i] >> 1)
    for (let step = 0; step < steps; step++) {
      maps[i].predict([0, 0], still)
      if (maps[i].update(reading).outcome !== 'matched') throw new Error('the sighting was not matched')
    }
  })

const bodies = {
  'Kalman step, JavaScript': () => time(2_000_000, kalmanInJavaScript),
  'Kalman step, module, one call a step': () => time(50_000, kalmanPerCall),
  'Kalman step of a log, module': () =>
    time(100 * LOG, () => {
      for (let i = 0; i < 100; i++) kalmanOfALog()
    }),
  'Observer Bench step, module, batched': () =>
    time(20_000, (steps) => {
      const lab = new core.ObserverBench()
      lab.run(steps)
      lab.free()
    }),
  'EKF step, JavaScript': () => time(500_000, ekfInJavaScript),
  'EKF step of a log, module': () =>
    time(20 * LOG, () => {
      for (let i = 0; i < 20; i++) logs.ekf.replay(logs.numbers, logs.ids, noise.V)
    }),
  'EKF step, module, two calls a step': () =>
    time(20_000, (steps) => {
      const ekf = localizer()
      for (let step = 0; step < steps; step++) {
        ekf.predict([0, 0], noise.V)
        ekf.update({ range, bearing, landmark: 1 })
      }
      ekf.free()
    }),
  ...Object.fromEntries(SIZES.map((n, i) => [`SLAM, ${n} landmarks, module`, () => mapping(i)])),
}

execFileSync('cargo', ['build', '--release', '--quiet', '--example', 'pace', '-p', 'labs'], {
  cwd: root,
  stdio: 'inherit',
})
const pace = path.join(process.env.CARGO_TARGET_DIR ?? path.join(root, 'target'), 'release/examples/pace')
const native = {
  kalmanStep: 'Kalman step, native',
  kalmanReplay: 'Kalman step of a log, native',
  ObserverBench: 'Observer Bench step, native',
  Localizer: 'EKF step, native',
  EkfLocalizer: 'EKF step of a log, native',
  'dense 100': 'SLAM, 100 landmarks, dense algebra, native',
  ...Object.fromEntries(SIZES.map((n) => [`EkfSlam ${n}`, `SLAM, ${n} landmarks, native`])),
}

const times = new Map()
const note = (name, ns) => times.set(name, [...(times.get(name) ?? []), ns])
// The engine takes its time to compile well what runs often: a body is warm when more rounds make it no faster.
for (const body of Object.values(bodies)) for (let i = 0; i < WARM; i++) body()
for (let round = 0; round < ROUNDS; round++) {
  for (const [name, body] of Object.entries(bodies)) note(name, body())
  const paces = JSON.parse(execFileSync(pace, { encoding: 'utf8' }))
  for (const [name, ns] of Object.entries(paces)) {
    if (!native[name]) throw new Error(`${pace} times “${name}”, which is called nothing here.`)
    note(native[name], ns)
  }
}
const median = (name) => times.get(name).sort((a, b) => a - b)[ROUNDS >> 1]

console.log(`\nMedians of ${ROUNDS} interleaved rounds, ns\n`)
for (const name of times.keys()) console.log(`${name.padEnd(44)} ${median(name).toFixed(1).padStart(10)}`)
const ratio = (a, b) => (median(a) / median(b)).toFixed(2)
/** The slope of ln time over ln n from 100 landmarks on, by least squares. */
function growth(where) {
  const points = SIZES.filter((n) => n >= 100).map((n) => [
    Math.log(n),
    Math.log(median(`SLAM, ${n} landmarks, ${where}`)),
  ])
  const mean = (i) => points.reduce((sum, point) => sum + point[i], 0) / points.length
  const [x, y] = [mean(0), mean(1)]
  return (
    points.reduce((sum, p) => sum + (p[0] - x) * (p[1] - y), 0) / points.reduce((sum, p) => sum + (p[0] - x) ** 2, 0)
  ).toFixed(2)
}
/** @type {[what: string, value: string | number, goal?: number][]} */
const rows = [
  ['Kalman step of a log, module / native', ratio('Kalman step of a log, module', 'Kalman step of a log, native'), 1.8],
  ['Kalman step of a log, module / JavaScript', ratio('Kalman step of a log, module', 'Kalman step, JavaScript'), 4],
  [
    'Observer Bench step, module batched / native',
    ratio('Observer Bench step, module, batched', 'Observer Bench step, native'),
  ],
  ['Kalman step, native / JavaScript', ratio('Kalman step, native', 'Kalman step, JavaScript')],
  [
    'Kalman step, module per call / JavaScript',
    ratio('Kalman step, module, one call a step', 'Kalman step, JavaScript'),
  ],
  ['EKF step, native / JavaScript', ratio('EKF step, native', 'EKF step, JavaScript')],
  ['EKF step of a log, native / JavaScript', ratio('EKF step of a log, native', 'EKF step, JavaScript')],
  ['EKF step of a log, module / JavaScript', ratio('EKF step of a log, module', 'EKF step, JavaScript'), 1],
  ['EKF step, module per call / JavaScript', ratio('EKF step, module, two calls a step', 'EKF step, JavaScript')],
  [
    'SLAM, 100 landmarks, dense / ours, native',
    ratio('SLAM, 100 landmarks, dense algebra, native', 'SLAM, 100 landmarks, native'),
  ],
  ['SLAM, 100 landmarks, module / native', ratio('SLAM, 100 landmarks, module', 'SLAM, 100 landmarks, native')],
  ['SLAM, growth from 100 to 500 landmarks, native: n to the', growth('native')],
  ['SLAM, growth from 100 to 500 landmarks, module: n to the', growth('module')],
]
console.log('\nRatios')
for (const [what, value, goal] of rows) {
  const judged = goal === undefined ? '' : `  (goal: at most ${goal}, ${Number(value) <= goal ? 'met' : 'missed'})`
  console.log(`${what.padEnd(58)} ${value}${judged}`)
}
