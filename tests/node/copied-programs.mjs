// The programs whose copies are compiled and run: the chapter’s algorithm in its forms, the museum’s bugs that are
// formulas, and whatever else the language knows.

import { CHAPTER } from './program-exports.mjs'

const ROBOT = `# one sighting of a known landmark
F = jac(f, x)
x = f(x, u)
P = F P F' + V
H = jac(h, x)
nu = y - h(x, l)
nu[2] = wrap(nu[2])
S = H P H' + W
R = P H' / S
x = x + R nu
x[3] = wrap(x[3])
P = sym((I - R H) P (I - R H)' + R W R')
`
/** A right filter with a line that is another. @param {string} text @param {string} old @param {string} by */
function changed(text, old, by) {
  if (!text.includes(old)) throw new Error(`No “${old}” in the program.`)
  return text.replace(old, by)
}
/** @param {string} old @param {string} by */
const linear = (old, by) => ({ text: changed(CHAPTER, old, by) })
/** @param {string} old @param {string} by */
const robot = (old, by) => ({ text: changed(ROBOT, old, by), world: 'robot' })

/** @type {Record<string, { text: string, world?: string, notation?: string, readings?: number }>} */
export const PROGRAMS = {
  kalman: { text: CHAPTER },
  // What a comment holds is nobody’s code.
  comments: { text: `# */ oops /* \\\\\n# \u2028 oops()\n${CHAPTER}# */ \u2029 oops(` },
  marks: {
    text: 'x̂⁻ = F x̂ + G u\nP⁻ = F P Fᵀ + V\nR = P⁻ Hᵀ / (H P⁻ Hᵀ + W)\nx̂ = x̂⁻ + R (y − H x̂⁻)\nP = P⁻ − R H P⁻',
  },
  times: {
    text: `x̂(k+1|k) = F x̂(k|k) + G u(k)
P(k+1|k) = F P(k|k) Fᵀ + V
ν = y(k+1) − H x̂(k+1|k)
S = H P(k+1|k) Hᵀ + W
R = P(k+1|k) Hᵀ S⁻¹
x̂(k+1|k+1) = x̂(k+1|k) + R ν
P(k+1|k+1) = P(k+1|k) − R H P(k+1|k)
`,
  },
  bars: {
    text: `μ̄ₜ = A μₜ₋₁ + B uₜ
Σ̄ₜ = A Σₜ₋₁ Aᵀ + R
K = Σ̄ₜ Cᵀ / (C Σ̄ₜ Cᵀ + Q)
μₜ = μ̄ₜ + K (zₜ − C μ̄ₜ)
Σₜ = Σ̄ₜ − K C Σ̄ₜ
`,
    notation: 'thrun',
  },
  joseph: linear('P = P − R H P', 'A = I − R H\nP = A P Aᵀ + R W Rᵀ'),
  symmetric: linear('P − R H P', 'sym(P − R H P)'),
  observer: {
    text: "x = F x + G u\nK = [0.5; 0.3]\nx = x + K (y - H x)\nA = eye(n) - K H\nP = A (F P F' + V) A' + K W K'",
  },
  information: {
    text: "x = F x + G u\nP = F P F' + V\nL = inv(P) + H' inv(W) H\nq = P \\ x + H' (W \\ y)\nP = inv(L)\nx = P q",
    readings: 2,
  },
  sequential: {
    text: `x = F x + G u
P = F P F' + V
a = H[1, :]
k = P a' / (a P a' + W[1, 1])
x = x + k (y[1] - a x)
P = P - k a P
b = H[2, :]
k = P b' / (b P b' + W[2, 2])
x = x + k (y[2] - b x)
P = P - k b P
`,
    readings: 2,
  },
  root: {
    text: `x = F x + G u
L = chol(F P F' + V)
B = H L
S = B B' + W
K = L B' / S
x = x + K (y - H x)
C = chol(I - B' (S \\ B))
P = (L C) (L C)'
`,
  },
  blocks: {
    text: `m0 = F x + G u
M = F P F' + V
A = [eye(n); H]
B = [M, zeros(n, p); zeros(p, n), W]
P = inv(A' (B \\ A))
x = P A' (B \\ [m0; y])
`,
    readings: 2,
  },
  joint: {
    text: `x = F x + G u
P = F P F' + V
J = [P, P H'; H P, H P H' + W]
C = P H'
K = C / (H C + W)
x = x + K y - K H x
P = J[1:n, 1:n] - K C'
`,
  },
  names: {
    text: `lambda = 2 I
step = F x + G u   # names that languages keep for themselves
f = trace(P) / trace(P)
k = det(P)^2 / det(P)^2
in = f k norm(x) / norm(x)
P = (F P F' + V) * in
matrix = P H' / (H P H' + W)
new = diag(diag(I_2))
x = step + matrix (y - H step)
P = sym(P - matrix H P) + lambda - 2 I + 0 new
P = exp(0) P + 0 abs(P) - sqrt(0) P + 0 P^3 + 0 P^-1 + 0 (-P)
`.replace('I_2', 'P'),
  },
  thrun: {
    text: 'μ = A μ + B u\nΣ = A Σ Aᵀ + R\nK = Σ Cᵀ (C Σ Cᵀ + Q)⁻¹\nμ = μ + K (z − C μ)\nΣ = (I − K C) Σ',
    notation: 'thrun',
  },
  numpy: {
    text: `x = F @ x + B @ u
P = F @ P @ F.T + Q
y = z - H @ x
S = H @ P @ H.T + R
K = P @ H.T @ np.linalg.inv(S)
x += K @ y
I_KH = np.eye(n) - K @ H
P = I_KH @ P @ I_KH.T + K @ R @ K.T
`,
    notation: 'common',
    readings: 2,
  },
  ekf: { text: ROBOT, world: 'robot' },
  'ekf by hand': {
    text: `F = jac([x[1] + u[1] cos(x[3]); x[2] + u[1] sin(x[3]); x[3] + u[2]], x)
G = jac(f, u)
x = f(x, u)
P = F P F' + V + 0 G G'
d = x[1:2] - l
r = norm(d)
H = [d[1]/r, d[2]/r, 0; -d[2]/r^2, d[1]/r^2, -1]
nu = [y[1] - r; wrap(y[2] - atan2(d[2], d[1]) + x[3])]
K = P H' inv(H P H' + W)
x = x + K nu
P = P - K H P
`,
    world: 'robot',
  },
  'ekf in Thrun’s letters': {
    text: `A = jac(f, mu)
mu = f(mu, u)
Sigma = A Sigma A' + R
C = jac(h, mu)
d = z - h(mu, l)
d = [d[1]; wrap(d[2])]
K = Sigma C' / (C Sigma C' + Q)
mu = mu + K d
Sigma = sym((I - K C) Sigma)
`,
    world: 'robot',
    notation: 'thrun',
  },
  'forget W': linear('+ W', '+ 0 W + 1e-3 I'),
  transposed: linear('F P Fᵀ', 'Fᵀ P F'),
  deviation: linear('+ W', '+ diag(sqrt(diag(W)))'),
  'step-length': linear('+ V', '+ 16 V'),
  'short-form': linear('R = P Hᵀ S⁻¹', 'R = 1.3 P Hᵀ S⁻¹'),
  twice: linear('P = P − R H P', 'P = P − R H P\nR = P Hᵀ / (H P Hᵀ + W)\nx = x + R (y − H x)\nP = P − R H P'),
  'unwrapped-innovation': robot('nu[2] = wrap(nu[2])\n', ''),
  'unwrapped-heading': robot('x[3] = wrap(x[3])\n', ''),
  'wrong-derivative': robot('nu = y', 'H[2, 3] = -1 / norm(x[1:2] - l)^2\nnu = y'),
  degrees: robot('S = H', 'W[2, 2] = (180/pi)^2 W[2, 2]\nS = H'),
  asymmetric: robot("sym((I - R H) P (I - R H)' + R W R')", 'P - R H P'),
  'transposed robot': robot("F P F'", "F' P F"),
}

const RAIL = {
  F: [
    [1, 0.5],
    [0, 1],
  ],
  G: [[0.125], [0.5]],
  V: [
    [0.2, 0.05],
    [0.05, 0.1],
  ],
}

/** The world of a program: what it reads in ten steps. @param {{ world?: string, readings?: number }} program */
export function worldOf({ world, readings = 1 }) {
  // Noise from a fixed sequence.
  let state = 7
  const noise = () => ((state = (state * 16807) % 2147483647), state / 2147483647 - 0.5)
  if (world === 'robot') {
    const marks = [
      [3, 1],
      [-2, 2],
      [0, -3],
    ]
    const truth = [0.2, -0.1, 3]
    const steps = Array.from({ length: 10 }, (_, k) => {
      truth[0] += 0.5 * Math.cos(truth[2])
      truth[1] += 0.5 * Math.sin(truth[2])
      truth[2] += 0.4
      const landmark = marks[k % 3]
      const [dx, dy] = [truth[0] - landmark[0], truth[1] - landmark[1]]
      const bearing = Math.atan2(dy, dx) - truth[2] + 0.1 * noise()
      return {
        u: [0.5, 0.4],
        y: [Math.hypot(dx, dy) + 0.2 * noise(), Math.atan2(Math.sin(bearing), Math.cos(bearing))],
        landmark,
        // A reading beyond the gate is one that says nothing.
        ...(k === 4 && { W: diagonal([1e10, 1e10]) }),
      }
    })
    const start = { x: [0.3, 0, 2.9], P: diagonal([0.05, 0.05, 0.02]) }
    return {
      system: { V: diagonal([0.002, 0.002, 0.001]), W: diagonal([0.01, 0.0025]), gate: 9.21 },
      belief: start,
      steps,
    }
  }
  const H = [
    [1, 0],
    [0.5, 1],
  ].slice(0, readings)
  let [at, speed] = [2.5, 3.5]
  const steps = Array.from({ length: 10 }, (_, k) => {
    const u = k < 5 ? 1 : -1
    at += 0.5 * speed + 0.125 * u + 0.3 * noise()
    speed += 0.5 * u + 0.3 * noise()
    return { u: [u], y: H.map(([a, b]) => a * at + b * speed + noise()) }
  })
  return {
    system: { ...RAIL, H, W: diagonal([0.5, 0.25].slice(0, readings)) },
    belief: { x: [2, 4], P: diagonal([1, 2]) },
    steps,
  }
}

/** @param {number[]} entries */
const diagonal = (entries) => entries.map((entry, i) => entries.map((_, j) => (i === j ? entry : 0)))
