// What the fuzz test knows of each export: how to make valid arguments, and where an answer holds a covariance.
import { FIGURES } from '../../target/figures.js'
import { logClasses } from './log-exports.mjs'
import { covariance } from './nonsense.mjs'

const vector = (n, dice) => Array.from({ length: n }, () => dice.normal() * 10 ** dice.below(3))
const matrix = (rows, columns, dice) => Array.from({ length: rows }, () => vector(columns, dice))

/** A vector as a program may hand it over. */
const row = (n, dice) => (dice.uniform() < 0.5 ? vector(n, dice) : Float64Array.from(vector(n, dice)))

function sizes(dice) {
  return { n: 1 + dice.below(4), p: 1 + dice.below(2), m: 1 + dice.below(2) }
}

function system({ n, p, m }, dice) {
  return {
    F: matrix(n, n, dice).map((row) => row.map((a) => a / 20)),
    G: matrix(n, m, dice),
    H: matrix(p, n, dice),
    V: covariance(n, dice),
    W: covariance(p, dice),
  }
}

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
      const poles =
        n === 2 && dice.uniform() < 0.5
          ? [
              { re: 0.3, im: 0.2 },
              { re: 0.3, im: -0.2 },
            ]
          : Array.from({ length: n }, () => dice.uniform())
      return [matrix(n, n, dice), matrix(1, n, dice), poles]
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
      const poles =
        n === 2 && dice.uniform() < 0.5
          ? [
              { re: 0.3, im: 0.2 },
              { re: 0.3, im: -0.2 },
            ]
          : Array.from({ length: n }, () => dice.uniform())
      return [matrix(n, n, dice), matrix(1 + dice.below(2), n, dice), poles, ...dice.pick([[], [1e-6]])]
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

const pose = (dice) => ({ x: [dice.normal() * 3, dice.normal() * 3, dice.normal()], P: covariance(3, dice) })
const motion = (dice) => [[dice.normal() * 0.1, dice.normal() * 0.1], covariance(3, dice)]
const gate = (dice) => dice.pick([null, 9.21, 1e-3, 1e6])

/** What the robot at `x` reads of a place: mostly as from there, a little off; now and then anything. */
function seen([x, y, theta], at, dice) {
  if (dice.uniform() < 0.15) return { range: 0.1 + Math.abs(dice.normal()) * 4, bearing: dice.normal() }
  const off = dice.pick([1e-3, 0.02, 0.3])
  const range = Math.hypot(x - at.x, y - at.y) + off * dice.normal()
  return { range: Math.abs(range), bearing: Math.atan2(y - at.y, x - at.x) - theta + off * dice.normal() }
}

/** What there is to be mapped: few places, so that they are seen again. */
const WORLD = [
  { x: 4, y: 1 },
  { x: -3, y: 2 },
  { x: 1, y: -4 },
  { x: -2, y: -3 },
]

/**
 * name → how to make one; what it can be told, given the object and what it was made of; what it must not change when
 * it refuses; the covariances it shows, and those of an answer. `chain`: fewer calls than this on one object; `spoilt`:
 * the share of calls with spoilt arguments (nonsense alone never gets far into a filter); `often`: what is called more
 * than the rest. `least` says how often an outcome or a code comes up in 1500 cases at least, about half of what twenty
 * seeds had: without it a test that no longer reaches anything would pass.
 */
export const CLASSES = {
  KalmanFilter: {
    chain: 30,
    spoilt: 0.35,
    often: ['step', 'update'],
    least: { 'a reading judged': 300 },
    make(dice) {
      const size = dice.uniform() < 0.5 ? { n: 2, p: 1 + dice.below(2), m: 1 } : sizes(dice)
      return [system(size, dice), { x: vector(size.n, dice), P: covariance(size.n, dice) }]
    },
    methods: {
      predict: (dice, _, _it, [{ G }]) => [row(G[0].length, dice)],
      update: (dice, _, _it, [{ H }]) => [row(H.length, dice)],
      step: (dice, _, _it, [{ G, H }]) => [row(G[0].length, dice), row(H.length, dice)],
    },
    look: ({ x, P, logLikelihood, nis }) => [x, P, logLikelihood, nis],
    covariances: (it) => [it.P],
    outcomes: (_, it) => (it?.nis === null ? [] : ['a reading judged']),
  },
  EkfLocalizer: {
    chain: 30,
    spoilt: 0.35,
    often: ['update', 'update', 'update'],
    least: { accepted: 200, rejected: 45, 'at-landmark': 5, 'accepted by range': 70, 'rejected by range': 12 },
    make(dice) {
      const belief = pose(dice)
      const landmarks = Array.from({ length: 1 + dice.below(4) }, (_, id) => ({
        id: id + 1,
        x: dice.normal() * 5,
        y: dice.normal() * 5,
      }))
      // Under the robot there is no bearing, nor a gradient of the range.
      if (dice.uniform() < 0.4) Object.assign(landmarks[0], { x: belief.x[0], y: belief.x[1] })
      const sensor = dice.pick(['range-bearing', 'range'])
      return [belief, landmarks, { W: covariance(sensor === 'range' ? 1 : 2, dice), gate: gate(dice), sensor }]
    },
    methods: {
      predict: motion,
      update(dice, _, it, [, landmarks, { sensor }]) {
        const landmark = dice.pick(landmarks)
        const { range, bearing } = seen(it.belief().x, landmark, dice)
        return [
          {
            range,
            ...(sensor === 'range' ? {} : { bearing }),
            ...(dice.uniform() < 0.6 ? { landmark: landmark.id } : {}),
          },
        ]
      },
      replay(dice, _, it, [, landmarks, { sensor }]) {
        const steps = 1 + dice.below(4)
        const landmark = dice.pick(landmarks)
        const log = Float64Array.from(
          Array.from({ length: steps }, () => {
            const { range, bearing } = seen(it.belief().x, landmark, dice)
            return [dice.normal() * 0.1, dice.normal() * 0.1, range, ...(sensor === 'range' ? [] : [bearing])]
          }).flat(),
        )
        if (dice.uniform() < 0.3) log[dice.below(log.length)] = dice.pick([NaN, Infinity, -1, 1e308, 5e-324])
        return [
          log,
          Uint32Array.from({ length: steps }, () => (dice.uniform() < 0.95 ? landmark.id : 9)),
          covariance(3, dice),
        ]
      },
      belief: () => [],
    },
    look: (it) => it.belief(),
    covariances: (it) => [it.belief().P],
    answered: (answer) => (answer?.S ? [answer.S] : []),
    outcomes: (answer) =>
      answer?.outcome ? [answer.outcome, ...(answer.S.length === 1 ? [`${answer.outcome} by range`] : [])] : [],
  },
  EkfSlam: {
    chain: 30,
    spoilt: 0.35,
    often: ['update', 'update', 'update'],
    least: { matched: 110, founded: 130, rejected: 60, 'at-landmark': 4 },
    make: (dice) => {
      const belief = pose(dice),
        W = covariance(2, dice),
        bound = gate(dice),
        founding = dice.pick([50, 1e7])
      // A gate above the founding threshold is refused; at the threshold it does what a higher one would.
      return [belief, { W, gate: bound && Math.min(bound, founding), found: founding }]
    },
    methods: {
      predict: motion,
      update(dice, _, it) {
        const { x } = it.belief()
        const sighting = () => {
          const id = dice.below(WORLD.length)
          // A landmark founded at no distance lies under the robot when it is seen again.
          const reading = dice.uniform() < 0.05 ? { range: 0, bearing: 0 } : seen(x, WORLD[id], dice)
          return { ...reading, ...(dice.uniform() < 0.5 ? { landmark: id + 1 } : {}) }
        }
        return [dice.uniform() < 0.5 ? sighting() : Array.from({ length: 1 + dice.below(3) }, sighting)]
      },
      belief: () => [],
      landmarks: () => [],
    },
    look: (it) => [it.belief(), it.landmarks()],
    covariances: (it) => [it.belief().P, ...it.landmarks().map(({ P }) => P)],
    // One answer, or one of each sighting; what is new is compared with nothing and has no S.
    answered: (answer) => [answer].flat().flatMap((one) => (one?.S ? [one.S] : [])),
    outcomes: (answer) => [answer].flat().flatMap((one) => (one?.outcome ? [one.outcome] : [])),
  },
}

/** The labs of the page share one face; their parameters are what `state()` says of a fresh one. */
export const LABS = FIGURES.filter(({ world }) => !world).map(({ lab }) => lab)
for (const name of LABS) {
  CLASSES[name] = {
    lab: true,
    make: (dice, fresh) => (dice.uniform() < 0.3 ? [] : [fresh().state().params]),
    methods: {
      set: (dice, fresh) => {
        const params = Object.entries(fresh().state().params)
        return [Object.fromEntries(params.filter(() => dice.uniform() < 0.5))]
      },
      step: () => [],
      run: (dice) => [1 + dice.below(50)],
      frame: () => [],
      state: () => [],
      digest: () => [],
    },
    look: (it) => [it.state(), it.frame()],
    covariances: (it) => covariancesIn(it.frame()),
  }
}

CLASSES.Tune.methods.likelihoodRow = (dice) => [dice.below(4), 4 + dice.below(5), 1 + dice.below(5)]

Object.assign(CLASSES, logClasses(CLASSES.Picture))

/** Every square matrix under a key P, however deep. */
function covariancesIn(value, found = []) {
  if (Array.isArray(value)) value.forEach((inner) => covariancesIn(inner, found))
  else if (value && typeof value === 'object') {
    for (const [key, inner] of Object.entries(value)) {
      if (key === 'P' && Array.isArray(inner?.[0]) && inner.length === inner[0].length) found.push(inner)
      else covariancesIn(inner, found)
    }
  }
  return found
}
