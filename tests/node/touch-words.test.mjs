// What the touch says of its ellipse and of the reader's dot is true of its frames, and nothing before it has grown.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { check, estimate, pattern, prints, widget } from './claims.mjs'

check(
  'touch',
  {
    guess: [-2.5, -0.65, -0.4, 0, 0.7, 1.5, 2.5],
    covariance: [-1.75, -1.05, 0, 0.3, 1.05, 1.75],
    grown: [false, true],
  },
  [0],
  () => [
    [
      /^The sensor has read ([\d.]+) m\/s, without noise: the state is on the green line\.$/,
      ({ reading, params }, said) => prints(said, reading) && !params.grown,
    ],
    [
      /^Where will the growing ellipse first touch it\? Drag the dot there and press Grow\.$/,
      ({ params }) => !params.grown,
    ],
    [
      pattern(
        /^The ellipse touches at ([\d.]+) σ, at the purple foot, /,
        /(?:where the gray foot is too|([\d.]+) m to the (left|right) of the gray foot)\.$/,
      ),
      ({ touchRadius, touch, below, guessRadius }, radius, away, side) => {
        const off = touch[0] - below[0]
        return (
          prints(radius, touchRadius) &&
          touchRadius <= guessRadius + 1e-12 &&
          (away ? prints(away, Math.abs(off)) && (side === 'left') === off < 0 : Math.abs(off) < 0.005)
        )
      },
    ],
    [/^Your dot is there\.$/, ({ guess, touch }) => Math.hypot(guess[0] - touch[0], guess[1] - touch[1]) < 0.03],
    [
      pattern(
        /^Your dot is ([\d.]+) m away; the ellipse reaches it at ([\d.]+) σ, /,
        /and the purple foot is (?:hardly more probable|(more than 999|[\d.]+) times as probable)\.$/,
      ),
      ({ guess, touch, guessRadius, touchRadius }, away, radius, times) => {
        const ratio = Math.exp((guessRadius ** 2 - touchRadius ** 2) / 2)
        return (
          prints(away, Math.abs(guess[0] - touch[0])) &&
          prints(radius, guessRadius) &&
          (times === undefined ? ratio < 1.0051 : times === 'more than 999' ? ratio > 999 : prints(times, ratio))
        )
      },
    ],
  ],
)

test('before it has grown, the touch says and shows nothing of where that will be', async () => {
  const spec = await widget('touch')
  const at = (/** @type {number} */ covariance) =>
    new estimate[spec.lab]({ covariance, grown: false, guess: 1 }).frame()
  const [one, other] = [at(1.05), at(0.3)]
  assert.notEqual(one.touch[0], other.touch[0])
  assert.deepEqual(spec.readouts(one), spec.readouts(other))
  assert.equal(spec.verdict(one), spec.verdict(other))
  assert.deepEqual(spec.describe(one), spec.describe(other), 'both lean to the right')
})
