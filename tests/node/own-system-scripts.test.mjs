// A script that computes its system is read: a matrix by a formula of another, a name set anew, discrete names.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { figure } from '../../web/widgets/own-system/index.js'
import { PRESETS, paramsOf } from '../../web/widgets/own-system/presets.js'
import { readSystem } from '../../web/widgets/own-system/read.js'

const root = fileURLToPath(new URL('../..', import.meta.url))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** @param {string} text */
const read = (text) => /** @type {any} */ (readSystem(text))
/** @param {number[][]} a @param {number[][]} b @param {string} of */
function near(a, b, of) {
  const flat = b?.flat() ?? []
  assert.ok(
    a?.length === b?.length && a.flat().every((x, i) => Math.abs(x - flat[i]) <= 1e-12 * (1 + Math.abs(flat[i]))),
    `${of}: ${a?.join('; ')} and ${b?.join('; ')}`,
  )
}

/** exp([0 1; −4 −0.4] 0.1), in closed form: an oscillator of ω = √3.96 that dies out by e^(−0.2 t). */
const [T, w] = [0.1, Math.sqrt(3.96)]
const [c, s, e] = [Math.cos(w * T), Math.sin(w * T) / w, Math.exp(-0.2 * T)]
const EXACT = [
  [e * (c + 0.2 * s), e * s],
  [-4 * e * s, e * (c - 0.2 * s)],
]
const EULER = [
  [1, 0.1],
  [-0.4, 0.96],
]
const MATLAB = 'A = [0 1; -4 -0.4]; B = [0; 1]; T = 0.1; C = [1 0]; Q = 0.01*eye(2); R = 0.5;\n'
const NUMPY =
  'import numpy as np\nimport scipy\nfrom scipy.linalg import expm\nA = np.array([[0, 1], [-4, -0.4]])\ndt = 0.1\n' +
  'H = np.array([[1, 0]])\nQ = 0.01*np.eye(2)\nR = np.array([[0.5]])\n'

test('a matrix that is given by a formula of another is the matrix, and the other a variable', () => {
  for (const [text, F] of /** @type {[string, number[][]][]} */ ([
    [`${MATLAB}F = expm(A*T);`, EXACT],
    [`${MATLAB}F = eye(2) + A*T;`, EULER],
    [`${MATLAB}M = A*T; F = expm(M);`, EXACT],
    [`${MATLAB}Ad = expm(A*T);`, EXACT],
    [`${MATLAB}A_d = eye(2) + A*T`, EULER],
    [`${MATLAB}Phi = expm(A*T);`, EXACT],
    [`${MATLAB.replace('A =', 'F =')}Phi = expm(F*T);`, EXACT],
    [`${MATLAB}sys = ss(A, B, C, 0); Ad = expm(A*T);`, EXACT],
    [`${NUMPY}F = np.eye(2) + A*dt`, EULER],
    [`${NUMPY}F = expm(A*dt)`, EXACT],
    [`${NUMPY}F = scipy.linalg.expm(A*dt)`, EXACT],
    [`${NUMPY}Ad = expm(A * dt)`, EXACT],
  ])) {
    const { system, fault, unused } = read(text)
    assert.ok(system, `${text}: ${fault}`)
    near(system.F, F, text)
    assert.deepEqual([text, system.period, system.continuous, unused], [text, T, undefined, []])
  }
  // B is then of a step, unless its formula says how a step takes it: that is said.
  const [one, two] = [`${MATLAB}F = expm(A*T);`, `${MATLAB}F = expm(A*T); G = B*T;`].map(read)
  assert.deepEqual(
    [one.system.G, two.system.G],
    [
      [[0], [1]],
      [[0], [0.1]],
    ],
  )
  assert.deepEqual(one.variables, ['A'])
  assert.deepEqual(two.variables, ['A', 'B'])
  assert.deepEqual([one.held, two.held], ['B', ''])
  const noise = read(
    `${NUMPY.replace('Q =', 'W =')}F = np.eye(2) + A*dt\nG = np.array([[1, 0], [0, 2]])\nQ = G @ W @ G.T`,
  )
  near(
    noise.system.V,
    [
      [0.01, 0],
      [0, 0.04],
    ],
    noise.fault,
  )
  near(noise.system.W, [[0.5]], 'R')
  const step = read(`${MATLAB}Ad = expm(A*T); Bd = T*B; Qd = Ad*Q*Ad'*T; Rd = R/T`)
  near(step.system.W, [[5]], step.fault)
  near(step.system.G, [[0], [0.1]], 'Bd')
  assert.equal(step.as, 'Ad, Bd, C, Qd, Rd read as F, G, H, V, W')
  for (const text of ['A = [1 1; 0 1]; F = [1 2; 0 1]', 'A = [1 1; 0 1]; F = [1 2; 0 1]; Z = 2*A'])
    assert.match(read(`${text}; H = [1 0]; Q = eye(2); R = 1`).fault, /^F and A are both given/)
})

test('what a call of c2d makes is not taken for the matrix of continuous time', () => {
  const whole = 'A = [0 1; -4 -0.4]; B = [0; 1]; C = [1 0]; Q = diag([0 0.1]); R = 0.01\n'
  const expected = read(`${whole}sysd = c2d(ss(A, B, C, 0), 0.1)`).system
  for (const after of [
    'sys = ss(A, B, C, 0); sysd = c2d(sys, 0.1); Ad = sysd.A; Bd = sysd.B; Cd = sysd.C',
    'sys = ss(A, B, C, 0); sysd = c2d(sys, 0.1); F = sysd.A; G = sysd.B; H = sysd.C',
    '[Ad, Bd] = c2d(A, B, 0.1); F = Ad; G = Bd',
  ]) {
    const { system, fault } = read(whole + after)
    assert.deepEqual([after, system], [after, expected], fault)
  }
  for (const [after, fault] of /** @type {[string, RegExp][]} */ ([
    [
      'sysd = c2d(ss(A, B, C, 0), 0.1); F = 2*sysd.A',
      /^F: “sysd\.A” is made only after the text is read; write its num/,
    ],
    ['[Ad, Bd] = c2d(A, B, 0.1); F = Ad*2', /^F: “Ad” is made only after the text is read; write its numbers\.$/],
    ['sysd = made(A); F = sysd.A', /^F: “sysd\.A” is not known here; write its numbers\.$/],
    ['c2d(ss(A, B, C, 0), 0.1); Qd = 0.1*eye(2)', /^Qd is of one step, and A of continuous time: write both of one\.$/],
  ]))
    assert.match(read(whole.replace(/Q = [^;]*;/, after.includes('Qd') ? '' : '$&') + after).fault ?? 'read', fault)
})

test('a name that is set anew is what it is then, and one that is not set has no change', () => {
  const whole = 'F = [1 0.1; 0 1]\nH = [1 0]\nQ = eye(2)\nR = 1\ndt = 0.5\n'
  for (const [after, V, W] of /** @type {[string, number, number][]} */ ([
    ['R *= 5', 1, 5],
    ['Q *= dt', 0.5, 1],
    ['Q += eye(2)', 2, 1],
    ['Q -= 0.5*eye(2)', 0.5, 1],
    ['R /= 4', 1, 0.25],
    ['Q = Q*dt', 0.5, 1],
    ['Q = Q*dt; Q *= 2; R = 2*R + 1', 1, 3],
    ['q = 3; q += 1; Q *= q', 4, 1],
  ])) {
    const { system, fault } = read(whole + after)
    assert.deepEqual([after, system?.V[0][0], system?.W[0][0]], [after, V, W], fault)
  }
  for (const [after, fault] of /** @type {[string, RegExp][]} */ ([
    ['X *= 5', /^X is changed before it is given; write X = its numbers first\.$/],
    ['Q += [1 2 3]', /^Q: a 2 × 2 and a 1 × 3 matrix have no sum\.$/],
    ['H += eye(2)', /^H: a change may not make a 2 × 2 matrix of a 1 × 2\.$/],
    ['R = 2', /^R is given twice\.$/],
  ]))
    assert.match(read(whole + after).fault ?? 'read', fault)
  assert.match(read('F = 1\nH = 1\nQ = 1\nR *= 5').fault, /^R is changed before it is given; write R = its numbers/)
  assert.equal(read('dt = 1; dt /= 10; F = [1 dt; 0 1]; H = [1 0]; Q = eye(2); R = 1').system.period, 0.1)
})

test('the names of the discrete matrices are read and said', () => {
  const phi = read('Phi = [1 0.1; 0 1]\nGamma = [0.005; 0.1]\nH = [1 0]\nQ = eye(2)\nR = 1')
  assert.equal(phi.as, 'Phi, Gamma, Q, R read as F, G, V, W')
  const all = read('Ad = [1 0.1; 0 1]\nBd = [0.005; 0.1]\nCd = [1 0]\nDd = 0\nQd = eye(2)\nRd = 1')
  assert.equal(all.as, 'Ad, Bd, Cd, Qd, Rd read as F, G, H, V, W')
  assert.deepEqual(
    [all.system.F, all.system.H, all.unused],
    [
      [
        [1, 0.1],
        [0, 1],
      ],
      [[1, 0]],
      [],
    ],
  )
  assert.equal(read('F_k = 1; H_k = 1; Q_k = 1; R_k = 2').system.W[0][0], 2)
  // Beside those of continuous time they are what a step does; what does not fit is another thing.
  const both = read(
    'A = [0 1; 0 0]; B = [0; 1]; C = [1 0]; Ad = [1 0.1; 0 1]; Bd = [0; 0.1]; Cd = 0.3; Q = eye(2); R = 1',
  )
  assert.deepEqual([both.system.F[0][1], both.system.G, both.system.H], [0.1, [[0], [0.1]], [[1, 0]]], both.fault)
  assert.deepEqual(both.unused, ['A', 'B', 'Cd'])
  assert.match(read('Ad = 1; Bd = 1; Cd = 1; Dd = 2; Qd = 1; Rd = 1').fault, /^D is not 0/)
  assert.equal(read('F = 1; H = 1; Qd = 1').fault, 'R, the noise of a reading, is missing.')
})

test('where there are no inputs, none is said not to reach a state', () => {
  const of = (/** @type {number} */ inputs) => {
    const params = { ...paramsOf(PRESETS[0]), inputs }
    const frame = core.OwnSystem.from({ version: 1, lab: 'own-system', step: 0, params }).frame()
    return figure.readouts(frame).find(({ key }) => key === 'input')?.value
  }
  assert.deepEqual([of(0), of(1)], ['there are none', 'yes'])
})

test('the noises of filterpy are those that it makes, with and without the names of their values', () => {
  const of = (/** @type {string} */ call) => {
    const { system, fault } = read(
      `kf = KalmanFilter(dim_x=2, dim_z=1)\nkf.F = np.eye(2)\nkf.H = np.array([[1., 0.]])\nkf.R *= 5\nkf.Q = ${call}`,
    )
    return system?.V ?? fault
  }
  const [two, four] = ['0.00000325 0.000065 0.000065 0.0013', '0.03125 0.125 0.125 0.5'].map((row) =>
    row.split(' ').map(Number),
  )
  near(of('Q_discrete_white_noise(dim=2, dt=0.1, var=0.13)'), [two.slice(0, 2), two.slice(2)], 'discrete')
  near(of('Q_discrete_white_noise(2, dt=0.5, var=2)'), [four.slice(0, 2), four.slice(2)], 'discrete, by place')
  const density = of('Q_continuous_white_noise(2, 0.1, spectral_density=0.13)')
  near(
    density,
    [
      [0.13e-3 / 3, 0.00065],
      [0.00065, 0.013],
    ],
    'continuous',
  )
  assert.match(String(of('Q_discrete_white_noise(5)')), /^Q: “Q_discrete_white_noise” makes 2, 3 or 4 states; write/)
  assert.match(String(of('Q_discrete_white_noise(2, rate=3)')), /^Q: “rate =” is not understood here/)
  assert.match(String(of('np.diag(v=[1, 2])')), /^Q: “v =” is not understood here/)
  const large = read(
    'dt = 0.5\nf = np.eye(3)\nF = np.kron(np.eye(2), f)\nH = np.eye(1, 6)\nR = 1\n' +
      'Q = Q_discrete_white_noise(dim=3, dt=dt, var=2., block_size=2, order_by_dim=False)',
  ).system.V
  // Each of the values stands twice, for the two coordinates.
  near(
    large.slice(0, 2),
    [
      [0.03125, 0, 0.125, 0, 0.25, 0],
      [0, 0.03125, 0, 0.125, 0, 0.25],
    ],
    'by derivative',
  )
  const whole = read('F = np.eye(4)\nH = np.eye(1, 4)\nR = 1\nQ = Q_continuous_white_noise(4, 0.5)').system.V
  near([[whole[0][0], whole[0][3], whole[3][3]]], [[0.5 ** 7 / 252, 0.5 ** 4 / 24, 0.5]], 'four states')
})

test('what Julia, numpy and R write otherwise is read, or it is said what to write', () => {
  const whole = (/** @type {string} */ Q, H = 'H = [1 0]') =>
    read(`using LinearAlgebra\nF = [1 0.1; 0 1]\n${H}\nQ = ${Q}\nR = 2`)
  for (const Q of ['0.5*I(2)', 'Diagonal([0.5, 0.5])', 'diagm([0.5, 0.5])', '0.5 * np.eye(2).astype(float)'])
    assert.deepEqual(
      [Q, whole(Q).system?.V],
      [
        Q,
        [
          [0.5, 0],
          [0, 0.5],
        ],
      ],
      whole(Q).fault,
    )
  assert.deepEqual(whole('eye(2)', 'H = fill(0.5, 1, 2)').system.H, [[0.5, 0.5]])
  assert.equal(whole('square(3)*eye(2)').system.V[1][1], 9)
  for (const F of ['F = matrix(c(1, 0, 0.1, 1), nrow=2)', 'F <- matrix(c(1, 0, 0.1, 1), nrow=2)'])
    assert.match(read(`${F}\nH = [1 0]`).fault, /R’s notation is not read here; write each matrix by its rows, as F = /)
  const old = read('F = np.matrix([[1, 1], [0, 1]])\nH = np.matrix([[1, 0]])\nR = 1\nQ = F * F.T')
  assert.match(old.fault, /^Q: “\*” is a product for np\.matrix, and goes entry by entry for np\.array; write @/)
  // What a filter’s call gives is not needed here, and named.
  const call = read('A = [1 1; 0 1]; C = [1 0]; Q = eye(2); R = 1; [M, P, Z, E] = dlqe(A, eye(2), C, Q, R);')
  assert.deepEqual([call.fault, call.unused], [undefined, ['M', 'P', 'Z', 'E']])
  const shaped = 'A = [1 1; 0 1]; G = [0.5; 1]; C = [1 0]; Q = 0.1; R = 1'
  assert.match(read(shaped).fault, /^Q is 1 × 1; .* 2 × 2\. Write Q = G\*Q\*G' if G takes it to the state\.$/)
  assert.equal(read(`${shaped}; Q = G*Q*G'`).system.V[1][1], 0.1)
  assert.match(read('[F, G] = made(3); H = 1; Q = 1; R = 1').fault, /is not understood here/)
})

test('a part of a matrix is set as MATLAB, Julia and numpy count it', () => {
  const F = [
    [1, 0, 0.1, 0],
    [0, 1, 0, 0.1],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ]
  for (const text of [
    'F = eye(4); F(1:2, 3:4) = 0.1*eye(2)',
    'F = np.eye(4)\nF[:2, 2:] = 0.1*np.eye(2)',
    'F = np.eye(4)\nF[0:2, 2:4] = 0.1*np.eye(2)',
    'F = np.eye(4)\nF[0, 2] = F[1, 3] = 0.1',
    'F = zeros(4)\nF(1, :) = [1 0 0.1 0]; F(2, :) = [0 1 0 0.1]; F(3:end, 3:end) = eye(2)',
  ]) {
    const found = read(`${text}\nH = [1 0 0 0]\nQ = eye(4)\nR = 1`)
    assert.deepEqual([text, found.system?.F], [text, F], found.fault)
  }
  // A name that is no matrix of the system is set in part as well: a matrix is made of it.
  const block = read('f = eye(2); f(1, 2) = 0.1; F = blkdiag(f, f); H = [1 0 0 0]; Q = eye(4); R = 1')
  assert.equal(block.system.F[2][3], 0.1)
  for (const [text, fault] of /** @type {[string, RegExp][]} */ ([
    ['F = eye(2); F[1, 1] = 3', /^F\[1, 1\] counts from 0 in Python and from 1 in Julia; write the whole matrix\.$/],
    ['F = eye(2); F(1:2, 3:4) = eye(2)', /^F\(1:2, 3:4\): F is 2 × 2\.$/],
    ['F = eye(4); F(1:2, 3:4) = eye(3)', /^F\(1:2, 3:4\) is 2 × 2, and what it is set to 3 × 3\.$/],
  ]))
    assert.match(read(`${text}\nH = [1 0]\nQ = eye(4)\nR = 1`).fault ?? 'read', fault)
})
