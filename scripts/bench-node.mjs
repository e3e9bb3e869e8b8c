// Times the module in Node against hand-unrolled JavaScript and against the same code run natively: five interleaved
// rounds, medians, ratios; where there is a goal, whether it is met. The JavaScript filters are here only, to be
// measured against; the page has none.
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const ROUNDS = 5
const WARM = 8
const reading = (step) => (step % 7) * 0.3 - 0.9

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

/** Unrolled by hand, Joseph form, numbers in local variables. */
function kalmanInJavaScript(steps) {
  let x1 = 2,
    x2 = 4,
    p11 = 1,
    p12 = 0,
    p22 = 2
  for (let step = 0; step < steps; step++) {
    const u = 0.1,
      y = reading(step),
      t = 0.5
    x1 += t * x2
    x2 += 0.5 * u
    const q12 = p12 + t * p22
    p11 = p11 + t * p12 + t * q12 + 0.2
    p12 = q12 + 0.05
    p22 += 0.1
    const s = p11 + 0.5,
      k1 = p11 / s,
      k2 = p12 / s,
      nu = y - x1
    x1 += k1 * nu
    x2 += k2 * nu
    const a = 1 - k1
    const n11 = a * a * p11 + k1 * k1 * 0.5
    const n12 = a * (p12 - k2 * p11) + k1 * k2 * 0.5
    const n22 = p22 - 2 * k2 * p12 + k2 * k2 * p11 + k2 * k2 * 0.5
    p11 = n11
    p12 = n12
    p22 = n22
  }
  return [x1, x2]
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
const start = {
  x: [1.5, 1.5, 0],
  P: [
    [0.01, 0, 0],
    [0, 0.01, 0],
    [0, 0, 0.01],
  ],
}
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
const landmark = { id: 1, x: 6, y: 6 }
const [range, bearing] = [6.363961, -2.3561945]

/** Unrolled by hand, Joseph form, numbers in local variables. */
function ekfInJavaScript(steps) {
  const { cos, sin, hypot, atan2, PI, floor } = Math
  const wrap = (a) => a - 2 * PI * floor((a + PI) / (2 * PI))
  let [x, y, th] = start.x
  let a = 0.01,
    b = 0,
    c = 0,
    d = 0.01,
    e = 0,
    f = 0.01
  const ds = 0,
    dth = 0
  for (let step = 0; step < steps; step++) {
    const fx = -ds * sin(th),
      fy = ds * cos(th)
    x += ds * cos(th)
    y += ds * sin(th)
    th = wrap(th + dth)
    const c2 = c + fx * f,
      e2 = e + fy * f
    a = a + fx * c + fx * c2 + 1e-4
    b = b + fx * e + fy * c2
    d = d + fy * e + fy * e2 + 1e-4
    c = c2
    e = e2
    f += 1e-4
    const dx = x - landmark.x,
      dy = y - landmark.y,
      rho = hypot(dx, dy)
    const h0 = dx / rho,
      h1 = dy / rho,
      g0 = -h1 / rho,
      g1 = h0 / rho
    const n0 = range - rho,
      n1 = wrap(bearing - wrap(atan2(dy, dx) - th))
    const m00 = a * h0 + b * h1,
      m10 = b * h0 + d * h1,
      m20 = c * h0 + e * h1
    const m01 = a * g0 + b * g1 - c,
      m11 = b * g0 + d * g1 - e,
      m21 = c * g0 + e * g1 - f
    const s00 = h0 * m00 + h1 * m10 + 0.01,
      s01 = h0 * m01 + h1 * m11,
      s11 = g0 * m01 + g1 * m11 - m21 + 0.001
    const det = s00 * s11 - s01 * s01
    const i00 = s11 / det,
      i01 = -s01 / det,
      i11 = s00 / det
    const k00 = m00 * i00 + m01 * i01,
      k01 = m00 * i01 + m01 * i11
    const k10 = m10 * i00 + m11 * i01,
      k11 = m10 * i01 + m11 * i11
    const k20 = m20 * i00 + m21 * i01,
      k21 = m20 * i01 + m21 * i11
    x += k00 * n0 + k01 * n1
    y += k10 * n0 + k11 * n1
    th = wrap(th + k20 * n0 + k21 * n1)
    const t00 = 1 - k00 * h0 - k01 * g0,
      t01 = -k00 * h1 - k01 * g1,
      t02 = k01
    const t10 = -k10 * h0 - k11 * g0,
      t11 = 1 - k10 * h1 - k11 * g1,
      t12 = k11
    const t20 = -k20 * h0 - k21 * g0,
      t21 = -k20 * h1 - k21 * g1,
      t22 = 1 + k21
    const u00 = t00 * a + t01 * b + t02 * c,
      u01 = t00 * b + t01 * d + t02 * e,
      u02 = t00 * c + t01 * e + t02 * f
    const u10 = t10 * a + t11 * b + t12 * c,
      u11 = t10 * b + t11 * d + t12 * e,
      u12 = t10 * c + t11 * e + t12 * f
    const u20 = t20 * a + t21 * b + t22 * c,
      u21 = t20 * b + t21 * d + t22 * e,
      u22 = t20 * c + t21 * e + t22 * f
    a = u00 * t00 + u01 * t01 + u02 * t02 + 0.01 * k00 * k00 + 0.001 * k01 * k01
    b = u00 * t10 + u01 * t11 + u02 * t12 + 0.01 * k00 * k10 + 0.001 * k01 * k11
    c = u00 * t20 + u01 * t21 + u02 * t22 + 0.01 * k00 * k20 + 0.001 * k01 * k21
    d = u10 * t10 + u11 * t11 + u12 * t12 + 0.01 * k10 * k10 + 0.001 * k11 * k11
    e = u10 * t20 + u11 * t21 + u12 * t22 + 0.01 * k10 * k20 + 0.001 * k11 * k21
    f = u20 * t20 + u21 * t21 + u22 * t22 + 0.01 * k20 * k20 + 0.001 * k21 * k21
  }
  return [x, y, th, a, b, c, d, e, f]
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
  ChosetEkf: 'EKF step, native',
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
  for (const [name, ns] of Object.entries(paces)) note(native[name], ns)
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
