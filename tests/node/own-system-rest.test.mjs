// What is said of a covariance that comes to rest or falls on, of a matrix of rates that is given as a step's, and of
// entries of a gain that rounding leaves.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { estimate, widget } from './claims.mjs'
import { withoutRounding } from '../../web/widgets/own-system/index.js'
import { PRESETS, paramsOf } from '../../web/widgets/own-system/presets.js'
import { readSystem } from '../../web/widgets/own-system/read.js'
import { settles, verdict } from '../../web/widgets/own-system/words.js'

const { start, readouts } = await widget('own-system')

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
