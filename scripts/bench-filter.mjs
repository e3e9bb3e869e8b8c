// Times the class KalmanFilter beside npm's `kalman-filter`, and a filter written with `ml-matrix`, in one run: a step
// of two states (position and speed, the position read), and of four (the same in the plane). Interleaved rounds,
// medians, ratios; first all are held against one another, so that the same is timed. Prints the tables of the module's
// README. Nothing fails on a time.
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..')
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const peers = createRequire(path.join(root, 'crates/peers/package.json'))
const { KalmanFilter: Npm } = peers('kalman-filter')
const { Matrix, inverse } = peers('ml-matrix')
const ROUNDS = 7

const line = {
  F: [
    [1, 0.5],
    [0, 1],
  ],
  H: [[1, 0]],
  V: [
    [0.2, 0.05],
    [0.05, 0.1],
  ],
  W: [[0.5]],
  x: [2, 4],
  P: [
    [1, 0],
    [0, 2],
  ],
}
const plane = {
  F: [
    [1, 0, 0.5, 0],
    [0, 1, 0, 0.5],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ],
  H: [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
  ],
  V: [
    [0.2, 0, 0.05, 0],
    [0, 0.2, 0, 0.05],
    [0.05, 0, 0.1, 0],
    [0, 0.05, 0, 0.1],
  ],
  W: [
    [0.5, 0],
    [0, 0.5],
  ],
  x: [2, 2, 4, 4],
  P: [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 2, 0],
    [0, 0, 0, 2],
  ],
}
const reading = (step) => (step % 7) * 0.3 - 0.9

/** Each filters so many steps, and answers its last mean. */
const filters = {
  /** One call a step, with a Float64Array that is used again. */
  KalmanFilter({ F, H, V, W, x, P }, steps) {
    const filter = new core.KalmanFilter({ F, G: F.map(() => []), H, V, W }, { x, P })
    const [none, y] = [new Float64Array(0), new Float64Array(H.length)]
    for (let step = 0; step < steps; step++) {
      y.fill(reading(step))
      filter.step(none, y)
    }
    const mean = filter.x
    filter.free()
    return mean
  },
  'ml-matrix'({ F, H, V, W, x, P }, steps) {
    const [f, h, v, w] = [F, H, V, W].map((rows) => new Matrix(rows))
    const [ft, ht, eye] = [f.transpose(), h.transpose(), Matrix.eye(x.length)]
    let [mean, covariance] = [Matrix.columnVector(x), new Matrix(P)]
    for (let step = 0; step < steps; step++) {
      mean = f.mmul(mean)
      covariance = f.mmul(covariance).mmul(ft).add(v)
      const y = Matrix.columnVector(H.map(() => reading(step)))
      const gain = covariance.mmul(ht).mmul(inverse(h.mmul(covariance).mmul(ht).add(w)))
      mean = mean.add(gain.mmul(y.sub(h.mmul(mean))))
      covariance = eye.clone().sub(gain.mmul(h)).mmul(covariance)
    }
    return mean.to1DArray()
  },
  'kalman-filter'({ F, H, V, W, x, P }, steps) {
    const filter = new Npm({
      observation: { dimension: H.length, stateProjection: H, covariance: W },
      dynamic: {
        dimension: x.length,
        transition: F,
        covariance: V,
        init: { mean: x.map((entry) => [entry]), covariance: P, index: -1 },
      },
    })
    let corrected = null
    for (let step = 0; step < steps; step++) {
      corrected = filter.filter({ previousCorrected: corrected, observation: H.map(() => reading(step)) })
    }
    return corrected.mean.map(([entry]) => entry)
  },
}

const STEPS = { KalmanFilter: 100_000, 'ml-matrix': 20_000, 'kalman-filter': 10_000 }
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1]

for (const [title, model] of /** @type {[string, any][]} */ ([
  ['2 states, 1 reading', line],
  ['4 states, 2 readings', plane],
])) {
  const means = Object.values(filters).map((run) => run(model, 500))
  for (const mean of means) {
    if (!mean.every((entry, i) => Math.abs(entry - means[0][i]) < 1e-9))
      throw new Error(`the filters disagree: ${JSON.stringify(means)}`)
  }
  const times = Object.fromEntries(Object.keys(filters).map((name) => [name, /** @type {number[]} */ ([])]))
  for (let round = -1; round < ROUNDS; round++) {
    for (const [name, run] of Object.entries(filters)) {
      const start = process.hrtime.bigint()
      run(model, STEPS[name])
      // The first round is for the engine to compile what it runs.
      if (round >= 0) times[name].push(Number(process.hrtime.bigint() - start) / STEPS[name] / 1000)
    }
  }
  const ours = median(times.KalmanFilter)
  console.log(`\n| a step of ${title} | µs | of KalmanFilter's |\n|---|---:|---:|`)
  for (const [name, values] of Object.entries(times)) {
    const called = name === 'KalmanFilter' ? '`KalmanFilter`' : `npm's \`${name}\``
    const taken = median(values)
    console.log(`| ${called} | ${taken.toFixed(2)} | ${(taken / ours).toFixed(1)}× |`)
  }
}
