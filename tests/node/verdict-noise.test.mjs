// What a verdict without a fault says of innovations that do not look like noise.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { remedies } from '../../web/page/log-remedy.js'
import { unsettledWords } from '../../web/widgets/robot-log/unsettled.js'
import { ranked } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const log = { rows: 1000, truth: false }

test('beside no fault it is said where the innovations do not look like noise', () => {
  const noise = {
    nis: { times: [152.04, 160], there: 3.52, elsewhere: 0.93 },
    refused: { times: [100, 159.8], there: 0.49, elsewhere: 0.003 },
    correlated: { sensor: 'fix', by: 0.16, chance: 0.02 },
  }
  assert.match(
    ranked(judgement([suspect({ standing: 'cleared' })], { noise }), log),
    /Yet from 152\.0 to 160\.0 s after the first row NIS is 3\.5, and 0\.9 elsewhere; from 100\.0 to 159\.8 s after /,
  )
  assert.match(
    ranked(judgement([suspect({ standing: 'cleared' })], { noise: { ...noise, nis: null } }), log),
    /Yet from 100\.0 .* gates refuse 49 % of the readings, and 0\.3 % elsewhere; the innovations of the positions are /,
  )
  assert.doesNotMatch(ranked(judgement([suspect({})], { noise }), log), /Yet/, 'what is named is mended first')
})

test('of readings that go together no fault is named: it is said how far apart to take them, and a press does', () => {
  const thinning = { every: 5, by: [0.978, 0.37], counts: [2067, 22.5], either: false }
  const found = judgement([suspect({ fault: 'sigma', name: 'sigmaDistance' })], { thinning })
  const said = ranked(found, log)
  assert.match(
    said,
    /^The positions go together: .* are correlated by 0\.98\. So 2,067 of them tell about as much as 23/,
  )
  assert.match(said, /Take those first that are at least 5 s apart: they are correlated by 0\.37\.$/)
  assert.equal(unsettledWords(found, {}, []), '')
  /** @type {any} */
  const frame = { params: { gate: null, every: 0 }, truth: null }
  const apart = { fix: 5, heading: 0, range: 0, bearing: 0 }
  assert.deepEqual(remedies(found, frame), [{ press: 'Take those 5 s apart', patch: { every: apart } }])
  const often = judgement([suspect({})], { thinning: { ...thinning, every: 0.5 } })
  assert.match(ranked(often, log), /at least 0\.5 s apart/)
  frame.params.every = { ...apart, fix: 0.1 }
  assert.equal(/** @type {any} */ (remedies(often, frame)[0].patch).every.fix, 0.5)
})

test('of positions that err alike a smaller σ is one of two: they may wander, and both have a press', () => {
  const thinning = { every: 20, by: [0.95, 0.3], counts: [3000, 77], either: true }
  const size = { now: 1, value: 0.0916, sigma: 0.0011, end: false }
  const smaller = { fault: 'sigma', name: 'fixSigmaScale', sizes: [size], claims: [1, 1, 1] }
  const other = suspect({ fault: 'sigma', name: 'sigmaTurn', sizes: [{ ...size, now: 0.02 }], standing: 'maybe' })
  const found = judgement([suspect(smaller), other], { thinning })
  const said = ranked(found, log)
  assert.match(said, /^Either: The positions err alike .* correlated by 0\.95, as where a receiver’s errors wander\. /)
  assert.match(said, /at least 20 s apart\. Or: The positions claim 1 m, and 0\.0916 .* do not tell which\.$/)
  /** @type {any} */
  const frame = { params: { gate: null, every: 0 }, truth: null }
  const presses = (/** @type {any} */ one) => remedies(one, frame).map(({ press }) => press)
  assert.deepEqual(presses(found), ['Either: take those 20 s apart', 'Or: fit both σ'])
  // The truth may say that a smaller σ is none.
  const refuted = judgement([suspect(smaller), other], { thinning, other: true })
  assert.match(ranked(refuted, log), /^The positions err alike .* 20 s apart\.$/)
  assert.deepEqual(presses(refuted), ['Take those 20 s apart'])
  const gaps = [{ what: 'held', count: 1, longest: [120, 180], between: [151, 900] }]
  const cut = { params: frame.params, truth: null, log: { corrections: {} } }
  /** @type {any} */
  const gap = judgement([suspect(smaller), other], { thinning, gaps })
  assert.equal(remedies(gap, /** @type {any} */ (cut)).length, 1, 'a long gap is cut before all')
})
