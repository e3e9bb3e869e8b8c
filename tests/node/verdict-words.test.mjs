// The sentences of a verdict on a log, each from what it is told: who is late, what is claimed, what is no remedy, and
// what is the motion model's own.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const times = (value, sigma, set = 1, unit = null) => ({ value, sigma, set, unit })
const log = { rows: 1000, truth: false }

test('a clock is late or early, by itself or beside what is set', () => {
  const clock = (size, name = 'delayFix') => sentence(suspect({ name, sizes: [size] }), false)
  assert.equal(
    clock({ now: 0, value: 0.35, sigma: 0.021 }),
    'The positions come 0.350 ± 0.021 s late: set the delay to 0.350 s.',
  )
  assert.match(
    clock({ now: 0, value: -0.35, sigma: 0.021 }),
    /come 0\.350 ± 0\.021 s early: set the delay to −0\.350 s/,
  )
  assert.match(clock({ now: 0.2, value: 0.58, sigma: 0.09 }, 'delaySpeed'), /speed comes 0\.380 ± 0\.090 s later than/)
})

test('beside odometry a delay is told from one row of motion to the next', () => {
  const told = (flat, now = 0) => sentence(suspect({ flat, sizes: [{ now, value: 0.33, sigma: 0.025 }] }), false)
  assert.match(told([0.3, 0.4]), /^The positions come 0\.30 to 0\.40 s late, and the rows of motion tell no more: set/)
  assert.match(told([0.3, 0.4], 0.6), /come 0\.20 to 0\.30 s earlier than set, and/)
  // Between rows so near to one another the noise of the readings tells less.
  assert.match(told([0.32, 0.34]), /^The positions come 0\.330 ± 0\.025 s late: set/)
})

test('where no motion was read, that is said before any fault', () => {
  const gaps = [{ what: 'held', count: 1, longest: [120, 150.04], between: [151, 900] }]
  const said = ranked(judgement([suspect({})], { gaps }), log)
  assert.match(said, /^No rows of motion from 120\.0 to 150\.0 s after .*: what was read last is held .* The positions/)
  const speed = [{ what: 'speed', count: 3, longest: [10, 12], between: [12, 90] }]
  assert.match(ranked(judgement([suspect({})], { gaps: speed }), log), /^No speed from 10\.0 to 12\.0 s .* of 3 such/)
  assert.match(ranked(judgement([suspect({ standing: 'cleared' })], { gaps }), log), /^No fault/)
})

test('a σ is claimed too small or too large, and what is not told has no ±', () => {
  const sigma = (value, told) =>
    sentence(suspect({ fault: 'sigma', name: 'sigmaFix', sizes: [{ now: 1, value, sigma: told }] }), false)
  assert.equal(sigma(1.64, 0.1), 'The σ of a position is 1.64 ± 0.10 m, and is set to 1: set it higher.')
  assert.match(sigma(0.2, null), /is about 0\.20 m, and is set to 1: set it lower/)
})

test('what readings claim is named with what fits, and the factor that mends it', () => {
  const claims = (more, size = { now: 1, value: 5.0017, sigma: 0.1176 }) =>
    suspect({ fault: 'sigma', name: 'fixSigmaScale', claims: [0.1, 0.1, 0.1], sizes: [size], ...more })
  assert.equal(
    sentence(claims({}), false),
    'The positions claim 0.1 m, and 0.500 ± 0.012 m fits: set the factor on their own σ to 5.00.',
  )
  assert.match(sentence(claims({ claims: [0.05, 0.1, 9] }), false), /^The positions claim 0\.1 m in the median, and/)
  assert.match(
    sentence(claims({}, { now: 2, value: 4.5, sigma: 0.1 }), false),
    /^The positions claim 0\.1 m, taken times 2, and 0\.450 ± 0\.010 m fits: set the factor on their own σ to 4\.50\./,
  )
  assert.match(
    sentence(claims({ name: 'headingSigmaScale' }, { now: 1, value: 0.25, sigma: 0.006 }), false),
    /^The headings claim 0\.1 rad, and 0\.02500 ± 0\.00060 rad fits: set the factor on their own σ to 0\.2500\.$/,
  )
  const mended = { rmse: 3, nees: 9, outside: 0.4 }
  const none = judgement([claims({ mended })], { against: { rmse: 2, nees: 3, outside: 0.2 }, other: true })
  assert.match(
    ranked(none, log),
    /likeliest is this: The positions claim 0\.1 m, .* Mended so, the estimate would be 3\.00 m/,
  )
})

test('a share of outliers has its ± where it is clear of it, and a handful is about so many', () => {
  const tails = (value, sigma) =>
    sentence(suspect({ fault: 'tails', name: null, sensor: 'fix', sizes: [{ now: 0, value, sigma }] }), false)
  assert.match(tails(0.13, 0.0154), /^13\.0 ± 1\.5 % of the positions are outliers: switch their gate on/)
  assert.match(tails(0.0075, 0.0043), /^About 0\.75 % of the positions are outliers: switch their gate on/)
  const sizes = [
    { now: 0, value: 0.067, sigma: 0.007 },
    { now: 0.6, value: 0.12, sigma: 0.003 },
  ]
  assert.match(
    sentence(suspect({ fault: 'tails', name: 'sigmaRange', sensor: 'range', sizes }), false),
    /which refuses them\. Without them the σ of a range is 0\.1200 ± 0\.0030 m, and is set to 0\.6\.$/,
  )
  assert.match(
    sentence(suspect({ fault: 'tails', name: 'fixSigmaScale', sensor: 'fix', sizes }), false),
    /Without them 0\.1200 ± 0\.0030 times the σ that the positions bring fits\.$/,
  )
})

test('where two explain the readings alike both are named, and where chance does it is said', () => {
  const other = suspect({ name: 'delaySpeed', standing: 'maybe', excess: 13 })
  const either = ranked(judgement([suspect({ standing: 'maybe' }), other]), log)
  assert.match(either, /^Either: The positions come .* Or: The speed comes .* The readings do not tell which\.$/)
  const little = ranked(judgement([suspect({ standing: 'maybe', excess: 0.4 })]), log)
  assert.match(little, /^Perhaps: The positions .* Chance explains it nearly as well\.$/)
  const none = ranked(judgement([suspect({ standing: 'cleared' })]), log)
  assert.equal(
    none,
    'No fault: of the 1 that were looked for, none makes the 2,067 readings likelier than chance does.',
  )
  const long = ranked(judgement([suspect({ standing: 'cleared' })]), { rows: 5000, truth: false })
  assert.match(long, / The first 1,000 rows are judged\.$/)
})

test('a remedy that leads away from the truth is none', () => {
  const [against, mended] = [
    { rmse: 0.13, nees: 3, outside: 0.2 },
    { rmse: 0.25, nees: 9, outside: 0.4 },
  ]
  const wrong = suspect({ fault: 'bias', name: 'offset', standing: 'maybe', mended })
  const said = ranked(judgement([wrong], { against, other: true }), log)
  assert.match(said, /^Something is wrong that none of the 1 faults .* mends by itself\. .* is this: The ranges read/)
  assert.match(said, /would be 0\.25 m from the truth, where it is 0\.13 m from it now .*may hide behind it\./)
  assert.doesNotMatch(said, /Mended so, the RMS/)
  const chance = ranked(judgement([{ ...wrong, standing: 'cleared' }], { against }), log)
  assert.match(chance, /^No fault: .* That is more than chance: a σ may/)
  assert.doesNotMatch(chance, /Mended so/, 'nothing is named')
  // One that was held against the truth and fell is no rival of the one that did not.
  const better = suspect({ standing: 'maybe', mended: { rmse: 0.1, nees: 2, outside: 0.05 } })
  const passed = ranked(judgement([better, suspect({ standing: 'maybe', excess: 16, mended })], { against }), log)
  assert.match(passed, /^Perhaps: The positions come .* Mended so, the RMS error goes from 0\.13 to 0\.10 m/)
})

test('numbers that hold without the gate alone are said to', () => {
  const [against, mended] = [
    { rmse: 11.14, nees: 5896, outside: 0.92 },
    { rmse: 0.37, nees: 2.2, outside: 0.06 },
  ]
  const said = ranked(judgement([suspect({ mended })], { against, ungated: true }), log)
  assert.match(
    said,
    /Against the truth, without the gate, the NEES .* the RMS error, without the gate, goes from 11\.14/,
  )
})

test('a turned compass, turns of the wrong sign, and scale and offset together have their sentences', () => {
  const of = (given) => sentence(suspect(given), false)
  assert.equal(
    of({ fault: 'turned', name: 'headingOffset', sizes: [{ now: 0, value: 0.2, sigma: 0.0026 }] }),
    'The compass reads 11.46 ± 0.15° too far counter-clockwise: ' +
      'set the offset of the headings, counted counter-clockwise, to 11.46°.',
  )
  assert.match(
    of({ fault: 'mirrored', name: null, sizes: [] }),
    /^The turns have the wrong sign: choose the unit of ω that turns the other way/,
  )
  const sizes = [
    { now: 0.0395, value: 0.03, sigma: 0.00055 },
    { now: 0, value: 0.493, sigma: 0.028 },
  ]
  assert.equal(
    of({ fault: 'scale', name: 'scale', with: 'offset', sizes, times: times(1.03, 0.00055, 1.0395) }),
    'The ranges read 3.000 ± 0.055 % too long and 0.493 ± 0.028 m too long, ' +
      'where 3.95 % too long is what the settings say: set their scale to 3.000 % and their offset to 0.493 m.',
  )
})

test('what is the motion model’s own is said, and is no fault', () => {
  const own = suspect({ standing: 'cleared', own: true, sizes: [{ now: 0, value: -0.021, sigma: 0.009 }] })
  const said = ranked(
    judgement([suspect({ standing: 'cleared' }), own], { arcs: 171.24, period: 0.5, ownDelay: 0.25 }),
    log,
  )
  assert.match(
    said,
    /^No fault: of the 2 .* than chance does, but for what may be the motion model’s own\. The positions come/,
  )
  assert.match(
    said,
    /come 0\.0210 ± 0\.0090 s early: less than half a step between rows of motion, 0\.25 s\. That may be the/,
  )
  const longer = suspect({ standing: 'cleared', own: true, sizes: [{ now: 0, value: -0.4, sigma: 0.09 }] })
  assert.match(
    ranked(judgement([suspect({ standing: 'cleared' }), longer], { period: 0.5, ownDelay: 0.5 }), log),
    /come 0\.400 ± 0\.090 s early: less than a step between rows of motion, 0\.5 s\. That/,
  )
  const doubtful = suspect({ standing: 'maybe', own: true, sizes: [{ now: 0, value: -0.6, sigma: 0.1 }] })
  assert.match(
    ranked(judgement([doubtful], { period: 0.5, ownDelay: 0.5 }), log),
    /^Perhaps: .* Of it a step between rows of motion, 0\.5 s, may be the motion model’s own, and .* be no fault\./,
  )
  const short = suspect({ standing: 'maybe', own: true, sizes: [{ now: 0, value: -0.4, sigma: 0.1 }] })
  assert.match(
    ranked(judgement([short], { period: 0.5, ownDelay: 0.5 }), log),
    / All of it, less than a step between rows of motion, 0\.5 s, may be the motion model’s own: it may be no fault\.$/,
  )
  assert.match(
    said,
    /with rows of motion 0\.5 s apart this costs 171\.2 of the log-likelihood\. .* no fault of the log\.$/,
  )
  // A log with a fault tells what its steps cost as soon as that is mended.
  assert.doesNotMatch(ranked(judgement([suspect({})], { arcs: 50 }), log), /costs/)
})

test('landmarks that are exchanged have the names of their file, or their numbers', () => {
  const exchanged = suspect({ fault: 'exchanged', name: null, sizes: [], landmarks: [1, 2] })
  const named = { motion: 'velocity', names: ['A12', 'north door'] }
  assert.match(sentence(exchanged, false, named), /^Landmarks A12 and north door are .* exchange their names where/)
  assert.match(sentence(exchanged, false), /^Landmarks 1 and 2 are taken for one another: exchange their numbers where/)
})

test('a landmark that stands elsewhere is said with how far, and where its place is to be written', () => {
  const sizes = [
    { now: 3, value: 4.2, sigma: 0.031, end: false },
    { now: 1, value: 0.5, sigma: 0.04, end: false },
  ]
  const elsewhere = suspect({ fault: 'displaced', name: null, sizes, landmarks: [2] })
  const named = { motion: 'velocity', names: ['A1', 'A3'] }
  const said = 'stands 1.30 m beside its place: write 4.200 ± 0.031 m and 0.500 ± 0.040 m where that is said.'
  assert.equal(sentence(elsewhere, false, named), `Landmark A3 ${said}`)
  assert.equal(sentence(elsewhere, false), `Landmark 2 ${said}`)
})

test('odometry that reads too long or too short is said by factors, and by the wheels that do so', () => {
  const sizes = [
    { now: 0, value: -0.0301, sigma: 0.0021, end: false },
    { now: 0, value: 0.0123, sigma: 0.0034, end: false },
  ]
  const odometry = (given) => suspect({ fault: 'odometry', name: null, sizes: given })
  const log = { motion: 'odometry', names: [] }
  const said =
    'The robot drives 3.01 ± 0.21 % less far and turns 1.23 ± 0.34 % more than odometry reads: take the distances ' +
    '0.9699 times and the turns 1.0123 times as they are read.'
  const wheels = 'radius 0.9699 times and a base 0.9581 times as long as was said do the same.'
  assert.equal(sentence(odometry(sizes), false, log), `${said} Of two wheels a ${wheels}`)
  assert.equal(sentence(odometry(sizes), false, { ...log, wheels: true }), `${said} A ${wheels}`)
  assert.match(sentence(odometry(sizes.slice(0, 1)), false, log), / less far than odometry reads: take the distances /)
  assert.match(sentence(odometry([{ ...sizes[0], value: 9, end: true }]), false, log), /mend their unit\.$/)
  const cleared = (more) =>
    ranked(judgement([...more, suspect({ standing: 'cleared' })]), { rows: 1000, truth: false, log })
  assert.match(cleared([]), / A scale of odometry’s distances is not among them\./)
  assert.doesNotMatch(cleared([{ ...odometry(sizes), standing: 'cleared' }]), /is not among them/)
})

test('errors far beyond the ellipse of a log without a fault speak against the truth', () => {
  const against = (outside) => ({ against: { rmse: 1, nees: 9, outside } })
  const said = (outside) =>
    ranked(judgement([suspect({ standing: 'cleared' })], against(outside)), { rows: 1000, truth: true })
  assert.match(said(0.6), /a σ may have taken in a fault .*, or the truth is off, by its origin, .* own errors\.$/)
  assert.doesNotMatch(said(0.1), /more than chance/)
  // Of a robot that drives a metre in the step that is held nothing is to be said against the truth.
  const held = { ...against(0.6), pace: 20, ownDelay: 0.05 }
  const small = ranked(judgement([suspect({ standing: 'cleared' })], held), { rows: 1000, truth: true })
  assert.match(small, /lie beyond [^.]*95 %\. The errors are no larger than what the motion model has as its own/)
})

test('a start is said with how well it is known, and far from its origin with its digits', () => {
  const size = (value, sigma) => ({ now: 0, value, sigma })
  const far = suspect({
    fault: 'start',
    name: null,
    sizes: [size(4430123.456, 0.012), size(5333.1, 0.3), size(1, 0.1)],
  })
  assert.match(
    sentence(far, false),
    /set the start to 4430123\.456 ± 0\.012 m, 5333\.10 ± 0\.30 m and 57\.3 ± 5\.7°\.$/,
  )
})

test('of a delay of a step or two half a step may be the motion model’s own, and that is said', () => {
  const late = (/** @type {number} */ value) => suspect({ sizes: [{ now: 0, value, sigma: 0.0093, end: false }] })
  const said = (/** @type {number} */ value) => ranked(judgement([late(value)], { period: 0.05, ownDelay: 0.025 }), log)
  assert.match(
    said(-0.0511),
    /set the delay to .*\. Of it half a step between rows of motion, 0\.025 s, may be the motion/,
  )
  assert.doesNotMatch(said(0.35), /Of it half a step/)
})
