// A pasted system: every line is taken, of no use and named, or a fault with its line.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { paramsOf } from '../../web/widgets/own-system/presets.js'
import { readSystem } from '../../web/widgets/own-system/read.js'
import { wordsOf } from '../../web/widgets/own-system/typed-system.js'
import { dice } from './nonsense.mjs'

const REST = 'H = [1 0]\nV = [1 0; 0 1]\nW = 1'
const read = (text) => /** @type {any} */ (readSystem(text))

test('an entry given by itself is taken, counted as its brackets say', () => {
  const half = [
    [1, 0.5],
    [0, 1],
  ]
  for (const text of [
    `F = eye(2);\nF(1,2) = 0.5;\n${REST}`,
    `F = eye(2), F(1, 2) = 1/2\n${REST}`,
    `F = np.eye(2)\nF[0, 1] = 0.5\n${REST}`,
    `F = np.eye(2); F[0][1] = .5\n${REST}`,
    `kf = KalmanFilter(dim_x=2)\nkf.F = np.eye(2)\nkf.F[0, 1] = 0.5\nkf.H = [1 0]\nkf.V = eye(2)\nkf.W = 1`,
    `>>> F = np.eye(2)\n>>> F[0,1] = 0.5\n${REST}`,
    `F = [1 0; 0 1]\nF[1, 2] = 0.5\n${REST}`,
    `F = [1 .5; 0 1] # known to 5 % 3\n// 5 % 3\n${REST} % in 2 % of all`,
    `F = eye(2) % the dynamics\n%{\nF(2,1) = 7\n%}\nF(1,2) = 0.5\n${REST}`,
  ])
    assert.deepEqual([text, read(text).system?.F], [text, half])
})

test('what is not understood is a fault with its line, and nothing of the paste is taken', () => {
  for (const [text, line, fault] of [
    [`F *= 2\nF = eye(2)\n${REST}`, 1, /^F is changed before it is given; write F = its/],
    [`F = eye(2)\n\nF ^= 2\n${REST}`, 3, /“F \^= 2” is not understood/],
    [`F = eye(2)\nF(:,k) = 2\n${REST}`, 2, /“F\(:,k\) = 2” is not understood/],
    [`F = eye(2)\nF(3,1) = 2\n${REST}`, 2, /^F\(3,1\): F is 2 × 2\.$/],
    [`F = np.eye(2)\nF[0, 2] = 2\n${REST}`, 2, /^F\[0, 2\]: F is 2 × 2\.$/],
    [`F = np.eye(2)\nF[0, 1] = dt\n${REST}`, 2, /“dt” is not a number/],
    [`F = np.eye(2)\nF[0, 1] = [1 2]\n${REST}`, 2, /^F\[0, 1\] is 1 × 1, and what it is set to 1 × 2\.$/],
    [`F(1,2) = 0.5\nF = eye(2)\n${REST}`, 1, /“F\(1,2\) =” is not understood/],
    [`F = eye(2)\nF = 2*eye(2)\n${REST}`, 2, /F is given twice/],
    [`F = eye(2)\n${REST}\nfor i = 1:3\nend`, 5, /“for i = 1:3” is not understood/],
    [`F = eye(2)\n${REST.replace('W = 1', 'W = 5 % 3')}`, 4, /“5 % 3” is a comment in MATLAB and a rest in Python/],
    [`F = [1 0; 0 1]\nF[0, 1] = 2\n${REST}`, 2, /^F\[0, 1\]: F is 2 × 2\.$/],
    [`F = eye(2)\n${REST}\nhello`, 5, /“hello” is not understood/],
    [`F = [1 ...\n 0; 0 1]\n${REST}\nF'`, 6, /“F'” is not understood/],
    [`/* two\nlines */ F = eye(2)\n${REST}\n! W`, 6, /“! W” is not understood/],
    [`F = eye(2)\nH = [1 0 0]\nV = eye(2)\nW = 1`, 2, /^H is 1 × 3/],
    [`F = eye(2)\nB = 5\n${REST}`, 2, /^B is 1 × 1; .* it needs 2 rows\. Give B another name if it is not that\.$/],
    [`F = eye(2)\nH = a_very_long_name_of_it\n${REST}`, 2, /^H: “a_very_long_name_of_…” is not a number\.$/],
    [`F = eye(2)\n${REST}\n! ${'long '.repeat(9)}`, 5, /^“! (?:long ){5}lon…” is not understood/],
    [`F = eye(2)\n${REST}\nfrom now on F is doubled: F = 2*F`, 5, /“from now on/],
    [`F = eye(2)\n${REST}\nelse: F *= 2`, 5, /“else: F \*= 2”/],
    [`F = eye(2)\n${REST}\nx0 = [1 2\nF(1,2) = 0.5`, 5, /bracket is not closed/],
    [`G = [0; 1]\nF = eye(2)\n${REST}\nclear G`, 6, /“clear G” is not understood/],
    [`F = eye(2)\nH = [1 0]\nV = eye(2)\nW = 5//2`, 4, /“\/\/2” is not understood/],
    [`F = eye(2)\nH = [1 0]\nV = eye(2)\nW = 1e-400`, 4, /“1e-400” is not a number/],
    [`F = [[1 0] [0 1]]\n${REST}`, 1, /is not a list of rows/],
    [`${'a = 1\n'.repeat(5000)}F = eye(2)\n${REST}`, 0, /more than 20,000 letters/],
    [`F = eye(2)\nB = [0; 1]\nG = [0; 1]\n${REST}`, 0, /both are what an input does\. Give B another name if it/],
    [`F = eye(2)\nP0 = [1 2; 3 4]\n${REST}`, 2, /^P0: only the diagonal of the start can be set here/],
    [`F = eye(2)\nT = -1\n${REST}`, 0, /^The length of a step must be more than 0\.$/],
    [`F = eye(2)\nH = [1 0]\nQ = eye(2)`, 0, /^R, the noise of a reading, is missing\.$/],
  ]) {
    const found = read(text)
    assert.deepEqual([text, found.ok, found.line], [text, false, line], found.fault)
    assert.match(found.fault, /** @type {RegExp} */ (fault))
  }
})

test('what is of no use here is named, and what only sets things up is passed over', () => {
  const before = 'import numpy as np\nfrom math import pi\nclear all; clc\ndt = 0.1; x0 = [1; 2]\n'
  const text = `${before}F = eye(2)\n${REST}\ndisp(F)`
  assert.deepEqual([read(text).ok, read(text).unused], [true, ['x0']], read(text).fault)
  const one = `import numpy as np; G = [0; 1]\nF = eye(2)\n${REST}`
  assert.deepEqual(read(one).system?.G, [[0], [1]])
  const prompts = '>>> s = dict(F=[[1, 0],\n...  [0, 1]], H=[[1, 0]], V=[[1, 0], [0, 1]], W=[[1]],\n... G=[[0],[1]])'
  assert.deepEqual([read(prompts).system?.G, read(prompts).unused], [[[0], [1]], []], read(prompts).fault)
  const quoted = `name = 'a (b'\nF = eye(2)\n${REST}\nF(1,2) = 0.5`
  assert.deepEqual([read(quoted).system?.F[0], read(quoted).unused], [[1, 0.5], ['name']])
  const within = `# see a/*/b\nG = [0; 1]\n# and c/*/\nF = eye(2)\n${REST}`
  assert.deepEqual(read(within).system?.G, [[0], [1]])
  const inner = '{"old": {"G": [[9]]}, "F": [[1]], "H": [[1]], "V": [[1]], "W": [[1]]}'
  assert.deepEqual([read(inner).system?.G, read(inner).unused], [[[]], ['old']])
  const json = '{"name": "cart, by [hand]", "F": [[1]], "notes": {"a": [1, 2]}, "H": [[1]], "V": [[1]], "W": [[1]]}'
  assert.deepEqual([read(json).ok, read(json).unused], [true, ['name', 'notes']], read(json).fault)
})

test('whatever line is put wherever into a system is taken, named or a fault', () => {
  const { pick, below } = dice(7)
  const usual = ['F = eye(2)', 'H = [1 0]', 'V = eye(2)', 'W = 1']
  const taken = { 'G = [0; 1]': 'G', 'F(1,2) = 3': 'F' }
  const named = ['rate = 0.1', 'x0 = {1, 2}']
  const faults = [
    'F *= [1 2]',
    'F ^= 1',
    'print F',
    '7',
    '= 3',
    'F(1,2) == 3',
    'W == 2',
    'eye(2)',
    'V(1) = 2',
    'F[0:1] = 2',
  ]
  for (let i = 0; i < 2000; i += 1) {
    const more = pick([...Object.keys(taken), ...named, ...faults])
    const at = more === 'F(1,2) = 3' ? 1 + below(usual.length) : below(usual.length + 1)
    const lines = [...usual.slice(0, at), more, ...usual.slice(at)]
    const { ok, system, unused, line, fault } = read(lines.join('\n'))
    if (taken[more])
      assert.ok(ok && (taken[more] === 'G' ? system.G[1][0] === 1 : system.F[0][1] === 3), lines.join('\n'))
    else if (named.includes(more)) assert.deepEqual([ok, unused], [true, [more.split(' ')[0]]], lines.join('\n'))
    else assert.deepEqual([ok, line], [false, at + 1], `${lines.join('\n')}: ${fault}`)
  }
})

test('the letters of other books are read as ours, by their sizes where two books differ', () => {
  const matrices = (text) => {
    const { F, G, H, V, W } = read(text).system ?? {}
    return [F, G, H, V, W]
  }
  const ours = matrices('F = [1 1; 0 1]\nG = [0; 1]\nH = [1 0]\nV = [0 0; 0 2]\nW = 3')
  for (const [text, as] of [
    ['A = [1 1; 0 1]\nB = [0; 1]\nC = [1 0]\nQ = [0 0; 0 2]\nR = 3', 'A, B, C, Q, R read as F, G, H, V, W'],
    ['F = [1 1; 0 1]\nB = [0; 1]\nH = [1 0]\nQ = [0 0; 0 2]\nR = 3', 'B, Q, R read as G, V, W'],
    ['A = [1 1; 0 1]\nB = [0; 1]\nC = [1 0]\nR = [0 0; 0 2]\nQ = 3', 'A, B, C, R, Q read as F, G, H, V, W'],
    [
      'kf.F = np.array([[1, 1], [0, 1]])\nkf.B = np.array([[0], [1]])\nkf.H = np.array([[1, 0]])\n' +
        'kf.Q = np.diag([0, 2])\nkf.R = 3',
      'B, Q, R read as G, V, W',
    ],
  ])
    assert.deepEqual([text, matrices(text), read(text).as], [text, ours, as])
  assert.equal(read('F = 1\nH = 1\nV = 2\nW = 3').as, '')
})

test('names stand for what was given before, and the length of a step is known by its name', () => {
  const half = 'T = 0.5; F = [1 T; 0 1]; G = [T^2/2; T]; H = [1 0]; W = 0.5; '
  for (const text of [
    `${half}V = 0.1*G*G'`,
    `q = 0.1; ${half}V = q * [T^4/4, T^3/2; T^3/2, T^2]`,
    'import numpy as np\ndt = 0.5\nF = np.array([[1, dt], [0, 1]])\nG = np.array([[dt**2/2], [dt]])\n' +
      'H = np.array([[1, 0]])\nV = 0.1 * G @ G.T\nW = 1/2',
    `sigma = sqrt(0.1); ${half}V = (sigma^2)*G*G'`,
    `${half}V = [0 0; 0 0] + G*0.1*G' - zeros(2)`,
  ]) {
    const { system, unused, fault } = read(text)
    const close = (m, n) => m.flat().every((entry, i) => Math.abs(entry - n.flat()[i]) < 1e-15)
    assert.ok(system, `${text}: ${fault}`)
    assert.deepEqual(
      [system.F, system.G, system.period, unused],
      [
        [
          [1, 0.5],
          [0, 1],
        ],
        [[0.125], [0.5]],
        0.5,
        [],
      ],
      text,
    )
    assert.ok(
      close(system.V, [
        [0.0015625, 0.00625],
        [0.00625, 0.025],
      ]),
      text,
    )
  }
  // In brackets a blank parts two entries unless an operator stands between blanks.
  assert.deepEqual(read('a = 2; F = [1 -a; 0 - a 1]\nH = [1, - a]\nV = eye(2)\nW = 1').system.F, [
    [1, -2],
    [-2, 1],
  ])
})

test('a system is of continuous time, and its step has a length, where the text says so', () => {
  const slow = 'A = [0 1; -4 -0.4]\nC = [1 0]\nQ = eye(2)\nR = 1\n'
  for (const [text, continuous, period, unused] of [
    ['T = 0.2\nsys = ss(A, B, C, 0)', true, 0.2, []],
    ['sys = ss(A, B, C, 0, 0.1)', undefined, 0.1, []],
    ['sys = ss(A, B, C, 0, -1)', undefined, undefined, []],
    ['sys = ss(Ac, Bc, C, 0)', undefined, undefined, []],
    ['d = signal.cont2discrete((A, B, C, D), dt=0.1)', true, 0.1, []],
    ['d = StateSpace(A, B, C, D).to_discrete(0.1)', true, 0.1, []],
    ['Ts = 0.01; T = 10', undefined, 0.01, ['T']],
    ['Ts = 0.01; T = 10\nc2d(sys, T)', true, 10, ['Ts']],
    ['Ts = 0.1; dt = 0.1', undefined, 0.1, ['dt']],
  ]) {
    const found = read(slow + text)
    assert.deepEqual(
      [text, found.system?.continuous, found.system?.period, found.unused],
      [text, continuous, period, unused],
      found.fault,
    )
  }
  for (const [text, line, fault] of [
    ["T = 0.1\nd = c2d(sys, T, 'tustin')", 6, /^“tustin” is not done here: an input is held over a step \(“zoh”\)\.$/],
    ["d = sys.sample(0.1, method='bilinear')", 5, /^“bilinear” is not done here/],
    ['sys = ss(A, B, C, 0)', 0, /^The length of a step is missing: write T = …, in seconds\.$/],
    ['Ts = 0.2; dt = 0.3', 0, /^Ts is 0\.2 and dt is 0\.3, and both are the length of a step; give one\.$/],
    ['T = 0,01', 5, /^T: “0,01” is not a number\. Write 0\.01\.$/],
  ]) {
    const found = read(slow + text)
    assert.deepEqual([text, found.ok, found.line], [text, false, line])
    assert.match(found.fault, /** @type {RegExp} */ (fault))
  }
})

test('a start, a system in continuous time and nine states are taken as they are given', () => {
  const slow = 'A = [0 1; -1 -0.1]\nB = [0; 1]\nC = [1 0]\nD = 0\nQ = diag([0 0.1])\nR = 0.01\n'
  for (const [text, period] of [
    [`${slow}sys = ss(A, B, C, D); sampled = c2d(sys, 0.05);`, 0.05],
    [`${slow}Ts = 0.02\nsampled = c2d(ss(A, B, C, D), Ts, 'zoh')`, 0.02],
    [`${slow}dt = 0.02\n[Ad, Bd] = c2d(A, B, dt)`, 0.02],
    [`${slow}Ad, Bd, Cd, Dd, _ = signal.cont2discrete((A, B, C, D), 0.1)`, 0.1],
  ]) {
    const { system, unused, fault } = read(text)
    assert.deepEqual([text, system?.continuous, system?.period, unused], [text, true, period, []], fault)
  }
  for (const [text, spread] of [
    ['P0 = diag([1 4])', [1, 4]],
    ['P = [1, 4]', [1, 4]],
    ['kf.P *= 1000.', [1000, 1000]],
    ['P = eye(2)\nP *= 9', [9, 9]],
    ['P0 = 2', [2, 2]],
    ['P = np.eye(2)\nP[1, 1] = 7', [1, 7]],
  ])
    assert.deepEqual([text, read(`F = eye(2)\n${REST}\n${text}`).system?.spread], [text, spread])
  assert.equal(read(`F = eye(2)\n${REST}`).system.spread, undefined)
  const nine = read('n = 9\nF = eye(n)\nH = ones(1, 9)\nV = 0.1*eye(n)\nW = 1')
  assert.deepEqual([nine.system?.F.length, nine.unused], [9, []], nine.fault)
  assert.match(read('F = eye(10)\nH = ones(1, 9)\nV = 0.1\nW = 1').fault, /^F: at most 9 states are shown here\.$/)
})

test('what the core refuses of a paste has its line, the letter of the paste, and entries counted from 1', () => {
  const core = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
  const refused = (text) => {
    const { system, places } = read(text)
    try {
      core.OwnSystem.from({ version: 1, lab: 'own-system', step: 0, params: paramsOf(system) }).free()
    } catch (error) {
      return wordsOf(error, places)
    }
    return 'taken'
  }
  const before = 'A = [1 0.5; 0 1]\nC = [1 0]\n'
  assert.match(refused(`${before}Q = [1 2\n2 1]\nR = 1`), /^Line 3: Q .*negative eigenvalue/)
  assert.match(refused(`${before}Q = eye(2)\nR = -1`), /^Line 4: R .*negative eigenvalue/)
  assert.match(
    refused(`${before}Q = [1 0; 0.5 1]\nR = 1`),
    /^Line 3: Q: entries \((?:1, 2|2, 1)\) and \((?:1, 2|2, 1)\)/,
  )
  assert.equal(refused(`${before}Q = eye(2)\nR = 1`), 'taken')
})
