// A sensor that is late, in words: by how much, what to set, and what would look the same.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const log = { rows: 1000, truth: true }

test('sensors of one receiver are late together, or one alone, and motion that is early looks the same', () => {
  const size = { now: 0, value: 0.4, sigma: 0.021 }
  const both = (sizes) => sentence(suspect({ with: 'delayHeading', sizes }), false)
  assert.equal(
    both([size, size]),
    'The positions and the headings come together 0.400 ± 0.021 s late: set both delays to 0.400 s.',
  )
  const same = / That all of the motion comes as (late|early) would look the same\./
  const said = (suspects, truth) => ranked(judgement(suspects), { rows: 1000, truth }).match(same)?.[1]
  const together = suspect({ with: 'delayHeading', sizes: [size, size] })
  const lone = suspect({ sizes: [{ ...size, value: -0.4 }] })
  assert.deepEqual([said([together], false), said([together], true)], ['early', undefined])
  const cleared = suspect({ name: 'delayHeading', standing: 'cleared', excess: -3 })
  assert.deepEqual(
    [said([lone], false), said([lone], true), said([lone, cleared], false)],
    ['late', undefined, undefined],
  )
  assert.equal(said([suspect({ name: 'delayTurn' })], false), undefined)
  // What has no size is no delay.
  assert.equal(said([suspect({ fault: 'mirrored', name: null, sizes: [] })], false), undefined)
  assert.match(both([size, { ...size, now: 0.1, value: 0.5 }]), /set their delays to 0\.400 s and 0\.500 s\./)
  assert.match(both([size, size, size]), /^The readings come together .* set all their delays to 0\.400 s\./)
  const turn = suspect({ name: 'delayTurn', sizes: [{ now: 0, value: -0.38, sigma: 0.036 }] })
  assert.match(sentence(turn, false), /^The turn rate comes 0\.380 ± 0\.036 s early: set the delay to −0\.380 s\.$/)
  const none = { mended: { rmse: 3, nees: 9, outside: 0.4 } }
  const other = judgement([suspect({ with: 'delayHeading', sizes: [size, size], ...none })], {
    against: { rmse: 2, nees: 3, outside: 0.2 },
    other: true,
  })
  assert.match(
    ranked(other, log),
    /likeliest is this: The positions and the headings come together .* another fault may hide behind it\./,
  )
})
