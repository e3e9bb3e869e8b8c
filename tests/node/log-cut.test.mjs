// A log whose motion is not read for a while: the verdict's presses keep the longest stretch without such a gap.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { areCorrections, isCorrected, plain, sameCorrections } from '../../web/page/log-corrections.js'
import { remedies } from '../../web/page/log-remedy.js'
import { judgement, suspect } from './verdicts.mjs'

/** @type {import('estimate-wasm').LogCorrections} */
const NONE = { driven: [1, 1], landmarks: [], ranges: [], kept: null }
const gap = (longest, between, count = 1) => ({ what: 'turn rate', count, longest, between })
/** What is pressed beside a fault, by words and by what is read then. */
const presses = (gaps, /** @type {any} */ { kept = null, standing = 'sure' } = {}) => {
  const frame = { params: {}, truth: null, log: { corrections: { ...NONE, kept } } }
  const found = remedies(judgement([suspect({ standing })], { gaps }), /** @type {any} */ (frame))
  return found.map(({ press, corrections }) => [press, corrections?.kept])
}

test('where much of the motion is not read, the one press is to cut the log', () => {
  const early = gap([120, 240], [0, 120])
  assert.deepEqual(presses([early]), [['Cut the log: keep 0.0 to 120.0 s', [0, 120]]])
  // A part of a part, in seconds since the first row of the files.
  assert.deepEqual(presses([early], { kept: [30, 270] }), [['Cut the log: keep 0.0 to 120.0 s', [30, 150]]])
  assert.deepEqual(presses([gap([3, 5], [5, 240]), early])[0][1], [0, 120], 'at the longest')
})

test('beside a short gap a fault has its press as well, and where there is no fault nothing is cut', () => {
  const short = gap([80, 82], [82, 240], 3)
  assert.deepEqual(presses([short]), [
    ['Cut the log: keep 82.0 to 240.0 s', [82, 240]],
    ['Set it so', undefined],
  ])
  assert.deepEqual(presses([short], { standing: 'cleared' }), [])
  assert.deepEqual(presses([]), [['Set it so', undefined]])
})

test('the part that is read is kept among what is corrected', () => {
  /** @type {typeof NONE} */
  const part = { ...NONE, kept: [0, 120] }
  assert.ok(isCorrected({ corrections: part }) && !isCorrected({ corrections: NONE }))
  assert.deepEqual(plain(part).kept, [0, 120])
  assert.ok(!('kept' in plain(NONE)), 'files of before have none')
  assert.ok(!sameCorrections(part, { ...NONE, kept: [0, 119] }))
  assert.ok(areCorrections(plain(part)) && areCorrections(plain(NONE)))
  for (const kept of [[5, 5], [5], ['0', 5], 7]) assert.ok(!areCorrections({ ...plain(NONE), kept }), String(kept))
})
