// A filter says whether its digits are lost: what the chapter shows has all of them, and where the scales of P and W
// are too far apart there is no likelihood.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { PRESETS, paramsOf } from '../../web/widgets/own-system/presets.js'

const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** Two states that nothing is known of, of which readings of small noise tell the sum and then the difference. */
const sum = {
  F: [
    [1, 0],
    [0, 1],
  ],
  G: [[], []],
  H: [[1, 1]],
  V: [
    [0, 0],
    [0, 0],
  ],
  W: [[1e-10]],
}
const difference = {
  ...sum,
  F: [
    [1, 0],
    [0, -1],
  ],
}
const unknown = (variance) => ({
  x: [0, 0],
  P: [
    [variance, 0],
    [0, variance],
  ],
})

test('a filter, a step and a replay whose digits are lost say so, and give no likelihood', () => {
  for (const [variance, conditioned] of [
    [1e-6, true],
    [1e-3, true],
    [1e14, false],
  ]) {
    // Each step turns the second state's sign, so that sum and difference are read in turn.
    const filter = new core.KalmanFilter(difference, unknown(variance))
    for (const y of [1, 1, 1]) filter.step([], [y])
    assert.deepEqual([variance, filter.conditioned], [variance, conditioned])
    assert.equal(filter.logLikelihood === null, !conditioned)
    const replay = core.kalmanReplay(difference, unknown(variance), new Float64Array(0), Float64Array.of(1, 1, 1))
    assert.deepEqual([replay.conditioned, replay.logLikelihood], [conditioned, filter.logLikelihood])
  }
  const known = core.kalmanStep(sum, unknown(1), [], [1])
  assert.equal(known.conditioned, true)
  // What is read lies across a direction of variance 10¹⁸: of S a double has nothing.
  const across = {
    x: [0, 0],
    P: [
      [9e18, -3e18],
      [-3e18, 1e18],
    ],
  }
  const read = () => core.kalmanStep({ ...sum, H: [[1, 3]], W: [[0.5]] }, across, [], [1])
  assert.equal(read().conditioned, false)
})

test('every preset of a system of one’s own keeps its digits over a thousand steps', () => {
  for (const preset of PRESETS) {
    const lab = new core.OwnSystem(paramsOf(preset))
    lab.run(1000)
    assert.deepEqual([preset.name, lab.frame().conditioned], [preset.name, true])
  }
})
