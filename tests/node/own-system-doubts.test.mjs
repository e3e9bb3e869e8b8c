// What a script might be misread as in silence: weights for noises, a matrix before for the one after.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readSystem } from '../../web/widgets/own-system/read.js'

/** @param {string} text */
const read = (text) => /** @type {any} */ (readSystem(text))
const WHOLE = 'A = [0 1; -4 -0.4]; B = [0; 1]; C = [1 0]; T = 0.1; Q = 0.01*eye(2); R = 0.5;\n'

test('a matrix that is set anew is no longer that of the system in continuous time', () => {
  const { system, fault } = read(`${WHOLE}sys = ss(A, B, C, 0); A = eye(2) + A*T;`)
  assert.deepEqual([system?.F[0][1], system?.continuous], [0.1, undefined], fault)
  assert.equal(read(`A = [0 4; -16 -1.6]; ${WHOLE.slice(20)}A = A/4; sys = ss(A, B, C, 0);`).system.continuous, true)
})

test('an input beside a computed F is said to be that of a step, whatever F is called', () => {
  for (const [text, held] of /** @type {[string, string][]} */ ([
    ['F = expm(A*T);', 'B'],
    ['Ad = expm(A*T);', 'B'],
    ['Phi = [1 0.1; 0 1];', 'B'],
    ['Ad = expm(A*T); Bd = [0; 0.1];', ''],
    ['Ad = expm(A*T); G = T*B;', ''],
    ['', ''],
  ])) {
    const found = read(WHOLE + text)
    assert.deepEqual([text, found.held], [text, held], found.fault)
  }
})

test('the weights of a controller are not taken for noises', () => {
  for (const call of ['K = dlqr(A, B, Q, R);', '[K, S, e] = lqr(A, B, Q, R)', 'K, S, E = ct.dlqr(A, B, Q, R)']) {
    assert.equal(
      read(WHOLE + call).fault,
      'Q and R are weights of a controller here, and no noises; write the noises as V = … and W = ….',
    )
    const both = read(`${WHOLE}V = eye(2); W = 3; ${call}`)
    assert.deepEqual(
      [both.system?.V, both.system?.W],
      [
        [
          [1, 0],
          [0, 1],
        ],
        [[3]],
      ],
      both.fault,
    )
  }
  assert.equal(read(`${WHOLE}K = dlqr(A, B, eye(2), 1)`).system.W[0][0], 0.5)
})

test('a name that is set in part to what cannot be read is not the name before', () => {
  const whole = 'F = [1 0.1; 0 1]; H = [1 0]; R = 1\n'
  const idle = read(`${whole}Q = eye(2); x = zeros(2, 1); x(1, 1) = rand`)
  assert.deepEqual([idle.fault, idle.unused], [undefined, ['x']])
  assert.match(read(`${whole}x = eye(2); x(1, 1) = rand; Q = 2*x`).fault, /^Q: “x” is not a number\.$/)
  assert.match(read(`${whole}Q = eye(2); Q(1, 1) = rand`).fault, /^Q: “rand” is not a number\.$/)
})

test('a letter that a formula alone uses is a variable where it is no matrix of its role', () => {
  const noises = 'Q = eye(2); R = 1'
  const gamma = "Phi = [1 .1; 0 1]; B = [2; 1]; Gamma = [1; 2]; H = [1 0]; Q = Gamma*0.5*Gamma'; R = 1"
  assert.deepEqual([read(gamma).system?.G, read(gamma).variables], [[[2], [1]], ['Gamma']], read(gamma).fault)
  const b = read(`B = 0.3; F = [1 B; 0 1]; H = [1 0]; ${noises}`)
  assert.deepEqual([b.system?.F[0][1], b.system?.G, b.variables], [0.3, [[], []], ['B']], b.fault)
  const r = read('R = 4; F = [1 0.1; 0 1]; H = [1/R 0]; V = eye(2); W = 2')
  assert.deepEqual([r.system?.H[0][0], r.system?.W, r.variables], [0.25, [[2]], ['R']], r.fault)
  assert.match(read(`Phi = 0.3; F = 1; H = 1; Q = 1; R = 1`).fault ?? 'read', /^F and Phi are both given/)
  assert.equal(read(`Ad = 0.3; A = 1; H = 1; Q = 1; R = 1`).system.F[0][0], 0.3)
  for (const none of ['B = []', 'kf.B = None']) {
    const found = read(`${none}\nF = [1 0.1; 0 1]; H = [1 0]; ${noises}`)
    assert.deepEqual([none, found.system?.G], [none, [[], []]], found.fault)
  }
})

test('a size is that of what was given', () => {
  for (const [one, numpy] of /** @type {[string, boolean][]} */ ([
    ['eye(size(A))', false],
    ['eye(size(A, 1))', false],
    ['eye(length(A))', false],
    ['np.eye(len(A))', true],
    ['np.eye(A.shape[0])', true],
    ['np.eye(A.shape[0], A.shape[1])', true],
  ])) {
    const [A, H] = numpy ? ['np.array([[0, 1], [0, 0]])', 'np.array([[1, 0]])'] : ['[0 1; 0 0]', '[1 0]']
    const found = read(`A = ${A}; F = ${one} + A*0.5; H = ${H}; Q = ${one}; R = 1`)
    assert.deepEqual(
      [one, found.system?.F],
      [
        one,
        [
          [1, 0.5],
          [0, 1],
        ],
      ],
      found.fault,
    )
  }
  const like = read('F = np.eye(2); H = np.array([[1, 0]]); Q = np.zeros_like(F); Q[1, 1] = 3; R = 1')
  assert.deepEqual(
    like.system?.V,
    [
      [0, 0],
      [0, 3],
    ],
    like.fault,
  )
})

test('two names of numpy for one matrix are one matrix, and in MATLAB two', () => {
  const [numpy, matlab] = [
    'F = np.eye(2); H = np.array([[1, 0]]); R = 1; Q = np.eye(2)\n',
    'F = eye(2); H = [1 0]; R = 1; Q = eye(2)\n',
  ]
  for (const [text, F, Q] of /** @type {[string, number, number][]} */ ([
    [`${numpy}M = F\nM[0, 1] = 0.3`, 0.3, 1],
    [`${numpy}M = F.copy()\nM[0, 1] = 0.3`, 0, 1],
    [`${numpy}M = Q\nQ *= 2\nQ[0, 0] = M[1, 1]`.replace('M[1, 1]', '5'), 0, 5],
    [`${numpy}M = Q\nM *= 2`, 0, 2],
    [`${numpy}M = Q\nM = M*2`, 0, 1],
    [`${numpy}r = R\nr *= 2`, 0, 1],
    [`${matlab}M = F; M(1, 2) = 0.3`, 0, 1],
    [`${matlab}M = Q; M = M*2`, 0, 1],
  ])) {
    const { system, fault } = read(text)
    assert.deepEqual([text, system?.F[0][1], system?.V[0][0], system?.W], [text, F, Q, [[1]]], fault)
  }
})

test('a text may say in words which time it is of', () => {
  const whole = 'A = [0 1; -4 -0.4]; B = [0; 1]; C = [1 0]; Q = diag([0 0.1]); R = 0.01; T = 0.1\n'
  const { system: expected } = read(`${whole}c2d(ss(A, B, C, 0), T)`)
  for (const words of [
    'continuous',
    'continuous = true',
    'Continuous-time',
    'continuous_time: 1',
    'discrete = false',
  ]) {
    const { system, unused, fault } = read(whole + words)
    assert.deepEqual([words, system, unused], [words, expected, []], fault)
  }
  const json =
    '{"A": [[0, 1], [-4, -0.4]], "C": [[1, 0]], "Q": [[0, 0], [0, 0.1]], "R": [[0.01]], "T": 0.1, "continuous": X}'
  for (const [word, continuous] of [
    ['true', true],
    ['false', undefined],
  ])
    assert.equal(read(json.replace('X', String(word))).system.continuous, continuous)
  for (const words of ['discrete', 'discrete = true', 'continuous = 0'])
    assert.equal(read(whole + words).system.continuous, undefined)
  for (const [after, fault] of /** @type {[string, RegExp][]} */ ([
    ['continuous\ndiscrete', /^The text says both, continuous and discrete time; leave one out\.$/],
    ['discrete; c2d(ss(A, B, C, 0), T)', /^The text says discrete time, and has a system of continuous time; leave/],
  ]))
    assert.match(read(whole + after).fault ?? 'read', fault)
  assert.match(read(`${whole.replace('; T = 0.1', '')}continuous`).fault, /^The length of a step is missing/)
})

test('a diagonal that is given number by number says how it is written', () => {
  for (const [text, fault] of /** @type {[string, RegExp][]} */ ([
    ['V = diag(1e-5, 1e-8)', /^V: a diagonal is one list: diag\(\[a b\]\)\.$/],
    ['V = np.diag(1e-5, 1e-8)', /^V: a diagonal is one list: np\.diag\(\[a, b\]\)\.$/],
  ]))
    assert.match(read(`F = [[1, 0], [0, 1]]\nH = [[1, 0]]\nW = 1\n${text}`).fault, fault)
})
