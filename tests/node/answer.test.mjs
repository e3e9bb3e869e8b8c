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

test('a number rounded to two digits or more is right, and one in fewer is asked for more, if it is that', () => {
  const told = (key, text) => {
    const { right, near, nearly, close } = judge(key, text) ?? assert.fail(text)
    return right ? 'right' : near >= 0 ? near : nearly ? 'nearly' : close ? 'close' : 'wrong'
  }
  const third = { values: [1.873], tolerance: 0.005, near: [[2.0625], [1.698]] }
  for (const text of ['1.873', '1.87', '1,88', '1.9', '1.87298']) assert.equal(told(third, text), 'right', text)
  assert.equal(told(third, '2'), 'nearly')
  for (const text of ['1.90', '1.86', '1.8']) assert.equal(told(third, text), 'close', text)
  for (const text of ['1.6', '18.7', '0.19', '3']) assert.equal(told(third, text), 'wrong', text)
  // The well-known wrong ones are told as themselves, rounded too.
  assert.deepEqual(
    ['2.0626', '2.06', '2.1', '1.7'].map((text) => told(third, text)),
    [0, 0, 0, 1],
  )
  const share = { values: [0.11476], unit: '%', tolerance: 0.002, near: [[0.0011476]] }
  for (const text of ['0.115 %', '0.12', '0.11', '1.1e-1', '.115']) assert.equal(told(share, text), 'right', text)
  assert.deepEqual(
    ['0.1', '0.00115', '0.0011', '11.5', '12'].map((text) => told(share, text)),
    ['nearly', 0, 0, 'wrong', 'wrong'],
  )
  const threshold = { values: [27.631], tolerance: 0.1, near: [[13.8155]] }
  assert.deepEqual(
    ['28', '27.6', '27', '30', '14', '20'].map((text) => told(threshold, text)),
    ['right', 'right', 'close', 'nearly', 0, 'wrong'],
  )
  const lag = { values: [-0.49], tolerance: 0.005, near: [[0.49]] }
  assert.deepEqual(
    ['-0.49', '-0.5', '0.5', '-1', '0'].map((text) => told(lag, text)),
    ['right', 'nearly', 'wrong', 'wrong', 'wrong'],
  )
  // Zeros at the end of a whole number may stand for what was rounded; a tolerance wider than the digits is enough.
  assert.equal(told({ values: [6628], tolerance: 1 }, '6600'), 'right')
  assert.equal(told({ values: [33.13], tolerance: 0.6 }, '34'), 'close')
  assert.equal(told({ values: [1.07], tolerance: 0.001 }, '15/14'), 'close')
  // A digit more helps who has the right one rounded, and nobody else.
  const gain = { values: [0.27016], tolerance: 0.002, near: [[0.358]] }
  assert.deepEqual(
    ['0.27', '0.3', '0.30', '0.28', '0.32'].map((text) => told(gain, text)),
    ['right', 'nearly', 'wrong', 'close', 'wrong'],
  )
  // Where bounds say what is right a rounded number is not enough.
  const knob = { values: [1.0706], tolerance: 0.001, bounds: [1.0564, 1.071], near: [[5.58], [1]] }
  assert.deepEqual(
    ['1.06', '1.07', '1.071', '1.1', '1.09', '1.05', '1', '1.0', '1.2'].map((text) => told(knob, text)),
    ['right', 'right', 'right', 'nearly', 'close', 'close', 1, 1, 'wrong'],
  )
  // Where the digits leave open which of the two was meant, a digit more is asked for.
  assert.equal(told({ values: [1.73], tolerance: 0.001, near: [[1.68]] }, '1.7'), 'nearly')
  assert.equal(told({ values: [1, 2, -1], direction: true, tolerance: 0.005 }, '1, 2, -1.1'), 'wrong')
  const vector = { values: [1.234, 0], tolerance: 0.0001 }
  assert.deepEqual(
    ['1.2, 0', '1.23 0.0', '1, 0', '1.2 0.1', '1.2 0.05'].map((text) => told(vector, text)),
    ['right', 'right', 'nearly', 'wrong', 'close'],
  )
})
