// What the fuzz test knows of the class Program: texts that are programs, texts that are nearly one, and their steps.
import { sizes, system, vector } from './arguments.mjs'
import { covariance } from './nonsense.mjs'

export const CHAPTER = `x = F x + G u
P = F P Fᵀ + V
ν = y − H x      # the innovation
S = H P Hᵀ + W
R = P Hᵀ S⁻¹
x = x + R ν
P = P − R H P
`
export const ROBOT = `F = jac(f, x)
x = f(x, u)
P = F P F' + V
H = jac(h, x)
nu = y - h(x, l)
nu[2] = wrap(nu[2])
S = H P H' + W
R = P H' / S
x = x + R nu
x[3] = wrap(x[3])
P = sym(P - R H P)
`
const NUMPY = `x = F @ x + B @ u
P = F @ P @ F.T + Q
S = H @ P @ H.T + R
K = np.linalg.solve(S, H @ P).T
x += K @ (z - H @ x)
P = (np.eye(n) - K @ H) @ P @ (np.eye(n) - K @ H).T + K @ R @ K.T
`

/** A text with a few letters changed, taken out or doubled. */
function spoilt(text, dice) {
  const letters = [...text]
  for (let count = dice.below(3); count > 0; count -= 1) {
    const at = dice.below(letters.length)
    letters.splice(at, dice.below(2), dice.pick(['', '[', ')', ' 1e9 ', '\n', 'x', 'K', "'", '⁻¹', letters[at]]))
  }
  return letters.join('')
}

/** What a step is given, in the world of these options. */
function given({ world }, dice) {
  if (world === 'robot') {
    const robot = { V: covariance(3, dice), W: covariance(2, dice), landmark: vector(2, dice) }
    return [robot, { x: vector(3, dice), P: covariance(3, dice) }, vector(2, dice), vector(2, dice)]
  }
  const { n, p, m } = sizes(dice)
  return [system({ n, p, m }, dice), { x: vector(n, dice), P: covariance(n, dice) }, vector(m, dice), vector(p, dice)]
}

export const program = {
  chain: 10,
  spoilt: 0.3,
  often: ['step', 'step'],
  least: { right: 40, refused: 40 },
  make(dice) {
    const [text, options] = dice.pick([
      [CHAPTER, {}],
      [CHAPTER, { world: 'linear', notation: 'choset' }],
      [NUMPY, { notation: 'common' }],
      [ROBOT, { world: 'robot' }],
    ])
    return [dice.uniform() < 0.5 ? text : spoilt(text, dice), options]
  },
  methods: {
    judge: () => [],
    tree: (dice) => dice.pick([[], [Object.values(sizes(dice))]]),
    step: (dice, _, _it, [, options]) => given(options, dice),
    lines: (dice, _, _it, [, options]) => given(options, dice),
  },
  look: (it) => [it.faults, it.letters],
  covariances: () => [],
  outcomes: (answer) => (answer?.outcome ? [answer.outcome] : []),
}
