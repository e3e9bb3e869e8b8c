// What the fuzz test knows of each exported class: how to make an object, what it can be told, and where it shows a
// covariance.
import { FIGURES } from '../../target/figures.js'
import { matrix, reading, row, sizes, system, vector } from './arguments.mjs'
import { logClasses } from './log-exports.mjs'
import { covariance } from './nonsense.mjs'
import { program } from './program-exports.mjs'

const pose = (dice) => ({ x: [dice.normal() * 3, dice.normal() * 3, dice.normal()], P: covariance(3, dice) })
const motion = (dice) => [[dice.normal() * 0.1, dice.normal() * 0.1], covariance(3, dice)]
const gate = (dice) => dice.pick([null, 9.21, 1e-3, 1e6])

/** A time near the latest of a time line. */
const moment = (it, dice) => it.newest + dice.pick([-5, -1, -0.5, 0, 0, 0.25, 1, dice.normal()])

/** A sensor for one call, now and then. */
const oneCall = (H, dice) => dice.pick([[], [], [{ H, W: covariance(H.length, dice) }]])

const times = (M, x) => M.map((row) => row.reduce((sum, a, j) => sum + a * x[j], 0))

/** A motion of n states that bends. */
function motionOf(n, dice) {
  const F = matrix(n, n, dice)
  const bend = dice.pick([0, 0.1])
  return (x) => times(F, x).map((number) => number + bend * Math.sin(number))
}

/** What the filters of one's own models have in common. */
const ownModels = {
  chain: 30,
  spoilt: 0.35,
  often: ['update'],
  least: { accepted: 100, rejected: 20 },
  make(dice) {
    const n = 1 + dice.below(4)
    return [{ x: vector(n, dice), P: covariance(n, dice) }, ...dice.pick([[], [{ angles: [0] }]])]
  },
  look: ({ x, P }) => [x, P],
  covariances: (it) => [it.P],
  answered: (answer) => [answer?.S].filter(Boolean),
  outcomes: (answer) => (answer?.outcome ? [answer.outcome] : []),
}

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
      predict: (dice, _, _it, [{ F, G }]) => [
        row(G[0].length, dice),
        ...dice.pick([[], [], [{ F, G, V: covariance(F.length, dice) }]]),
      ],
      state: () => [],
      clone: () => [],
      update: (dice, _, _it, [{ H }]) => [reading(H.length, dice), ...oneCall(H, dice)],
      step: (dice, _, _it, [{ G, H }]) => [row(G[0].length, dice), reading(H.length, dice)],
    },
    look: ({ x, P, logLikelihood, nis, innovation, S, R }) => [x, P, logLikelihood, nis, innovation, S, R],
    covariances: (it) => [it.P],
    outcomes: (_, it) => (it?.nis === null ? [] : ['a reading judged']),
  },
  ExtendedKalmanFilter: {
    ...ownModels,
    methods: {
      predict: (dice, _, it) => [motionOf(it.x.length, dice), covariance(it.x.length, dice)],
      update(dice, _, it) {
        const p = 1 + dice.below(2)
        const H = matrix(p, it.x.length, dice)
        const options = { gate: gate(dice), ...dice.pick([{}, { H: () => H }, { angles: [0] }]) }
        return [reading(p, dice), (x) => times(H, x), covariance(p, dice), options]
      },
    },
  },
  UnscentedKalmanFilter: {
    ...ownModels,
    methods: {
      predict: (dice, _, it) => [motionOf(it.x.length, dice), covariance(it.x.length, dice)],
      update(dice, _, it) {
        const p = 1 + dice.below(2)
        const H = matrix(p, it.x.length, dice)
        const options = dice.pick([undefined, { gate: gate(dice) }, { angles: [0] }])
        return [reading(p, dice), (x) => times(H, x), covariance(p, dice), options]
      },
    },
  },
  Timeline: {
    chain: 30,
    spoilt: 0.35,
    often: ['reading', 'reading', 'reading'],
    least: { accepted: 120, rejected: 80, 'too-late': 130, duplicate: 14, full: 30, ahead: 4, index: 20 },
    make(dice) {
      const { n, m } = sizes(dice)
      const A = matrix(n, n, dice).map((row) => row.map((a) => a / 50))
      const sensor = () => {
        const p = 1 + dice.below(2)
        return { H: matrix(p, n, dice), W: covariance(p, dice), delay: dice.pick([0, 0.5, -1]), gate: gate(dice) }
      }
      /** As many sines of the state. */
      const own = ({ H, ...rest }) => ({
        ...rest,
        h: (x) => H.map((weights) => Math.sin(weights.reduce((sum, weight, i) => sum + weight * x[i], 0))),
        angles: dice.pick([[], [0]]),
      })
      const options = { time: dice.pick([0, 1e9]), window: dice.pick([0.5, 3]), capacity: dice.pick([3, 100]) }
      return [
        { A, B: matrix(n, m, dice), Q: covariance(n, dice) },
        { x: vector(n, dice), P: covariance(n, dice) },
        { ...options, sensors: { first: sensor(), second: dice.pick([(it) => it, own])(sensor()) } },
      ]
    },
    methods: {
      input: (dice, _, it, [{ B }]) => [moment(it, dice), row(B[0].length, dice)],
      reading(dice, _, it, [, , { sensors }]) {
        const name = dice.pick(['first', 'second'])
        return [name, moment(it, dice), reading(sensors[name].W.length, dice), ...dice.pick([[], [1]])]
      },
      at: (dice, _, it) => [moment(it, dice)],
      statistics: () => [],
    },
    look: (it) => [it.newest, it.length, it.at(it.newest)],
    covariances: (it) => [it.at(it.newest).P],
    answered: (answer) => [answer?.S, answer?.P].filter(Boolean),
    outcomes: (answer) => (answer?.outcome ? [answer.outcome] : []),
  },
  Program: program,
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

CLASSES.WriteFilter.methods.textIn = (dice) => [dice.pick(['choset', 'thrun', 'common'])]
CLASSES.WriteFilter.methods.worlds = () => []
CLASSES.FilterWorlds = {
  make: (dice) => [
    { begin: dice.pick(['kalman', 'empty', 'observer', 'twice']), notation: dice.pick(['choset', 'thrun']) },
  ],
  methods: { step: () => [], found: () => [] },
  look: (it) => it.found(),
  covariances: () => [],
}
CLASSES.LateReadings.methods.seeds = (dice) => [dice.below(100), 1 + dice.below(3)]
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
