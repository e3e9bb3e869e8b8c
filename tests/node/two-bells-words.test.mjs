// What the two bells say of weights and of the point of balance is true of their frames.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { check, estimate, pattern, prints, widget } from './claims.mjs'

const weights = ({ params }) => [1 / params.expectedVariance, 1 / params.noise]
const balance = (frame) => {
  const [expected, read] = weights(frame)
  return (frame.params.expected * expected + frame.params.reading * read) / (expected + read)
}
/** Whether both opinions are printed as they are. */
const told = ({ params }, prediction, reading) => prints(prediction, params.expected) && prints(reading, params.reading)

check(
  'two-bells',
  {
    expected: [0, 2.7, 4, 7],
    reading: [0, 2.7, 7],
    expectedVariance: [0.05, 0.5, 2.1, 4],
    noise: [0.05, 0.5, 0.502, 4],
  },
  [0],
  () => [
    [
      /^Both opinions weigh the same: the beam balances half way from (\S+) to (\S+), at y\^?∗ = (\S+) m\/s\.$/,
      (frame, prediction, reading, at) => {
        const [expected, read] = weights(frame)
        return Math.abs(expected / read - 1) < 0.005 && told(frame, prediction, reading) && prints(at, balance(frame))
      },
    ],
    [
      /^The (prediction|reading) weighs ([\d.]+) times as much as the (prediction|reading)\.$/,
      (frame, heavy, times, light) => {
        const [expected, read] = weights(frame)
        return (
          heavy !== light &&
          (heavy === 'prediction') === expected > read &&
          prints(times, Math.max(expected / read, read / expected))
        )
      },
    ],
    [
      pattern(
        /^The beam balances at y\^?∗ = (\S+) m\/s, ([\d.]+) m\/s from the prediction of (\S+) /,
        /and ([\d.]+) m\/s from the reading of (\S+)\.$/,
      ),
      (frame, at, left, prediction, right, reading) =>
        told(frame, prediction, reading) &&
        prints(at, balance(frame)) &&
        prints(left, Math.abs(balance(frame) - frame.params.expected)) &&
        prints(right, Math.abs(frame.params.reading - balance(frame))),
    ],
  ],
)

test('a poor sensor weighs less than the prediction, whatever either weighed before', async () => {
  const spec = await widget('two-bells')
  const { change } = spec.tries.find(({ name }) => name === 'noisy')
  const open = (params) => estimate.TwoBells.from({ version: 1, lab: spec.name, step: 0, params })
  for (const params of [{}, { noise: 4 }, { noise: 4, expectedVariance: 4 }, { noise: 0.05, expectedVariance: 4 }]) {
    const lab = open(params)
    const [expected, read] = open({ ...lab.frame().params, ...change(lab.frame(), lab) }).frame().weights
    assert.ok(expected > 1.5 * read, `${expected}, ${read} after ${JSON.stringify(params)}`)
  }
})
