// What a figure says of its state is true of it: every sentence of a verdict is one of the claims below, and each claim is held
// against the frame that the sentence speaks of, over a grid of parameters and steps, just-reset states among them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { WIDGETS } from '../../web/widgets/index.js'

const estimate = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const LOG = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const number = (text) => Number(text.replace('\u2212', '-').replace('∞', 'Infinity'))
/** Whether a printed number is this value, rounded. */
const prints = (text, value) => Math.abs(number(text) - value) <= 0.51 * 10 ** -(text.split('.')[1]?.length ?? 0) + 1e-9 * Math.abs(value)

/** Every choice of one value for each name. @returns {Record<string, unknown>[]} */
function grid(axes) {
  return Object.entries(axes).reduce((all, [name, values]) => all.flatMap((one) => values.map((value) => ({ ...one, [name]: value }))), [{}])
}

/** The frames of a widget's lab over a grid. */
function* frames(spec, axes, steps) {
  for (const params of grid(axes)) {
    let lab = estimate[spec.lab].from({ version: 1, lab: spec.name, step: 0, params })
    for (const step of steps) {
      if (step > lab.state().step) lab.run(step - lab.state().step)
      yield lab.frame()
    }
    lab.free()
  }
}

/** Sentences: a full stop within a number ends none. */
const sentences = (text) => text.split(/(?<=\.)\s+/)

/** Says what of a widget's words is false of its frames. */
function falsehoods(spec, all, claims) {
  const found = new Set()
  for (const frame of all) {
    const where = `${JSON.stringify(frame.params)} at step ${frame.step}`
    const words = spec.verdict(frame)
    for (const sentence of sentences(words)) {
      const claim = claims.filter(([pattern]) => pattern.test(sentence))
      if (claim.length !== 1) found.add(`“${sentence}” is none of the claims, or several; ${where}`)
      else if (!claim[0][1](frame, ...sentence.match(claim[0][0]).slice(1))) found.add(`“${sentence}” is false; ${where}`)
    }
    const others = [...Object.values(spec.describe(frame)), spec.announce(frame, frame), spec.announce(frame, { ...frame, step: frame.step + 1 })]
    for (const said of [words, ...others]) {
      if (/undefined|NaN|null|\[object|\d{5}|  |\b1 (steps|ticks|laps|directions)\b/.test(said)) found.add(`“${said}” is no sentence; ${where}`)
    }
  }
  return [...found].slice(0, 12)
}

const check = (tag, axes, steps, claims) => test(`what the ${tag} says is true, in every state`, async () => {
  const spec = await WIDGETS[tag]()
  const all = [...frames(spec, axes, steps)]
  assert.ok(all.length > 60)
  assert.deepEqual(falsehoods(spec, all, claims(spec)), [])
})

/** The modulus of the largest eigenvalue that a gain moves. */
const moving = ({ pinned, modulus, spectralRadius }) => (pinned === null ? spectralRadius : modulus[1 - pinned])
const many = (word) => ['no', 'one', 'two', 'three'].indexOf(word.toLowerCase())

check('observer-bench', {
  sensor: ['velocity', 'position'], mode: ['fixed', 'filter'], seed: [1, 7],
  gain: [0, 0.01, 0.5, 1, 2.99, 3.02, 3.028947959635742, 3.03, 3.05, 5.57, 5.58257569495584, 5.59, 6],
}, [0, 1, 2, 12, 30, 400], () => [
  [/^The estimate has left every bound, and the run has stopped\.$/, ({ diverged }) => diverged],
  [/^Turn the gain below ([\d.]+)\.$/, ({ stableUpTo, diverged }, limit) => diverged && prints(limit, stableUpTo)],
  [/^Dead reckoning: no reading is used, and nothing takes an error back\.$/, ({ params, R }) => params.mode === 'fixed' && R.every((entry) => entry === 0)],
  [/^At the limit of stability: the factor a step is 1\.000, and an error neither dies out nor grows\.$/, (frame) => Math.abs(moving(frame) - 1) < 6e-4 && frame.params.mode === 'fixed'],
  [/^Unstable: in the long run the error grows by the factor ([\d.]+) a step\.$/, (frame, factor) => !frame.stable && number(factor) > 1 && prints(factor, moving(frame)) && frame.params.mode === 'fixed'],
  [/^Stable: in the long run every error shrinks by the factor ([\d.]+) a step\.$/, (frame, factor) => frame.stable && frame.pinned === null && number(factor) < 1 && prints(factor, frame.spectralRadius) && frame.params.mode === 'fixed'],
  [/^A velocity error shrinks by the factor ([\d.]+) a step\.$/, (frame, factor) => frame.stable && frame.pinned !== null && number(factor) < 1 && prints(factor, moving(frame)) && frame.params.mode === 'fixed'],
  [/^The other eigenvalue is 1 for every gain: no gain takes a position error back\.$/, ({ pinned, modulus }) => pinned !== null && Math.abs(modulus[pinned] - 1) < 1e-9],
  [/^If the filter kept this step's gain, (every|a velocity) error would shrink by the factor ([\d.]+) a step in the long run\.$/, (frame, which, factor) => frame.params.mode === 'filter' && (which === 'every') === (frame.pinned === null) && number(factor) < 1 && prints(factor, moving(frame))],
])

check('odometry-hook', {
  bias: [0, 0.0005, 0.005, 0.01], slip: [0, 0.001, 0.005], fixes: [false, true], seed: [1, 3],
}, [0, 1, 5, 40, 160, 640, 1300], () => {
  const off = (frame, words, kind) => {
    const value = kind === 'heading' ? Math.abs(frame.error.heading * 180) / Math.PI : frame.error.position
    const ratio = frame.ratio[kind]
    const [, printed, rest] = words.match(/^off by ([\d.]+)(?: m|°), (.*)$/) ?? []
    if (!printed || !prints(printed, value)) return false
    if (rest === 'and the filter claims no error at all') return ratio === null
    if (rest === 'about the σ it claims') return ratio > 0.94 && ratio < 1.06
    if (rest === 'within the σ it claims') return ratio < 1
    const [, times] = rest.match(/^([\d.]+) times the σ it claims$/) ?? []
    return times !== undefined && ratio > 1 && prints(times, ratio)
  }
  return [
    [/^At the start the pose is known exactly\.$/, ({ step, error, sigma }) => step === 0 && error.position === 0 && sigma.position === 0],
    [/^Dead reckoning: the position is (off [^:]*)(: the error has outrun the ellipse)?\.$/, (frame, words, outrun) => !frame.params.fixes && off(frame, words, 'position') && (outrun === undefined || (frame.error.position > 0.005 && (frame.ratio.position === null || frame.ratio.position > 2)))],
    [/^No corner seen yet: the position is (off .*)\.$/, (frame, words) => frame.params.fixes && frame.lastSighting === null && off(frame, words, 'position')],
    [/^With fixes, the position is (off .*)\.$/, (frame, words) => frame.params.fixes && frame.lastSighting !== null && off(frame, words, 'position')],
    [/^The heading is (off .*)\.$/, (frame, words) => off(frame, words, 'heading')],
  ]
})

check('kalman-picture', {
  mean: [[4, 4], [4, 2.7], [-3, 6]], semiMajor: [0.15, 1.005, 1.7230432137127605, 3], semiMinor: [0.15, 1, 3],
  angle: [0, 0.8795089160498338, Math.PI / 2], reading: [-8, 2.7, 4], noise: [0, 0.5, 4], tilt: [-Math.PI / 2, -0.7, 0, 0.3],
}, [0], () => {
  const apart = ({ euclideanFoot: a, mahalanobisFoot: b }) => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])
  return [
    [/^The gray foot is ([\d.]+) standard deviations away, the purple one ([\d.]+)\.$/, (frame, gray, purple) => prints(gray, frame.euclideanFoot.distance) && prints(purple, frame.mahalanobisFoot.distance)],
    [/^The ellipse is a circle: both metrics agree, and the two feet are one point\.$/, (frame) => Math.abs(frame.P[0][0] - frame.P[1][1]) < 1e-9 && Math.abs(frame.P[0][1]) < 1e-9 && apart(frame) < 1e-9],
    [/^The two feet are one point here, to two decimals\.$/, (frame) => apart(frame) < 0.0051],
    [/^The reading is the one expected: there is nothing to correct\.$/, (frame) => Math.abs(frame.innovation) < 5e-4 && Math.hypot(...frame.posterior.x.map((value, i) => value - frame.params.mean[i])) < 5e-3],
    [/^The sensor is perfect: Ω and Ω\* are one line\.$/, (frame) => frame.params.noise === 0 && Math.abs(frame.mostLikelyOutput - frame.params.reading) < 1e-9],
  ]
})

const landmarks = [[[6, 6], [0, 6], [3, 0]], [[1.5, 1.5], [4.5, 4.5], [3, 3]], [[1.5, 4.5], [0, 0], [6, 0]]]
check('observability-probe', {
  landmarks, count: [1, 2, 3], sensor: ['range', 'range-bearing'], stop: [null, 1, 20], forget: [false, true], tolerance: [0, 1e-6, 0.3, 1],
}, [0, 1, 2, 15, 60, 240], () => [
  [/^(\w+) landmarks?, (range only|range and bearing): rank (\d) frozen at this pose(?:, (\d) along the last (?:(\d+) steps|step))?\.$/, (frame, count, sensor, frozen, path, steps) =>
    !frame.slam && many(count) === frame.params.count && (sensor === 'range only') === (frame.sensor === 'range') && Number(frozen) === frame.frozen.rank
    && (path === undefined ? frame.alongPath.steps === 0 : Number(path) === frame.alongPath.rank && Number(steps ?? 1) === frame.alongPath.steps)],
  [/^No path is driven yet, so there is no rank along it\.$/, ({ alongPath, step }) => alongPath.steps === 0 && step === 0],
  [/^Every direction of the pose is seen\.$/, ({ frozen, alongPath }) => frozen.rank === 3 && alongPath.rank === 3],
  [/^This pose alone hides (\w+) directions?, and the path has shown (?:it|them)\.$/, ({ frozen, alongPath }, hidden) => alongPath.rank === 3 && many(hidden) === 3 - frozen.rank],
  [/^The frozen test is too kind: turn the pose about the landmark, and no reading changes\.$/, ({ params, frozen, alongPath }) => params.count === 1 && frozen.rank === 3 && alongPath.rank < 3 && alongPath.steps > 0],
  [/^The frozen test counts (\w+) directions? more than the path has shown\.$/, ({ frozen, alongPath }, more) => frozen.rank === 3 && many(more) === 3 - alongPath.rank && alongPath.steps > 0],
  [/^(\w+) directions? of the pose (?:is|are) hidden: no reading along the path changes with (?:it|them)\.$/, ({ frozen, alongPath }, hidden) => frozen.rank < 3 && many(hidden) === 3 - alongPath.rank && alongPath.relative.slice(alongPath.rank).every((value) => value < 1e-9)],
  [/^(\w+) directions? of the pose (?:falls|fall) below the tolerance\.$/, ({ frozen, alongPath }, hidden) => frozen.rank < 3 && many(hidden) === 3 - alongPath.rank && alongPath.relative.slice(alongPath.rank).some((value) => value >= 1e-9)],
  [/^The map is forgotten: (\d+) founded, (\d+) matched, (\d+) rejected\.$/, ({ slam }, founded, matched, rejected) => slam && slam.founded === Number(founded) && slam.matched === Number(matched) && slam.rejected === Number(rejected)],
  [/^The worst stands ([\d.]+) m off, ([\d.]+) of its own σ\.$/, ({ slam }, error, sigma) => prints(error, slam.worst.error) && prints(sigma, slam.worst.sigma)],
  [/^The map is full: it founds no more\.$/, ({ slam }) => slam.full],
])

test('to put the last landmark in line puts it in line, however many are shown', async () => {
  const spec = await WIDGETS['observability-probe']()
  const line = [...spec.controls, ...(spec.tries ?? [])].find(({ name }) => name === 'line')
  for (const count of [1, 2, 3]) {
    const lab = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params: { count } })
    const params = { ...lab.frame().params, ...line.change(lab.frame(), lab) }
    const { estimate: [x, y], frozen, params: { count: shown } } = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params }).frame()
    assert.equal(shown, Math.max(2, count))
    if (shown === 2) assert.equal(frozen.rank, 2, `with ${count} shown`)
    // Of three the last one stands in line with the robot and one of the others.
    const [px, py] = params.landmarks[shown - 1]
    const off = params.landmarks.slice(0, shown - 1).map(([qx, qy]) => Math.abs((px - x) * (qy - y) - (py - y) * (qx - x)))
    assert.ok(Math.min(...off) < 1e-3, `with ${count} shown it is off by ${off}`)
  }
})

test('no readout of a figure is empty or wrong in kind, in any state', async () => {
  for (const load of Object.values(WIDGETS)) {
    const spec = await load()
    const open = (state) => spec.lab === 'RobotLog' ? estimate.RobotLog.from(estimate.RobotLog.parse(LOG), state) : estimate[spec.lab].from(state)
    for (const step of spec.timeless ? [0] : [0, 1, 300]) {
      const lab = open({ version: 1, lab: spec.name, step, params: spec.start.params })
      for (const { key, value } of spec.readouts(lab.frame())) assert.doesNotMatch(`${key}: ${value}`, /undefined|NaN|null|: $/)
    }
  }
})
