// A verdict's sentences on a factor, on what lies at the end of a search, and on a σ that hides a fault: they say what
// is read beside what is there, and not what a filter is to multiply by.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { sentence as fitted } from '../../web/page/log-fit-words.js'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

/** A speed that is off by a factor. @param {Record<string, unknown>} given */
const scaled = (given) =>
  suspect({
    fault: 'scale',
    name: 'speedScale',
    sizes: [{ now: 0, value: -1 / 6, sigma: 0.002, end: false }],
    ...given,
  })
/** @param {number} value @param {number} sigma @param {[string, string] | null} [unit] @param {number} [set] */
const times = (value, sigma, unit = null, set = 1) => ({ value, sigma, unit, set })
const size = (value, sigma, more) => ({ now: 0, value, sigma, end: false, ...more })
const said = (given) => sentence(scaled(given), false)

test('a speed that reads too much is said to by what it reads too much', () => {
  assert.equal(
    said({ times: times(1.2, 0.0029) }),
    'The speed reads 20.00 ± 0.29 % too high: let the filter learn its scale.',
  )
  assert.match(
    said({ sizes: [size(0.25, 0.003)], times: times(0.8, 0.0019) }),
    /^The speed reads 20\.00 ± 0\.19 % too low:/,
  )
  assert.match(
    said({ times: times(1.2, 0.0029, null, 1.1) }),
    /^The speed reads 20\.00 ± 0\.29 % too high, where 10 % too high is what the settings say: let/,
  )
  assert.equal(
    said({ name: 'scale', sizes: [size(0.07, 0.0005)], times: times(1.07, 0.0005) }),
    'The ranges read 7.000 ± 0.050 % too long: set their scale to 7.000 %.',
  )
})

test('a factor between two units asks for them', () => {
  assert.equal(
    said({ sizes: [size(-0.7222, 0.001)], times: times(3.61, 0.011, ['km/h', 'm/s']) }),
    'The speed reads 3.610 ± 0.011 times what it is: is it in km/h, and taken for m/s? Then mend the unit; ' +
      'else let the filter learn its scale.',
  )
  assert.match(
    said({ name: 'scale', sizes: [size(2.28, 0.01)], times: times(3.28, 0.01, ['ft', 'm']) }),
    /^The ranges read 3\.280 ± 0\.010 times what they are: are they in ft, .* for m\? .*set their scale to 228\.0 %\.$/,
  )
})

test('what lies at the end of a search is more than that, and has no ±', () => {
  const end = { end: true }
  assert.equal(
    said({ sizes: [size(-0.9, 0.01, end)], times: times(10, 1) }),
    'The speed reads more than 10 times what it is: mend the unit.',
  )
  assert.match(
    said({ sizes: [size(9, 0.9, end)], times: times(0.1, 0.01) }),
    /reads less than 0\.1 times what it is: mend/,
  )
  const clock = { fault: 'clock', name: 'delayHeading' }
  assert.equal(
    said({ ...clock, sizes: [size(3, 0.035, end)] }),
    'The headings come more than 3.0 s late: set the delay to 3.0 s. ' +
      'No longer delay was tried. Where a whole file has another clock, add the seconds to its times, among its ' +
      'columns.',
  )
  assert.match(
    said({ fault: 'bias', name: 'turnBias', sizes: [size(-1, 0.01, end)] }),
    /reads more than 1\.0 rad\/s too little/,
  )
  const sigma = (value, now) =>
    said({ fault: 'sigma', name: 'sigmaFix', sizes: [{ now, value, sigma: 0.1, end: true }] })
  assert.match(sigma(1000, 1), /is more than 1000 m, and is set to 1: set it higher/)
  assert.match(sigma(0.0001, 1), /is less than 0\.00010 m, and is set to 1: set it lower/)
  const turned = said({ fault: 'turned', name: 'headingOffset', sizes: [size(-Math.PI, 0.01, end)] })
  assert.match(turned, /^The compass reads about 180° too far clockwise/)
})

test('a σ of the distance that is a good part of the way is told with what it may hide', () => {
  const hides = 'So much is 40 % of what is driven in a second: a fault of the motion may hide in it.'
  const number = { name: 'sigmaDistance', value: 0.6, sigma: 0.03, relative: true, flat: null, most: null }
  assert.equal(
    fitted(number, { pace: 1.5, period: 0.1, ownDelay: 0.05 }),
    `σ of the distance, m/√s: 0.600 ± 3.0 %. ${hides}`,
  )
  assert.equal(
    fitted({ ...number, value: 0.06 }, { pace: 1.5, period: 0.1, ownDelay: 0.05 }),
    'σ of the distance, m/√s: 0.0600 ± 3.0 %',
  )
  assert.doesNotMatch(fitted({ ...number, name: 'sigmaFix' }, { pace: 1.5, period: 0.1, ownDelay: 0.05 }), /hide/)
  assert.doesNotMatch(fitted(number, { pace: 0, period: 0.1, ownDelay: 0.05 }), /hide/, 'a robot that never drives')
  const log = { rows: 1000, truth: false }
  const sigma = (now, value, standing) =>
    scaled({ fault: 'sigma', name: 'sigmaDistance', standing, sizes: [{ now, value, sigma: 0.02, end: false }] })
  const larger = ranked(judgement([sigma(0.05, 0.6, 'sure')]), log)
  assert.match(larger, new RegExp(`set to 0\\.05: set it higher\\. ${hides} The log-likelihood rises`))
  const taken = ranked(judgement([sigma(0.6, 0.6, 'cleared')]), log)
  assert.match(taken, new RegExp(`^No fault: .* The σ of the distance is set to 0\\.6 m/√s\\. ${hides}$`))
  assert.doesNotMatch(ranked(judgement([sigma(0.06, 0.06, 'cleared')]), log), /hide/)
})

test('of a turned camera it is said what may be the motion model’s own', () => {
  const turned = suspect({ fault: 'turned', name: 'bearingOffset', sizes: [size(0.0568, 0.0016)] })
  const told = (/** @type {number} */ halfTurn) =>
    ranked(judgement([turned], { halfTurn }), { rows: 1000, truth: false })
  assert.match(told(0.0042), /to 3\.254°\. 0\.24° of that may be the motion model’s own, half of the turn of a step\. /)
  assert.doesNotMatch(told(0.0002), /own/)
})
