// Numbers as a reader sees them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { metres } from '../../web/draw/numbers.js'

test('an error has its centimetres, and below a decimetre its millimetres', () => {
  assert.deepEqual([12.345, 0.1, 0.0996, 0.0994, 0.004, 0].map(metres), [
    '12.35',
    '0.10',
    '0.10',
    '0.099',
    '0.004',
    '0.000',
  ])
  assert.deepEqual([metres(null), metres(undefined), metres(Number.NaN)], ['–', '–', '–'])
})
