// Sums, products and functions of a paste are what MATLAB or numpy make of them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { Expression } from '../../web/widgets/own-system/expression.js'

const T = 0.1
const GIVEN = {
  T: [[T]],
  a: [[2]],
  G: [[0.005], [0.1]],
  M: [
    [1, 0.1],
    [0, 1],
  ],
  N: [
    [2, 1],
    [1, 3],
  ],
}

/** What a text is worth. @param {string} text @param {boolean} [numpy] */
const worth = (text, numpy = /\bnp\./.test(text)) =>
  new Expression(text, 'V', { numpy, get: (name) => GIVEN[/** @type {'T'} */ (name)] }).read()

/** @param {string} text @param {number[][]} expected */
function comesTo(text, expected) {
  const value = worth(text)
  const near = value.flat().every((x, i) => Math.abs(x - expected.flat()[i]) <= 1e-12 * (1 + Math.abs(x)))
  assert.ok(
    near && value.length === expected.length && value[0].length === expected[0].length,
    `${text}: ${value.join('; ')}`,
  )
}

/** @param {number} a @param {number} b @param {number} c @param {number} d */
const two = (a, b, c, d) => [
  [a, b],
  [c, d],
]

test('a sum ends where a product ends, with blanks about its sign and without', () => {
  for (const [text, ...entries] of /** @type {[string, number, number, number, number][]} */ ([
    ["G*G'*0.3+0.01*eye(2)", 0.0100075, 0.00015, 0.00015, 0.013],
    ["G*G'*0.3 + 0.01*eye(2)", 0.0100075, 0.00015, 0.00015, 0.013],
    ['a^2*N*0.1+0.5*M', 1.3, 0.45, 0.4, 1.7],
    ['0.1+0.5*[1 0.1;0 1]', 0.6, 0.15, 0.1, 0.6],
    ['[1 0.1;0 1]/2-0.1', 0.4, -0.05, -0.1, 0.4],
    ['eye(2)*0.9+0.1', 1, 0.1, 0.1, 1],
    ['eye(2)*0.1+1e-3', 0.101, 0.001, 0.001, 0.101],
    ['eye(2)*0.9+[0 0.1;0 0]', 0.9, 0.1, 0, 0.9],
    ['2*-M+M*3', 1, 0.1, 0, 1],
    ['-(M-N)*2^-1', 0.5, 0.45, 0.5, 1],
    ['[1 -T; 0 - T 1]', 1, -0.1, -0.1, 1],
    ['[a -T; a-1, 2*T ^2]', 2, -0.1, 1, 0.02],
    ['np.array([[1, a -1], [0, 1]])', 1, 1, 0, 1],
    ["[1 2]'+[3 4]", 4, 5, 5, 6],
  ]))
    comesTo(text, two(...entries))
})

test('powers, quotients and products are those of matrices or of entries, as the language has them', () => {
  for (const [text, expected] of /** @type {[string, number[][]][]} */ ([
    ['2^3^2', [[64]]],
    ['2**3**2', [[512]]],
    ['-2^2', [[-4]]],
    ['2^-1', [[0.5]]],
    ['1 - 2 - 3', [[-4]]],
    ['8/2/2', [[2]]],
    ['8/2*3', [[12]]],
    ['N^2', two(5, 5, 5, 10)],
    ['N.^2', two(4, 1, 1, 9)],
    ['N^-1', two(0.6, -0.2, -0.2, 0.4)],
    ['N*M', two(2, 1.2, 1, 3.1)],
    ['N.*M', two(2, 0.1, 0, 3)],
    ['N/M', two(2, 0.8, 1, 2.9)],
    ['N\\M', two(0.6, -0.14, -0.2, 0.38)],
    ['np.eye(2)*N', two(2, 0, 0, 3)],
    ['N @ M + 0*np.pi', two(2, 1.2, 1, 3.1)],
    ['np.linalg.matrix_power(N, 3)', two(15, 20, 20, 35)],
    ['N.dot(M)', two(2, 1.2, 1, 3.1)],
    ['np.dot(np.array([1, 2]), np.array([3, 4]))', [[11]]],
    ['np.array([1, 2]).T', [[1, 2]]],
    ['N @ np.array([1, 2])', [[4, 7]]],
    ['np.outer([1, 2], [3, 4])', two(3, 4, 6, 8)],
  ]))
    comesTo(text, expected)
})

test('matrices of blocks, and functions that make matrices', () => {
  for (const [text, expected] of /** @type {[string, number[][]][]} */ ([
    [
      '[eye(2) T*eye(2); zeros(2) eye(2)]',
      [
        [1, 0, 0.1, 0],
        [0, 1, 0, 0.1],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
    ],
    ['[T^2/2*eye(2); T*eye(2)]', [...two(0.005, 0, 0, 0.005), ...two(0.1, 0, 0, 0.1)]],
    [
      'np.block([[np.eye(2), np.zeros((2, 1))], [np.ones((1, 2)), np.array([[7]])]])',
      [
        [1, 0, 0],
        [0, 1, 0],
        [1, 1, 7],
      ],
    ],
    [
      'np.hstack([np.eye(2), np.ones((2, 1))])',
      [
        [1, 0, 1],
        [0, 1, 1],
      ],
    ],
    ['np.vstack((np.array([1, 2]), [3, 4]))', two(1, 2, 3, 4)],
    ['np.array([np.array([1, 2]), np.array([3, 4])])', two(1, 2, 3, 4)],
    [
      'kron(eye(2), [1 T])',
      [
        [1, 0.1, 0, 0],
        [0, 0, 1, 0.1],
      ],
    ],
    [
      'blkdiag(N, 5)',
      [
        [2, 1, 0],
        [1, 3, 0],
        [0, 0, 5],
      ],
    ],
    [
      'diag([1 2], 1)',
      [
        [0, 1, 0],
        [0, 0, 2],
        [0, 0, 0],
      ],
    ],
    ['diag(N)', [[2], [3]]],
    [
      'np.diag(np.ones(2), -1)',
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 1, 0],
      ],
    ],
    ['inv(N)', two(0.6, -0.2, -0.2, 0.4)],
    ['expm([0 1; 0 0]*T)', two(1, 0.1, 0, 1)],
    ['expm([1 0; 0 -3])', two(Math.E, 0, 0, Math.exp(-3))],
    ['expm([0 1; -1 0]*pi/2)', two(0, 1, -1, 0)],
    ['expm(diag([-40 20]))', two(Math.exp(-40), 0, 0, Math.exp(20))],
    ['sqrt([4 9; 16 25])', two(2, 3, 4, 5)],
    ['[[1;2], [3;4]]', two(1, 3, 2, 4)],
    ['\n[[ 1.   0.5]\n [ 0.  -1. ]]', two(1, 0.5, 0, -1)],
    ['\n\nDiagonal Matrix\n\n   1   0\n   0   2\n', two(1, 0, 0, 2)],
    [
      '\n\n  Columns 1 through 2\n\n     1     2\n     3     4\n\n  Column 3\n\n     5\n     6\n',
      [
        [1, 2, 5],
        [3, 4, 6],
      ],
    ],
    ['\n        x1   x2\n   x1    1  0.1\n   x2    0    1\n', two(1, 0.1, 0, 1)],
  ]))
    comesTo(text, expected)
})

test('what cannot be read is a fault that names what troubles', () => {
  for (const [text, fault] of /** @type {[string, RegExp][]} */ ([
    ['eye(2)*rand(2)', /^V: “rand\(2\)” is not understood here/],
    ['[1 0; 0 n]', /^V, row 2, column 2: “n” is not a number\.$/],
    ['[[1, 0], [0, n]]', /^V, row 2, column 2: “n” is not a number\.$/],
    ['inv([1 2; 2 4])', /^V: a matrix has no inverse\.$/],
    ['N^0.5', /^V: a matrix has no power of 0\.5 here\.$/],
    ['N*[1 2 3]', /^V: a 2 × 2 and a 1 × 3 matrix have no product\.$/],
    ['[eye(2) 1]', /^V: matrices of different heights stand in one row\.$/],
    ['[eye(2); 1]', /^V: row 2 has 1 number, row 1 has 2\.$/],
    ['sqrt(-1)', /^V: a number that comes of it is not finite\.$/],
    ['0,5', /^V: “0,5” is not a number\. Write 0\.5\.$/],
    ['N(1,2)', /^V: “N\(1,2\)” is not understood here/],
    ['np.eye(2)^2', /^V: “\^” is not understood here/],
    ['np.array([np.eye(2), np.eye(2)])', /^V is not a list of rows\.$/],
    [`${'('.repeat(1000)}1${')'.repeat(1000)}`, /^V: more than 60 brackets or powers are within one another\.$/],
    [`2${'**2'.repeat(5000)}`, /^V: more than 60 brackets or powers are within one another\.$/],
  ]))
    assert.throws(() => worth(text), { message: fault }, text)
})
