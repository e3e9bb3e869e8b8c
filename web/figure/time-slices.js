/**
 * Runs a lab for a limited time. A step of one lab costs a hundred times that of another, and the cost may grow along a
 * run, so the number of steps in one call follows from how long the last call took.
 */

/** How long one call of the lab should take, milliseconds: nothing can interrupt a call. */
export const CALL_MS = 6
/** Steps of the first call. */
export const FIRST_CALL = 16
/**
 * How long it may go on in one turn of a page, or of a worker before that reads its messages, milliseconds: half of it
 * would leave most of the time between a page's frames unused.
 */
export const TURN_MS = 24
/** A replay that needs no longer than this, milliseconds, is finished before a later one begins. */
export const NEARLY_DONE_MS = 150

/**
 * Milliseconds that a replay still needs, as far as it has shown.
 * @param {{ done: number, left: number, spent: number }} replay steps, and the milliseconds of those that are done
 */
export const remaining = ({ done, left, spent }) => (done === 0 ? Infinity : (spent * left) / done)

export class Pace {
  /** @param {() => number} [clock] milliseconds */
  constructor(clock = () => performance.now()) {
    this.clock = clock
    /** Steps of the next call. */
    this.steps = FIRST_CALL
  }

  /**
   * At most `steps` steps of `lab`, in calls that stop once `budget` milliseconds have passed.
   * @param {{ run: (steps: number) => void }} lab what it throws is thrown on
   * @param {number} steps
   * @param {number} budget
   * @returns {number} the steps taken, at least 1
   */
  run(lab, steps, budget) {
    const began = this.clock()
    let [taken, now] = [0, began]
    while (taken < steps && (taken === 0 || now - began < budget)) {
      const asked = Math.min(this.steps, steps - taken)
      const start = now
      lab.run(asked)
      taken += asked
      now = this.clock()
      this.adapt(asked, now - start)
    }
    return taken
  }

  /**
   * A call may at most double: where the clock is too coarse to see a short call, the number of steps still grows
   * slowly.
   * @param {number} asked
   * @param {number} took milliseconds
   */
  adapt(asked, took) {
    const fitting = took > 0 ? Math.floor((asked * CALL_MS) / took) : Infinity
    // A short call that was quick says nothing about a longer one.
    if (asked < this.steps && fitting >= this.steps) return
    this.steps = Math.max(1, Math.min(fitting, 2 * asked))
  }
}
