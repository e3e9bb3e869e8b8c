// A phrase of the Picture shows what it speaks of whatever was chosen before: over all ordered pairs of phrases, and from states that a
// reader has made.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { WIDGETS } from '../../web/widgets/index.js'
import { estimate } from './claims.mjs'

/** What each phrase speaks of, of the frame that it leads to. */
const SPEAKS_OF = {
  guess: ({ params: { sealed, guess, radius, semiMajor, semiMinor } }) => ({ sealed, guess, radius, round: Math.abs(semiMajor - semiMinor) < 1e-9 }),
  show: ({ params: { sealed } }) => ({ sealed }),
  perfect: ({ params: { sealed, guess, radius, noise } }) => ({ sealed, guess, radius, noise }),
  equal: ({ params: { sealed, guess, radius }, mostLikelyVariance, expectedVariance }) => ({ sealed, guess, radius, half: (mostLikelyVariance / expectedVariance).toFixed(9) }),
  round: ({ params: { sealed, guess, radius }, euclideanFoot, mahalanobisFoot }) => ({ sealed, guess, radius, apart: Math.hypot(...euclideanFoot.at.map((value, i) => value - mahalanobisFoot.at[i])) < 1e-9 }),
  position: ({ params: { sealed, guess, radius }, H }) => ({ sealed, guess, radius, H }),
  again: (frame) => frame,
}

test('a phrase of the Picture shows the same after any other', async () => {
  const spec = await WIDGETS['kalman-picture']()
  assert.deepEqual(spec.tries.map(({ name }) => name), Object.keys(SPEAKS_OF))
  const open = (params) => estimate.Picture.from({ version: 1, lab: spec.name, step: 0, params })
  const after = (params, phrase) => {
    const lab = open(params)
    const changed = { ...lab.frame().params, ...phrase.change(lab.frame(), lab) }
    lab.free()
    return changed
  }
  const frameAt = (params) => open(params).frame()
  for (const phrase of spec.tries) {
    const fresh = SPEAKS_OF[phrase.name](frameAt(after({}, phrase)))
    const before = [...spec.tries.map((other) => [other.name, after({}, other)]), ['a state of a reader', { radius: 2, guess: 0.4, sealed: true, noise: 3, semiMajor: 1, semiMinor: 2 }]]
    for (const [name, params] of before) {
      const frame = frameAt(after(params, phrase))
      assert.deepEqual(SPEAKS_OF[phrase.name](frame), fresh, `“${phrase.label}” after ${name}`)
      assert.equal(spec.verdict(frame).startsWith('The answer is hidden'), phrase.name === 'guess', `“${phrase.label}” after ${name}`)
    }
  }
})
