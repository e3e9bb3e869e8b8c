// What the fuzz test knows of each exported function: how to make valid arguments, and where an answer holds a
// covariance.
import { matrix, reading, row, sizes, system, vector } from './arguments.mjs'
import { covariance } from './nonsense.mjs'

/**
 * F and a matrix beside it, as often of zeros and ones as of anything: deadbeat and unseen directions are rare
 * otherwise.
 */
function pair(dice, shape) {
  const { n } = sizes(dice)
  const entry = dice.uniform() < 0.5 ? () => dice.below(2) : dice.normal
  const [rows, columns] = shape(n)
  const of = (height, width) => Array.from({ length: height }, () => Array.from({ length: width }, entry))
  return [of(n, n), of(rows, columns), ...dice.pick([[], [0], [1e-3]])]
}

/** Eigenvalues to be placed, now and then a pair. */
const poles = (n, dice) =>
  n === 2 && dice.uniform() < 0.5
    ? [
        { re: 0.3, im: 0.2 },
        { re: 0.3, im: -0.2 },
      ]
    : Array.from({ length: n }, () => dice.uniform())

/** name → valid arguments, the covariances in an answer, and for what is slow how many calls will do. */
export const FUNCTIONS = {
  kalmanStep: {
    args(dice) {
      const size = sizes(dice)
      return [
        system(size, dice),
        { x: vector(size.n, dice), P: covariance(size.n, dice) },
        vector(size.m, dice),
        vector(size.p, dice),
      ]
    },
    covariances: (answer) => [answer.predicted.P, answer.S, answer.P],
  },
  kalmanReplay: {
    args(dice) {
      const size = dice.uniform() < 0.3 ? { n: 2, p: 1, m: 1 } : sizes(dice)
      const steps = 1 + dice.below(5)
      const log = (width) => Float64Array.from(vector(steps * width, dice))
      const [inputs, readings] = [log(size.m), log(size.p)]
      if (dice.uniform() < 0.2) readings[dice.below(readings.length)] = dice.pick([NaN, -Infinity, 1e308, 5e-324])
      return [system(size, dice), { x: vector(size.n, dice), P: covariance(size.n, dice) }, inputs, readings]
    },
    covariances: (answer) => [answer.P],
  },
  kalmanSmooth: {
    args(dice) {
      const size = dice.uniform() < 0.3 ? { n: 2, p: 1, m: 1 } : sizes(dice)
      const rows = 1 + dice.below(5)
      const log = (one) => Array.from({ length: rows }, one)
      const y = () => (dice.uniform() < 0.2 ? null : reading(size.p, dice))
      const belief = { x: vector(size.n, dice), P: covariance(size.n, dice) }
      return [system(size, dice), belief, log(() => row(size.m, dice)), log(y)]
    },
    covariances: (answer) => answer.map(({ P }) => P),
  },
  discretize: {
    args(dice) {
      const { n, m } = sizes(dice)
      const dt = dice.pick([0, 1e-12, 0.1, dice.uniform(), 10 ** (18 * dice.uniform() - 9)])
      return [{ A: matrix(n, n, dice), B: matrix(n, m, dice), Q: covariance(n, dice) }, dt]
    },
    covariances: (answer) => [answer.V],
  },
  observerStep: {
    args(dice) {
      const size = sizes(dice)
      return [
        system(size, dice),
        matrix(size.n, size.p, dice),
        vector(size.n, dice),
        vector(size.m, dice),
        vector(size.p, dice),
      ]
    },
  },
  errorEigenvalues: {
    args(dice) {
      const size = sizes(dice)
      // Small whole numbers too: deadbeat matrices are where eigenvalue iterations hang.
      const plain = dice.uniform() < 0.5
      const whole = (rows, columns) =>
        Array.from({ length: rows }, () => Array.from({ length: columns }, () => dice.below(2)))
      const it = system(size, dice)
      if (plain) Object.assign(it, { F: whole(size.n, size.n), H: whole(size.p, size.n) })
      return [it, plain ? whole(size.n, size.p) : matrix(size.n, size.p, dice)]
    },
  },
  observability: {
    args(dice) {
      const { n, p } = sizes(dice)
      return dice.uniform() < 0.5
        ? [matrix(n, n, dice), matrix(p, n, dice)]
        : [matrix(n, n, dice), matrix(p, n, dice), 1e-9]
    },
  },
  placeObserverGain: {
    args(dice) {
      const n = 1 + dice.below(3)
      return [matrix(n, n, dice), matrix(1, n, dice), poles(n, dice)]
    },
  },
  detectability: {
    args: (dice) => pair(dice, (n) => [1 + dice.below(2), n]),
  },
  stabilizability: {
    args: (dice) => pair(dice, (n) => [n, 1 + dice.below(2)]),
  },
  noiseReach: {
    args(dice) {
      const [f] = pair(dice, (n) => [1, n])
      return [f, covariance(f.length, dice), ...dice.pick([[], [1e-6]])]
    },
  },
  riccatiLimit: {
    args: (dice) => [system(sizes(dice), dice), ...dice.pick([[], [1e-6]])],
  },
  placeMovable: {
    args(dice) {
      const n = 1 + dice.below(3)
      return [matrix(n, n, dice), matrix(1 + dice.below(2), n, dice), poles(n, dice), ...dice.pick([[], [1e-6]])]
    },
  },
  steadyStateGain: {
    args(dice) {
      const size = sizes(dice)
      const rest = dice.pick([[], [200], [200, 1e-9]])
      return [system(size, dice), covariance(size.n, dice), ...rest]
    },
    covariances: (answer) => [answer.P],
  },
  gainSchedule: {
    args(dice) {
      const size = sizes(dice)
      return [system(size, dice), covariance(size.n, dice), 1 + dice.below(20)]
    },
  },
  covarianceEllipse: {
    args: (dice) => (dice.uniform() < 0.5 ? [covariance(2, dice)] : [covariance(2, dice), 1 + dice.uniform()]),
  },
  euclideanFoot: {
    args(dice) {
      const { n, p } = { n: 2 + dice.below(2), p: 1 + dice.below(2) }
      return [matrix(p, n, dice), vector(n, dice), vector(p, dice)]
    },
  },
  mahalanobisFoot: {
    args(dice) {
      const { n, p } = { n: 2 + dice.below(2), p: 1 + dice.below(2) }
      return [matrix(p, n, dice), covariance(n, dice), vector(n, dice), vector(p, dice)]
    },
  },
  mostLikelyOutput: {
    args(dice) {
      const { n, p } = { n: 2 + dice.below(2), p: 1 + dice.below(2) }
      return [matrix(p, n, dice), covariance(n, dice), covariance(p, dice), vector(n, dice), vector(p, dice)]
    },
  },
  chapterChecks: { args: () => [], cases: 2 },
  chapterCheck: { args: (dice) => [1 + dice.below(13)], cases: 40 },
}
