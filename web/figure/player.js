/** What a reader has asked of a run and the screen does not show yet, and how many steps are due in play. */

/** Where motion is not wanted a run in play goes on in lumps, and each picture stays this long, milliseconds. */
const STILL_MS = 500
/** After a pause of the browser a run in play goes on, and does not catch up, milliseconds. */
const MOST_MS = 250

/**
 * @typedef {object} Outcome of one turn
 * @property {'nothing' | 'steps' | 'replay' | 'reset'} moved
 * @property {string | null} refused what the lab said when it refused; the run is then as it was
 * @property {boolean} ended whether play, or a press on Step, has come to the last step of all
 */

export class Player {
  /** @param {any} frame the one on the screen @param {number} pace steps a second at speed 1 */
  constructor(frame, pace) {
    this.frame = frame
    this.pace = pace
    /** The step that the reader has asked for. */
    this.goal = 0
    /** What the reader has changed since the last replay began. @type {Record<string, unknown> | null} */
    this.patch = null
    this.wantsReset = false
    this.playing = false
    this.rate = 1
    /** Steps of play that are due: the fraction that is left over from the last turn. */
    this.due = 0
    /** When steps were last taken in play. */
    this.stepped = -Infinity
    /** What `wanted` answered last. @type {{ frame: any, patch: any, pending: any, wanted: any } | null} */
    this.remembered = null
  }

  /** The replay that is under way. @returns {{ params: any } | null} */
  get pending() {
    return null
  }

  /** The parameters that the reader has asked for, when the screen does not show them yet. */
  get asked() {
    const { pending, patch, frame } = this
    return patch || pending ? { ...(pending ?? frame).params, ...patch } : null
  }

  /**
   * The frame on the screen, but with the parameters that the reader has asked for: controls and handles show these at
   * once, and the next change starts from them. The same object until one of the two changes.
   */
  get wanted() {
    const { frame, patch, pending, asked, remembered: old } = this
    if (!asked) return frame
    if (old && old.frame === frame && old.patch === patch && old.pending === pending) return old.wanted
    const wanted = { ...frame, params: asked }
    this.remembered = { frame, patch, pending, wanted }
    return wanted
  }

  reset() {
    this.playing = false
    this.wantsReset = true
    this.goal = 0
  }

  /**
   * @param {number} now
   * @param {number} elapsed milliseconds since the last turn
   * @param {boolean} calm whether motion is not wanted
   * @param {number} [most] steps of one turn
   */
  dueSteps(now, elapsed, calm, most = Infinity) {
    this.due += Number.isFinite(elapsed) ? (Math.min(elapsed, MOST_MS) / 1000) * this.rate * this.pace : 0
    if (calm && now - this.stepped < STILL_MS) return 0
    const whole = Math.min(Math.floor(this.due), most)
    this.due -= whole
    if (whole > 0) this.stepped = now
    return whole
  }
}
