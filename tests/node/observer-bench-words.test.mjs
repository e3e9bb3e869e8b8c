import assert from 'node:assert/strict'
import { test } from 'node:test'
import { check, estimate, number, prints, pattern, widget } from './claims.mjs'

/** The modulus of the largest eigenvalue that a gain moves. */
const moving = ({ pinned, modulus, spectralRadius }) => (pinned === null ? spectralRadius : modulus[1 - pinned])

check(
  'observer-bench',
  {
    sensor: ['velocity', 'position'],
    mode: ['fixed', 'filter'],
    seed: [1, 7],
    gain: [0, 0.01, 0.5, 1, 2.99, 3.02, 3.028947959635742, 3.03, 3.05, 5.57, 5.58257569495584, 5.59, 6],
  },
  [0, 1, 2, 12, 30, 400],
  () => [
    [/^The estimate has left every bound, and the run has stopped\.$/, ({ diverged }) => diverged],
    [/^Turn the gain below ([\d.]+)\.$/, ({ stableUpTo, diverged }, limit) => diverged && prints(limit, stableUpTo)],
    [/^No gain has been used yet\.$/, ({ step, params }) => step === 0 && params.mode === 'filter'],
    [
      /^Dead reckoning: no reading is used, and nothing takes an error back\.$/,
      ({ params, R }) => params.mode === 'fixed' && R.every((entry) => entry === 0),
    ],
    [
      /^At the limit of stability: the factor a step is 1\.000, and an error neither dies out nor grows\.$/,
      (frame) => Math.abs(moving(frame) - 1) < 6e-4 && frame.params.mode === 'fixed',
    ],
    [
      /^Unstable: in the long run the error grows by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        !frame.stable && number(factor) > 1 && prints(factor, moving(frame)) && frame.params.mode === 'fixed',
    ],
    [
      /^Stable: in the long run every error shrinks by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        frame.stable &&
        frame.pinned === null &&
        number(factor) < 1 &&
        prints(factor, frame.spectralRadius) &&
        frame.params.mode === 'fixed',
    ],
    [
      /^A velocity error shrinks by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        frame.stable &&
        frame.pinned !== null &&
        number(factor) < 1 &&
        prints(factor, moving(frame)) &&
        frame.params.mode === 'fixed',
    ],
    [
      /^The other eigenvalue is 1 for every gain: no gain takes a position error back\.$/,
      ({ pinned, modulus }) => pinned !== null && Math.abs(modulus[pinned] - 1) < 1e-9,
    ],
    [
      pattern(
        /^If the filter kept (this step’s gain|that of step 1), /,
        /(every|a velocity) error would shrink by the factor ([\d.]+) a step in the long run\.$/,
      ),
      (frame, gain, which, factor) =>
        frame.params.mode === 'filter' &&
        (gain === 'that of step 1') === (frame.step === 0) &&
        (which === 'every') === (frame.pinned === null) &&
        number(factor) < 1 &&
        prints(factor, moving(frame)),
    ],
  ],
)

test('before the first step of the filter no gain is read out', async () => {
  const spec = await widget('observer-bench')
  for (const sensor of ['velocity', 'position']) {
    const lab = estimate.ObserverBench.from({
      version: 1,
      lab: spec.name,
      step: 0,
      params: { sensor, mode: 'filter' },
    })
    const read = () => Object.fromEntries(spec.readouts(lab.frame()).map(({ key, value }) => [key, value]))
    /** @type {any} */
    const knob = spec.controls.find(({ name }) => name === 'gain')
    const shown = () => knob.words(knob.get(lab.frame().params, lab.frame()), lab.frame())
    assert.deepEqual([read().gain, read().knob, read().innovation, shown()], ['–', '–', '–', '–'])
    assert.match(spec.describe(lab.frame()).gain, /none used yet/)
    assert.match(spec.describe(lab.frame()).disc, /in step 1 are/)
    lab.run(1)
    assert.match(read().gain, /^\[[\d.]+, [\d.]+\]$/)
    assert.match(`${read().knob} ${shown()}`, /^[\d.]+ [\d.]+$/)
    lab.free()
  }
})
