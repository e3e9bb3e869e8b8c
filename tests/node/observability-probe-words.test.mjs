// What the Observability Probe says of ranks, maps and its ghost is true of its frames.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { check, estimate, prints, widget, pattern } from './claims.mjs'
import { marksOf } from './marks.mjs'

const many = (word) => ['no', 'one', 'two', 'three'].indexOf(word.toLowerCase())

const landmarks = [
  [
    [6, 6],
    [0, 6],
    [3, 0],
  ],
  [
    [1.5, 1.5],
    [4.5, 4.5],
    [3, 3],
  ],
  [
    [1.5, 4.5],
    [0, 0],
    [6, 0],
  ],
]
check(
  'observability-probe',
  {
    landmarks,
    count: [1, 2, 3],
    sensor: ['range', 'range-bearing'],
    stop: [null, 1, 20],
    forget: [false, true],
    tolerance: [0, 1e-6, 0.3, 1],
  },
  [0, 1, 2, 15, 60, 240],
  () => [
    [
      pattern(
        /^(\w+) landmarks?, (range only|range and bearing): /,
        /rank (\d) frozen at this pose(?:, (\d) along the last (?:(\d+) steps|step))?\.$/,
      ),
      (frame, count, sensor, frozen, path, steps) =>
        !frame.slam &&
        many(count) === frame.params.count &&
        (sensor === 'range only') === (frame.sensor === 'range') &&
        Number(frozen) === frame.frozen.rank &&
        (path === undefined
          ? frame.alongPath.steps === 0
          : Number(path) === frame.alongPath.rank && Number(steps ?? 1) === frame.alongPath.steps),
    ],
    [
      /^No path is driven yet, so there is no rank along it\.$/,
      ({ alongPath, step }) => alongPath.steps === 0 && step === 0,
    ],
    [/^Every direction of the pose is seen\.$/, ({ frozen, alongPath }) => frozen.rank === 3 && alongPath.rank === 3],
    [
      /^This pose alone hides (\w+) directions?, and the path has shown (?:it|them)\.$/,
      ({ frozen, alongPath }, hidden) => alongPath.rank === 3 && many(hidden) === 3 - frozen.rank,
    ],
    [
      /^The frozen test is too kind: turn the pose about the landmark, and no reading changes\.$/,
      ({ params, frozen, alongPath }) =>
        params.count === 1 && frozen.rank === 3 && alongPath.rank < 3 && alongPath.steps > 0,
    ],
    [
      /^The frozen test counts (\w+) directions? more than the path has shown\.$/,
      ({ frozen, alongPath }, more) => frozen.rank === 3 && many(more) === 3 - alongPath.rank && alongPath.steps > 0,
    ],
    [
      /^(\w+) directions? of the pose (?:is|are) hidden: no reading along the path changes with (?:it|them)\.$/,
      ({ frozen, alongPath }, hidden) =>
        frozen.rank < 3 &&
        many(hidden) === 3 - alongPath.rank &&
        alongPath.relative.slice(alongPath.rank).every((value) => value < 1e-9),
    ],
    [
      /^(\w+) directions? of the pose (?:falls|fall) below the tolerance\.$/,
      ({ frozen, alongPath }, hidden) =>
        frozen.rank < 3 &&
        many(hidden) === 3 - alongPath.rank &&
        alongPath.relative.slice(alongPath.rank).some((value) => value >= 1e-9),
    ],
    [
      /^The map is forgotten, and ranges with bearings found it anew: (\d+) founded, (\d+) matched, (\d+) rejected\.$/,
      ({ slam }, founded, matched, rejected) =>
        slam &&
        slam.founded === Number(founded) &&
        slam.matched === Number(matched) &&
        slam.rejected === Number(rejected),
    ],
    [
      /^The worst stands ([\d.]+) m off, ([\d.]+) of its own σ\.$/,
      ({ slam }, error, sigma) => prints(error, slam.worst.error) && prints(sigma, slam.worst.sigma),
    ],
    [/^The map is full: it founds no more\.$/, ({ slam }) => slam.full],
  ],
)

check(
  'observability-probe',
  {
    ghost: [true],
    count: [1, 2],
    sensor: ['range', 'range-bearing'],
    forget: [false, true],
    ghostAround: [0, 0.2, -0.1],
    ghostShift: [0, 0.5],
    ghostTurn: [0, 0.2, -0.1],
  },
  [0, 1, 60, 240],
  () => [
    [
      /^The ghost drives where the robot drives: turn one of its dials\.$/,
      ({ ghost, params }) =>
        [params.ghostAround, params.ghostShift, params.ghostTurn].every((dial) => dial === 0) &&
        ghost.rangeGap === 0 &&
        ghost.moved === 0,
    ],
    [/^The ghost has been up to ([\d.]+) m from the robot\.$/, ({ ghost }, moved) => prints(moved, ghost.moved)],
    [
      /^Its ranges differ by up to ([\d.]+) m(?: and its bearings by ([\d.]+)°)?\.$/,
      ({ ghost, sensor }, ranges, bearings) =>
        prints(ranges, ghost.rangeGap) &&
        (ghost.rangeGap > 1e-9 || ghost.bearingGap > 1e-9) &&
        (sensor === 'range') === (bearings === undefined) &&
        (bearings === undefined || prints(bearings, (ghost.bearingGap * 180) / Math.PI)),
    ],
    [
      /^The ghost begins ([\d.]+) m from the robot: let both drive\.$/,
      ({ ghost, step }, moved) => step === 0 && prints(moved, ghost.moved),
    ],
    [
      /^It reads what the robot reads: no filter can tell the two apart\.$/,
      ({ ghost, params, step }) =>
        step > 0 &&
        params.count === 1 &&
        ghost.rangeGap < 1e-9 &&
        params.ghostAround === params.ghostTurn &&
        params.ghostShift === 0 &&
        ghost.byHand.every(Number.isFinite),
    ],
    [
      /^The map is forgotten, and ranges with bearings found it anew: \d+ founded, \d+ matched, \d+ rejected\.$/,
      ({ slam, ghost }) => slam && !ghost,
    ],
    [/^The worst stands [\d.]+ m off, [\d.]+ of its own σ\.$/, ({ slam }) => slam.worst],
  ],
)

test('to put the last landmark in line leaves two, in line with the robot, however many were shown', async () => {
  const spec = await widget('observability-probe')
  const line = spec.tries.find(({ name }) => name === 'line')
  for (const count of [1, 2, 3]) {
    const lab = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params: { count } })
    const params = { ...lab.frame().params, ...line.change(lab.frame(), lab) }
    const {
      estimate: [x, y],
      frozen,
      params: { count: shown },
    } = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params }).frame()
    assert.deepEqual([shown, frozen.rank], [2, 2], `with ${count} shown`)
    const [[qx, qy], [px, py]] = params.landmarks
    const off = Math.abs((px - x) * (qy - y) - (py - y) * (qx - x))
    assert.ok(off < 1e-3, `with ${count} shown it is off by ${off}`)
  }
})

const frameAt = (params, step) => {
  const lab = estimate.ObservabilityProbe.from({ version: 1, lab: 'observability-probe', step, params })
  const frame = lab.frame()
  lab.free()
  return frame
}
const panelOf = async (name) => (await widget('observability-probe')).panels.find((panel) => panel.name === name)

test('no dot of a singular value hides another one', async () => {
  const { draw, ...size } = await panelOf('ranks')
  for (const params of [{ count: 2 }, { count: 3, sensor: 'range-bearing' }, { stop: 20 }, { tolerance: 1 }]) {
    const marks = marksOf(draw, size, frameAt(params, 240))
    for (const row of ['frozen', 'path']) {
      const dots = marks.filter(({ tag, key }) => tag === 'circle' && key.startsWith(`${row}-`))
      assert.equal(dots.length, 3)
      for (const [i, a] of dots.entries())
        for (const b of dots.slice(0, i))
          assert.ok(Math.hypot(a.cx - b.cx, a.cy - b.cy) >= 7, `${JSON.stringify(params)}: ${a.key} on ${b.key}`)
    }
  }
})

test('what leads a name to its mark stays on the map, wherever the estimate has gone', async () => {
  const { draw, ...size } = await panelOf('map')
  for (const step of [1200, 1920, 2400, 2657, 3000]) {
    for (const { key, tag, x1, y1 } of marksOf(draw, size, frameAt({ seed: 2 }, step))) {
      if (tag !== 'line' || !key.endsWith('-lead')) continue
      assert.ok(x1 >= 0 && x1 <= size.width && y1 >= 0 && y1 <= size.height, `${key} at step ${step}: ${x1}, ${y1}`)
    }
  }
})

test('the run that the trace is laid beside is said to have two landmarks and ranges only', async () => {
  const spec = await widget('observability-probe')
  const frame = frameAt({ sensor: 'range-bearing' }, 240)
  const { draw, ...size } = spec.panels.find(({ name }) => name === 'trace')
  const title = marksOf(draw, size, frame).find(({ key }) => key === 'title').words
  const { label } = spec.readouts(frame).find(({ key }) => key === 'reference')
  for (const words of [title, label, spec.describe(frame).trace]) assert.match(words, /two.* ranges only/)
  assert.equal(frame.trace.reference, frameAt({ count: 2 }, 240).trace.reference)
  assert.notEqual(frame.trace.reference, frameAt({ count: 2, sensor: 'range-bearing' }, 240).trace.total)
})

test('to drive twice as far leads to the ends of laps that the text compares', async () => {
  const { tries } = await widget('observability-probe')
  const { change } = tries.find(({ name }) => name === 'farther')
  const steps = [0, 100, 240, 480, 500, 960, 1920, 3000].map((step) => change({ step }, null).step)
  assert.deepEqual(steps, [240, 240, 480, 960, 960, 1920, 1920, 1920])
})
