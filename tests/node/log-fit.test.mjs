// What a fit of a log has found, in words, and what of it is taken.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import {
  bentBy,
  stayingBy,
  delaysAreOfModel,
  isAsSet,
  isOfModel,
  rises,
  sentence as fitted,
  untold,
  vague,
  whyAsSet,
} from '../../web/page/log-fit-words.js'
import { judgement, suspect } from './verdicts.mjs'
import { gated } from '../../web/page/log-remedy.js'

const MOTION = { pace: 1, period: 0.1, ownDelay: 0.05 }

test('a σ that the log does not tell stays, or is no greater than one that is as likely as all smaller ones', () => {
  const number = (name, sigma, /** @type {number | null} */ most = null, relative = true) =>
    /** @type {any} */ ({ name, value: 1e-4, sigma, relative, flat: null, most })
  const params = { sigmaDistance: 0.1, sigmaTurn: 0.002, fixSigmaScale: 1 }
  assert.deepEqual(untold([number('sigmaTurn', 0.05), number('delayFix', null, null, false)], params), [])
  const all = [number('sigmaDistance', null, 0.00553), number('sigmaTurn', null, 0.004), number('fixSigmaScale', null)]
  assert.deepEqual(
    untold(all, params).map(({ value, words }) => [value, words]),
    [
      [
        0.00553,
        'The log does not tell the σ of the distance: all up to about 0.0055 m/√s are as likely, and it is ' +
          'set so.',
      ],
      [
        0.002,
        'The log does not tell the σ of the turn: all up to about 0.004 rad/√s are as likely, and it ' +
          'stays 0.002 rad/√s.',
      ],
      [1, 'The log does not tell the factor on the positions’ own σ: it stays 1.'],
    ],
  )
  assert.equal(
    fitted(all[0], MOTION),
    'σ of the distance, m/√s: the log does not tell it; all up to about 0.0055 are as likely.',
  )
  assert.deepEqual(vague([number('sigmaDistance', 0.43), number('sigmaTurn', 0.05), number('sigmaFix', null)]), [
    'The σ of the distance is known to ± 43 % only.',
  ])
})

test('what a fit has found has as many digits as it is known to', () => {
  const number = (name, value, sigma, relative = false) =>
    fitted({ name, value, sigma, relative, flat: null, most: null }, MOTION)
  assert.equal(number('delayFix', 0.38547, 0.00134), 'delay of the positions, s: 0.3855 ± 0.0013')
  assert.equal(number('delayFix', 0.399941, 0.0000202), 'delay of the positions, s: 0.399941 ± 0.000020')
  assert.equal(number('sigmaFix', 0.029967, 0.01342, true), 'σ of a position, m: 0.02997 ± 1.3 %')
  assert.equal(number('headingOffset', 0.2, 0.0025), 'offset of the headings, °: 11.46 ± 0.14')
  assert.equal(number('offset', -12.3, 25), 'offset of the ranges, m: −12 ± 25')
  assert.match(number('scale', 0.03, null), /does not tell it/)
  const turned = { name: 'bearingOffset', value: 0.0567, sigma: 0.0008, relative: false, flat: null, most: null }
  assert.equal(
    fitted(turned, { ...MOTION, halfTurn: 0.0042 }),
    'offset of the bearings, °: 3.249 ± 0.046, of which 0.241 may be the motion model’s own, half of the turn of a ' +
      'step',
  )
  assert.doesNotMatch(fitted(turned, { ...MOTION, halfTurn: 0.0002 }), /own/)
  const stair = fitted(
    { name: 'delayFix', value: 0.317, sigma: 0.025, relative: false, flat: [0.3, 0.4], most: null },
    MOTION,
  )
  const short = { name: 'delaySighting', value: -0.0108, sigma: 0.0023, relative: false, flat: null, most: null }
  const own = /: −0\.0108 ± 0\.0023: less than half a step between rows of motion, 0\.05 s, .* own, and not taken$/
  assert.match(fitted(short, MOTION), own)
  assert.deepEqual([isOfModel(short, 0.05), isOfModel(short, 0.01)], [true, false])
  // What is late against another is told: short delays beside a longer one are taken with it.
  const late = { ...short, name: 'delayFix', value: 0.42 }
  assert.deepEqual([delaysAreOfModel([short], 0.1), delaysAreOfModel([short, late], 0.1)], [true, false])
  assert.match(stair, /^delay of the positions, s: 0\.30 to 0\.40, all alike: the log has no row of motion in between$/)
})

test('a fit that outliers have bent says so, and a sound one does not', () => {
  /** @param {number} beyond @param {number} readings @param {number | null} [outliers] */
  const bent = (beyond, readings, outliers = null, refused = outliers) =>
    bentBy({ beyond, expected: 0.001, readings, outliers, refused })
  const words =
    /^2\.0 % of these readings lie beyond what should hold 99\.9 % of them: outliers, or .* or switch on the gate/
  assert.match(bent(40, 2000), words)
  assert.equal(bent(4, 2000), '')
  assert.equal(bent(3, 100), '', 'few readings say nothing')
  const gated =
    /^2\.0 % of the others lie beyond .* a start or another fault that the verdict names, .* Mend that first\.$/
  assert.match(bent(40, 2100, 100), gated, 'of the readings that are left')
  assert.match(bent(0, 2000, 1001), /^Most readings count as outliers/)
  assert.match(
    bent(0, 2000, 20, 480),
    /^Under what was found the gates refuse 24 % .* loses its way, .* Switch the gates off/,
  )
  assert.equal(bent(0, 2000, 20, 300), '', 'a narrow gate')
  assert.equal(bent(0, 2000, 200, 700), '', 'many outliers')
  assert.equal(bent(0, 2000, 999), '')
})

test('a fit says how many readings it has left out, and no sum that is on no other place of the page', () => {
  /** @type {Parameters<typeof rises>[0]} */
  const found = { logLikelihood: [-100, -60], readings: 2000, outliers: null, settled: true }
  assert.equal(rises(found), 'The log-likelihood of 2,000 readings rises by 40.0, to −60.0.')
  /** @param {number} outliers */
  const behind = (outliers, settled = true) => rises({ ...found, outliers, settled })
  const rise = 'The log-likelihood of 2,000 readings rises by 40.0.'
  assert.equal(behind(0), `${rise} None is an outlier.`)
  assert.equal(behind(1), `${rise} 1 (0.05 %) is an outlier and was left out.`)
  assert.equal(
    behind(100, false),
    `${rise} 100 (5.0 %) are outliers and were left out. The search was ended before it settled.`,
  )
})

test('what a fit tells by less than twice its ± from what is set stays, and a σ is always taken', () => {
  const number = (more) => ({ name: 'delayFix', value: -0.06, relative: false, sigma: 0.035, flat: null, ...more })
  const late = { delayFix: 0 }
  assert.equal(isAsSet(number({}), late), true)
  assert.equal(isAsSet(number({ value: 0.64 }), late), false)
  assert.equal(isAsSet(number({}), { delayFix: 0.64 }), false)
  assert.equal(isAsSet(number({ sigma: null }), late), false, 'it is not told at all')
  const sigma = number({ name: 'sigmaFix', value: 1, relative: true })
  assert.equal(isAsSet(sigma, { sigmaFix: 1 }), false)
  // A likelihood may have a top where nothing is late: where the verdict finds no fault, no delay is taken.
  assert.equal(whyAsSet(number({ value: 0.996, sigma: 0.054 }), late, ': so it stays'), ': so it stays')
  assert.equal(whyAsSet(number({ value: 0.996, sigma: 0.054 }), late, ''), '')
  assert.equal(whyAsSet(sigma, { sigmaFix: 3 }, ': so it stays'), '')
})

test('a delay that its ± tells less well than the rows of motion has its ±', () => {
  /** @type {import('estimate-wasm').LogFound['numbers'][number]} */
  const number = { name: 'delayFix', value: 0.65, relative: false, sigma: 0.04, flat: [0.64, 0.66], most: null }
  const motion = { pace: 1, period: 0.1, ownDelay: 0 }
  assert.match(fitted(number, motion), /^delay of the positions, s: 0\.650 ± 0\.040$/)
  assert.match(fitted({ ...number, sigma: 0.005 }, motion), /0\.64 to 0\.66, all alike/)
  assert.match(fitted({ ...number, sigma: null }, motion), /0\.64 to 0\.66, all alike/)
})

test('what a verdict does not find wrong is not taken, and a delay that may be wrong leaves all open', () => {
  const of = (/** @type {any[]} */ ...suspects) => stayingBy(judgement(suspects.map(suspect)))
  const stays = (/** @type {any[]} */ ...suspects) =>
    ['delayFix', 'delaySpeed', 'offset'].map((name) => of(...suspects)(name) !== '')
  const sigma = { fault: 'sigma', name: 'sigmaFix' }
  const cleared = { fault: 'bias', name: 'offset', standing: 'cleared' }
  assert.deepEqual(stays(sigma, { standing: 'cleared' }, cleared), [true, true, true])
  assert.match(of(sigma, cleared)('offset'), /does not find it wrong, so it stays/)
  assert.deepEqual(stays(sigma, { standing: 'maybe' }), [false, false, true])
  // One that may be the model's own leaves none to be taken, and one that is no such leaves all.
  assert.match(of({ standing: 'maybe', own: true })('delaySpeed'), /calls it no fault, as it may be the motion model’s/)
  assert.deepEqual(stays({ standing: 'maybe', own: true }, { name: 'delaySpeed' }), [false, false, true])
  assert.deepEqual(stays({ fault: 'scale', name: 'scale', with: 'offset' }), [true, true, false])
  assert.equal(stayingBy(null)('delayFix'), '', 'before there is a verdict')
  const elsewhere = { fault: 'displaced', name: null, landmarks: [2] }
  assert.match(of(elsewhere, { fault: 'bias', name: 'offset', standing: 'maybe' })('offset'), /to be mended first/)
  assert.match(stayingBy(judgement([suspect({})], { other: true }))('delayFix'), /to be mended first/)
})

test('σ that were found beside outliers come with gates, and those of a sound log do not', () => {
  const found = (/** @type {number | null} */ outliers) =>
    /** @type {any} */ ({ outliers, readings: 2000, expected: 0.001 })
  assert.deepEqual(gated(found(121), { gate: null }), {
    gate: { gate: 0.999 },
    words: '6.0 % of the readings are outliers: the gates are on, and refuse them.',
  })
  // Two in two thousand lie there by chance, and six may.
  for (const [outliers, gate] of [
    [6, null],
    [null, null],
    [121, 0.99],
    [121, { fix: 0.99, heading: null, range: null, bearing: null }],
  ])
    assert.deepEqual(gated(found(/** @type {any} */ (outliers)), { gate }), { gate: {}, words: '' })
})
