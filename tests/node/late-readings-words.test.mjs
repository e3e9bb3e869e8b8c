// What the figure of late readings says is held against its frames: way, lag, innovations, error, gap.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { InParts } from '../../web/figure/in-parts.js'
import { costs, counting as task } from '../../web/widgets/late-readings/costs.js'
import { handlesOf } from '../../web/widgets/late-readings/handles.js'
import { check, estimate, number, pattern, prints, widget } from './claims.mjs'

const camera = ({ sensors }) => sensors[2]
const rms = ({ ways }, way) => ways[['as-new', 'drop', 'go-back'].indexOf(way)].rms
const thirds = { 'first third': [0, 1 / 3], 'middle third': [1 / 3, 2 / 3], 'last third': [2 / 3, 1] }

check(
  'late-readings',
  {
    way: ['as-new', 'drop', 'go-back'],
    delay: [0, 0.05, 0.6, 2],
    laserRate: [0, 0.5],
    sonarRate: [0, 5],
    cameraRate: [0, 1],
    gap: [null, [8, 13], [19, 2]],
    ownDelay: [null, 3],
    course: ['steady', 'to-and-fro'],
    smooth: [false, true],
  },
  [0],
  () => [
    [/^The camera reads nothing, so nothing comes late\.$/, (frame) => camera(frame).period === 0],
    [
      /^Nothing comes late: the three ways are one\.$/,
      (frame) =>
        camera(frame).came.every((time, i) => time === camera(frame).measured[i]) &&
        frame.ways.every(({ rms }) => rms === frame.ways[0].rms),
    ],
    [/^One reading comes ([\d.]+) s late\.$/, (frame, late) => prints(late, frame.picked.came - frame.picked.measured)],
    [
      /^As new it leaves an error of ([\d.]+) m \(RMS\), dropped ([\d.]+) m, in its place ([\d.]+) m\.$/,
      (frame, ...said) => said.every((text, i) => prints(text, frame.ways[i].rms)),
    ],
    [
      pattern(
        /^Without the late readings the error is ([\d.]+) m \(RMS from (\d+) s on\); /,
        /going back would leave ([\d.]+) m\.$/,
      ),
      (frame, error, settled, back) =>
        prints(error, rms(frame, 'drop')) && prints(settled, frame.settled) && prints(back, rms(frame, 'go-back')),
    ],
    [
      /^Put where they were measured, the late readings leave an error of ([\d.]+) m \(RMS from (\d+) s on\)\.$/,
      (frame, error, settled) => prints(error, rms(frame, 'go-back')) && prints(settled, frame.settled),
    ],
    [
      /^The camera’s mean innovation is (−?[\d.]+) m\.$/,
      (frame, mean) => frame.params.way === 'go-back' && prints(mean, camera(frame).mean),
    ],
    [
      /^In ([\d.]+) s the robot drives ([\d.]+) m\.$/,
      (frame, delay, way) => prints(delay, frame.params.delay) && prints(way, frame.travelled),
    ],
    [
      pattern(
        /^With late readings taken as new the estimate is ([\d.]+) m (ahead|behind) in the mean/,
        /(?:, and the camera’s mean innovation is (−?[\d.]+) m)?(: it hides the lag)?\.$/,
      ),
      (frame, lag, side, mean, hidden) =>
        prints(lag, Math.abs(frame.lag)) &&
        (side === 'ahead') === frame.lag < 0 &&
        (mean === undefined ? camera(frame).mean === null : prints(mean, camera(frame).mean)) &&
        (!hidden || Math.abs(number(mean)) < 0.11 * number(lag)),
    ],
    [
      /^The error is ([\d.]+) m \(RMS\); going back would leave ([\d.]+) m\.$/,
      (frame, error, back) => prints(error, rms(frame, 'as-new')) && prints(back, rms(frame, 'go-back')),
    ],
    [
      /^In the gap of ([\d.]+) s the claimed σ of the position grows from ([\d.]+) m to ([\d.]+) m\.$/,
      ({ gap }, long, before, after) =>
        prints(long, gap.to - gap.from) && prints(before, gap.sigmaBefore) && prints(after, gap.sigmaAfter),
    ],
    [
      /^Afterwards it is at most ([\d.]+) m, in the (first third|middle third|last third) of the gap\.$/,
      ({ gap }, most, third) =>
        prints(most, gap.sigmaSmoothed) &&
        gap.worstPlace >= thirds[third][0] - 1e-9 &&
        gap.worstPlace <= thirds[third][1] + 1e-9,
    ],
  ],
)

const lab = (params) => estimate.LateReadings.from({ version: 1, lab: 'late-readings', step: 0, params })

test('the costs are the lab’s, a few seeds at a time, and those of the last schedule asked for', async () => {
  const waiting = []
  let told = 0
  /** @type {any} */
  const counting = new InParts(
    task,
    () => (told += 1),
    async (params) => lab(params),
    (act) => waiting.push(act),
  )
  const run = async () => {
    for (let i = 0; i < 60; i += 1) {
      await null
      waiting.splice(0).forEach((act) => act())
    }
  }
  const open = lab({}).frame()
  counting.follow(open)
  assert.deepEqual(counting.progress, { step: 0, of: 500, unit: 'seed' })
  await null
  await null
  waiting.splice(0).forEach((act) => act())
  const other = lab({ delay: 1 }).frame()
  counting.follow(other)
  await run()
  assert.equal(counting.progress, null)
  assert.equal(counting.value.seeds, 500)
  assert.deepEqual(counting.value, costs.whole(lab({ delay: 1 })))
  assert.ok(told > 20)
  // Neither the way, the smoother nor the seed of the run asks for another count.
  counting.follow(lab({ delay: 1, way: 'drop', smooth: true, seed: 9 }).frame())
  assert.equal(counting.progress, null)
  counting.follow(open)
  counting.cancel()
  await run()
  assert.equal(counting.progress, null)
  assert.deepEqual(counting.value, costs.whole(lab({ delay: 1 })))
})

test('the figure opens with one switch, one slider and the handles on its line of time', async () => {
  const { controls, panels, timeless, seeded } = await widget('late-readings')
  assert.deepEqual(
    controls.filter(({ more }) => !more).map(({ name }) => name),
    ['way', 'delay'],
  )
  assert.ok(timeless && !seeded)
  assert.deepEqual(
    panels.filter(({ handles }) => handles).map(({ name }) => name),
    ['line'],
  )
})

test('what a gap withholds has no handle for when it came, and the phrase has another reading in hand', async () => {
  const { tries, lab: name } = await widget('late-readings')
  const of = (params) => {
    const lab = estimate[name].from({ version: 1, lab: 'late-readings', step: 0, params })
    const frame = lab.frame()
    lab.free()
    return frame
  }
  const scale = Object.assign((value) => value, { invert: (pixel) => pixel })
  /** @type {any} */
  const plane = { x: scale, y: scale, box: { left: 0, top: 0, right: 20, bottom: 20 } }
  /** @type {any} */
  const limits = { ownDelay: { step: 0.05, greatest: 10 }, gap: { step: 0.05 } }
  const grips = (frame) => handlesOf(frame, limits, plane, { measured: 80, came: 44, height: 400 })
  const inside = of({ gap: [8, 13], picked: 9 })
  assert.ok(inside.picked.missing)
  assert.deepEqual(Object.keys(grips(inside)).sort(), ['gap-from', 'gap-to', 'which'])
  assert.match(grips(inside).which.value, /^number 10 of \d+, in the gap at 10\.00 s: never measured$/)
  const shown = of(tries.find(({ name: one }) => one === 'gap').change(null, null))
  assert.ok(shown.gap && !shown.picked.missing)
  assert.ok('came' in grips(shown))
})
