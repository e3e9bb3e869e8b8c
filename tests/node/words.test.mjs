// What a figure says of its state is true of it: every sentence of a verdict is one of the claims below, and each claim
// is held against the frame that the sentence speaks of, over a grid of parameters and steps, just-reset states among
// them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { BUGS } from '../../web/widgets/bug-museum/words.js'
import { WIDGETS } from '../../web/widgets/index.js'
import { LOG, check, estimate, number, prints, sentences } from './claims.mjs'

/** The modulus of the largest eigenvalue that a gain moves. */
const moving = ({ pinned, modulus, spectralRadius }) => (pinned === null ? spectralRadius : modulus[1 - pinned])
const many = (word) => ['no', 'one', 'two', 'three'].indexOf(word.toLowerCase())

check(
  'observer-bench',
  {
    sensor: ['velocity', 'position'],
    mode: ['fixed', 'filter'],
    seed: [1, 7],
    gain: [0, 0.01, 0.5, 1, 2.99, 3.02, 3.028947959635742, 3.03, 3.05, 5.57, 5.58257569495584, 5.59, 6],
  },
  [0, 1, 2, 12, 30, 400],
  () => [
    [/^The estimate has left every bound, and the run has stopped\.$/, ({ diverged }) => diverged],
    [/^Turn the gain below ([\d.]+)\.$/, ({ stableUpTo, diverged }, limit) => diverged && prints(limit, stableUpTo)],
    [
      /^Dead reckoning: no reading is used, and nothing takes an error back\.$/,
      ({ params, R }) => params.mode === 'fixed' && R.every((entry) => entry === 0),
    ],
    [
      /^At the limit of stability: the factor a step is 1\.000, and an error neither dies out nor grows\.$/,
      (frame) => Math.abs(moving(frame) - 1) < 6e-4 && frame.params.mode === 'fixed',
    ],
    [
      /^Unstable: in the long run the error grows by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        !frame.stable && number(factor) > 1 && prints(factor, moving(frame)) && frame.params.mode === 'fixed',
    ],
    [
      /^Stable: in the long run every error shrinks by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        frame.stable &&
        frame.pinned === null &&
        number(factor) < 1 &&
        prints(factor, frame.spectralRadius) &&
        frame.params.mode === 'fixed',
    ],
    [
      /^A velocity error shrinks by the factor ([\d.]+) a step\.$/,
      (frame, factor) =>
        frame.stable &&
        frame.pinned !== null &&
        number(factor) < 1 &&
        prints(factor, moving(frame)) &&
        frame.params.mode === 'fixed',
    ],
    [
      /^The other eigenvalue is 1 for every gain: no gain takes a position error back\.$/,
      ({ pinned, modulus }) => pinned !== null && Math.abs(modulus[pinned] - 1) < 1e-9,
    ],
    [
      /^If the filter kept this step’s gain, (every|a velocity) error would shrink by the factor ([\d.]+) a step in the long run\.$/,
      (frame, which, factor) =>
        frame.params.mode === 'filter' &&
        (which === 'every') === (frame.pinned === null) &&
        number(factor) < 1 &&
        prints(factor, moving(frame)),
    ],
  ],
)

check(
  'bug-museum',
  {
    bug: ['none', 'late', 'asymmetric'],
    second: ['none', 'twice'],
    lot: [0, 3],
    pair: [false, true],
    guess: ['late'],
    committed: [false, true],
    many: [false, true],
  },
  [0, 1, 240, 250],
  () => {
    const why = (bug) => sentences(BUGS[bug].why)
    const bugs = ({ params, answer }) =>
      params.lot === 0 ? [params.bug, params.second] : answer ? [answer.bug, answer.second] : []
    const named = (frame, list) =>
      list ===
      bugs(frame)
        .filter((bug) => bug !== 'none')
        .map((bug) => `“${BUGS[bug].name}”`)
        .join(' and ')
    const beyond = ({ figures }) =>
      figures.filter(({ value, band: [low, high] }) => value === null || value < low || value > high).length
    return [
      [/^The filter has no bug\.$/, (frame) => frame.params.lot === 0 && bugs(frame).every((bug) => bug === 'none')],
      [/^The filter has (“.*”)\.$/, (frame, list) => frame.params.lot === 0 && named(frame, list)],
      [
        /^(A bug is|Two bugs are) hidden in the filter\.$/,
        ({ params, answer }, count) =>
          params.lot !== 0 && !params.committed && answer === null && (count === 'A bug is') === !params.pair,
      ],
      [
        /^(Right|No): it was (“.*”)\.$/,
        (frame, judged, list) => frame.answer.right === (judged === 'Right') && named(frame, list),
      ],
      [
        /^The run is at step (\d+) of 240; its figures are judged at the end\.$/,
        ({ driven }, step) => Number(step) === driven && driven < 240,
      ],
      [
        /^All 14 figures of this run lie within a right filter’s 95 % bands\.$/,
        (frame) => frame.driven >= 240 && beyond(frame) === 0,
      ],
      [
        /^(\d+) of 14 figures of this run lie outside a right filter’s 95 % bands\.$/,
        (frame, out) => frame.driven >= 240 && beyond(frame) === Number(out),
      ],
      [
        /^Of (\d+) seeds?, (\d+) % have a mean NEES outside its band\.$/,
        ({ seeds, figures }, count, share) =>
          Number(count) === seeds && prints(share, 100 * (figures[3].beyond[0] + figures[3].beyond[1])),
      ],
      [
        new RegExp(
          `^(?:${Object.keys(BUGS)
            .flatMap(why)
            .filter(Boolean)
            .map((text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'))
            .join('|')})$`,
        ),
        (frame) => frame.answer !== null,
      ],
    ]
  },
)

test('what the frame, the words and the link of a hidden bug hold is the same for every bug', async () => {
  const spec = await WIDGETS['bug-museum']()
  const open = (params) => estimate.BugMuseum.from({ version: 1, lab: 'bug-museum', step: 240, params })
  const bugs = new Set()
  for (let lot = 1; lot < 60; lot += 1) {
    const [lab, answered] = [open({ lot }), open({ lot, committed: true })]
    const frame = lab.frame()
    bugs.add(answered.frame().answer.bug)
    assert.equal(frame.answer, null)
    assert.deepEqual({ ...lab.state().params, lot: 0 }, { ...open({}).state().params })
    const said = [
      spec.verdict(frame),
      ...Object.values(spec.describe(frame)),
      ...spec.readouts(frame).map(({ value }) => value),
    ].join(' ')
    for (const { name } of Object.values(BUGS)) assert.ok(name === 'none' || !said.includes(name), `${lot}: ${said}`)
    lab.free()
    answered.free()
  }
  assert.ok(bugs.size > 9, `${bugs.size} bugs were drawn`)
})

check(
  'odometry-hook',
  {
    bias: [0, 0.0005, 0.005, 0.01],
    slip: [0, 0.001, 0.005],
    fixes: [false, true],
    learn: [false, true],
    seed: [1, 3],
  },
  [0, 1, 5, 40, 160, 186, 640, 1300],
  () => {
    const off = (frame, words, kind) => {
      const value = kind === 'heading' ? Math.abs(frame.error.heading * 180) / Math.PI : frame.error.position
      const ratio = frame.ratio[kind]
      const [, printed, rest] = words.match(/^off by ([\d.]+)(?: m|°), (.*)$/) ?? []
      if (!printed || !prints(printed, value)) return false
      if (rest === 'and the filter claims no error at all') return ratio === null
      if (rest === 'about the σ it claims') return ratio > 0.94 && ratio < 1.06
      if (rest === 'within the σ it claims') return ratio < 1
      const [, times] = rest.match(/^([\d.]+) times the σ it claims$/) ?? []
      return times !== undefined && ratio > 1 && prints(times, ratio)
    }
    return [
      [
        /^At the start the pose is known exactly\.$/,
        ({ step, error, sigma }) => step === 0 && error.position === 0 && sigma.position === 0,
      ],
      [
        /^Dead reckoning: the position is (off [^:]*)(: the error has outrun the ellipse)?\.$/,
        (frame, words, outrun) =>
          !frame.params.fixes &&
          off(frame, words, 'position') &&
          (outrun === undefined ||
            (frame.error.position > 0.005 && (frame.ratio.position === null || frame.ratio.position > 2))),
      ],
      [
        /^No corner seen yet: the position is (off .*)\.$/,
        (frame, words) => frame.params.fixes && frame.lastSighting === null && off(frame, words, 'position'),
      ],
      [
        /^With fixes, the position is (off .*)\.$/,
        (frame, words) => frame.params.fixes && frame.lastSighting !== null && off(frame, words, 'position'),
      ],
      [/^The heading is (off .*)\.$/, (frame, words) => off(frame, words, 'heading')],
      [
        /^No reading is used, so the bias stays at ([−\d.]+) %, with a σ of ([\d.]+) %\.$/,
        ({ params, wheel }, bias, sigma) =>
          params.learn && !params.fixes && wheel.rank === 0 && number(bias) === 0 && prints(sigma, 100 * wheel.sigma),
      ],
      [
        /^No reading yet: the bias is taken as ([−\d.]+) %, with a σ of ([\d.]+) %\.$/,
        ({ params, step, wheel }, bias, sigma) =>
          params.learn &&
          params.fixes &&
          step === 0 &&
          wheel.rank === 0 &&
          number(bias) === 0 &&
          prints(sigma, 100 * wheel.sigma),
      ],
      [
        /^The readings so far have rank (\d) of 4: they do not tell the bias from the pose\.$/,
        ({ params, step, wheel }, rank) =>
          params.learn && params.fixes && step < 186 && Number(rank) === wheel.rank && wheel.rank < 4,
      ],
      [
        /^The bias is learned as ([−\d.]+) %, with a σ of ([\d.]+) %; in truth it is ([\d.]+) %\.$/,
        ({ params, wheel }, bias, sigma, truth) =>
          params.learn &&
          params.fixes &&
          wheel.rank === 4 &&
          // What is learned and what is true are said in the words of the slider, as parts of the true radius.
          prints(truth, 100 * params.bias) &&
          prints(truth, 100 * (1 / (1 - wheel.truth) - 1)) &&
          prints(bias, 100 * (1 / (1 - wheel.epsilon) - 1)) &&
          prints(sigma, (100 * wheel.sigma) / (1 - wheel.epsilon) ** 2),
      ],
    ]
  },
)

check(
  'picture',
  {
    mean: [
      [4, 4],
      [4, 2.7],
      [-3, 6],
    ],
    semiMajor: [0.15, 1.005, 1.7230432137127605, 3],
    semiMinor: [0.15, 1, 3],
    radius: [0, 0.9, 6],
    guess: [null, -0.65],
    sealed: [false, true],
    angle: [0, 0.8795089160498338, Math.PI / 2],
    reading: [-8, 2.7, 4],
    noise: [0, 0.5, 4],
    tilt: [-Math.PI / 2, -0.7, 0, 0.3],
  },
  [0],
  () => {
    const apart = ({ euclideanFoot: a, mahalanobisFoot: b }) => Math.hypot(a.at[0] - b.at[0], a.at[1] - b.at[1])
    return [
      [
        /^The gray foot is ([\d.]+) standard deviations away, the purple one ([\d.]+)\.$/,
        (frame, gray, purple) =>
          prints(gray, frame.euclideanFoot.distance) && prints(purple, frame.mahalanobisFoot.distance),
      ],
      [
        /^The ellipse is a circle: both metrics agree, and the two feet are one point\.$/,
        (frame) =>
          Math.abs(frame.P[0][0] - frame.P[1][1]) < 1e-9 && Math.abs(frame.P[0][1]) < 1e-9 && apart(frame) < 1e-9,
      ],
      [/^The two feet are one point here, to two decimals\.$/, (frame) => apart(frame) < 0.0051],
      [
        /^The reading is the one expected: there is nothing to correct\.$/,
        (frame) =>
          Math.abs(frame.innovation) < 5e-4 &&
          Math.hypot(...frame.posterior.x.map((value, i) => value - frame.params.mean[i])) < 5e-3,
      ],
      [
        /^The answer is hidden: (drop|drag) (?:a guess|your guess along the green line), then choose “Show the answer”\.$/,
        ({ params }, what) => params.sealed && (what === 'drag') === (params.guess !== null),
      ],
      [
        /^Your guess is the purple foot, the most probable point of the line\.$/,
        ({ guess, mahalanobisFoot: { at } }) => Math.hypot(guess.at[0] - at[0], guess.at[1] - at[1]) < 0.03,
      ],
      [
        /^The purple foot is (more than 999|[\d.]+) times as probable as your guess\.$/,
        ({ guess, params }, times) =>
          !params.sealed && (times === 'more than 999' ? guess.density < 1 / 999 : prints(times, 1 / guess.density)),
      ],
      [
        /^Grown to ([\d.]+) σ, the ellipse holds (more than 99|\d+) % of the probability; it (?:(touches|does not reach|crosses) Ω\* and )?(touches|does not reach|crosses) Ω\.$/,
        (frame, radius, inside, star, omega) => {
          const stands = (word, distance) =>
            word ===
            (Math.abs(frame.params.radius - distance) <= 0.026
              ? 'touches'
              : frame.params.radius < distance
                ? 'does not reach'
                : 'crosses')
          return (
            prints(radius, frame.params.radius) &&
            (inside === 'more than 99'
              ? frame.inside >= 0.995
              : number(inside) < 100 && prints(inside, 100 * frame.inside)) &&
            stands(omega, frame.mahalanobisFoot.distance) &&
            (star === undefined ? frame.params.noise === 0 || frame.params.sealed : stands(star, frame.update.distance))
          )
        },
      ],
      [
        /^Reading and expected output weigh the same: y\* lies half way\.$/,
        ({ params, expectedOutput, expectedVariance, mostLikelyOutput }) =>
          Math.abs(expectedVariance / params.noise - 1) < 0.0051 &&
          Math.abs(mostLikelyOutput - (params.reading + expectedOutput) / 2) <=
            0.0013 * Math.abs(params.reading - expectedOutput) + 1e-9,
      ],
      [
        /^The reading weighs ([\d.]+) times as much as the expected output\.$/,
        ({ params, expectedVariance }, times) => prints(times, expectedVariance / params.noise),
      ],
      [
        /^The expected output weighs ([\d.]+) times as much as the reading\.$/,
        ({ params, expectedVariance }, times) => prints(times, params.noise / expectedVariance),
      ],
      [
        /^The sensor is perfect: Ω and Ω\* are one line\.$/,
        (frame) => frame.params.noise === 0 && Math.abs(frame.mostLikelyOutput - frame.params.reading) < 1e-9,
      ],
    ]
  },
)

const four = (rows) => Array.from({ length: 4 }, (_, i) => Array.from({ length: 4 }, (_, j) => rows[i]?.[j] ?? 0))
check(
  'own-system',
  {
    f: [
      four([
        [1, 0.5],
        [0, 1],
      ]),
      four([
        [0.5, 0],
        [0, 1],
      ]),
      four([
        [1, 0],
        [0, 1 + 1e-11],
      ]),
      four([
        [1.2, 0],
        [0, 0.3],
      ]),
      four([
        [1, 1e12],
        [0, 1],
      ]),
    ],
    h: [four([[1, 0]]), four([[0, 1]]), four([[1, 1]])],
    v: [
      four([]),
      four([
        [0.01, 0.02],
        [0.02, 0.04],
      ]),
      four([
        [0, 0],
        [0, 1],
      ]),
      four([
        [1, 0],
        [0, 1],
      ]),
    ],
    gain: ['filter', 'hand', 'placement'],
    logTolerance: [-14, -9, -1],
  },
  [0, 60],
  () => {
    const sizes = (directions) => directions.length
    const apart = (list) => list.split(/, | and /).length
    return [
      [
        /^Observable: the readings tell every direction of the state\.$/,
        ({ observable, rank }) => observable === 'yes' && rank.rank === 2 && rank.directions.length === 0,
      ],
      [
        /^Not observable: the rank is full only because rounding errors exceed so small a tolerance\.$/,
        ({ observable, rank }) => observable === 'no' && rank.rank === 2,
      ],
      [
        /^The rank is full, but whether the system is observable is undecided within the tolerance of (\S.*)\.$/,
        ({ observable, rank }) => observable === 'undecided' && rank.rank === 2,
      ],
      [
        /^Observable in units that fit each state; in the units given, the singular values lie too far apart for the rank to say so\.$/,
        ({ observable, rank }) => observable === 'yes' && rank.rank < 2,
      ],
      [
        /^Not observable: (.*) (is|are) never seen\.$/,
        ({ observable, rank }, list, verb) =>
          observable === 'no' &&
          sizes(rank.directions) === 2 - rank.rank &&
          apart(list) === sizes(rank.directions) &&
          (verb === 'are') === apart(list) > 1,
      ],
      [
        /^(.*) (count|counts) as unseen: less is read of it than the tolerance of (\S.*), so whether the system is observable is undecided\.$/,
        ({ observable, rank }, list) => observable === 'undecided' && apart(list) === sizes(rank.directions),
      ],
      [
        /^Detectable: what is not seen dies out by itself\.$/,
        ({ observable, detectable }) => detectable === 'yes' && observable !== 'yes',
      ],
      [
        /^Not detectable: what is not seen does not die out\.$/,
        ({ detectable, unseenModes, tolerance }) =>
          detectable === 'no' &&
          (unseenModes.length === 0 || Math.hypot(unseenModes[0].re, unseenModes[0].im) >= 1 - tolerance),
      ],
      [
        /^Whether it is detectable is undecided within the tolerance\.$/,
        ({ detectable }) => detectable === 'undecided',
      ],
      [/^Noise reaches every state\.$/, ({ noise }) => noise.reachable === 'yes'],
      [
        /^Whether noise reaches every state is undecided within the tolerance\.$/,
        ({ noise }) => noise.reachable === 'undecided',
      ],
      [/^There is no noise in the motion\.$/, ({ params }) => params.v.flat().every((entry) => entry === 0)],
      [
        /^Noise never moves (.*)\.$/,
        ({ noise }, list) => noise.reachable === 'no' && apart(list) === sizes(noise.unreached),
      ],
      [
        /^The covariance tends to one limit from every start, because the system is detectable and noise reaches all that does not die out\.$/,
        ({ detectable, noise, limit }) =>
          limit === 'from-every-start' && detectable === 'yes' && noise.stabilizable === 'yes',
      ],
      [
        /^The covariance tends to a limit from every large enough start, because the system is detectable; noise does not reach all that does not die out, or whether it does is undecided; so a smaller start may lead elsewhere, and the filter may in the end stop correcting what noise does not reach\.$/,
        ({ detectable, noise, limit }) =>
          limit === 'from-large-start' && detectable === 'yes' && noise.stabilizable !== 'yes',
      ],
      [
        /^The covariance has no limit: something unseen does not die out, and noise feeds it, so its variance grows without end\.$/,
        ({ limit, detectable }) => limit === 'none' && detectable === 'no',
      ],
      [
        /^Whether the covariance has a limit depends on the start: something unseen does not die out, and noise does not reach all of that\.$/,
        ({ limit, detectable, noise }) =>
          limit === 'depends-on-start' && detectable === 'no' && noise.stabilizable === 'no',
      ],
      [
        /^Whether the covariance has a limit is undecided within the tolerance\.$/,
        ({ limit }) => limit === 'undecided',
      ],
      [
        /^From this start it settles in (\d+) steps\.$/,
        ({ settled, limit }, steps) => settled === Number(steps) && limit !== 'none',
      ],
      [
        /^From this start it grows too slowly to show: after (\d+) steps no digit changes\.$/,
        ({ settled, limit }, steps) => settled === Number(steps) && limit === 'none',
      ],
      [
        /^From this start it has not settled after (\d+) steps\.$/,
        ({ settled, tried }, steps) => settled === null && tried === Number(steps),
      ],
      [/^From this start it outgrows every number\.$/, ({ settled, tried }) => settled === null && tried === null],
      [/^The simulated run has left every bound and stands still\.$/, ({ diverged }) => diverged],
      [
        /^No gain was found that puts the eigenvalues there, so the gain is 0\.$/,
        ({ placed, K }) => placed === false && K.flat().every((entry) => entry === 0),
      ],
      [
        /^With (the filter’s gain|this gain|the gain that places them) the eigenvalues of the error’s matrix reach the modulus (\S+?)(?: × \S+)?(, so an error need not die out)?\.$/,
        ({ params, spectralRadius }, who, radius, lives) =>
          (({ 'the filter’s gain': 'filter', 'this gain': 'hand' })[who] ?? 'placement') === params.gain &&
          (spectralRadius >= 1e4 || prints(radius, spectralRadius)) &&
          Boolean(lives) === spectralRadius >= 1,
      ],
      [
        /^(One|2) of them (?:stays where it is|stay where they are) whatever the gain\.$/,
        ({ eigenvalues, movable }, count) =>
          eigenvalues.filter(({ fixed }) => fixed).length === (count === 'One' ? 1 : 2) &&
          movable === 2 - (count === 'One' ? 1 : 2),
      ],
    ]
  },
)

const landmarks = [
  [
    [6, 6],
    [0, 6],
    [3, 0],
  ],
  [
    [1.5, 1.5],
    [4.5, 4.5],
    [3, 3],
  ],
  [
    [1.5, 4.5],
    [0, 0],
    [6, 0],
  ],
]
check(
  'observability-probe',
  {
    landmarks,
    count: [1, 2, 3],
    sensor: ['range', 'range-bearing'],
    stop: [null, 1, 20],
    forget: [false, true],
    tolerance: [0, 1e-6, 0.3, 1],
  },
  [0, 1, 2, 15, 60, 240],
  () => [
    [
      /^(\w+) landmarks?, (range only|range and bearing): rank (\d) frozen at this pose(?:, (\d) along the last (?:(\d+) steps|step))?\.$/,
      (frame, count, sensor, frozen, path, steps) =>
        !frame.slam &&
        many(count) === frame.params.count &&
        (sensor === 'range only') === (frame.sensor === 'range') &&
        Number(frozen) === frame.frozen.rank &&
        (path === undefined
          ? frame.alongPath.steps === 0
          : Number(path) === frame.alongPath.rank && Number(steps ?? 1) === frame.alongPath.steps),
    ],
    [
      /^No path is driven yet, so there is no rank along it\.$/,
      ({ alongPath, step }) => alongPath.steps === 0 && step === 0,
    ],
    [/^Every direction of the pose is seen\.$/, ({ frozen, alongPath }) => frozen.rank === 3 && alongPath.rank === 3],
    [
      /^This pose alone hides (\w+) directions?, and the path has shown (?:it|them)\.$/,
      ({ frozen, alongPath }, hidden) => alongPath.rank === 3 && many(hidden) === 3 - frozen.rank,
    ],
    [
      /^The frozen test is too kind: turn the pose about the landmark, and no reading changes\.$/,
      ({ params, frozen, alongPath }) =>
        params.count === 1 && frozen.rank === 3 && alongPath.rank < 3 && alongPath.steps > 0,
    ],
    [
      /^The frozen test counts (\w+) directions? more than the path has shown\.$/,
      ({ frozen, alongPath }, more) => frozen.rank === 3 && many(more) === 3 - alongPath.rank && alongPath.steps > 0,
    ],
    [
      /^(\w+) directions? of the pose (?:is|are) hidden: no reading along the path changes with (?:it|them)\.$/,
      ({ frozen, alongPath }, hidden) =>
        frozen.rank < 3 &&
        many(hidden) === 3 - alongPath.rank &&
        alongPath.relative.slice(alongPath.rank).every((value) => value < 1e-9),
    ],
    [
      /^(\w+) directions? of the pose (?:falls|fall) below the tolerance\.$/,
      ({ frozen, alongPath }, hidden) =>
        frozen.rank < 3 &&
        many(hidden) === 3 - alongPath.rank &&
        alongPath.relative.slice(alongPath.rank).some((value) => value >= 1e-9),
    ],
    [
      /^The map is forgotten, and ranges with bearings found it anew: (\d+) founded, (\d+) matched, (\d+) rejected\.$/,
      ({ slam }, founded, matched, rejected) =>
        slam &&
        slam.founded === Number(founded) &&
        slam.matched === Number(matched) &&
        slam.rejected === Number(rejected),
    ],
    [
      /^The worst stands ([\d.]+) m off, ([\d.]+) of its own σ\.$/,
      ({ slam }, error, sigma) => prints(error, slam.worst.error) && prints(sigma, slam.worst.sigma),
    ],
    [/^The map is full: it founds no more\.$/, ({ slam }) => slam.full],
  ],
)

check(
  'observability-probe',
  {
    ghost: [true],
    count: [1, 2],
    sensor: ['range', 'range-bearing'],
    forget: [false, true],
    ghostAround: [0, 0.2, -0.1],
    ghostShift: [0, 0.5],
    ghostTurn: [0, 0.2, -0.1],
  },
  [0, 1, 60, 240],
  () => [
    [
      /^The ghost drives where the robot drives: turn one of its dials\.$/,
      ({ ghost, params }) =>
        [params.ghostAround, params.ghostShift, params.ghostTurn].every((dial) => dial === 0) &&
        ghost.rangeGap === 0 &&
        ghost.moved === 0,
    ],
    [/^The ghost has been up to ([\d.]+) m from the robot\.$/, ({ ghost }, moved) => prints(moved, ghost.moved)],
    [
      /^Its ranges differ by up to ([\d.]+) m(?: and its bearings by ([\d.]+)°)?\.$/,
      ({ ghost, sensor }, ranges, bearings) =>
        prints(ranges, ghost.rangeGap) &&
        (ghost.rangeGap > 1e-9 || ghost.bearingGap > 1e-9) &&
        (sensor === 'range') === (bearings === undefined) &&
        (bearings === undefined || prints(bearings, (ghost.bearingGap * 180) / Math.PI)),
    ],
    [
      /^The ghost begins ([\d.]+) m from the robot: let both drive\.$/,
      ({ ghost, step }, moved) => step === 0 && prints(moved, ghost.moved),
    ],
    [
      /^It reads what the robot reads: no filter can tell the two apart\.$/,
      ({ ghost, params, step }) =>
        step > 0 &&
        params.count === 1 &&
        ghost.rangeGap < 1e-9 &&
        params.ghostAround === params.ghostTurn &&
        params.ghostShift === 0 &&
        ghost.byHand.every(Number.isFinite),
    ],
    [
      /^The map is forgotten, and ranges with bearings found it anew: \d+ founded, \d+ matched, \d+ rejected\.$/,
      ({ slam, ghost }) => slam && !ghost,
    ],
    [/^The worst stands [\d.]+ m off, [\d.]+ of its own σ\.$/, ({ slam }) => slam.worst],
  ],
)

/** A noise level as it is printed: two digits. */
const level = (text, log) => Math.abs(number(text) / 10 ** log - 1) < 0.051
const times = (text, logs) =>
  Math.abs(number(text) / 10 ** Math.abs(logs) - 1) < 0.006 ||
  (Math.abs(logs) >= 1 && Math.abs(number(text) - 10 ** Math.abs(logs)) <= 0.51)
/**
 * The logarithm of q/W over that of the likeliest noise: a log of 200 readings tells its sign where the autocorrelation
 * leaves its band, a shorter one not always.
 */
const ratio = ({ params: { logQ, logW, ...others } }) => {
  const lab = estimate.Tune.from({
    version: 1,
    lab: 'tune',
    step: 0,
    params: { ...others, logQ, logW, fit: true, committed: false },
  })
  const { fit } = lab.frame()
  lab.free()
  return logQ - logW - (fit.logQ - fit.logW)
}
const lastOf = ({ meanNis, meanNisBand }) => ({ mean: meanNis.at(-1), ...meanNisBand.at(-1) })
check(
  'tune',
  {
    logQ: [-2, -0.6, -0.1, 0.74, 2],
    logW: [-2, -0.86, 0.04, 0.42, 2],
    seed: [1, 2, 5],
    length: [20, 50, 200],
    fit: [false, true],
    committed: [false, true],
  },
  [0],
  () => {
    const nis = (frame, mean, low, high) =>
      [
        [mean, lastOf(frame).mean],
        [low, lastOf(frame).low],
        [high, lastOf(frame).high],
      ].every(([text, value]) => prints(text, value))
    const lag = ({ autocorrelation: [first], autocorrelationBand }, printed, band) =>
      prints(printed, first) && prints(band, autocorrelationBand)
    return [
      [
        /^The mean NIS is ([\d.]+), above its band from ([\d.]+) to ([\d.]+): the innovations are larger than the filter expects, so its noise as a whole is too small\.$/,
        (frame, ...said) => !frame.verdict && nis(frame, ...said) && lastOf(frame).mean > lastOf(frame).high,
      ],
      [
        /^The mean NIS is ([\d.]+), below its band from ([\d.]+) to ([\d.]+): the innovations are smaller than the filter expects, so its noise as a whole is too large\.$/,
        (frame, ...said) => !frame.verdict && nis(frame, ...said) && lastOf(frame).mean < lastOf(frame).low,
      ],
      [
        /^The mean NIS is ([\d.]+), above its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) => frame.verdict && nis(frame, ...said) && lastOf(frame).mean > lastOf(frame).high,
      ],
      [
        /^The mean NIS is ([\d.]+), below its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) => frame.verdict && nis(frame, ...said) && lastOf(frame).mean < lastOf(frame).low,
      ],
      [
        /^The mean NIS is ([\d.]+), within its band from ([\d.]+) to ([\d.]+)\.$/,
        (frame, ...said) =>
          nis(frame, ...said) && lastOf(frame).mean >= lastOf(frame).low && lastOf(frame).mean <= lastOf(frame).high,
      ],
      [
        /^Neighbouring innovations tend to the same side \(([\d.]+), beyond ±([\d.]+)\): the filter trusts its motion too much, a sign of too small a q\/W\.$/,
        (frame, first, band) =>
          lag(frame, first, band) &&
          (frame.params.length < 200 || ratio(frame) < 0) &&
          frame.autocorrelation[0] > frame.autocorrelationBand,
      ],
      [
        /^Neighbouring innovations tend to opposite sides \(([\u2212\d.]+), beyond ±([\d.]+)\): the filter trusts its sensor too much, a sign of too large a q\/W\.$/,
        (frame, first, band) =>
          lag(frame, first, band) &&
          (frame.params.length < 200 || ratio(frame) > 0) &&
          frame.autocorrelation[0] < -frame.autocorrelationBand,
      ],
      [
        /^Neighbouring innovations are uncorrelated, within ±([\d.]+)\.$/,
        ({ autocorrelation: [first], autocorrelationBand }, band) =>
          prints(band, autocorrelationBand) && Math.abs(first) <= autocorrelationBand,
      ],
      [
        /^The log-likelihood is ([\d.]+)( × 10⁴)? below its maximum, (inside|outside) the 95 % region, which ends at ([\d.]+)\.$/,
        ({ fit, logLikelihood }, lacking, large, where, limit) =>
          prints(lacking, (fit.logLikelihood - logLikelihood) / (large ? 1e4 : 1)) &&
          prints(limit, fit.limit / 2) &&
          (where === 'inside') === fit.lacking <= fit.limit,
      ],
      [/^The likeliest noise lies at the end of a range, and may lie beyond\.$/, ({ fit }) => fit.held.includes(true)],
      [/^The truth is still sealed\.$/, ({ params, verdict }) => verdict === null && !params.committed],
      [
        /^The true q is ([\d.]+) and the true sensor noise ([\d.]+) m²: yours are off by the factors ([\d.]+) and ([\d.]+)\.$/,
        ({ params, verdict }, q, w, offQ, offW) =>
          params.committed &&
          level(q, verdict.logQ) &&
          level(w, verdict.logW) &&
          times(offQ, params.logQ - verdict.logQ) &&
          times(offW, params.logW - verdict.logW),
      ],
      [
        /^By its likelihood this log tells them to factors of ([\d.]+) and ([\d.]+) \(one σ\)\.$/,
        ({ fit }, q, w) => fit.sigma && times(q, fit.sigma[0]) && times(w, fit.sigma[1]),
      ],
      [
        /^How well this log tells them cannot be said at the end of a range\.$/,
        ({ fit }) => fit.sigma === null && fit.held.includes(true),
      ],
      [
        /^The mean NEES of your filter is ([\d.]+); 2 is expected\.$/,
        ({ verdict }, mean) => prints(mean, verdict.meanNees),
      ],
    ]
  },
)

/** Sightings and landmarks in words: `no`, or their number. */
const counted = (word) => (word.toLowerCase() === 'no' ? 0 : Number(word))
check(
  'loop-closure',
  {
    gate: [0.5, 9.21, 100],
    found: [0.5, 6, 50],
    correlated: [true, false],
    seed: [1, 2, 5],
  },
  [0, 1, 60, 112, 113, 128, 300],
  () => [
    [
      /^At the start the pose is known exactly, and (\w+) landmarks? in reach (?:is|are) founded\.$/,
      ({ step, map, P }, founded) =>
        step === 0 && counted(founded) === map.founded && P.flat().every((entry) => entry === 0),
    ],
    [
      /^The map has (\w+) landmarks?; ([1-9]\d*) of (\w+) sightings? (?:was|were) not used\.$/,
      ({ step, map, closure }, landmarks, rejected, all) =>
        step > 0 &&
        closure === null &&
        counted(landmarks) === map.landmarks.length &&
        counted(all) === map.sightings &&
        Number(rejected) === map.rejected &&
        map.matched + map.founded + map.rejected === map.sightings,
    ],
    [
      /^The map has (\w+) landmarks?; (?:all (\d+) sightings were|(1|no) sightings? was) used\.$/,
      ({ step, map, closure }, landmarks, many, few) =>
        step > 0 &&
        closure === null &&
        counted(landmarks) === map.landmarks.length &&
        counted(many ?? few) === map.sightings &&
        map.rejected === 0 &&
        map.matched + map.founded === map.sightings,
    ],
    [
      /^(\d+) landmarks? (?:is a ghost|are ghosts), founded though the map had (?:it|them) already(?:; (\d+) sightings? (?:was|were) matched to the wrong landmark)?(; the map is full and founds no more)?\.$/,
      ({ map }, spurious, wrong, full) =>
        Number(spurious) === map.spurious &&
        Number(wrong ?? 0) === map.wrong &&
        Boolean(full) === map.full &&
        new Set(map.landmarks.map(({ truth }) => truth)).size === map.landmarks.length - map.spurious,
    ],
    [
      /^(\d+) sightings? (?:was|were) matched to the wrong landmark(; the map is full and founds no more)?\.$/,
      ({ map }, wrong, full) => map.spurious === 0 && Number(wrong) === map.wrong && Boolean(full) === map.full,
    ],
    [/^The map is full and founds no more\.$/, ({ map }) => map.full && map.spurious === 0 && map.wrong === 0],
    [
      /^No landmark that was long out of sight has been recognized\.$/,
      ({ closure, lap }) => closure === null && lap > 0,
    ],
    [
      /^At step (\d+) landmark (\d+) was recognized again, and the landmarks’ mean σ (shrank|grew) from ([\d.]+) to ([\d.]+) m\.$/,
      ({ closure }, step, landmark, how, before, after) =>
        closure.step === Number(step) &&
        closure.landmark + 1 === Number(landmark) &&
        before !== after &&
        prints(before, closure.before) &&
        prints(after, closure.after) &&
        (how === 'shrank') === closure.after < closure.before,
    ],
    [
      /^At step (\d+) landmark (\d+) was recognized again, and the landmarks’ mean σ hardly changed, ([\d.]+) m\.$/,
      ({ closure }, step, landmark, after) =>
        closure.step === Number(step) &&
        closure.landmark + 1 === Number(landmark) &&
        prints(after, closure.after) &&
        prints(after, closure.before),
    ],
    [
      /^The mean NEES of the pose is ([\d.]+), where 3 is expected\.$/,
      ({ meanNees, neesBand }, mean) => prints(mean, meanNees) && meanNees <= neesBand[1],
    ],
    [
      /^The mean NEES of the pose is ([\d.]+)( × 10[⁰-⁹]+)?, where 3 is expected: the filter claims far more than it knows\.$/,
      ({ meanNees, neesBand }, mean, large) =>
        (large !== undefined || prints(mean, meanNees)) && meanNees > neesBand[1],
    ],
  ],
)

test('to put the last landmark in line puts it in line, however many are shown', async () => {
  const spec = await WIDGETS['observability-probe']()
  const line = [...spec.controls, ...(spec.tries ?? [])].find(({ name }) => name === 'line')
  for (const count of [1, 2, 3]) {
    const lab = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params: { count } })
    const params = { ...lab.frame().params, ...line.change(lab.frame(), lab) }
    const {
      estimate: [x, y],
      frozen,
      params: { count: shown },
    } = estimate.ObservabilityProbe.from({ version: 1, lab: spec.name, step: 240, params }).frame()
    assert.equal(shown, Math.max(2, count))
    if (shown === 2) assert.equal(frozen.rank, 2, `with ${count} shown`)
    // Of three the last one stands in line with the robot and one of the others.
    const [px, py] = params.landmarks[shown - 1]
    const off = params.landmarks
      .slice(0, shown - 1)
      .map(([qx, qy]) => Math.abs((px - x) * (qy - y) - (py - y) * (qx - x)))
    assert.ok(Math.min(...off) < 1e-3, `with ${count} shown it is off by ${off}`)
  }
})

test('no readout of a figure is empty or wrong in kind, in any state', async () => {
  for (const load of Object.values(WIDGETS)) {
    const spec = await load()
    const open = (state) =>
      spec.lab === 'RobotLog'
        ? estimate.RobotLog.from(estimate.RobotLog.parse(LOG), state)
        : estimate[spec.lab].from(state)
    for (const step of spec.timeless ? [0] : [0, 1, 300]) {
      const lab = open({ version: 1, lab: spec.name, step, params: spec.start.params })
      for (const { key, value } of spec.readouts(lab.frame()))
        assert.doesNotMatch(`${key}: ${value}`, /undefined|NaN|null|: $/)
    }
  }
})

test('two opinions: the printed weights are one over the variances, and add up to that of the product', async () => {
  const spec = await WIDGETS.picture()
  const opened = (params) => estimate.Picture.from({ version: 1, lab: spec.name, step: 0, params })
  const weights = (frame) => spec.readouts(frame).find(({ key }) => key === 'weights').value
  assert.equal(weights(opened({}).frame()), '0.476 + 2.000 = 2.476')
  assert.equal(weights(opened({ noise: 0 }).frame()), '0.476 + ∞ = ∞')
  // The phrase makes both weigh the same, wherever the sensor is turned and whatever the ellipse.
  const equal = spec.tries.find(({ name }) => name === 'equal')
  for (const params of [
    {},
    { tilt: -0.7 },
    { tilt: -Math.PI / 2 },
    { semiMajor: 3, semiMinor: 3 },
    { semiMajor: 0.15, semiMinor: 0.15 },
    { semiMajor: 3, tilt: -0.4 },
  ]) {
    const lab = opened(params)
    const frame = opened({ ...params, ...equal.change(lab.frame(), lab) }).frame()
    assert.match(spec.verdict(frame), /Reading and expected output weigh the same: y\* lies half way\./)
    assert.ok(Math.abs(frame.mostLikelyVariance / frame.expectedVariance - 0.5) < 1e-9)
  }
})
