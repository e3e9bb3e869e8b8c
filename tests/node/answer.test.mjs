// What a reader types as an answer is read as people write numbers, and told from the key.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { judge } from '../../web/page/answer.js'

/** @param {import('../../web/page/answer.js').Key} key @param {string[]} texts */
const verdicts = (key, ...texts) => texts.map((text) => judge(key, text)?.right ?? null)

test('thousands may be parted, and a decimal comma stays one', () => {
  const readings = { values: [6600], tolerance: 500 }
  const right = ['6600', '6,600', '6 600', "6'600", '6\u202f600', '6,600.0', '6.6e3']
  assert.deepEqual(
    verdicts(readings, ...right),
    right.map(() => true),
  )
  assert.deepEqual(verdicts(readings, '6,60', '6.6', '0,600', '66,00'), [false, false, false, false])
  assert.deepEqual(verdicts({ values: [1.652], tolerance: 0.001 }, '1,652', '1.652', '1652'), [true, true, false])
  assert.deepEqual(verdicts({ values: [1234567], tolerance: 0 }, '1,234,567', '1,234 567'), [true, null])
  assert.deepEqual(verdicts({ values: [-6600], tolerance: 0 }, '-6,600', '\u22126,600'), [true, true])
})

test("the question's unit may follow a number, and another unit makes it no answer", () => {
  assert.deepEqual(verdicts({ values: [33.1], unit: '%', tolerance: 0.1 }, '33.1 %', '33,1%', '33.1', '%'), [
    true,
    true,
    true,
    null,
  ])
  const area = { values: [1.87], unit: 'm²', tolerance: 0.01 }
  assert.deepEqual(verdicts(area, '1.87 m²', '1.87 m^2', '1.87m2', '1.87 cm²', '1.87 m', '1.87 s'), [
    true,
    true,
    true,
    null,
    null,
    null,
  ])
})

test('a vector keeps its commas, and a direction of zeros is none', () => {
  const vector = { values: [1, 600], tolerance: 0 }
  assert.deepEqual(verdicts(vector, '1,600', '[1; 600]', '1 600', '1'), [true, true, true, null])
  const direction = { values: [1, 2, -1], direction: true, tolerance: 1e-9 }
  assert.deepEqual(verdicts(direction, '-2, -4, 2', '0, 0, 0'), [true, null])
})
