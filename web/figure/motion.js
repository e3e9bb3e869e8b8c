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
   * @param {number} [loose] how many times the range of the values may be before it glides to a closer one
   * @returns {boolean} whether it still moves
   */
  follow(low, high, elapsed, margin = 0.14, loose = 2.4) {
    const wide = high - low || 1
    const [from, to] = this.goal
    if (!this.now || low < from || high > to || wide < (to - from) / loose)
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

/** How much wider than what it shows a scale may be before it is chosen anew: three of its steps. */
const MUCH = 8
/** What is shown keeps this distance from the edge, as a part of its reach. */
const ROOM = 1.06

/**
 * One axis of a plane that holds still for a run: what grows is seen to grow. Where it would leave the plane on a side,
 * that side glides to twice its distance from the origin, and never to less, unless the run begins anew or what it
 * shows has become small.
 */
export class Scale {
  /** @param {number} least the least distance from the origin to a side; others are its doubles */
  constructor(least) {
    this.least = least
    /** From the origin to either side. */
    this.goal = [0, 0]
    this.sides = [0, 0]
  }

  /** @returns {[number, number]} */
  get now() {
    return [-this.sides[0], this.sides[1]]
  }

  /** Whether what is shown has become small. @param {[number, number]} range */
  isLoose(range) {
    return Math.max(...distances(range)) * MUCH < Math.max(...this.goal)
  }

  /**
   * @param {[number, number]} range of what is shown
   * @param {number} elapsed
   * @param {boolean} anew whether a run begins
   * @returns {boolean} whether it still moves
   */
  follow(range, elapsed, anew) {
    const far = distances(range)
    if (anew || this.isLoose(range)) this.goal = [0, 0]
    this.goal = this.goal.map((goal, i) => doubled(goal || this.least, far[i]))
    if (!this.sides[0] || elapsed === Infinity) this.sides = this.goal
    const t = 1 - Math.exp(-elapsed / 140)
    const next = this.sides.map((side, i) => mix(side, this.goal[i], t))
    const arrived = next.every((side, i) => Math.abs(side - this.goal[i]) < 0.003 * this.goal[i])
    this.sides = arrived ? this.goal : next
    return !arrived
  }
}

/** @param {[number, number]} range */
const distances = ([low, high]) => [-low, high].map((side) => Math.max(0, side) * ROOM)

/** Twice as much as often as it takes. @param {number} goal @param {number} far */
function doubled(goal, far) {
  while (goal < far && Number.isFinite(far)) goal *= 2
  return goal
}
