// A figure that draws all of a run keeps what a reader has seen of it: the dot is taken back, something is changed, and
// the changed run is there as far as the old one was.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { CALL_MS, Pace } from '../../web/figure/time-slices.js'
import { Run } from '../../web/figure/run.js'
import { estimate, widget } from './claims.mjs'

/** A clock by which each call of a lab takes just as long as it should. */
const ticking = () => {
  let now = 0
  return () => (now += CALL_MS)
}

/** Turns until nothing is left to do. @param {Run} run */
function finish(run) {
  for (let turns = 0; run.busy; turns++) {
    assert.ok(turns < 100_000, 'it comes to an end')
    run.turn(turns * 16, 16, false)
  }
}

test('a change behind the farthest step computes the run to there, and the screen stays where it is', async () => {
  const { lap, whole } = await widget('odometry-hook')
  const at = (params, step) => estimate.OdometryHook.from({ version: 1, lab: 'odometry-hook', step, params })
  const hook = (/** @type {number} */ step) => new Run(at({}, step), 20, new Pace(ticking()), lap, undefined, whole)
  const run = hook(640)
  run.change({ step: 206 })
  finish(run)
  assert.deepEqual([run.frame.step, run.far.step], [206, 640])
  for (const params of [{ bias: 0.01 }, { bias: 0.01, fixes: true }]) {
    run.change(params)
    for (let last = 0; run.busy; ) {
      run.turn(0, 16, false)
      if (!run.progress) continue
      assert.ok(run.progress.step >= last && run.progress.of === 640, 'the bar only grows')
      last = run.progress.step
    }
    assert.deepEqual(run.frame, at(params, 206).frame())
    assert.deepEqual(run.far, at(params, 640).frame())
    assert.equal(run.lab.digest(), at(params, 206).digest())
  }
  // On to beyond it, and from a step that its curves do not reach any more: there is nothing to keep.
  run.advance(500)
  finish(run)
  assert.deepEqual([run.frame.step, run.far.step], [706, 706])
  run.advance(5000)
  finish(run)
  run.change({ step: 300, bias: 0 })
  finish(run)
  assert.deepEqual([run.frame.step, run.far.step], [300, 300])
  run.reset()
  finish(run)
  assert.equal(run.far.step, 0)
  // While the way ahead is computed the reader goes on: what was asked for last is shown.
  const other = hook(640)
  other.change({ step: 100 })
  finish(other)
  other.change({ slip: 0.001 })
  other.turn(0, 16, false)
  other.advance(700)
  other.change({ bias: 0.002 })
  finish(other)
  assert.deepEqual([other.frame.step, other.far.step, other.frame.params.bias], [800, 800, 0.002])
})
