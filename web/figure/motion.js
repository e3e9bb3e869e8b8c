/** Motion between two frames: easing, beliefs between two beliefs, and a camera that follows. */

/** @typedef {{ semiMajor: number, semiMinor: number, angle: number }} Ellipse */
/** @typedef {{ x: number[], ellipse: Ellipse }} Blob a mean and its ellipse */

/** Length of a step on the screen, predict and update together. */
export const STEP_MS = 250

/** @param {number} t */
export function ease(t) {
  return t < 0.5 ? 4 * t ** 3 : 1 - (2 - 2 * t) ** 3 / 2
}

/**
 * @param {number} from
 * @param {number} to
 * @param {number} t
 */
export function mix(from, to, t) {
  return from + (to - from) * t
}

/**
 * A belief between two others; its ellipse turns the short way round.
 * @template {Blob} B
 * @param {B} from
 * @param {B} to
 * @param {number} t
 * @returns {B}
 */
export function between(from, to, t) {
  if (t >= 1) return to
  const turn = to.ellipse.angle - from.ellipse.angle
  const short = turn - Math.PI * Math.round(turn / Math.PI)
  return {
    ...to,
    x: to.x.map((value, i) => mix(from.x[i], value, t)),
    ellipse: {
      semiMajor: mix(from.ellipse.semiMajor, to.ellipse.semiMajor, t),
      semiMinor: mix(from.ellipse.semiMinor, to.ellipse.semiMinor, t),
      angle: from.ellipse.angle + short * t,
    },
  }
}

/**
 * One axis of a camera. It shows the first range at once. It glides to another range when the present one is too small
 * for the values or much too wide, and otherwise rests.
 */
export class Span {
  constructor() {
    /** @type {[number, number] | null} */
    this.now = null
    /** @type {[number, number]} */
    this.goal = [-1, 1]
  }

  /**
   * @param {number} low
   * @param {number} high
   * @param {number} elapsed
   * @param {number} [margin] room on either side, as a part of the range
   * @returns {boolean} whether it still moves
   */
  follow(low, high, elapsed, margin = 0.14) {
    const wide = high - low || 1
    const [from, to] = this.goal
    if (!this.now || low < from || high > to || wide < (to - from) / 2.4)
      this.goal = [low - wide * margin, high + wide * margin]
    this.now ??= this.goal
    const t = 1 - Math.exp(-elapsed / 110)
    const next = /** @type {[number, number]} */ (this.now.map((value, i) => mix(value, this.goal[i], t)))
    const off = Math.max(...next.map((value, i) => Math.abs(value - this.goal[i])))
    const arrived = off < 0.003 * (this.goal[1] - this.goal[0])
    this.now = arrived ? this.goal : next
    return !arrived
  }
}
