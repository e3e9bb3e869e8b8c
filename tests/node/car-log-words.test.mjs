// What the figure of the car says is held against its frames, on its own log and on the mower's, which has no fix; and
// its curve is the lab's.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { InParts } from '../../web/figure/in-parts.js'
import { readFileSync } from 'node:fs'
import { fixed } from '../../web/draw/numbers.js'
import { plain } from '../../web/draw/words.js'
import { curve, tracing as task } from '../../web/widgets/car-log/curve.js'
import { of } from '../../web/widgets/car-log/open.js'
import { LOG, estimate, number, prints, sentences, widget } from './claims.mjs'

const car = estimate.CarLog.parse(readFileSync(new URL('../../content/logs/car.csv', import.meta.url), 'utf8'))
const state = (params) => ({ version: 1, lab: 'car-log', step: 0, params })
const lab = (params) => estimate.CarLog.from(car, state(params))

/** @type {any[][]} */
const CLAIMS = [
  [
    /^Speeds and turn rates alone are off a fix by (\d+) m at worst\.$/,
    (frame, off) => frame.nis === null && prints(off, frame.reckonedOff),
  ],
  [
    /^(\d+) fixes are used(?:, and (\d+) are refused)?\.$/,
    (frame, used, refused) => number(used) === frame.used && number(refused ?? '0') === frame.refusals,
  ],
  [
    /^Their NIS is ([\d.]+) for each output(, above 1: .*|, below 1: .*)?\.$/,
    (frame, nis, side) =>
      prints(nis, frame.nis) &&
      (side?.includes('above') ?? false) === frame.nis > 1.2 &&
      (side?.includes('below') ?? false) === frame.nis < 0.8,
  ],
  [/^Their log-likelihood is (.+)\.$/, (frame, likelihood) => likelihood === fixed(frame.logLikelihood, 1)],
  [
    /^The speed reads ([\d.]+) % (low|high) \(±([\d.]+) %\)\.$/,
    ({ learned }, scale, side, sigma) =>
      prints(scale, 100 * Math.abs(1 / (1 + learned.speedScale) - 1)) &&
      (side === 'high') === learned.speedScale < 0 &&
      prints(sigma, (100 * learned.speedScaleSigma) / (1 + learned.speedScale) ** 2),
  ],
  [
    /^In the tunnel the filter is off by up to (\d+) m, the track afterwards by (\d+) m\.$/,
    ({ tunnel }, worst, later) => prints(worst, tunnel.worst) && prints(later, tunnel.worstSmoothed),
  ],
]

test('what the car says is true, in every state', async () => {
  const spec = await widget('car-log')
  const logs = [
    [car, ['second', 'all', 'none']],
    [estimate.CarLog.parse(LOG), ['second']],
  ]
  for (const [log, which] of logs)
    for (const fixes of which)
      for (const delay of [0, 0.58])
        for (const [learn, tunnel, gate] of [
          [false, false, false],
          [true, false, false],
          [true, true, false],
          [true, false, true],
        ]) {
          const it = estimate.CarLog.from(log, state({ fixes, delay, learn, tunnel, gate }))
          const frame = it.frame()
          it.free()
          const words = plain(spec.verdict(frame))
          for (const sentence of sentences(words)) {
            const claim = CLAIMS.filter(([pattern]) => pattern.test(sentence))
            assert.equal(claim.length, 1, sentence)
            assert.ok(claim[0][1](frame, ...sentence.match(claim[0][0]).slice(1)), sentence)
          }
          for (const said of [words, ...Object.values(spec.describe(frame))])
            assert.doesNotMatch(said, /undefined|NaN|null|Infinity/)
        }
})

test('each phrase leads to what it speaks of, whatever was pressed before', async () => {
  const spec = await widget('car-log')
  const open = lab({}).frame()
  const after = Object.fromEntries(
    spec.tries.map(({ name, change }) => {
      const params = change(open, null)
      assert.deepEqual(Object.keys(params).sort(), Object.keys(open.params).sort(), 'all of them')
      return [name, lab(params).frame()]
    }),
  )
  assert.ok(after.none.reckonedOff > 80 && after.none.nis === null)
  assert.ok(after.all.nis < 0.8 && after.second.nis > 1.2)
  assert.ok(after.learn.learned.speedScale > 0.01)
  assert.ok(after.tunnel.tunnel.worstSmoothed < after.tunnel.tunnel.worst / 2)
  assert.ok(after.gate.refusals > 20)
})

test('the curve is the lab’s, a delay at a time, and stays while only the delay moves', async () => {
  const waiting = []
  const Lab = of(estimate.CarLog, car)
  /** @type {any} */
  const tracing = new InParts(
    task,
    () => {},
    async (params) => Lab.from(state(params)),
    (act) => waiting.push(act),
  )
  tracing.follow(lab({ fixes: 'none' }).frame())
  assert.equal(tracing.progress, null, 'nothing to trace without fixes')
  tracing.follow(lab({}).frame())
  await null
  await null
  while (waiting.length) waiting.shift()()
  const whole = curve.whole(lab({}))
  assert.deepEqual(tracing.value, whole)
  const best = whole.delays[whole.values.indexOf(Math.max(...whole.values))]
  assert.equal(best, 0.6)
  tracing.follow(lab({ delay: 0.5 }).frame())
  assert.equal(tracing.progress, null)
  tracing.follow(lab({ learn: true }).frame())
  assert.equal(tracing.progress.step, 0)
  tracing.cancel()
  assert.equal(tracing.progress, null)
})
