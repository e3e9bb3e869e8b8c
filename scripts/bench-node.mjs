// Times the module in Node against hand-unrolled JavaScript and against the same code run natively: five interleaved
// rounds, medians, ratios. The JavaScript filters are here only, to be measured against; the page has none.
import { execFileSync } from 'node:child_process'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const ROUNDS = 5
const reading = (step) => (step % 7) * 0.3 - 0.9

/** Nanoseconds a call of `body(steps)`. */
function time(steps, body) {
  const start = process.hrtime.bigint()
  body(steps)
  return Number(process.hrtime.bigint() - start) / steps
}

// ── The 2-state Kalman step of the rail robot, position sensor ──
const system = { F: [[1, 0.5], [0, 1]], G: [[0], [0.5]], H: [[1, 0]], V: [[0.2, 0.05], [0.05, 0.1]], W: [[0.5]] }

/** Unrolled by hand, Joseph form, numbers in local variables. */
function kalmanInJavaScript(steps) {
  let x1 = 2, x2 = 4, p11 = 1, p12 = 0, p22 = 2
  for (let step = 0; step < steps; step++) {
    const u = 0.1, y = reading(step), t = 0.5
    x1 += t * x2
    x2 += 0.5 * u
    const q12 = p12 + t * p22
    p11 = p11 + t * p12 + t * q12 + 0.2
    p12 = q12 + 0.05
    p22 += 0.1
    const s = p11 + 0.5, k1 = p11 / s, k2 = p12 / s, nu = y - x1
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
  let belief = { x: [2, 4], P: [[1, 0], [0, 2]] }
  for (let step = 0; step < steps; step++) belief = core.kalmanStep(system, belief, [0.1], [reading(step)])
  return belief.x
}

{
  const [a, b] = [kalmanInJavaScript(500), kalmanPerCall(500)]
  if (Math.hypot(a[0] - b[0], a[1] - b[1]) > 1e-9) throw new Error(`the two filters disagree: ${a} and ${b}`)
}

const bodies = {
  'Kalman step, JavaScript': () => time(2_000_000, kalmanInJavaScript),
  'Kalman step, module, one call a step': () => time(50_000, kalmanPerCall),
  'Observer Bench step, module, batched': () => time(20_000, (steps) => {
    const lab = new core.ObserverBench()
    lab.run(steps)
    lab.free()
  }),
}

execFileSync('cargo', ['build', '--release', '--quiet', '--example', 'pace', '-p', 'labs'], { cwd: root, stdio: 'inherit' })
const pace = path.join(process.env.CARGO_TARGET_DIR ?? path.join(root, 'target'), 'release/examples/pace')
const native = { kalmanStep: 'Kalman step, native', ObserverBench: 'Observer Bench step, native' }

const times = new Map()
const note = (name, ns) => times.set(name, [...(times.get(name) ?? []), ns])
for (const body of Object.values(bodies)) body()
for (let round = 0; round < ROUNDS; round++) {
  for (const [name, body] of Object.entries(bodies)) note(name, body())
  const paces = JSON.parse(execFileSync(pace, { encoding: 'utf8' }))
  for (const [name, ns] of Object.entries(paces)) note(native[name] ?? `${name} step, native`, ns)
}
const median = (name) => times.get(name).sort((a, b) => a - b)[ROUNDS >> 1]

console.log(`\nMedians of ${ROUNDS} interleaved rounds, ns\n`)
for (const name of times.keys()) console.log(`${name.padEnd(44)} ${median(name).toFixed(1).padStart(10)}`)
const ratio = (a, b) => (median(a) / median(b)).toFixed(2)
console.log('\nRatios')
console.log(`Observer Bench step, module batched / native    ${ratio('Observer Bench step, module, batched', 'Observer Bench step, native')}`)
console.log(`Kalman step, native / JavaScript                ${ratio('Kalman step, native', 'Kalman step, JavaScript')}`)
console.log(`Kalman step, module per call / JavaScript       ${ratio('Kalman step, module, one call a step', 'Kalman step, JavaScript')}`)
