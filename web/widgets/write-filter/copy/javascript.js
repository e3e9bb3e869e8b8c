/** A program as JavaScript without a package: matrices as lists of rows, and the few functions that it calls. */

import { caller } from './calls.js'
import { head, identifiers, ofEachStep, remarks, source, TOLERANCE } from './frame.js'
import { helpersOf } from './helpers.js'
import { RESERVED } from './reserved.js'
import { typed } from './typed.js'

/** @type {Record<string, string>} */
const HELPERS = {
  add: 'const add = (A, B) => A.map((row, i) => row.map((a, j) => a + B[i][j]))',
  subtract: 'const subtract = (A, B) => A.map((row, i) => row.map((a, j) => a - B[i][j]))',
  multiply: `const multiply = (A, B) =>
  A.map((row) => (B[0] ?? [0]).map((_, j) => row.reduce((sum, a, k) => sum + a * B[k][j], 0)))`,
  scale: 'const scale = (by, A) => A.map((row) => row.map((a) => by * a))',
  each: 'const each = (f, A) => A.map((row) => row.map((a) => f(a)))',
  transposed: 'const transposed = (A) => A[0].map((_, j) => A.map((row) => row[j]))',
  zeros: 'const zeros = (rows, columns) => Array.from({ length: rows }, () => Array(columns).fill(0))',
  identity: 'const identity = (n) => zeros(n, n).map((row, i) => row.map((_, j) => (i === j ? 1 : 0)))',
  block: 'const block = (A, top, bottom, left, right) => A.slice(top, bottom).map((row) => row.slice(left, right))',
  beside: 'const beside = (A, B) => A.map((row, i) => [...row, ...B[i]])',
  below: 'const below = (A, B) => [...A, ...B]',
  put: `const put = (A, top, left, B) =>
  A.map((row, i) => row.map((a, j) => B[i - top]?.[j - left] ?? a))`,
  diagonal: 'const diagonal = (A) => A.map(([a], i) => A.map((_, j) => (i === j ? a : 0)))',
  diagonalOf: 'const diagonalOf = (A) => A.map((row, i) => [row[i]])',
  symmetric: 'const symmetric = (A) => A.map((row, i) => row.map((a, j) => (a + A[j][i]) / 2))',
  trace: 'const trace = (A) => A.reduce((sum, row, i) => sum + row[i], 0)',
  norm: 'const norm = (A) => Math.hypot(...A.flat())',
  wrap: `// An angle in (−π, π].
const wrap = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI))`,
  eliminated: `// Gauss’s elimination with the largest pivot of each column: A⁻¹ B, and det A.
function eliminated(A, B) {
  const rows = A.map((row, i) => [...row, ...B[i]])
  let determinant = 1
  rows.forEach((_, k) => {
    let best = k
    for (let i = k; i < rows.length; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[best][k])) best = i
    if (best !== k) [rows[k], rows[best], determinant] = [rows[best], rows[k], -determinant]
    const pivot = rows[k][k]
    determinant *= pivot
    if (pivot === 0) return
    rows[k] = rows[k].map((a) => a / pivot)
    rows.forEach((row, i) => {
      const by = row[k]
      if (i !== k) rows[i] = row.map((a, j) => a - by * rows[k][j])
    })
  })
  return { solution: rows.map((row) => row.slice(A.length)), determinant }
}`,
  determinant: 'const determinant = (A) => eliminated(A, A.map(() => [])).determinant',
  solve: `function solve(A, B) {
  const { solution, determinant } = eliminated(A, B)
  if (determinant === 0) throw new Error('A matrix that is divided by has no inverse.')
  return solution
}`,
  cholesky: `// The lower triangle L with L Lᵀ = A.
function cholesky(A) {
  const L = A.map((row) => row.map(() => 0))
  A.forEach((row, i) => {
    for (let j = 0; j <= i; j++) {
      let rest = row[j]
      for (let k = 0; k < j; k++) rest -= L[i][k] * L[j][k]
      if (i === j && !(rest > 0)) throw new Error('A matrix whose root is taken is not positive definite.')
      L[i][j] = i === j ? Math.sqrt(rest) : rest / L[j][j]
    }
  })
  return L
}`,
  f: `// Where the robot is after a move: along its heading, then the turn.
const f = ([[x], [y], [heading]], [[s], [turn]]) => [
  [x + s * Math.cos(heading)],
  [y + s * Math.sin(heading)],
  [wrap(heading + turn)],
]`,
  h: `// Range and bearing of a landmark, the bearing from the landmark.
const h = ([[x], [y], [heading]], [[markX], [markY]]) => [
  [Math.hypot(x - markX, y - markY)],
  [wrap(Math.atan2(y - markY, x - markX) - heading)],
]`,
}
/** @type {Record<string, string[]>} */
const NEED = { identity: ['zeros'], determinant: ['eliminated'], solve: ['eliminated'], f: ['wrap'], h: ['wrap'] }

/** @param {number[][]} m */
const list = (m) => JSON.stringify(m).replace(/,/g, ', ')

/** @param {import('./frame.js').Frame} frame */
export function javascript(frame) {
  const { given, x, P, start, constants, varying, steps } = frame
  const names = identifiers([x, P, ...given, ...frame.lines.map(({ name }) => name)], RESERVED.javascript, HELPERS)
  const name = (/** @type {string} */ one) => names.get(one) ?? one
  const lines = typed(frame.lines, new Set([x, P, ...given]))
  const { text, called } = caller({
    number: String,
    entry: (m, i, j) => `${m}[${i}][${j}]`,
    literal: (rows) => `[${rows.map((row) => `[${row.join(', ')}]`).join(', ')}]`,
    scalar: (word) => ({ wrap: 'wrap', pi: 'Math.PI' })[word] ?? `Math.${word}`,
    name,
  })
  const known = new Set([x, P, ...given])
  const body = lines.map(({ name: made, part, sides, value }, i) => {
    let line = text(value)
    const whole = sides[0] === 1 && sides[1] === 1 && !known.has(made)
    if (part && !whole) {
      const [top, bottom, left, right] = part
      const one = bottom - top === 1 && right - left === 1
      called.add('put')
      line = `put(${name(made)}, ${top}, ${left}, ${one ? `[[${line}]]` : line})`
    }
    const first = !known.has(made)
    known.add(made)
    const { formula, remark } = source(frame, i)
    const said = [...remarks(frame, i), remark ? `${formula}; ${remark}` : formula]
    return `${said.map((words) => `  // ${words}\n`).join('')}  ${first ? 'let ' : ''}${name(made)} = ${line}\n`
  })
  const helpers = helpersOf(HELPERS, NEED, called).map((one) => `${HELPERS[one]}\n`)
  const rows = steps.map((step) => `  [${step.map(list).join(', ')}],\n`)
  const inputs = [x, P, ...given].map(name)
  return `${head('//', frame, 'No package is needed: node filter.mjs')}
// Matrices are lists of rows; a column has one number in each row.
${helpers.join('\n')}
function step(${inputs.join(', ')}) {
${body.join('')}  return [${name(x)}, ${name(P)}]
}

${constants.map(([one, m]) => `const ${name(one)} = ${list(m)}\n`).join('')}// ${ofEachStep(varying.map(name))}
const STEPS = [
${rows.join('')}]

let [${name(x)}, ${name(P)}] = [${start.map(list).join(', ')}]
STEPS.forEach(([${[...varying.map(name), 'expectedX', 'expectedP'].join(', ')}], k) => {
  ;[${name(x)}, ${name(P)}] = step(${inputs.join(', ')})
  for (const [found, expected] of [[${name(x)}, expectedX], [${name(P)}, expectedP]]) {
    const most = ${TOLERANCE} * Math.max(1, ...expected.flat().map(Math.abs))
    const off = Math.max(...expected.flat().map((one, i) => Math.abs(one - found.flat()[i])))
    if (!(off <= most)) throw new Error(\`Step \${k + 1} is off by \${off}.\`)
  }
})
console.log(\`Steps that are right: \${STEPS.length}.\`)
`
}
