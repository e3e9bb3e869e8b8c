// What a verdict says of turn rates that are off by a share, of bearings that are counted the other way round, and of
// what may hide where no fault is named.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { mendBefore } from '../../web/page/log-fit-words.js'
import { remedies, remedy } from '../../web/page/log-remedy.js'
import { unsettledWords } from '../../web/widgets/robot-log/unsettled.js'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const params = /** @type {any} */ ({})
const share = { now: 0, value: -0.0384, sigma: 0.0029, end: false }
const scaled = (/** @type {any} */ size = share) => suspect({ fault: 'turn-scale', name: null, sizes: [size] })
const corrections = { driven: [1, 1.1], landmarks: [], ranges: [], kept: null }
const log = /** @type {any} */ ({ corrections, names: [], motion: 'velocity', readings: {} })

test('turn rates that read too much have the factor that their press sets', () => {
  const said = 'The robot turns 3.84 ± 0.29 % less than its turn rates say: take them 0.9616 times as they are read.'
  assert.equal(sentence(scaled(), false, log), said)
  assert.equal(
    sentence(scaled(), false, { ...log, wheels: true }),
    `${said} A distance between the wheels 1.0399 times as long does the same.`,
  )
  assert.match(sentence(scaled({ ...share, value: 0.04 }), false, log), /^The robot turns 4\.00 ± 0\.29 % more than /)
  const press = /** @type {any} */ (remedy(scaled(), params, false, log))
  assert.equal(press.press, 'Take them so')
  const [along, about] = press.corrections.driven
  assert.ok(along === 1 && Math.abs(about - 1.1 * 0.9616) < 1e-9, 'what was corrected before is counted in')
  const noisy = ranked(judgement([{ ...scaled(), dilution: 0.024 }]), { rows: 1000, truth: false, log })
  assert.match(
    noisy,
    / makes them look up to 2\.4 % larger than they are: the ± counts that, and what is set may be as/,
  )
  const end = scaled({ ...share, value: 9, end: true })
  assert.match(sentence(end, false, log), /mend their unit\.$/)
  assert.deepEqual([remedy(end, params, false, log), remedy(scaled(), params, false, null)], [null, null])
  assert.match(mendBefore(judgement([scaled()])), /^The verdict names a scale of the turn rates, which Fit does not/)
})

test('bearings that are counted clockwise are for the reader to mend', () => {
  const mirrored = suspect({ fault: 'mirrored-bearings', name: null, sizes: [] })
  assert.match(
    sentence(mirrored, false, log),
    /^The bearings are counted clockwise, .* unit of the bearing that says cl/,
  )
  assert.equal(remedy(mirrored, params, false, log), null)
  assert.match(mendBefore(judgement([mirrored])), /^The verdict names the sign of the bearings/)
})

const sigma = (/** @type {string} */ name, /** @type {number} */ now, more = {}) =>
  suspect({ fault: 'sigma', name, sizes: [{ now, value: now, sigma: 0.01, end: false }], standing: 'cleared', ...more })

test('beside no fault a σ of an angle that tells no direction is said', () => {
  const said = (/** @type {any[]} */ all) => ranked(judgement(all), { rows: 1000, truth: false, log })
  assert.match(
    said([sigma('sigmaBearing', 0.69)]),
    / The σ of a bearing is set to 40°: a fault of those angles may hide/,
  )
  assert.match(said([sigma('sigmaHeading', 0.4)]), / The σ of a heading is set to 23°: /)
  assert.doesNotMatch(said([sigma('sigmaBearing', 0.2), sigma('sigmaRange', 3)]), /may hide/)
})

test('several σ that are wrong together alarm nobody by another fault', () => {
  const both = ['sigmaRange', 'sigmaBearing'].map((name) => sigma(name, 0.1, { standing: 'maybe' }))
  both[0].mended = { rmse: 0.1, nees: 2, outside: 0.05 }
  const against = { rmse: 0.2, nees: 4, outside: 0.1 }
  const of = (/** @type {any[]} */ all) =>
    ranked(judgement(all, { other: true, against }), { rows: 1000, truth: true, log })
  assert.match(
    of(both),
    /^Several σ may be wrong together: none of the 2 faults .* mends all by itself\. The likeliest is/,
  )
  assert.doesNotMatch(of(both), /another fault may hide/)
  assert.match(of(both.slice(0, 1)), /^Something is wrong that none of the 1 faults /)
})

test('behind a gate the σ of the motion are said where nothing is to be pressed', () => {
  const known = /** @type {any} */ ([
    { name: 'sigmaDistance', default: 0.05 },
    { name: 'sigmaTurn', default: 0.02 },
  ])
  const set = { gate: { fix: 0.999 }, sigmaDistance: 0.05, sigmaTurn: 0.02 }
  const motion = [sigma('sigmaDistance', 0.05), sigma('sigmaTurn', 0.02)]
  const own = suspect({ standing: 'maybe', own: true })
  for (const all of [motion, [own, ...motion]]) {
    assert.match(unsettledWords(judgement(all), set, known), /behind a gate they may be wrong unseen: Fit tells\.$/)
    assert.deepEqual(remedies(judgement(all), /** @type {any} */ ({ params: set, truth: null, log })), [])
  }
  assert.doesNotMatch(unsettledWords(judgement([suspect({}), ...motion]), set, known), /unseen/)
})

test('of two wheels the size of both, or size and distance, is said and taken by its factors', () => {
  const read = { ...corrections, driven: [1, 1] }
  const wheels = { ...log, motion: 'velocity', wheels: true, corrections: read }
  const size = (/** @type {number} */ value) => ({ now: 0, value, sigma: 0.0026, end: false })
  const both = suspect({ fault: 'wheel-size', name: null, sizes: [size(0.0107)] })
  assert.equal(
    sentence(both, false, wheels),
    'The robot drives and turns 1.07 ± 0.26 % more than its wheels say: take speeds and turn rates 1.0107 times as ' +
      'they are read. Both wheels 1.0107 times as large as was said do the same.',
  )
  const each = suspect({ fault: 'odometry', name: null, sizes: [size(0.0602), size(-0.0498)] })
  assert.equal(
    sentence(each, false, wheels),
    'The robot drives 6.02 ± 0.26 % farther and turns 4.98 ± 0.26 % less than its wheels say: take the speeds 1.0602 ' +
      'times and the turn rates 0.9502 times as they are read. Wheels 1.0602 times as large and a base 1.1158 times ' +
      'as long as was said do the same.',
  )
  const taken = (/** @type {any} */ one) => remedy(one, params, false, /** @type {any} */ (wheels))?.corrections?.driven
  assert.deepEqual(
    [taken(both), taken(each)],
    [
      [1.0107, 1.0107],
      [1.0602, 0.9502],
    ],
  )
  const unit = suspect({ fault: 'wheel-size', name: null, sizes: [{ ...size(8), end: true }] })
  assert.match(sentence(unit, false, wheels), /mend their unit\.$/)
  assert.equal(taken(unit), undefined)
})

test('ranges and ways that are off together are said and taken as three, and undone as one', () => {
  const read = { ...log, corrections: { ...corrections, driven: [1, 1], swerve: 0.01 } }
  const size = (/** @type {number} */ value, /** @type {number} */ sigma) => ({ now: 0, value, sigma, end: false })
  const sizes = [size(0.0217, 0.0036), size(-0.0093, 0.0172), size(-0.0186, 0.0034)]
  const all = suspect({ fault: 'lengths', name: 'scale', with: 'offset', sizes })
  assert.equal(
    sentence(all, false, read),
    'The robot drives 1.86 ± 0.34 % less far than is read, the ranges read 2.17 ± 0.36 % too long and 0.009 ± 0.017 ' +
      'm too short: take all three so. Each makes up for a part of another, and none is right by itself.',
  )
  const { patch, corrections: taken } = /** @type {any} */ (remedy(all, params, false, /** @type {any} */ (read)))
  assert.deepEqual([patch.scale, patch.offset, taken.driven], [0.0217, -0.009, [0.9814, 1]])
  assert.ok(Math.abs(taken.swerve * taken.driven[0] - 0.01) < 1e-12, 'the turn of a metre is of those metres')
})

test('wheels of two sizes are said by the turn of a metre, its side and the wheel that is larger', () => {
  const said = (/** @type {number} */ value, end = false, base = /** @type {number | null} */ (null)) =>
    sentence(suspect({ fault: 'unequal-wheels', name: null, sizes: [{ now: 0, value, sigma: 0.0012, end }] }), false, {
      ...log,
      base,
    })
  assert.equal(
    said(0.0404),
    'The robot turns 2.315 ± 0.069° more to the left on each metre than is read: take the turns so. ' +
      'A right wheel that is larger than the left by 4.04 ± 0.12 % for each metre between the two turns it so. ' +
      'If one wheel alone is off, ways and turns are wrong by half of that as well, which a verdict after this looks ' +
      'for.',
  )
  assert.match(said(-0.0404), /more to the right .* A left wheel that is larger than the right by 4\.04 ± 0\.12 %/)
  assert.match(said(0.0237, false, 0.62), /larger than the left by 1\.469 ± 0\.074 % turns it so\. If one wheel alone/)
  assert.match(said(1, true), /^The robot turns more than 57° more to the left .*: mend the sizes of its wheels/)
})

test('the turn of a metre is added to that of before, which is counted in its turns and metres', () => {
  const before = { ...log, corrections: { ...corrections, swerve: 0.01 } }
  const press = (/** @type {any} */ given) => remedy(suspect({ name: null, ...given }), params, false, before)
  const unequal = { fault: 'unequal-wheels', sizes: [{ now: 0, value: 0.0404, sigma: 0.0012, end: false }] }
  const turned = press(unequal)?.corrections?.swerve ?? 0
  assert.ok(Math.abs(turned - 0.01 - (2.315 / 180) * Math.PI) < 1e-9, `${turned}`)
  const sizes = [-0.0301, 0.0123].map((value) => ({ now: 0, value, sigma: 0.0021, end: false }))
  const counted = press({ fault: 'odometry', sizes })?.corrections?.swerve ?? 0
  assert.ok(Math.abs(counted - (0.01 * 1.0123) / 0.9699) < 1e-9, `${counted}`)
  assert.equal(press({ ...unequal, sizes: [{ ...unequal.sizes[0], end: true }] }), null, 'not found')
})

test('beside courses a late turn may be an antenna that stands elsewhere, and they may be left out', () => {
  const late = (/** @type {any} */ more) =>
    judgement([suspect({ name: 'delayTurn', sizes: [{ now: 0, value: 0.477, sigma: 0.015 }], ...more })])
  const frame = (/** @type {any} */ course, headings = true) =>
    /** @type {any} */ ({ params: { ...params, fixes: true, headings }, truth: null, log: { ...log, course } })
  const presses = (/** @type {any} */ one, /** @type {any} */ given) => remedies(one, given).map(({ press }) => press)
  assert.deepEqual(presses(late({}), frame(true)), ['Either: set it so', 'Or: leave the courses out'])
  assert.deepEqual(remedies(late({}), frame(true))[1].patch, { headings: false })
  for (const other of [frame(false), frame(true, false)]) assert.deepEqual(presses(late({}), other), ['Set it so'])
  assert.deepEqual(presses(late({ name: 'delayFix' }), frame(true)), ['Set it so'], 'positions are late by themselves')
})
