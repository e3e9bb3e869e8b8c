// A system of the reader's own: what is pasted is read or its fault is named, and what its presets promise holds.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { lettersOf, nameOf, sumOf } from '../../web/widgets/own-system/names.js'
import { PRESETS, paramsOf, systemOf } from '../../web/widgets/own-system/presets.js'
import { faultOf, numberOf, readSystem } from '../../web/widgets/own-system/read.js'
import { figure, handed } from '../../web/widgets/own-system/index.js'
import { rail } from './rail.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const open = (params, step = 0) => core.OwnSystem.from({ version: 1, lab: 'own-system', step, params })
/** The system that a text is. @param {string} text */
const systemIn = (text) => /** @type {any} */ (readSystem(text)).system

test('a system is read in JSON, in MATLAB and in numpy notation', () => {
  const texts = [
    JSON.stringify(rail),
    JSON.stringify(rail, null, 2),
    'F = [1 0.5; 0 1];\nG = [0; .5] % the input\nH = [1, 0]\nV = [0.2 0.05\n 0.05 0.1]\nW = 0.5',
    'import numpy as np\nF = np.array([[1., 1/2], [0, 1]])  # dynamics\nG = np.array([[0], [5e-1]])\n' +
      'H = np.array([[1, 0]])\nV = np.array([[.2, .05],\n              [.05, .1]])\nW = np.array([[0.5]])',
    'F = np.array([[1, 0.5], [0, 1]]); G = np.array([0, 0.5]); H = np.array([1, 0]); ' +
      'V = np.array([[0.2, 0.05], [0.05, 0.1]]); W = 0.5',
  ]
  for (const text of texts) assert.deepEqual(systemIn(text), rail, text)
  const without = systemIn('F = [1 0.5; 0 1]\nH = [1 0]\nV = [0.2 0.05; 0.05 0.1]\nW = 0.5')
  assert.deepEqual(without.G, [[], []])
})

test('a system is read as engineers have it: with comments, continued lines, transposes and factors', () => {
  const half = {
    ...rail,
    V: [
      [0.01, 0],
      [0, 0.01],
    ],
  }
  for (const text of [
    "F = [1 0.5; 0 1];% dynamics\r\nG = [0 0.5]';%input\r\nH = [1 0];\r\nV = 0.01*eye(2);\r\nW = .5;\r\n",
    'F = [1 0.5; ...  the first row\n 0 1]\nG=[0;0.5]; H=[1 0]; V=diag([0.01 0.01]); W=1/2',
    "%{\nF = [9 9; 9 9]\n%}\nF = [1, 0.5\n0, 1;];\nG = [0 0.5].'; H = [1;0]'; V = eye(2)*0.01; W = eye(1)/2",
    'import numpy as np\nF = np.array([[1, 0.5],\n              [0, 1],\n             ], dtype=float)\n' +
      'G = np.array([[0, 0.5]]).T\nH = np.array([[1, 0]])\nV = 1e-2 * np.eye(2)\nW = 0.5 * np.identity(1)',
    'F =\n\n    1.0000    0.5000\n         0    1.0000\n\nG =\n\n         0\n    0.5000\n\nH =\n\n     1     0\n' +
      '\nV =\n\n    0.0100         0\n         0    0.0100\n\nW =\n\n    0.5000\n',
    'F = array([[1. , 0.5],\n       [0. , 1. ]])\n' +
      'G = (1/2) * array([[0], [1]]); H = array([[1., 0.]]) # position\nV = np.diag([0.01, .01])\nW = 2*0.25',
    '{"note": "5% noise // by hand", "F": [[1, 0.5], [0, 1]], "G": [[0], [0.5]], "H": [[1, 0]], "V": ' +
      '[[0.01, 0], [0, 0.01]], "W": [[0.5]]}',
    'F = [1 0.5; 0 1] G = [0; 0.5] H = [1 0] W = 0.5\nV =\n\n   1.0e-02 *\n\n     1     0\n     0     1\n',
    'F = [1 .5; 0 1]; G = [0; .5]; H = [1 0]; V = 0.01*(eye(2)); W = 0.5',
    'F = [1 .5; 0 1]; G = [0; .5]; H = [1 0]; V = 0.01*diag(ones(2, 1)); W = 0.5*ones(1, 1)',
    'F = [1 .5; 0 1]; G = [0; .5]; H = [1 0]; V = 0.01 * np.diag(np.ones(2)); W = np.array(np.eye(1))/2',
  ])
    assert.deepEqual(systemIn(text), half, text)
})

test('a decimal comma, a product of matrices and a name of another book are told as what they are', () => {
  const whole = 'F = [1 0.5; 0 1]\nH = [1 0]\nV = [1 0; 0 1]\nW = 1'
  for (const [text, fault] of /** @type {[string, RegExp][]} */ ([
    [
      whole.replace('0.5', '0,5'),
      /^F: row 2 has 2 numbers, row 1 has 3\. A comma stands between numbers: write 0\.5 for 0,5\.$/,
    ],
    [whole.replace('[1 0; 0 1]', '[1 0; 0 1] + eye(3)'), /^V: a 2 × 2 and a 3 × 3 matrix have no sum\.$/],
    [whole.replace('[1 0; 0 1]', '[1 0; 0 1]*[1; 0; 1]'), /^V: a 2 × 2 and a 3 × 1 matrix have no product\.$/],
    [whole.replace('[1 0; 0 1]', 'np.eye(2) * np.eye(3)'), /^V: a 2 × 2 and a 3 × 3 matrix have no product\.$/],
    [whole.replace('[1 0; 0 1]', 'eye(n)'), /^V: “n” is not a number\.$/],
    [whole.replace('[1 0; 0 1]', 'eye(2)/0'), /^V: “\/ 0” is not understood/],
    [whole.replace('[1 0; 0 1]', 'np.diag((1, 1), 0, 2)'), /^V: “diag” does not take 3 values here\.$/],
    [whole.replace('[1 0.5; 0 1]', '[1 0.5 2; 0 1 2]'), /^F is 2 × 3; it has to be square\.$/],
    [whole.replace('1 0.5', '1,,0.5'), /^F, row 1, column 2: a number is missing\.$/],
    [whole.replace('[1 0; 0 1]', 'eye(2) W'), /^V: “W” is not understood/],
    [whole.replace('[1 0; 0 1]', '[1 0; 0 1]2'), /^V: “2” is not understood/],
    [whole.replace('W = 1', 'W = 2 3'), /^W: “3” is not understood/],
    [whole.replace('[1 0; 0 1]', '0.1 eye(2)'), /^V: “eye\(2\)” is not understood/],
    [
      '{"F":[[1,0],[0,1]],"H":[[1,0,0]],"V":[[1,0],[0,1]],"W":[[1]]}',
      /^H is 1 × 3; with F 2 × 2 it needs 2 columns\.$/,
    ],
    ['A = [1 2; 3 4]\nC = [1 0]', /^Q, the noise of the motion, is missing\.$/],
    ['A = 1\nF = 1\nC = 1\nQ = 1\nR = 1', /^F and A are both given, and both are what a step does to the state\.$/],
    ['A = 1\nB = 1\nC = 1\nD = 2\nQ = 1\nR = 1', /^D is not 0: a reading does not depend on the input here\.$/],
  ])) {
    const read = readSystem(text)
    assert.ok(!read.ok, text)
    assert.match(read.fault, fault)
  }
  assert.equal(faultOf('0,5'), '“0,5” is not a number. Write 0.5.')
})

test('what is wrong with a pasted system is named with its matrix', () => {
  const whole = 'F = [1 0.5; 0 1]\nH = [1 0]\nV = [1 0; 0 1]\nW = 1'
  for (const [text, fault] of /** @type {[string, RegExp][]} */ ([
    ['', /No matrix was found/],
    ['hello = 3', /No matrix was found/],
    [whole.replace('W = 1', ''), /^W, the noise of a reading, is missing\.$/],
    [whole.replace('1 0.5;', '1 0.5 3;'), /^F: row 2 has 2 numbers, row 1 has 3\.$/],
    [whole.replace('0.5', 'x'), /^F, row 1, column 2: “x” is not a number\.$/],
    [whole.replace('H = [1 0]', 'H = [1 0 0]'), /^H is 1 × 3; with F 2 × 2 it needs 2 columns\.$/],
    [whole.replace('F = [1 0.5; 0 1]', 'F = [1 0.5; 0 1'), /^F: a bracket is not closed\.$/],
    [`${whole}\nF = 1`, /^F is given twice\.$/],
    [whole.replace('[1 0.5; 0 1]', '[]'), /^F is empty\.$/],
    [whole.replace('[1 0.5; 0 1]', 'zeros(5) + [1 2; 3 4]'), /^F: a 5 × 5 and a 2 × 2 matrix have no sum\.$/],
    [whole.replace('0.5', '1e999'), /is not a number/],
  ])) {
    const read = readSystem(text)
    assert.ok(!read.ok, text)
    assert.match(read.fault, fault)
  }
})

test('a number may have a true minus sign, an exponent or be a fraction', () => {
  assert.deepEqual(['1', '−2.5', '.5', '1e-3', '1/4', ' 7 '].map(numberOf), [1, -2.5, 0.5, 1e-3, 0.25, 7])
  for (const text of ['', 'a', '1,5', '1/0', '1/2/3', '0x10', '--1', 'Infinity'])
    assert.ok(Number.isNaN(numberOf(text)), text)
})

test('a name comes back from its numbers, and a direction is a sum of names', () => {
  const params = { names: ['position', 'a_b*c', '', 'Lageänderung viel zu lang'].map(lettersOf) }
  assert.deepEqual(
    [0, 1, 2, 3].map((i) => nameOf(params, i)),
    ['position', 'abc', 'x₃', 'Lageänderung'],
  )
  assert.equal(sumOf([1, 0, -0.5, 0.0012], params), 'position − 0.5 · x₃ + 1.2e−3 · Lageänderung')
})

test('every preset is a system that the lab takes, and gets the verdicts its name promises', () => {
  const expected = {
    'Constant velocity, 0.5 s': ['yes', 'yes', 'from-every-start'],
    'Constant velocity, velocity read': ['no', 'no', 'none'],
    'Constant acceleration, 0.5 s': ['yes', 'yes', 'from-every-start'],
    'Pendulum, 0.1 s': ['yes', 'yes', 'from-every-start'],
    'DC motor, 0.05 s': ['yes', 'yes', 'from-every-start'],
    'Bias plus sensor': ['no', 'no', 'depends-on-start'],
    'Two tanks, 1 s': ['yes', 'yes', 'from-every-start'],
    'Height, speed and bias, 0.01 s': ['yes', 'yes', 'from-every-start'],
    'Mass on a spring, continuous time': ['yes', 'yes', 'from-every-start'],
    'Acceleration in space, continuous time': ['yes', 'yes', 'from-every-start'],
  }
  for (const preset of PRESETS) {
    const { observable, detectable, limit, params } = open(paramsOf(preset)).frame()
    assert.deepEqual([observable, detectable, limit], expected[preset.name], preset.name)
    const { F, G, H, V, W } = preset
    assert.deepEqual(systemOf(params), { F, G, H, V, W })
  }
})

test('the functions of the module and the lab give one answer', () => {
  for (const preset of PRESETS) {
    const frame = open(paramsOf(preset)).frame()
    const { H, W } = preset
    const { F, G, V } = frame
    const seen = core.detectability(F, H, frame.tolerance)
    const noise = core.noiseReach(F, V, frame.tolerance)
    assert.deepEqual(
      [seen.observable, seen.detectable, noise.reachable, noise.stabilizable],
      [frame.observable, frame.detectable, frame.noise.reachable, frame.noise.stabilizable],
    )
    const system = { F, G, H, V, W }
    assert.equal(core.riccatiLimit(system, frame.tolerance), frame.limit)
    const { K, fixed } = core.placeMovable(
      F,
      H,
      Array.from({ length: frame.movable }, (_, i) => 0.1 * (i + 1)),
    )
    const found = core.errorEigenvalues(system, K).map(({ re }) => re)
    for (let i = 0; i < frame.movable; i++)
      assert.ok(
        // Nine eigenvalues of one gain are known to fewer digits than two.
        found.some((re) => Math.abs(re - 0.1 * (i + 1)) < (frame.movable > 4 ? 1e-5 : 1e-6)),
        `${preset.name}: ${found}`,
      )
    assert.equal(fixed.length, F.length - frame.movable)
  }
  assert.deepEqual(
    core.stabilizability(
      [
        [1, 0.5],
        [0, 1],
      ],
      [[0], [0.5]],
    ).reachable,
    'yes',
  )
})

test('a gain by hand begins with that of the filter, and with 0 where only rounding stands', () => {
  const K = [
    [0.5, -4e-16],
    [3e-15, 1e-9],
  ]
  assert.deepEqual(handed(K), [
    [0.5, 0],
    [0, 1e-9],
  ])
  assert.deepEqual(handed([[0], [0]]), [[0], [0]])
  const { set } = /** @type {any} */ (figure.controls.find(({ name }) => name === 'gain'))
  assert.deepEqual(set('hand', { k: [] }, { K }).k[0].slice(0, 2), [0.5, 0])
})

test('beside a gain that is no good it is said whose covariance settles, and that an error need not die out', () => {
  const [cart] = PRESETS
  const params = { ...paramsOf(cart), gain: 'hand', k: [-30, 5, 0, 0].map((entry) => [entry, 0, 0, 0]) }
  const words = /** @type {any} */ (figure).verdict(open(params, 60).frame())
  assert.match(words, /The filter’s covariance tends to one limit .* it settles in \d+ steps/)
  assert.match(words, /has left every bound and stands still\. With this gain .*, so an error need not die out\.$/)
})
