// The scale of a plane that holds still for a run: it widens by factors of two, never narrows while the run goes on,
// and is chosen anew where a run begins.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { Scale } from '../../web/figure/motion.js'

/** The range when the scale has arrived. */
function arrived(scale, range, anew = false) {
  let first = anew
  while (scale.follow(range, 16, first)) first = false
  return scale.now
}

test('a scale holds still while what it shows stays within it, and doubles a side that it leaves', () => {
  const scale = new Scale(0.5)
  assert.deepEqual(arrived(scale, [-0.3, 1.1], true), [-0.5, 2])
  for (const high of [1.2, 1.5, 1.8]) assert.deepEqual(arrived(scale, [-0.3, high]), [-0.5, 2], `${high}`)
  assert.deepEqual(arrived(scale, [-0.3, 2.1]), [-0.5, 4])
  assert.deepEqual(arrived(scale, [-0.3, 1.1]), [-0.5, 4], 'it does not narrow in the run')
  assert.deepEqual(arrived(scale, [-0.3, 1.1], true), [-0.5, 2], 'another run has its own')
})

test('a scale on its way shows every size between, and one of a still is there at once', () => {
  const scale = new Scale(1)
  scale.follow([-0.5, 0.5], Infinity, true)
  assert.deepEqual(scale.now, [-1, 1])
  assert.ok(scale.follow([-0.5, 1.5], 16, false))
  assert.ok(scale.now[1] > 1 && scale.now[1] < 2)
  scale.follow([-0.5, 1.5], Infinity, false)
  assert.deepEqual(scale.now, [-1, 2])
})

test('after something huge a scale comes back, and nothing that is no number moves it', () => {
  const scale = new Scale(0.5)
  assert.deepEqual(arrived(scale, [-1000, 1000], true), [-2048, 2048])
  assert.deepEqual(arrived(scale, [-0.3, 0.3]), [-0.5, 0.5])
  assert.deepEqual(arrived(scale, [-Infinity, NaN]), [-0.5, 0.5])
})
