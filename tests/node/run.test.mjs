// The run behind a figure, over the module's labs: replays in slices give the same bits as one call, no call of a lab
// grows long, a change supersedes a replay under way, and the last step is reached.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { CALL_MS, FIRST_CALL, Pace } from '../../web/figure/time-slices.js'
import { Run } from '../../web/figure/run.js'
import { LAST_STEP as LAST } from '../../web/figure/state-in-url.js'
import { HEAP } from '../heap.mjs'

const estimate = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/**
 * A clock by which each call of a lab takes just as long as it should, so that a turn is over after a few short calls.
 */
const ticking = () => {
  let now = 0
  return () => (now += CALL_MS)
}

/** A lab that takes `cost(step)` milliseconds of `time` for each step, and notes the length of each call. */
function slow(cost) {
  const time = { now: 0, calls: /** @type {number[]} */ ([]), steps: 0 }
  const lab = {
    run(n) {
      time.calls.push(n)
      for (let i = 0; i < n; i++) time.now += cost(time.steps++)
    },
  }
  return { lab, time, pace: new Pace(() => time.now) }
}

/** Turns until nothing is left to do; answers the outcomes. */
function finish(run, most = 100_000) {
  const outcomes = []
  for (let turns = 0; run.busy; turns++) {
    assert.ok(turns < most, 'it comes to an end')
    outcomes.push(run.turn(turns * 16, 16, false))
  }
  return outcomes
}

/** @returns {any} */
const runOf = (name, params, step) =>
  new Run(estimate[name].from({ version: 1, lab: nameOf(name), params, step }), 20, new Pace(ticking()))
const nameOf = (name) =>
  ({
    ObservabilityProbe: 'observability-probe',
    ObserverBench: 'observer-bench',
    OdometryHook: 'odometry-hook',
    Picture: 'picture',
  })[name]

for (const [what, cost] of /** @type {[string, (step: number) => number][]} */ ([
  ['each step costs the same', () => 0.5],
  ['steps become ever dearer', (step) => 0.01 + step / 2000],
  ['a step is dear from one on', (step) => (step < 5000 ? 0.001 : 2)],
])) {
  test(`no call of a lab grows long where ${what}`, () => {
    const { lab, time, pace } = slow(cost)
    let taken = 0
    while (taken < 20_000) {
      const before = time.now
      taken += pace.run(lab, 20_000 - taken, 24)
      const longest = 2 * CALL_MS + cost(taken) * FIRST_CALL
      // A lab whose cost jumps is measured once before calls become shorter.
      if (what !== 'a step is dear from one on')
        assert.ok(time.now - before <= 24 + longest, `${time.now - before} ms in one turn`)
    }
    assert.equal(taken, 20_000)
    assert.ok(time.calls.length > 20, `${time.calls.length} calls`)
    // The call that meets the jump is as long as the cheap steps before it allowed; the next one is not.
    assert.ok(time.calls.at(-2) * cost(19_999) <= 2 * CALL_MS || time.calls.at(-2) === 1)
  })
}

test('where the clock is too coarse to see a call, calls at most double', () => {
  const calls = []
  const pace = new Pace(() => 0)
  pace.run({ run: (n) => calls.push(n) }, 5000, 24)
  assert.equal(calls[0], FIRST_CALL)
  for (let i = 1; i < calls.length; i++) assert.ok(calls[i] <= 2 * calls[i - 1], `${calls}`)
})

for (const [name, params, step] of /** @type {[string, object, number][]} */ ([
  ['ObservabilityProbe', HEAP, 1500],
  ['ObservabilityProbe', { count: 2 }, 9000],
  ['OdometryHook', { fixes: true }, 20_000],
  ['ObserverBench', { gain: 0.7 }, 20_000],
])) {
  test(`a replay of the ${name} to step ${step} in slices has the bits of one call`, () => {
    const whole = estimate[name].from({ version: 1, lab: nameOf(name), params, step })
    const run = runOf(name, { ...params, seed: 9 }, step)
    run.change({ seed: 1 })
    const turns = finish(run).length
    assert.ok(turns > 3, `${turns} turns`)
    assert.equal(run.lab.digest(), whole.digest())
    assert.deepEqual(run.frame, whole.frame())
    assert.deepEqual(run.state(), whole.state())
  })
}

test("the old picture stays until the replay is over, and the reader's parameters are known at once", () => {
  const run = runOf('ObserverBench', { gain: 1 }, 20_000)
  const { frame } = run
  run.change({ gain: 0.5 })
  assert.equal(run.turn(0, 16, false).moved, 'nothing')
  assert.equal(run.frame, frame)
  assert.equal(run.wanted.params.gain, 0.5)
  assert.equal(run.wanted, run.wanted, 'one object while nothing changes')
  assert.ok(run.progress.step > 0 && run.progress.step < run.progress.of && run.progress.of === 20_000)
  assert.deepEqual([run.state().params.gain, run.state().step], [0.5, 20_000], 'a link leads where the reader goes')
  const outcomes = finish(run)
  assert.equal(outcomes.at(-1).moved, 'replay')
  assert.ok(outcomes.slice(0, -1).every(({ moved }) => moved === 'nothing'))
  assert.equal(run.frame.params.gain, 0.5)
  assert.equal(run.wanted, run.frame)
})

test('a replay that is cancelled leaves everything as it was', () => {
  const run = runOf('ObserverBench', { gain: 1 }, 20_000)
  const { frame, lab } = run
  const state = run.state()
  run.change({ gain: 0.5 })
  run.turn(0, 16, false)
  run.advance(10)
  run.cancel()
  assert.ok(!run.busy && run.progress === null)
  assert.ok(run.frame === frame && run.lab === lab && run.wanted === frame)
  assert.deepEqual(run.state(), state)
  run.advance(1)
  finish(run)
  assert.equal(run.step, 20_001)
})

test('a change supersedes a long replay, and what was changed before holds', () => {
  const run = runOf('ObserverBench', { gain: 1, seed: 1 }, 90_000)
  run.change({ gain: 0.5 })
  run.turn(0, 16, false)
  const { step } = run.progress
  run.change({ seed: 4 })
  run.replay.spent = 1e6
  run.turn(16, 16, false)
  assert.ok(run.progress.step <= 2 * step && run.replay.params.seed === 4, 'it begins anew')
  finish(run)
  assert.deepEqual([run.frame.params.gain, run.frame.params.seed, run.step], [0.5, 4, 90_000])
})

test('a replay that is nearly done is finished before the next change begins, so that a drag shows pictures', () => {
  const run = runOf('ObserverBench', { gain: 1 }, 300)
  run.change({ gain: 0.5 })
  run.turn(0, 16, false)
  run.change({ gain: 0.6 })
  assert.equal(run.wanted.params.gain, 0.6)
  const gains = new Set()
  while (run.busy) {
    run.turn(0, 16, false)
    gains.add(run.frame.params.gain)
  }
  assert.deepEqual([...gains], [1, 0.5, 0.6])
})

test('Step and Reset count while a replay is under way', () => {
  const run = runOf('ObserverBench', { gain: 1 }, 20_000)
  run.change({ gain: 0.5 })
  run.turn(0, 16, false)
  run.advance(3)
  finish(run)
  assert.deepEqual([run.step, run.frame.step], [20_003, 20_003])
  run.change({ gain: 0.7 })
  run.turn(0, 16, false)
  run.reset()
  run.advance(2)
  assert.equal(finish(run)[0].moved, 'reset')
  assert.deepEqual([run.frame.params.gain, run.frame.step], [0.7, 2])
})

test('play reaches the last step and stops there; Play and Step say so', () => {
  const run = runOf('ObserverBench', {}, LAST - 31)
  run.play(true)
  run.rate = 10
  let ended = false
  for (let turn = 0; turn < 50 && !ended; turn++) ended = run.turn(turn * 100, 100, false).ended
  assert.ok(ended)
  assert.deepEqual([run.step, run.frame.step, run.playing], [LAST, LAST, false])
  assert.equal(run.turn(6000, 16, false).ended, false, 'said once')
  run.advance(1)
  assert.deepEqual(run.turn(6016, 16, false), { moved: 'nothing', ended: true, refused: null })
  run.play(true)
  assert.deepEqual(run.turn(6032, 16, false), { moved: 'nothing', ended: true, refused: null })
  assert.ok(!run.playing)
})

test('a step past the last one leads to the last one', () => {
  const run = runOf('OdometryHook', {}, LAST - 4)
  run.advance(10)
  const outcomes = finish(run)
  assert.equal(run.step, LAST)
  assert.ok(outcomes.at(-1).ended && outcomes.every(({ refused }) => refused === null))
})

test('a change that the lab refuses leaves the run as it was, and a replay under way goes on', () => {
  const run = runOf('ObserverBench', { gain: 1 }, 20_000)
  const { frame } = run
  run.change({ gain: -1 })
  assert.match(run.turn(0, 16, false).refused, /gain/)
  assert.ok(!run.busy && run.frame === frame)
  run.play(true)
  assert.equal(run.turn(16, 250, false).moved, 'steps', 'it can be played on')
  run.play(false)
  run.change({ gain: 0.5 })
  run.turn(32, 16, false)
  run.replay.spent = 1e6
  run.change({ gain: -1 })
  assert.match(run.turn(48, 16, false).refused, /gain/)
  finish(run)
  assert.equal(run.frame.params.gain, 0.5)
})

test('a lab that refuses a step of a replay leaves the run as it was', () => {
  const run = runOf('ObserverBench', { gain: 1 }, 20_000)
  const { frame } = run
  run.change({ gain: 0.5 })
  run.turn(0, 16, false)
  run.replay.lab = {
    run: () => {
      throw new Error('stuck')
    },
    free: () => {},
  }
  assert.equal(run.turn(16, 16, false).refused, 'stuck')
  assert.ok(!run.busy && run.frame === frame && run.state().params.gain === 1)
})

test('where motion is not wanted a run is not shown between two lumps', () => {
  const run = runOf('ObservabilityProbe', HEAP, 0)
  run.advance(600)
  const outcomes = []
  while (run.busy) outcomes.push(run.turn(0, 16, true))
  assert.ok(outcomes.length > 1)
  assert.deepEqual(
    outcomes.map(({ moved }) => moved).filter((moved) => moved !== 'nothing'),
    ['steps'],
  )
  assert.equal(run.frame.step, 600)
})

test('play stops where the run ends, and begins it anew from there', () => {
  const lab = estimate.BugMuseum.from({ version: 1, lab: 'bug-museum', params: {}, step: 230 })
  const run = new Run(lab, 200, new Pace(ticking()), 240, ({ steps }) => steps)
  const play = () => {
    run.play(true)
    for (let turns = 0; run.playing; turns++) {
      assert.ok(turns < 1000, 'it stops')
      run.turn(turns * 16, 16, false)
    }
    return run.step
  }
  assert.equal(play(), 240)
  run.advance(5)
  finish(run)
  assert.equal(run.step, 240, 'a step leads no further')
  run.play(true)
  run.turn(0, 16, false)
  run.turn(16, 16, false)
  assert.ok(run.step < 100, `from the start, now at ${run.step}`)
  while (run.playing) run.turn(32, 16, false)
  assert.equal(run.step, 240)
  run.change({ step: 400 })
  finish(run)
  assert.equal(run.step, 400, "a reader's link or slider goes where it says")
})
