// The workbench of a reader's own log: what is compared of two replays, what each sensor and landmark says by itself,
// whose innovations are shown, and the map of the likelihood.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { sentence, settingBefore } from '../../web/page/log-likelihood.js'
import { LIMIT, closer, tells, within } from '../../web/page/log-limit.js'
import { unreadWords } from '../../web/page/log-file-words.js'
import { numbersOf as numbersToTell, settingsOf } from '../../web/page/log-numbers.js'
import { headsOf, rowsOf } from '../../web/page/log-sources.js'
import { fieldText } from '../../web/page/number-field.js'
import { Mapping } from '../../web/widgets/robot-log/likelihood.js'
import { belongs, nameOf, numbersOf, sourcesOf, touchedIn } from '../../web/widgets/robot-log/looks.js'
import { broken, readingAt, timeAt } from '../../web/widgets/robot-log/history.js'
import { withheldIn, withholdingShown } from '../../web/widgets/robot-log/withheld.js'

const { RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** Along a circle between four landmarks, with fixes; the camera is turned by 2°. */
const TURNED = (2 * Math.PI) / 180
const PLACES = [
  [9, 0],
  [0, 9],
  [-9, 0],
  [0, -9],
]
const rows = PLACES.map(([x, y], i) => `L,${i + 1},${x},${y}`)
let [x, y, theta] = [5, 0, Math.PI / 2]
for (let i = 0; i < 400; i += 1) {
  const [time, [lx, ly]] = [(0.1 * i).toFixed(1), PLACES[i % 4]]
  const bearing = Math.atan2(ly - y, lx - x) - theta + TURNED
  rows.push(`V,${time},2.5,0.5`, `B,${time},${1 + (i % 4)},${Math.hypot(lx - x, ly - y)},${bearing}`)
  if (i % 10 === 0) rows.push(`P,${time},${x},${y},0.1`)
  ;[x, y, theta] = [x + 0.25 * Math.cos(theta), y + 0.25 * Math.sin(theta), theta + 0.05]
}
const camera = RobotLog.parse(rows.join('\n'))
const START = { start: [5, 0, Math.PI / 2], sigmaDistance: 0.01, sigmaTurn: 0.001, sigmaRange: 0.05 }
function frameOf(params = {}, step = camera.contents().steps) {
  const lab = RobotLog.from(camera, { version: 1, lab: 'robot-log', step, params: { ...START, ...params } })
  const frame = lab.frame()
  lab.free()
  return frame
}

test('a camera that is turned by 2° shows in the bearings of each landmark, and nowhere once it is said', () => {
  const bearings = (frame) => {
    assert.equal(headsOf(frame).at(-1), 'Bearings’ mean, °')
    return rowsOf(frame)
      .slice(1)
      .map(({ cells }) => Number(cells.at(-1).replace('−', '-')))
  }
  const turned = bearings(frameOf())
  assert.equal(turned.length, 5, 'the camera, and four landmarks')
  assert.ok(
    turned.every((mean) => mean > 1 && mean < 3),
    String(turned),
  )
  const told = bearings(frameOf({ bearingOffset: TURNED }))
  assert.ok(
    told.every((mean) => Math.abs(mean) < 0.05),
    String(told),
  )
})

test('log-likelihoods are compared where they are of the same readings, and only there', () => {
  const [a, b] = [frameOf(), frameOf({ bearingOffset: TURNED })]
  const change = b.summary.logLikelihood - a.summary.logLikelihood
  assert.ok(change > 10)
  const digits = change.toLocaleString('en', { minimumFractionDigits: 1, maximumFractionDigits: 1 })
  assert.match(sentence(b, a, null), /^Log-likelihood [\d,.−]+ of 440 readings; \+[\d,.]+ against the last setting\.$/)
  assert.ok(sentence(b, null, a).endsWith(`+${digits} against A.`))
  assert.ok(sentence(a, null, b).endsWith(`−${digits} against A.`))
  const fewer = sentence(frameOf({ fixes: false }), null, a)
  assert.match(fewer, /A used 440 readings, and a sum over others is no measure/)
  assert.doesNotMatch(fewer, /against/)
  assert.equal(sentence(frameOf({}, 0), null, null), 'Log-likelihood: no reading has been used yet.')
})

test('a setting is compared with the one before of the same log alone', () => {
  const [one, other] = [{}, {}]
  /** @returns {any} */
  const frame = (log, scale) => ({ log, params: { scale } })
  const [a, b] = [frame(one, 0), frame(one, 1)]
  assert.equal(settingBefore(null, a, b), a)
  assert.equal(settingBefore(a, b, { ...b }), a, 'the same setting anew')
  assert.equal(settingBefore(null, a, frame(other, 1)), null)
  assert.equal(settingBefore(a, b, frame(other, 1)), null)
})

/** @param {number[][]} places @param {number} sigma */
const hill = ([across, up], sigma, turn = 0) =>
  up.flatMap((y) => across.map((x) => -((x + 0.5 * y) ** 2) / 2 - ((y - turn * x - 0.013) / sigma) ** 2 / 2))

test('the line of a map follows the likelihood where its cells are too coarse, and is not told on a ridge', () => {
  const SIZE = 28
  const axis = (half) => Array.from({ length: SIZE }, (_, i) => half * ((2 * i) / (SIZE - 1) - 1))
  const coarse = [axis(5), axis(5)]
  const found = within(hill(coarse, 0.02), SIZE)
  assert.ok(!tells(found) && !found.edge)
  const looks = (sigma, turn) => {
    let places = coarse
    for (let finer = 0; finer < 4; finer += 1) {
      const { columns, rows, edge } = within(hill(places, sigma, turn), SIZE)
      places = [closer(places[0], columns, edge), closer(places[1], rows, edge)]
    }
    return { places, line: within(hill(places, sigma, turn), SIZE) }
  }
  const { places, line } = looks(0.02)
  assert.ok(tells(line) && !line.edge)
  // Of two numbers the line reaches √(2 ln 20) = 2.45 standard deviations: to within a cell on each side.
  const [low, high] = line.rows.map((row) => places[1][row])
  const cell = places[1][1] - places[1][0]
  assert.ok(Math.abs((high - low) / 2 - 0.02 * Math.sqrt(LIMIT)) < cell, `${low} ${high} ${cell}`)
  assert.ok(Math.abs((high + low) / 2 - 0.013) < cell)
  assert.ok(!tells(looks(0.002, 1).line), 'a ridge')
  assert.ok(within(hill([axis(1), axis(1)], 5), SIZE).edge)
})

test('a curve breaks over a stretch without readings', () => {
  const [times, values] = broken([0, 1, 2, 9, 10], [1, 2, 3, 4, 5])
  assert.deepEqual(times, [0, 1, 2, 9, 9, 10])
  assert.deepEqual(values, [1, 2, 3, Number.NaN, 4, 5])
  assert.deepEqual(broken([], []), [[], []])
  assert.deepEqual(broken([3], [1]), [[3], [1]])
})

test('innovations are shown of all readings, of a sensor, of a landmark, and of its bearings', () => {
  const frame = frameOf()
  const sources = sourcesOf(frame)
  const names = sources.map((one) => nameOf(one, frame))
  assert.deepEqual(names.slice(0, 4), ['positions', 'ranges', 'ranges of 1', 'ranges of 2'])
  assert.equal(sources.length, 1 + 5 + 5)
  const { innovations } = frame
  const count = (source) => innovations.time.filter((_, i) => belongs(frame, source)(i)).length
  assert.equal(count(null), innovations.time.length)
  const [fixes, ranges, ...landmarks] = sources.slice(0, 6).map(count)
  assert.equal(fixes + ranges, innovations.time.length)
  assert.equal(
    landmarks.reduce((sum, one) => sum + one, 0),
    ranges,
  )
  for (const source of sources.filter(({ bearing }) => bearing))
    for (const [i, value] of numbersOf(frame, source).entries())
      assert.equal(Number.isNaN(value), innovations.second[i] === null)
})

test('a place of a panel is a time of the window, and the reading that is nearest there', () => {
  const looks = { window: [10, 20], source: null, touched: null, kept: null }
  const frame = { ...frameOf(), looks }
  const size = { width: 360, height: 235 }
  assert.deepEqual([timeAt(frame, 40, 360), timeAt(frame, 328, 360), timeAt(frame, 0, 360)], [10, 20, 10])
  for (const [i, time] of frame.innovations.time.entries()) {
    if (time < 11 || time > 19) continue
    const at = 40 + ((time - 10) / 10) * (328 - 40)
    const near = readingAt(frame, null, [at, null], size)
    assert.equal(frame.innovations.time[near], time)
    assert.equal(
      frame.innovations.time[touchedIn({ ...frame, looks: { ...looks, touched: time } })],
      frame.innovations.time[i],
    )
  }
})

test('the report names each number that the filter was told, of the sensors that the log has', () => {
  const told = settingsOf(frameOf({ bearingOffset: TURNED, gate: { fix: 0.99 } }))
  const value = (name) => told.find(([words]) => words === name)?.[1]
  assert.equal(value('Ranges with bearings: offset of the bearings, °'), '2')
  assert.equal(value('Positions: gate'), '99 %')
  assert.equal(value('Ranges with bearings: gate'), 'off')
  assert.ok(!told.some(([words]) => words.startsWith('Headings')))
  const names = numbersToTell(camera.contents()).map(({ told: [name] }) => name)
  assert.equal(new Set(names).size, names.length)
  for (const name of names) assert.ok(name in frameOf().params, name)
})

test('a map is a replay for each cell, row by row, and is given up between two', async () => {
  const told = []
  let now = 0
  const mapping = new Mapping(
    (message) => told.push(message),
    (act) => queueMicrotask(act),
    () => (now += 1),
  )
  const wish = {
    params: START,
    from: 2,
    across: { name: 'bearingOffset', values: [0, TURNED, 2 * TURNED] },
    up: { name: 'sigmaBearing', values: [0.01, 0.1] },
  }
  assert.deepEqual(await mapping.map({ RobotLog }, camera, wish), { kind: 'map' })
  assert.deepEqual(
    told.map(({ kind, row }) => [kind, row]),
    [
      ['mapped', 0],
      ['mapped', 1],
    ],
  )
  for (const { row, values } of told)
    for (const [i, bearingOffset] of wish.across.values.entries()) {
      const params = { ...START, bearingOffset, sigmaBearing: wish.up.values[row] }
      assert.equal(values[i], RobotLog.logLikelihood(camera, params, 2).logLikelihood)
    }
  assert.ok(told.every(({ values: [without, right, twice] }) => right > without && right > twice))
  const given = mapping.map({ RobotLog }, camera, wish)
  mapping.stop()
  assert.deepEqual(await given, { kind: 'no-map', message: 'The map was given up.' })
  const wrong = await mapping.map({ RobotLog }, camera, { ...wish, across: { name: 'sigmaRange', values: [-1] } })
  assert.equal(wrong.kind, 'no-map')
  assert.match(wrong.message, /sigmaRange/)
})

test('landmarks have the names of their file in the table and wherever innovations are named', () => {
  const frame = { ...frameOf(), log: { motion: 'velocity', names: ['A12', 'north door', 'C', 'D'] } }
  const names = rowsOf(frame).map(({ name }) => name)
  assert.deepEqual(names.slice(-4), ['Landmark A12', 'Landmark north door', 'Landmark C', 'Landmark D'])
  assert.equal(nameOf({ sensor: 'range', landmark: 2, bearing: false }, frame), 'ranges of north door')
  assert.equal(nameOf({ sensor: 'range', landmark: 2, bearing: false }, frameOf()), 'ranges of 2')
})

test('a field keeps the millimetres of a place far from its origin, and six digits of a small number', () => {
  const shown = [4430123.456, -5333000.0004, 999.1234, 0.00012345678, 0.1 + 0.2].map(fieldText)
  assert.deepEqual(shown, ['4430123.456', '-5333000', '999.123', '0.000123457', '0.3'])
})

test('the stretch that is withheld is counted from the log’s first row, and so is the one that is shown', () => {
  /** @type {any} */
  const frame = { params: { withheld: [1010, 1025] }, summary: { withheld: { rows: 3 } }, log: { span: [1000, 1060] } }
  assert.deepEqual(withheldIn(frame), [10, 25])
  assert.equal(withheldIn({ ...frame, params: { withheld: null } }), null)
  // Where fixes are off, or there are none, nothing is withheld.
  assert.equal(withheldIn({ ...frame, summary: { withheld: null } }), null)
  assert.equal(withholdingShown(frame), null)
  assert.deepEqual(withholdingShown({ ...frame, looks: { window: [5, 8] } }), { withheld: [1005, 1008] })
})

test('columns that are not read are named in one short sentence', () => {
  assert.equal(unreadWords([]), '')
  assert.equal(unreadWords(['hdg', 'temp']), 'Not read: hdg, temp.')
  const many = Array.from({ length: 400 }, (_, k) => `covariance.${k}`)
  const words = unreadWords(many)
  assert.match(words, /^Not read: covariance\.0, covariance\.1, .* and 39\d more\.$/)
  assert.ok(words.length < 130, words)
  assert.ok(unreadWords(['x'.repeat(5000)]).length < 40, 'a long name is cut')
})
