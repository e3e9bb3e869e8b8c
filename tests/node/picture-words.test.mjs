// What the Picture says of feet, ellipses and weights is true of its frames.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { check, estimate, number, prints, widget, pattern } from './claims.mjs'

check(
  'picture',
  {
    mean: [
      [4, 4],
      [4, 2.7],
      [-3, 6],
    ],
    semiMajor: [0.15, 1.005, 1.7230432137127605, 3],
    semiMinor: [0.15, 1, 3],
    radius: [0, 0.9, 6],
    guess: [null, -0.65],
    sealed: [false, true],
    angle: [0, 0.8795089160498338, Math.PI / 2],
    reading: [-8, 2.7, 4],
    noise: [0, 0.5, 4],
    tilt: [-Math.PI / 2, -0.7, 0, 0.3],
  },
  [0],
  () => {
    const apart = ({ euclideanFoot: a, mahalanobisFoot: b }) => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])
    return [
      [
        /^The gray foot is ([\d.]+) standard deviations away, the purple one ([\d.]+)\.$/,
        (frame, gray, purple) =>
          prints(gray, frame.euclideanFoot.distance) && prints(purple, frame.mahalanobisFoot.distance),
      ],
      [
        /^The ellipse is a circle: both metrics agree, and the two feet are one point\.$/,
        (frame) =>
          Math.abs(frame.P[0][0] - frame.P[1][1]) < 1e-9 && Math.abs(frame.P[0][1]) < 1e-9 && apart(frame) < 1e-9,
      ],
      [/^The two feet are one point here, to two decimals\.$/, (frame) => apart(frame) < 0.0051],
      [
        /^The reading is the one expected: there is nothing to correct\.$/,
        (frame) =>
          Math.abs(frame.innovation) < 5e-4 &&
          Math.hypot(...frame.posterior.x.map((value, i) => value - frame.params.mean[i])) < 5e-3,
      ],
      [
        pattern(
          /^The answer is hidden: (drop|drag) (?:a guess|your guess along the green line), /,
          /then choose “Show the answer”\.$/,
        ),
        ({ params }, what) => params.sealed && (what === 'drag') === (params.guess !== null),
      ],
      [
        /^Your guess is the purple foot, the most probable point of the line\.$/,
        ({ guess, mahalanobisFoot: { at } }) => Math.hypot(guess.at[0] - at[0], guess.at[1] - at[1]) < 0.03,
      ],
      [
        /^The purple foot is (hardly more probable than|(more than 999|[\d.]+) times as probable as) your guess\.$/,
        ({ guess, params }, hardly, times) =>
          !params.sealed &&
          (times === undefined
            ? guess.density > 0.995 && hardly.startsWith('hardly')
            : times === 'more than 999'
              ? guess.density < 1 / 999
              : prints(times, 1 / guess.density)),
      ],
      [
        pattern(
          /^Grown to ([\d.]+) σ, the ellipse holds (more than 99|\d+) % of the probability; /,
          /it (?:(touches|does not reach|crosses) Ω\* and )?(touches|does not reach|crosses) Ω\.$/,
        ),
        (frame, radius, inside, star, omega) => {
          const stands = (word, distance) =>
            word ===
            (Math.abs(frame.params.radius - distance) <= 0.026
              ? 'touches'
              : frame.params.radius < distance
                ? 'does not reach'
                : 'crosses')
          return (
            prints(radius, frame.params.radius) &&
            (inside === 'more than 99'
              ? frame.inside >= 0.995
              : number(inside) < 100 && prints(inside, 100 * frame.inside)) &&
            stands(omega, frame.mahalanobisFoot.distance) &&
            (star === undefined ? frame.params.noise === 0 || frame.params.sealed : stands(star, frame.update.distance))
          )
        },
      ],
      [
        /^Reading and expected output weigh the same: y\* lies half way\.$/,
        ({ params, expectedOutput, expectedVariance, mostLikelyOutput }) =>
          Math.abs(expectedVariance / params.noise - 1) < 0.0051 &&
          Math.abs(mostLikelyOutput - (params.reading + expectedOutput) / 2) <=
            0.0013 * Math.abs(params.reading - expectedOutput) + 1e-9,
      ],
      [
        /^The reading weighs ([\d.]+) times as much as the expected output\.$/,
        ({ params, expectedVariance }, times) => prints(times, expectedVariance / params.noise),
      ],
      [
        /^The expected output weighs ([\d.]+) times as much as the reading\.$/,
        ({ params, expectedVariance }, times) => prints(times, params.noise / expectedVariance),
      ],
      [
        /^The sensor is perfect: Ω and Ω\* are one line\.$/,
        (frame) => frame.params.noise === 0 && Math.abs(frame.mostLikelyOutput - frame.params.reading) < 1e-9,
      ],
    ]
  },
)

test('two opinions: the printed weights are one over the variances, and add up to that of the product', async () => {
  const spec = await widget('picture')
  const opened = (params) => estimate.Picture.from({ version: 1, lab: spec.name, step: 0, params })
  const weights = (frame) => spec.readouts(frame).find(({ key }) => key === 'weights').value
  assert.equal(weights(opened({}).frame()), '0.476 + 2.000 = 2.476')
  assert.equal(weights(opened({ noise: 0 }).frame()), '0.476 + ∞ = ∞')
  // The phrase makes both weigh the same, wherever the sensor is turned and whatever the ellipse.
  const equal = spec.tries.find(({ name }) => name === 'equal')
  for (const params of [
    {},
    { tilt: -0.7 },
    { tilt: -Math.PI / 2 },
    { semiMajor: 3, semiMinor: 3 },
    { semiMajor: 0.15, semiMinor: 0.15 },
    { semiMajor: 3, tilt: -0.4 },
  ]) {
    const lab = opened(params)
    const frame = opened({ ...params, ...equal.change(lab.frame(), lab) }).frame()
    assert.match(spec.verdict(frame), /Reading and expected output weigh the same: y\* lies half way\./)
    assert.ok(Math.abs(frame.mostLikelyVariance / frame.expectedVariance - 0.5) < 1e-9)
  }
})
