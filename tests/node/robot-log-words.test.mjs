// What the figure of a log says is true in every state: its verdict is held against the frame over a grid of settings
// and moments, on the real log and on logs without truth, without ranges and with bearings.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { figure } from '../../web/widgets/robot-log/index.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const text = readFileSync(new URL('../../content/logs/plaza1.csv', import.meta.url), 'utf8')
const { RobotLog } = core

const LOGS = {
  plaza: text,
  'no truth': text.replace(/^G.*\n/gm, ''),
  'no ranges': text.replace(/^R.*\n/gm, ''),
  bearings: [
    'L,1,5,5',
    'L,2,-5,5',
    ...Array.from({ length: 60 }, (_, i) => `O,${i},0.1,0\nB,${i},${1 + (i % 2)},${7 - i / 50},${0.7 + i / 90}`),
  ].join('\n'),
}
const GRID = [
  { sightings: false },
  {},
  { gate: 0.999 },
  { gate: 0.95 },
  { gate: 1e-9 },
  { offset: 2.4 },
  { scale: 0.069 },
  { scale: 0.069, gate: 0.99 },
  { scale: 0.069, sigmaRange: 0.54 },
  { learn: true },
  { learn: true, gate: 0.999, sigmaRange: 0.1 },
  { scale: -0.2 },
  { sigmaRange: 10, sigmaDistance: 1 },
]

/** @type {any} */
const robotLog = figure

/** Each claim, and when it is made. */
function check(words, { params, step, summary, reckonedRmse, bands, correlation }) {
  const { used, refused, rmse, nis, meanInnovation, lag1, epsilon } = summary
  const says = (pattern, when) => assert.equal(pattern.test(words), Boolean(when), `${pattern}: ${words}`)
  const read = Object.values(summary.sensors).some(Boolean)
  const heard = step > 0 && params.sightings && used > 0
  says(/Before the first row/, step === 0)
  says(/Dead reckoning: odometry alone/, step > 0 && read && !params.sightings)
  says(/the log has no reading that could/, step > 0 && !read)
  says(/No range has been read/, step > 0 && read && params.sightings && used + refused === 0)
  says(/refused every range/, step > 0 && params.sightings && used === 0 && refused > 0)
  says(/ worse than /, heard && rmse !== null && rmse / reckonedRmse > 1.05)
  says(/ better than the .* dead reckoning/, heard && rmse !== null && rmse / reckonedRmse < 0.95)
  says(/a bias, not noise/, heard && Math.abs(meanInnovation) >= 0.2 && Math.abs(meanInnovation) > bands.mean)
  says(/ above its band/, heard && nis > bands.nis[1])
  says(/ below its band/, heard && nis < bands.nis[0])
  says(/ within its band/, heard && nis >= bands.nis[0] && nis <= bands.nis[1])
  says(/are correlated/, heard && lag1 !== null && Math.abs(lag1) > correlation.band)
  const [, apart, alike] = /those (\d+) apart more so \(([-−\d.]+)\)/.exec(words) ?? []
  if (/are correlated/.test(words)) {
    const most = Math.max(...correlation.values.map(Math.abs))
    assert.equal(apart !== undefined, most > Math.abs(correlation.values[0]), words)
    if (apart !== undefined) {
      const there = correlation.values[Number(apart) - 1]
      assert.equal(Math.abs(there), most, words)
      assert.equal(Number(alike.replace('−', '-')).toFixed(2), there.toFixed(2), words)
    }
  }
  says(/The gate has refused [\d.]+ %/, heard && params.gate !== null)
  says(/The learned scale is/, heard && epsilon !== null)
  assert.ok(!/NaN|undefined|null|Infinity/.test(words), words)
}

for (const [name, log] of Object.entries(LOGS)) {
  test(`the words are true in every state of a log: ${name}`, () => {
    const drive = RobotLog.parse(log)
    const { steps } = drive.contents()
    let before = null
    for (const params of GRID) {
      for (const step of [0, 1, 7, Math.min(400, steps), steps]) {
        const lab = RobotLog.from(drive, { version: 1, lab: 'robot-log', params, step: Math.min(step, steps) })
        const frame = lab.frame()
        check(robotLog.verdict(frame), frame)
        const said = [
          ...robotLog.panels
            .filter(({ shown }) => shown?.(frame) ?? true)
            .map(({ name }) => robotLog.describe(frame)[name]),
          ...robotLog.readouts(frame).map(({ value }) => value),
          robotLog.announce(frame, before ?? frame),
        ]
        for (const words of said) assert.ok(words && !/NaN|undefined|null|Infinity/.test(words), words)
        const columns = Object.values(robotLog.series(frame))
        assert.ok(
          columns.every(({ length }) => length === columns[0].length),
          'every column of the CSV has as many rows',
        )
        before = frame
        lab.free()
      }
    }
  })
}

test('a phrase leads to the same from any state, and the first to what the lab has at first', () => {
  const drive = RobotLog.parse(text)
  const frame = (params) => RobotLog.from(drive, { version: 1, lab: 'robot-log', params, step: 900 }).frame()
  const fresh = frame({})
  const set = { gate: 0.95, scale: 0.1, offset: 1, learn: true, sigmaRange: 0.5, sigmaDistance: 1, sigmaTurn: 0.9 }
  const shown = robotLog.controls.filter(({ shown }) => shown?.(fresh) ?? true).map(({ name }) => name)
  assert.deepEqual(shown.sort(), [...Object.keys(set), 'sightings'].sort(), 'all that a reader can set')
  for (const { name, change } of robotLog.tries) {
    const { params } = frame({ ...set, ...change(fresh) })
    assert.deepEqual(params, frame(name === 'raw' ? {} : change(fresh)).params, name)
  }
})

test('in the CSV of the figure each reading has its time, and a range what it is off by', () => {
  const log = 'L,4,9,1\nV,0,1,0\nP,0,0.5,0.25\nH,1,0.125\nR,1,4,8.2\nR,1,4,8.3\nP,2,2,0.5\nR,3,4,6\n'
  const drive = RobotLog.parse(log)
  const { steps } = drive.contents()
  const { time, sensor, landmark, range, residual, innovation } = robotLog.series(
    RobotLog.from(drive, { version: 1, lab: 'robot-log', params: {}, step: steps }).frame(),
  )
  assert.deepEqual([...time], [0, 1, 1, 1, 2, 3])
  assert.deepEqual([...sensor], ['fix', 'heading', 'range', 'range', 'fix', 'range'])
  assert.deepEqual([...landmark], [null, null, 4, 4, null, 4])
  assert.deepEqual(
    range.map((one) => one === null),
    [true, true, false, false, true, false],
  )
  assert.ok(Math.abs(residual[3] - residual[2] - 0.1) < 1e-9 && innovation.length === 6)
})

test('of a log with positions the words are on readings, and its panels of ranges are not there', () => {
  const rows = Array.from(
    { length: 80 },
    (_, i) => `V,${i},1,0\nP,${i},${i + 0.8 * Math.sin(7 * i)},${Math.cos(5 * i)}`,
  )
  const drive = RobotLog.parse(rows.join('\n'))
  const { steps } = drive.contents()
  const frame = (params, step = steps) => RobotLog.from(drive, { version: 1, lab: 'robot-log', params, step }).frame()
  assert.match(robotLog.verdict(frame({ fixes: false })), /^Dead reckoning: odometry alone, no reading is used\./)
  assert.match(robotLog.verdict(frame({ sightings: false }, 1)), /^No reading has been read yet\./)
  assert.match(robotLog.verdict(frame({ sightings: false })), /NIS is [\d.]+/, 'positions correct without ranges')
  const gate = { fix: 1e-9, heading: null, range: null, bearing: null }
  assert.match(robotLog.verdict(frame({ gate })), /^The gate has refused every reading so far/)
  assert.match(
    robotLog.verdict(frame({ gate: { ...gate, fix: 0.5 } })),
    /The gates have refused [\d.]+ % of the readings/,
  )
  const said = robotLog.describe(frame({}))
  assert.deepEqual([said.ranges, said.inner], ['', ''])
  assert.ok(said.map && said.nis)
  const shown = robotLog.panels.filter(({ shown }) => !shown || shown(frame({}))).map(({ name }) => name)
  assert.ok(!shown.includes('ranges') && shown.includes('map'))
})
