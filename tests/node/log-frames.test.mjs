// A truth in a frame or on a clock of its own: what its file is asked, which answers it has and in which words, and
// that the answer is written with the settings and read again.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { nextChange } from '../../web/page/log-saved-files.js'
import { readSettings, settingsText } from '../../web/page/log-settings.js'
import { clocksOf, framesOf, originOf, short } from '../../web/page/log-file-words.js'
import { applyChange } from '../../web/widgets/robot-log/change.js'

const { LogFiles, RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const known = RobotLog.parameters()

/** Where a robot is that drives in curves, and how fast it goes and turns. @param {number} t */
const speed = (t) => 0.8 + 0.4 * Math.sin(t / 1.7)
const turning = (t) => 0.5 * Math.sin(t / 3) + 0.1
const STEP = 0.01
const WAY = [[0, 0, 0]]
for (let k = 0; k < 12000; k += 1) {
  const [x, y, theta] = WAY[k]
  const [v, omega] = [speed(k * STEP), turning(k * STEP)]
  WAY.push([x + v * STEP * Math.cos(theta), y + v * STEP * Math.sin(theta), theta + omega * STEP])
}
/** @param {number} t */
const at = (t) => WAY[Math.max(0, Math.min(Math.round(t / STEP), WAY.length - 1))]
/** @param {number} count @param {number} apart @param {(t: number) => number[]} row */
const rows = (count, apart, row) =>
  Array.from({ length: count }, (_, k) => `${[k * apart, ...row(k * apart)].map((one) => one.toFixed(4))}\n`).join('')
const WHEELS = `time_s,v,omega\n${rows(1200, 0.1, (t) => [speed(t), turning(t)])}`
// The errors of the fixes are the same in each run, and neighbours have nothing in common.
const error = (/** @type {number} */ t) => 0.3 * Math.sin(1e4 * Math.sin(77 * t + 1))
const FIXES = `time_s,gps_x,gps_y\n${rows(300, 0.4, (t) => [at(t)[0] + error(t), at(t)[1] + error(t + 3000)])}`

/** @param {number} turn rad @param {number[]} shift m @param {number} [late] s */
function truth(turn, [dx, dy], late = 0) {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)]
  return `time_s,true_x,true_y\n${rows(1200, 0.1, (t) => {
    const [x, y] = at(t - late)
    return [cos * x - sin * y + dx, sin * x + cos * y + dy]
  })}`
}
/** @param {string} text */
function opened(text) {
  const files = new LogFiles()
  for (const [name, one] of [
    ['wheels.csv', WHEELS],
    ['gps.csv', FIXES],
    ['truth.csv', text],
  ])
    files.add(name, one)
  return files
}
/** @param {any} files */
const last = (files) => files.files()[2]

test('a truth that lies on the positions is asked nothing', () => {
  const { frame, asks } = last(opened(truth(0, [0, 0])))
  assert.deepEqual([frame, asks], [null, []])
})

test('a truth in another frame has two answers, and its own turns it onto the positions', () => {
  const files = opened(truth(0.7, [12, -7]))
  const { frame, asks } = last(files)
  assert.match(
    asks[0],
    /^Turned by −40\.\d° about its origin and shifted by −4\.\d\d and 13\.\d\d m, the truth lies on /,
  )
  assert.ok(Math.abs(frame.own.turn + 0.7) < 0.02, String(frame.own.turn))
  assert.deepEqual(framesOf(frame), [
    ['same', 'the same frame'],
    ['own', 'its own frame: turned and moved'],
  ])
  assert.throws(() => files.read(), /truth\.csv asks/)
  assert.throws(() => files.setFrame(2, 'moved'), /file/)
  files.setFrame(2, 'own')
  assert.deepEqual(last(files).asks, [])
  const { notes } = files.read().contents()
  assert.ok(notes.some((/** @type {string} */ note) => /^The truth is turned by −40.*is in no error now/.test(note)))
})

test('a clock of its own and both are said as such', () => {
  const clock = last(opened(truth(0, [0, 0], 1.5)))
  assert.match(clock.asks[0], /^1\.[45]\d s earlier, the truth lies on the positions, .*is its clock another one\?/)
  const [same, own] = framesOf(clock.frame).map(([, words]) => words)
  assert.equal(same, 'the same clock')
  assert.match(own, /^its own clock: taken 1\.[45]\d s earlier$/)
  const both = last(opened(truth(0.7, [12, -7], 1.5)))
  assert.match(both.asks[0], /are its frame and its clock others\?/)
  assert.equal(framesOf(both.frame)[1][1], 'its own frame and clock')
  const mirrored = {
    said: null,
    origin: null,
    foreign: false,
    beside: false,
    own: { ...both.frame.own, mirrored: true, delay: 0 },
  }
  assert.equal(framesOf(mirrored)[1][1], 'its own frame: mirrored, turned and moved')
})

test('the answer is written and read again, and of a truth that lies on the positions nothing is said', () => {
  const files = opened(truth(0.7, [12, -7]))
  files.setFrame(2, 'own')
  const settings = readSettings(settingsText({}, files.files()), known)
  const follow = (/** @type {any} */ again) => {
    const change = nextChange(settings.files, again.files())
    if (change) applyChange(again, change)
    return change
  }
  const again = opened(truth(0.7, [12, -7]))
  assert.deepEqual(follow(again), { file: 2, frame: 'own' })
  assert.deepEqual(again.files(), files.files())
  assert.equal(nextChange(settings.files, again.files()), null)
  assert.equal(follow(opened(truth(0, [0, 0]))), null)
})

test('where the origin of a truth in metres lies is typed, written and read again', () => {
  const north = (/** @type {number} */ t) => [
    50 + (at(t)[1] + error(t)) / 111_229,
    8 + (at(t)[0] + error(t + 3000)) / 71_696,
  ]
  const degrees = Array.from({ length: 300 }, (_, k) => `${0.4 * k},${north(0.4 * k).map((one) => one.toFixed(8))}\n`)
  const open = () => {
    const files = new LogFiles()
    files.add('wheels.csv', WHEELS)
    files.add('gps.csv', `time_s,latitude,longitude\n${degrees.join('')}`)
    files.add('truth.csv', truth(0, [0, 0]))
    return files
  }
  const files = open()
  assert.match(last(files).asks[0], /^Its places are in metres, the positions are in latitude and longitude/)
  assert.throws(() => files.setOrigin(2, 91, 8), /origin/)
  assert.throws(() => files.setOrigin(1, 50, 8), /origin/)
  files.setOrigin(2, 50, 8)
  const { frame, asks } = last(files)
  assert.deepEqual([frame.said, [...frame.origin], asks], ['at', [50, 8], []])
  assert.deepEqual(framesOf(frame)[2], ['at', 'same axes, origin at 50, 8'])
  const { notes } = files.read().contents()
  assert.ok(notes.includes('Positions are in metres east and north of 50.00000° N, 8.00000° E.'), notes.join(' '))
  const settings = readSettings(settingsText({}, files.files()), known)
  const again = open()
  applyChange(again, nextChange(settings.files, again.files()) ?? {})
  assert.deepEqual(last(again), last(files))
  assert.equal(nextChange(settings.files, again.files()), null)
  files.setFrame(2, 'moved')
  assert.ok(
    files
      .read()
      .contents()
      .notes.some((/** @type {string} */ one) => /is moved by .* lies on the positions:/.test(one)),
  )
})

test('where the origin of landmarks in metres lies is asked beside latitudes, and may be typed', () => {
  const files = new LogFiles()
  files.add('wheels.csv', 'time,v,omega\n0,1,0\n1,1,0\n')
  files.add('gps.csv', 'time,latitude,longitude\n0,50,8\n1,50.0001,8\n')
  files.add('anchors.csv', 'anchor,x,y\n1,3,4\n')
  const { frame, asks } = last(files)
  assert.deepEqual([frame.beside, frame.foreign, frame.said], [true, false, null])
  assert.match(asks[0], /^Its places are in metres, others are in latitude and longitude: where does its origin lie\?/)
  assert.deepEqual(framesOf(frame), [['same', 'origin in the first latitude and longitude']])
  files.setOrigin(2, 49.9999, 8)
  const saved = readSettings(settingsText({}, files.files()), known).files
  assert.deepEqual(saved[2].origin, [49.9999, 8])
  files.setFrame(2, 'same')
  assert.deepEqual(nextChange(saved, files.files()), { file: 2, origin: [49.9999, 8] })
})

test('a file whose times do not meet the motion’s is asked, has words for its clock, and is read again so', () => {
  const open = (first = 3605) => {
    const files = new LogFiles()
    files.add('wheels.csv', `time_s,v,omega\n${rows(101, 1, () => [1, 0])}`)
    const fixes = Array.from({ length: 91 }, (_, k) => `${first + k},${k},0\n`)
    files.add('gps.csv', `time_s,gps_x,gps_y\n${fixes.join('')}`)
    return files
  }
  const files = open()
  const gps = (/** @type {any} */ of) => of.files()[1]
  assert.match(gps(files).asks[0], /^Its times begin 3505\.0 s after the motion ends: how many seconds/)
  assert.throws(() => files.read(), /gps\.csv asks/)
  const { clock } = gps(files)
  assert.deepEqual(clocksOf(clock), [
    [-3600, 'of another zone: 1 hour is taken off'],
    [-3605, 'its own: taken to begin with the motion, perhaps seconds off'],
    [0, 'the motion’s: nothing is added'],
  ])
  assert.deepEqual([clock.said, clock.asked, [...clock.meets]], [null, true, [-3695, -3505]])
  assert.equal(clocksOf({ ...clock, zone: -18 })[0][1], 'GPS time: 18 s are taken off')
  assert.deepEqual(
    clocksOf({ ...clock, zone: 2 * 86400, said: -3599.5 }).filter(([one]) => one !== 0),
    [
      [2 * 86400, 'of another day: 2 days are added'],
      [-3605, 'its own: taken to begin with the motion, perhaps seconds off'],
      [-3599.5, 'its own: −3599.5 s are added'],
    ],
  )
  assert.throws(() => files.setClockShift(0, 1), /file/)
  assert.throws(() => files.setClockShift(1, Number.NaN), /seconds/)
  applyChange(files, { file: 1, clockShift: -3600 })
  assert.equal(gps(files).asks.length, 0)
  assert.match(gps(files).follows, /5 to 95 s/)
  assert.deepEqual([...files.read().contents().span], [0, 100])
  const saved = readSettings(settingsText({}, files.files()), known).files
  assert.equal(saved[1].clockShift, -3600)
  const again = open()
  assert.deepEqual(nextChange(saved, again.files()), { file: 1, clockShift: -3600 })
  assert.equal(nextChange(saved, files.files()), null)
  assert.equal(nextChange(saved, open(9000).files()), null, 'of another recording it is asked')
  assert.equal(nextChange(saved, open(0).files()), null, 'what meets is not asked')
})

test('of what stands in a field the beginning is shown, and of a date all that differs from row to row', () => {
  assert.deepEqual(['', '0.1234567890123456', '2026-05-01T12:00:05.125+02:00'].map(short), [
    '(empty)',
    '0.1234567890123…',
    '2026-05-01T12:00:05.125+02:00',
  ])
})

test('an origin is two numbers in degrees, and nothing of it is passed over', () => {
  for (const text of ['48.137, -11.576', ' 48.137;\u221211.576 ', '48.137 -11.576', '+48.137° , -11.576°'])
    assert.deepEqual(originOf(text), [48.137, -11.576], text)
  for (const text of [
    '',
    '48.137',
    '48.137 N, 11.576 W',
    '48,137; 11,576',
    '48°08′13″ 11°34′',
    '91, 8',
    '48, 361',
    '1, 2, 3',
  ])
    assert.equal(originOf(text), null, text)
})
