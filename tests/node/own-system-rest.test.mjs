// What is said of a covariance that comes to rest or falls on, of a matrix of rates that is given as a step's, and of
// entries of a gain that rounding leaves.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { estimate, widget } from './claims.mjs'
import { withoutRounding } from '../../web/widgets/own-system/index.js'
import { limitWords } from '../../web/widgets/own-system/limit.js'
import { PRESETS, paramsOf } from '../../web/widgets/own-system/presets.js'
import { readSystem } from '../../web/widgets/own-system/read.js'
import { wordsOf } from '../../web/widgets/own-system/typed-system.js'
import { settles, verdict } from '../../web/widgets/own-system/words.js'

const { start, readouts, tries } = await widget('own-system')

/** The frame that a pasted system opens. @param {string} text @param {Record<string, unknown>} [more] */
function pasted(text, more = {}) {
  const { system, fault } = /** @type {any} */ (readSystem(text))
  assert.ok(system, fault)
  const params = { ...start.params, ...paramsOf(system), ...more }
  const lab = estimate.OwnSystem.from({ version: 1, lab: 'own-system', step: 0, params })
  const frame = lab.frame()
  lab.free()
  return frame
}

const BESIDE = [
  'F = [0.9 0 0; 0 1 0; 0 0 1]; H = [1 1 1]; V = diag([0.1 0.001 0]); W = 0.2',
  'F = [0.9 0 0; 0 1 0; 0 0 1]; H = [1 1 1]; V = diag([0.1 0.01 0]); W = 0.2',
  'F = [1 0 0; 0 0.9 0; 0 0 1]; H = [1 1 1]; V = diag([0 0.1 0.001]); W = 0.2; P0 = diag([2 2 2])',
  'F = eye(2); H = [1 1]; V = diag([0.001 0]); W = 0.2',
]

test('a constant that only the start tells from a walk is not said to be averaged', () => {
  for (const text of BESIDE) {
    const frame = pasted(text)
    assert.match(settles(frame), /^in \d+ steps$/, text)
    assert.match(
      verdict(frame),
      /From this start it settles in \d+ steps; a larger start leads to another limit\./,
      text,
    )
    assert.doesNotMatch(verdict(frame), /average/, text)
  }
})

test('a constant that a reading tells by itself is', () => {
  for (const text of [
    'F = [0.9 0; 0 1]; H = [1 1]; V = diag([0.1 0]); W = 0.2',
    'F = [0.9 0 0; 0 0.5 0; 0 0 1]; H = [1 1 1]; V = diag([0.1 0.001 0]); W = 0.2',
  ]) {
    assert.equal(settles(pasted(text)), 'falls as an average', text)
    assert.match(verdict(pasted(text)), /goes on falling as the variance of an average: where no noise is/, text)
  }
  assert.equal(settles(pasted('F = 1; H = 1; V = 0; W = 0.2')), 'falls towards 0')
})

test('an average beside what no reading sees is said to fall on, whatever the unseen does', () => {
  const grows = /has no limit: .* grows without end\. Another part of it goes on falling as the variance of an average/
  const turns = /may depend on the start: .* From this start a part of it goes on falling as the variance of an average/
  for (const [text, settling, words] of /** @type {[string, string, RegExp][]} */ ([
    // The unseen walks, beside a constant that is read and one that is read through a state that noise moves.
    ['F = eye(2); H = [1 0]; V = diag([0 0.1]); W = 0.2', 'never', grows],
    ['F = [0.9 0 0; 0 1 0; 0 0 1]; H = [1 1 0]; V = diag([0.1 0 0.1]); W = 0.2', 'never', grows],
    ['F = [1 0; 0 1.2]; H = [1 0]; V = diag([0 0.1]); W = 0.2', 'never', grows],
    // It turns for ever, or drifts, and no noise feeds it.
    [
      'F = [1 0 0; 0 0.6 0.8; 0 -0.8 0.6]; H = [1 0 0]; V = zeros(3); W = 0.2; P0 = diag([1 2 1])',
      'a part falls as an average',
      turns,
    ],
    ['F = [1 0 0; 0 1 1; 0 0 1]; H = [1 0 0]; V = zeros(3); W = 0.2', 'a part falls as an average', turns],
  ])) {
    const frame = pasted(text)
    assert.equal(settles(frame), settling, text)
    assert.match(verdict(frame), words, text)
    assert.doesNotMatch(verdict(frame), /not settled/, text)
  }
  // Where the unseen stays as it is, or nothing falls as an average, it is said as before.
  assert.equal(settles(pasted('F = eye(2); H = [1 0]; V = zeros(2); W = 0.2')), 'falls as an average')
  const still = pasted('F = [0.9 0; 0 1]; H = [1 0]; V = diag([0.1 0.1]); W = 0.2')
  assert.equal(still.doubled.part, false)
  assert.doesNotMatch(verdict(still), /average/)
})

test('what rounding makes of an eigenvalue of 0 is no digit, and no time constant', () => {
  const chain = (/** @type {number} */ steps) => {
    const n = steps + 1
    const row = (/** @type {number} */ i) =>
      Array.from({ length: n }, (_, j) => Number(j === Math.max(0, i - 1))).join(' ')
    const rows = Array.from({ length: n }, (_, i) => row(i)).join('; ')
    const last = Array.from({ length: n }, (_, j) => Number(j === steps)).join(' ')
    const noise = Array.from({ length: n }, (_, j) => (j === 0 ? 0.01 : 0)).join(' ')
    return `F = [${rows}]; H = [${last}]; V = diag([${noise}]); W = 1; T = 0.1`
  }
  for (const steps of [3, 6]) {
    const frame = pasted(chain(steps))
    const value = readouts(frame).find(({ key }) => key === 'roots')?.value ?? ''
    assert.equal(value, `0.905 (1 s)${', 0.000'.repeat(steps)}`)
    assert.equal(frame.eigenvalues.filter(({ modulus }) => modulus === 0).length, steps)
  }
  const none = pasted('F = zeros(2); H = [1 0]; V = eye(2); W = 1; T = 0.1')
  const all = readouts(none)
  const of = (/** @type {string} */ name) => all.find(({ key }) => key === name)?.value
  assert.deepEqual([of('roots'), of('steps'), of('seconds')], ['0.000, 0.000', '1', '–'])
  const untimed = readouts(pasted('F = [1 0.1; 0 1]; H = [1 0]; V = diag([0 0.1]); W = 1'))
  assert.equal(untimed.find(({ key }) => key === 'seconds')?.value, 'needs a step’s length')
})

test('of a limit all rows are shown, but of a large one the diagonal; a covariance that is rounding is 0', () => {
  assert.equal(limitWords(null), 'none')
  // Two walks that two readings tell apart: P = (1 + √5)/2 each, for V = W = 1.
  const apart = pasted('F = eye(2); H = eye(2); V = diag([1 1]); W = diag([1 1])')
  assert.equal(limitWords(apart.limitP), '1.62, 0; 0, 1.62')
  assert.equal(
    limitWords(pasted('F = eye(5); H = eye(5); V = eye(5); W = eye(5)').limitP),
    `diagonal ${Array(5).fill('1.62').join(', ')}`,
  )
  const beside = (/** @type {number} */ c) => limitWords([1, 2].map((i) => [1, 2].map((j) => (i === j ? i * i : c))))
  assert.deepEqual([1e-13, 1e-11].map(beside), ['1, 0; 0, 4', '1, 1.0e−11; 1.0e−11, 4'])
})

test('beside a system of the reader’s own stands no phrase of another, and what stands there keeps the system', () => {
  const shown = (/** @type {any} */ frame) => tries.filter(({ shown }) => shown?.(frame) ?? true)
  for (const preset of PRESETS) {
    const lab = estimate.OwnSystem.from({
      version: 1,
      lab: 'own-system',
      step: 0,
      params: { ...start.params, ...paramsOf(preset) },
    })
    assert.equal(shown(lab.frame()).length, tries.length, preset.name)
    lab.free()
  }
  const own = pasted('F = [0.9 0.2; 0 1]; H = [1 0]; V = diag([0.1 0.01]); W = 0.2')
  assert.deepEqual(
    shown(own).map(({ name }) => name),
    ['place'],
  )
  const { step, ...changed } = /** @type {any} */ (shown(own)[0].change(own, null))
  assert.deepEqual([step, Object.keys(changed).sort()], [undefined, ['gain', 'poles']])
  assert.equal(pasted('F = [0.9 0.2; 0 1]; H = [1 0]; V = diag([0.1 0.01]); W = 0.2', changed).placed, true)
  // Where no gain moves anything there is nothing to place.
  assert.deepEqual(shown(pasted('F = [0.9 0; 0 1]; H = [0 0]; V = eye(2); W = 1')), [])
})

test('what the lab refuses is said in the page’s words', () => {
  const refused = (/** @type {string} */ text) => {
    const { system, places } = /** @type {any} */ (readSystem(text))
    try {
      const params = { ...start.params, ...paramsOf(system) }
      estimate.OwnSystem.from({ version: 1, lab: 'own-system', step: 0, params }).free()
      return ''
    } catch (error) {
      return wordsOf(error, places)
    }
  }
  const line = (/** @type {string} */ Q, /** @type {string} */ C, /** @type {number} */ R) =>
    `A = eye(2)\nC = ${C}\nQ = ${Q}\nR = ${R}`
  assert.equal(
    refused(line('[1 2; 3 1]', '[1 0]', 1)),
    'Line 3: Q: entries (2, 1) and (1, 2) differ; a covariance is symmetric',
  )
  assert.equal(refused(line('[1 2; 2 1]', '[1 0]', 1)), 'Line 3: Q has a negative eigenvalue; a covariance has none')
  assert.equal(
    refused(line('eye(2)', '[0 0]', 0)),
    'Line 4: R: a reading without noise tells nothing, or only what another tells: give it noise, or leave it out',
  )
})

const RATES = [
  'F = [0 1 0; 0 -10 5; 0 -1 -20]; H = [1 0 0]; Q = diag([0 0.5 0.2]); R = 0.0001; T = 0.005',
  'F = [0 1; -4 -0.4]; H = [1 0]; Q = [0 0; 0 0.5]; R = 0.01; dt = 0.01',
  'A = [0 1; -4 -0.4]; C = [1 0]; Q = [0 0; 0 0.5]; R = 0.01',
]
const ASKED = /^F is taken as what one step does, and looks like one of a differential equation: tick “Continuous time”/

test('a matrix of rates that is given as what one step does is asked about, and no number is withheld', () => {
  for (const text of RATES) {
    const frame = pasted(text)
    assert.match(verdict(frame), ASKED, text)
    assert.ok(
      readouts(frame).every(({ value }) => value !== ''),
      text,
    )
    assert.doesNotMatch(verdict(pasted(text, { continuous: true, period: frame.params.period || 0.1 })), ASKED, text)
  }
})

test('no preset is asked about, and those of continuous time are once their tick is gone', () => {
  for (const preset of PRESETS) {
    const frame = (/** @type {object} */ more) => {
      const params = { ...start.params, ...paramsOf(preset), ...more }
      const lab = estimate.OwnSystem.from({ version: 1, lab: 'own-system', step: 0, params })
      const frame = lab.frame()
      lab.free()
      return frame
    }
    assert.equal(frame({}).looksLikeRates, false, preset.name)
    assert.equal(frame({ continuous: false }).looksLikeRates, Boolean(preset.continuous), preset.name)
  }
})

test('an entry of the filter’s gain that is rounding beside the others is shown as 0, and a small one is not', () => {
  const shown = (/** @type {any} */ frame) => readouts(frame).find(({ key }) => key === 'gain')?.value
  for (const [text, i] of /** @type {[string, number][]} */ ([
    [BESIDE[0], 2],
    [BESIDE[2], 0],
    [BESIDE[3], 1],
  ])) {
    const frame = pasted(text)
    assert.ok(frame.K[i][0] !== 0 && Math.abs(frame.K[i][0]) < 1e-12, `${text}: ${frame.K}`)
    assert.deepEqual(
      withoutRounding(frame).map(([entry]) => entry === 0),
      frame.K.map((_, j) => j === i),
    )
    assert.equal(shown(frame).split('; ')[i], '0')
  }
  // A speed in a unit of 10¹³ m/s: its entry is small because of that alone.
  const far = pasted('F = [1 5e12; 0 1]; H = [1 0]; V = [1e-3 0; 0 1e-28]; W = 0.5; P0 = diag([1 1e-26])')
  assert.ok(far.K[1][0] < 1e-12 * far.K[0][0], String(far.K))
  assert.deepEqual(withoutRounding(far), far.K)
  const mine = { ...far, K: [[1], [1e-15]], params: { ...far.params, gain: 'hand' } }
  assert.deepEqual(withoutRounding(mine), [[1], [1e-15]])
})

/** A walk that no reading sees, in turned coordinates, with so many digits. @param {number} digits */
function hidden(digits) {
  const write = (/** @type {number[][]} */ rows) =>
    `[${rows.map((row) => row.map((entry) => Number(entry.toPrecision(digits))).join(' ')).join('; ')}]`
  // F = T diag(1, 0.8) T⁻¹ and H = [0 1] T⁻¹, with T a turn by 0.3 rad.
  const [c, s] = [Math.cos(0.3), Math.sin(0.3)]
  const F = [
    [c * c + 0.8 * s * s, 0.2 * c * s],
    [0.2 * c * s, s * s + 0.8 * c * c],
  ]
  return `F = ${write(F)}; H = ${write([[-s, c]])}; V = eye(2); W = 0.2; T = 0.1`
}

test('what rounded numbers leave undecided is said so of the limit and of times, with what would decide', () => {
  const of = (/** @type {any} */ frame, /** @type {string} */ key) =>
    readouts(frame).find((/** @type {any} */ one) => one.key === key)?.value
  const KEYS = ['steps', 'seconds', 'settled', 'limit', 'depends']
  const open = pasted(hidden(11))
  assert.deepEqual([open.detectable, open.limit], ['undecided', 'undecided'])
  assert.deepEqual(
    KEYS.map((key) => of(open, key)),
    KEYS.map(() => 'undecided'),
  )
  assert.match(of(open, 'roots'), /^1\.000, 0\.\d+ \(/, 'its time is not said')
  assert.match(verdict(open), /More digits of the numbers, .*, and whether an error dies out is undecided\./)
  assert.doesNotMatch(verdict(open), /From this start|need not die out/)
  const typed = pasted(hidden(11), { logTolerance: -13 })
  assert.notEqual(typed.detectable, 'undecided')
  assert.doesNotMatch(verdict(typed), /undecided/)
})

/** A mode of 0.95 that no reading sees, in turned coordinates of nine digits. */
const NINE =
  'F = [0.908484138 0.543964982 0.093348769 -0.346747591; 0.0415564517 0.725224718 0.0179349168 0.0568416475; ' +
  '-0.175265977 -0.793503177 0.757803494 0.898984906; -7.107029e-06 -0.029097727 0.00974321695 0.95848765]; ' +
  'H = [0.653767421 1.40636567 0.326535782 -2.07910835]; V = eye(4); W = 0.1; T = 0.1'

test('a system that is observable by less than its digits is not said to be', () => {
  const frame = pasted(NINE)
  assert.deepEqual([frame.observable, frame.movable], ['undecided', 3], 'a change within the tolerance hides the mode')
  assert.equal(pasted(NINE, { logTolerance: -13 }).observable, 'yes', 'its numbers as they are written are')
  assert.equal(readouts(frame).find((/** @type {any} */ one) => one.key === 'observable')?.value, 'undecided')
  assert.match(verdict(frame), /whether the system is observable is undecided\. .* More digits of the numbers/)
  // What F forgets stays at 0, whatever is seen of it.
  assert.match(
    verdict(pasted('F = [0 1; 0 0]; H = [1 0]; V = eye(2); W = 0.1')),
    /^Observable: the readings tell every/,
  )
})
