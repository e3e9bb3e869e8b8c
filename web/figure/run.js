/**
 * The run that a figure shows: its lab, and the parameters and the step that the reader has asked for.
 *
 * A lab is a function of parameters, seed and step. So a change of parameters starts a second lab at step 0 and runs it
 * to the same step. A short replay is over within the turn that began it. A long one is spread over many turns, so that
 * the page stays responsive; the first lab stays on the screen until the second has arrived. `run(a)` and then `run(b)`
 * gives the same bits as `run(a + b)`.
 */

import { Player } from './player.js'
import { LAST_STEP } from './state-in-url.js'
import { NEARLY_DONE_MS, Pace, TURN_MS, remaining } from './time-slices.js'

/** Steps of one turn in play, at most: after a pause of the browser the run goes on, and does not catch up. */
const MOST_STEPS = 64

/** @typedef {import('./state-in-url.js').State} State */
/**
 * @typedef {{ lab: any, params: Record<string, unknown>, step: number, of: number, spent: number, moved: 'replay' |
 * 'reset', onRefusal?: string, same: boolean, ahead: number, far?: any }} Replay it runs to `ahead` first, for `far`
 */
/** @typedef {import('./player.js').Outcome} Outcome */

export class Run extends Player {
  /**
   * @param {any} lab
   * @param {number} pace steps a second at speed 1
   * @param {Pace} [calls]
   * @param {number} [lap] play stops at each multiple of so many steps
   * @param {(frame: any) => number} [end] the step that a run has no more behind
   * @param {(far: any, frame: { step: number }) => boolean} [whole] whether the figure draws the run as far as it has
   * come, though the screen shows a frame of before
   */
  constructor(lab, pace, calls = new Pace(), lap = LAST_STEP, end = () => LAST_STEP, whole = () => false) {
    super(lab.frame(), pace)
    this.lab = lab
    this.lap = lap
    this.end = end
    this.whole = whole
    /** The frame of this run that has come farthest. */
    this.far = this.frame
    this.calls = calls
    this.step = lab.state().step
    this.goal = this.step
    /** Whether Step was pressed at the last step of all. */
    this.atEnd = false
    /** @type {Replay | null} */
    this.replay = null
  }

  /** The last step of all. */
  get last() {
    return LAST_STEP
  }

  /** What the lab knows of each parameter. @returns {import('estimate-wasm').Parameter[]} */
  parameters() {
    return this.lab.constructor.parameters()
  }

  get pending() {
    return this.replay
  }

  /** Whether something is left to compute, play apart. */
  get busy() {
    return Boolean(this.patch || this.replay || this.wantsReset || this.step < this.goal)
  }

  /** How far a replay has come, null where there is none. @returns {{ step: number, of: number } | null} */
  get progress() {
    const { replay } = this
    return replay && { step: replay.far ? replay.ahead : replay.step, of: Math.max(replay.of, replay.ahead) }
  }

  /** Parameters and step as a link carries them; during a replay, those it leads to. @returns {State} */
  state() {
    const state = this.lab.state()
    return this.busy ? { ...state, params: this.asked ?? state.params, step: this.goal } : state
  }

  /** @param {Record<string, unknown>} patch parameters, and `step` where the run is to go to one */
  change({ step, ...patch }) {
    if (typeof step === 'number') this.goTo(step)
    if (step === undefined || Object.keys(patch).length > 0) this.patch = { ...this.patch, ...patch }
  }

  /** @param {number} step where the run has been already it is replayed */
  goTo(step) {
    this.playing = false
    this.goal = Math.max(0, Math.min(LAST_STEP, Math.round(step)))
    if (this.goal < this.step || this.replay) this.patch ??= {}
  }

  /** @param {number} steps */
  advance(steps) {
    this.playing = false
    this.atEnd = this.goal === LAST_STEP
    this.goal = Math.max(this.goal, Math.min(this.end(this.frame), LAST_STEP, this.goal + steps))
  }

  /** @param {boolean} on at the end of the run it plays from the start */
  play(on) {
    if (on && this.goal >= this.end(this.frame) && this.goal < LAST_STEP) this.reset()
    this.playing = on
    this.due = on ? 1 : 0
    if (!on && !this.replay) this.goal = this.step
  }

  /**
   * Goes over to another state, as a link asks for.
   * @param {any} lab at step 0
   * @param {number} step
   * @param {string} onRefusal what to say if the lab refuses a step of the way, instead of its own words
   */
  open(lab, step, onRefusal) {
    this.goal = step
    this.begin(lab, 'reset', onRefusal)
  }

  /**
   * Replays to the step asked for.
   * @param {any} lab at step 0
   * @param {'replay' | 'reset'} moved
   * @param {string} [onRefusal]
   */
  begin(lab, moved, onRefusal) {
    this.replay?.lab.free()
    const { far, goal } = this
    const { params } = lab.state()
    const same = moved === 'replay' && JSON.stringify(params) === JSON.stringify(far.params)
    const ahead = moved === 'replay' && !same && this.whole(far, { step: goal }) ? far.step : 0
    this.replay = { lab, params, step: 0, of: goal, spent: 0, moved, onRefusal, same, ahead }
  }

  /** Gives the replay up: the run on the screen stays. */
  cancel() {
    this.replay?.lab.free()
    this.replay = null
    this.patch = null
    this.wantsReset = false
    this.goal = this.step
  }

  /**
   * One turn's share of the work.
   * @param {number} now
   * @param {number} elapsed milliseconds since the last turn
   * @param {boolean} calm whether motion is not wanted
   * @param {number} [budget] milliseconds
   * @returns {Outcome}
   */
  turn(now, elapsed, calm, budget = TURN_MS) {
    try {
      this.startReplay()
    } catch (error) {
      return this.refuse(wordsOf(error))
    }
    try {
      if (this.replay) return { ...this.goOn(budget), refused: null, ended: false }
      return { ...this.takeSteps(now, elapsed, calm, budget), refused: null }
    } catch (error) {
      const words = this.replay?.onRefusal ?? wordsOf(error)
      this.cancel()
      return this.refuse(words)
    }
  }

  /** @param {string} refused @returns {Outcome} */
  refuse(refused) {
    this.playing = false
    if (!this.replay) this.goal = this.step
    return { moved: 'nothing', refused, ended: false }
  }

  /** What was changed since the last turn makes a replay necessary; a reset is one to step 0. */
  startReplay() {
    const { patch, wantsReset, replay } = this
    if (!patch && !wantsReset) return
    if (replay && !wantsReset) {
      const { step, of, spent } = replay
      if (remaining({ done: step, left: of - step, spent }) < NEARLY_DONE_MS) return
    }
    const params = this.asked ?? this.frame.params
    this.patch = null
    this.wantsReset = false
    this.begin(this.lab.constructor.from({ ...this.lab.state(), params, step: 0 }), wantsReset ? 'reset' : 'replay')
  }

  /** @param {number} budget @returns {{ moved: Outcome['moved'] }} */
  goOn(budget) {
    const replay = /** @type {Replay} */ (this.replay)
    const ahead = !replay.far && replay.ahead > this.goal
    // Steps asked for meanwhile.
    replay.of = ahead ? replay.ahead : this.goal
    const began = this.calls.clock()
    if (replay.step < replay.of) replay.step += this.calls.run(replay.lab, replay.of - replay.step, budget)
    replay.spent += this.calls.clock() - began
    if (replay.step < replay.of) return { moved: 'nothing' }
    const frame = replay.lab.frame()
    if (ahead) {
      const again = replay.lab.constructor.from({ ...replay.lab.state(), step: 0 })
      replay.lab.free()
      Object.assign(replay, { lab: again, step: 0, far: frame })
      return this.goOn(Math.max(0, budget - this.calls.clock() + began))
    }
    const far = replay.far ?? (replay.same ? this.far : frame)
    this.far = far.step > frame.step ? far : frame
    this.lab.free()
    this.replay = null
    this.lab = replay.lab
    this.frame = frame
    this.step = replay.step
    return { moved: replay.moved }
  }

  /**
   * @param {number} now
   * @param {number} elapsed
   * @param {boolean} calm
   * @param {number} budget
   * @returns {{ moved: Outcome['moved'], ended: boolean }}
   */
  takeSteps(now, elapsed, calm, budget) {
    const before = this.step
    const end = Math.max(
      this.step,
      Math.min(LAST_STEP, this.end(this.frame), (Math.floor(this.step / this.lap) + 1) * this.lap),
    )
    if (this.playing && this.step === this.goal)
      this.goal = Math.min(end, this.step + this.dueSteps(now, elapsed, calm, calm ? 8 * MOST_STEPS : MOST_STEPS))
    if (this.step < this.goal) this.step += this.calls.run(this.lab, this.goal - this.step, budget)
    const ended = this.step === LAST_STEP && (this.playing || this.atEnd || before < LAST_STEP)
    this.atEnd = false
    if (ended || (this.playing && this.step === end)) this.playing = false
    // Where motion is not wanted nothing is shown of the way to the step asked for.
    if (this.step === before || (calm && this.step < this.goal)) return { moved: 'nothing', ended }
    this.frame = this.lab.frame()
    if (!(this.far.step > this.frame.step)) this.far = this.frame
    return { moved: 'steps', ended }
  }
}

/** @param {unknown} error */
function wordsOf(error) {
  if (error instanceof WebAssembly.RuntimeError)
    return 'The figure’s program met a fault of its own. Load the page again to go on.'
  return error instanceof Error ? error.message : 'The lab refused.'
}
