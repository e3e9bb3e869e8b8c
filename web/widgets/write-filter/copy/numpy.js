/** A program as Python on numpy. */

import { head, identifiers, ofEachStep, remarks, source, TOLERANCE } from './frame.js'
import { helpersOf } from './helpers.js'
import { isNumber } from './node.js'
import { printer } from './ranks.js'
import { RESERVED } from './reserved.js'

/** @typedef {import('./node.js').Node} Node */
/** @typedef {import('./ranks.js').Ranked} Ranked */

/** @type {Record<string, string>} */
const HELPERS = {
  wrap: `def wrap(angle):
    """An angle in (-pi, pi]."""
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))
`,
  symmetric: `def symmetric(a):
    return (a + a.T) / 2
`,
  f: `def f(x, u):
    """Where the robot is after a move: along its heading, then the turn."""
    heading = x[2, 0]
    return np.array([
        [x[0, 0] + u[0, 0] * np.cos(heading)],
        [x[1, 0] + u[0, 0] * np.sin(heading)],
        [wrap(heading + u[1, 0])],
    ])
`,
  h: `def h(x, l):
    """Range and bearing of a landmark, the bearing from the landmark."""
    dx, dy = x[0, 0] - l[0, 0], x[1, 0] - l[1, 0]
    return np.array([[np.hypot(dx, dy)], [wrap(np.arctan2(dy, dx) - x[2, 0])]])
`,
}
/** @type {Record<string, string[]>} */
const NEED = { f: ['wrap'], h: ['wrap'] }

/** @param {string} one @param {number} [rank] @returns {Ranked} */
const of = (one, rank = 5) => [one, rank]
/** @param {string} module */
const call = (module) => (/** @type {Node} */ it, /** @type {(part: Node) => string} */ text) =>
  of(`${module}(${it.parts.map((part) => text(part)).join(', ')})`)
/** @param {[number, number]} sides */
const shape = (sides) => `np.zeros((${sides.join(', ')}))`
/** From and to, or one row. @param {number} from @param {number} to @param {number} all */
const slice = (from, to, all) => (from === 0 && to === all ? ':' : `${from}:${to}`)

/**
 * Where in a matrix a part is; a part of one entry is a number.
 * @param {number[]} ends @param {[number, number]} whole
 */
function place([top, bottom, left, right], [rows, columns]) {
  if (bottom - top === 1 && right - left === 1) return `[${top}, ${left}]`
  if (left === 0 && right === columns) return `[${slice(top, bottom, rows)}]`
  return `[${slice(top, bottom, rows)}, ${slice(left, right, columns)}]`
}

/** @param {(name: string) => string} name @param {Set<string>} called */
function pythonPrinter(name, called) {
  const own = (/** @type {string} */ one) => (/** @type {Node} */ it, /** @type {(part: Node) => string} */ text) => {
    called.add(one)
    return call(one)(it, text)
  }
  /** @type {Parameters<typeof printer<Node>>[0]} */
  const words = {
    number: (it) => of(String(it.number)),
    pi: () => of('np.pi'),
    name: (it) => of(name(it.name)),
    eye: (it) => of(`np.eye(${it.sides[0]})`),
    zeros: (it) => of(shape(it.sides)),
    negative: ({ parts: [a] }, text) => of(`-${text(a, 4)}`, 3),
    // Between matrices @; where a number, or a matrix of one entry, scales a matrix *.
    times: ({ parts: [a, b] }, text) => of(`${text(a, 2)} ${isNumber(a) || isNumber(b) ? '*' : '@'} ${text(b, 3)}`, 2),
    over: ({ parts: [a, b] }, text) =>
      isNumber(b)
        ? of(`${text(a, 2)} / ${text(b, 3)}`, 2)
        : of(`np.linalg.solve(${text(b, 4)}.T, ${text(a, 4)}.T).T`, 4),
    under: ({ parts: [a, b] }, text) =>
      isNumber(a) ? of(`${text(b, 2)} / ${text(a, 3)}`, 2) : of(`np.linalg.solve(${text(a)}, ${text(b)})`),
    inv: ({ parts: [a] }, text) => (isNumber(a) ? of(`1 / ${text(a, 3)}`, 2) : of(`np.linalg.inv(${text(a)})`)),
    transpose: ({ parts: [a] }, text) => (isNumber(a) ? of(text(a, 5)) : of(`${text(a, 4)}.T`, 4)),
    power: ({ parts: [a], number }, text) =>
      isNumber(a) ? of(`${text(a, 5)} ** ${number}`, 3) : of(`np.linalg.matrix_power(${text(a)}, ${number})`),
    part: ({ parts: [a], ends = [] }, text) =>
      isNumber(a) ? of(text(a, 5)) : of(`${text(a, 4)}${place(ends, a.sides)}`, 4),
    row: (it, text) => of(block([it.parts], text)),
    stack: (it, text) =>
      of(
        block(
          it.parts.map((row) => (row.word === 'row' ? row.parts : [row])),
          text,
        ),
      ),
    diag: ({ parts: [a] }, text) =>
      isNumber(a)
        ? of(text(a, 5))
        : a.sides[1] === 1
          ? of(`np.diag(${text(a, 4)}[:, 0])`)
          : of(`np.diag(${text(a)}).reshape(-1, 1)`, 4),
    sqrt: call('np.sqrt'),
    sin: call('np.sin'),
    cos: call('np.cos'),
    exp: call('np.exp'),
    abs: call('np.abs'),
    atan2: call('np.arctan2'),
    hypot: call('np.hypot'),
    norm: call('np.linalg.norm'),
    det: ({ parts: [a] }, text) => (isNumber(a) ? of(text(a, 5)) : of(`np.linalg.det(${text(a)})`)),
    trace: ({ parts: [a] }, text) => (isNumber(a) ? of(text(a, 5)) : of(`np.trace(${text(a)})`)),
    chol: ({ parts: [a] }, text) => (isNumber(a) ? of(`np.sqrt(${text(a)})`) : of(`np.linalg.cholesky(${text(a)})`)),
    sym: ({ parts: [a] }, text) => {
      if (isNumber(a)) return of(text(a, 5))
      called.add('symmetric')
      return of(`symmetric(${text(a)})`)
    },
    wrap: own('wrap'),
    f: own('f'),
    h: own('h'),
  }
  /**
   * np.block takes numbers and matrices beside one another.
   * @param {Node[][]} rows @param {(part: Node) => string} text
   */
  const block = (rows, text) =>
    `np.block([${rows.map((row) => `[${row.map((part) => text(part)).join(', ')}]`).join(', ')}])`
  return printer(words)
}

/** What may be another name’s matrix, seen otherwise. */
const SHARES = ['name', 'part', 'transpose', 'row', 'stack']
/** What is a float of Python’s whatever it is made of, and what is one where its parts are. */
const FLOATS = ['number', 'pi', 'norm', 'det', 'trace']
const OF_FLOATS =
  'plus minus times over under negative power sqrt sin cos exp abs wrap atan2 hypot inv sym transpose diag chol'.split(
    ' ',
  )

/**
 * Whether a formula is a float, and no matrix of one entry.
 * @param {Node} it @param {Set<unknown>} floats @returns {boolean}
 */
function isFloat(it, floats) {
  if (!isNumber(it)) return false
  if (it.word === 'name') return floats.has(it.name)
  if (it.word === 'part' && !isNumber(it.parts[0])) return true
  if (FLOATS.includes(it.word) && !(it.word !== 'norm' && it.parts[0] && isNumber(it.parts[0]))) return true
  return [...OF_FLOATS, 'part', 'det', 'trace'].includes(it.word) && it.parts.every((part) => isFloat(part, floats))
}

/** @param {number[][]} m */
function data(m) {
  const [rows, columns] = [m.length, m[0]?.length ?? 1]
  if (rows * columns === 0) return shape([rows, columns])
  const list = (/** @type {unknown} */ it) => JSON.stringify(it).replace(/,/g, ', ')
  return columns === 1 ? `column(${list(m.flat())})` : `np.array(${list(m)}, dtype=float)`
}

/** @param {import('./frame.js').Frame} frame */
export function numpy(frame) {
  const { given, x, P, start, constants, varying, steps, lines } = frame
  const names = identifiers([x, P, ...given, ...lines.map((line) => line.name)], RESERVED.python, HELPERS)
  const name = (/** @type {string} */ one) => names.get(one) ?? one
  /** @type {Set<string>} */
  const called = new Set()
  const text = pythonPrinter(name, called)
  // What is filled in part must be no other name’s matrix too.
  const own = new Set()
  const floats = new Set()
  const body = lines.map(({ name: made, part, sides, value }, i) => {
    const [it, float] = [text(value), isFloat(value, floats)]
    const said = remarks(frame, i).map((words) => `# ${words}`)
    if (part && sides[0] * sides[1] > 1) {
      if (!own.has(made)) said.push(`${name(made)} = ${name(made)}.copy()`)
      own.add(made)
      const number = part[1] - part[0] === 1 && part[3] - part[2] === 1 && !float
      said.push(`${name(made)}${place(part, sides)} = ${number ? `(${it}).item()` : it}`)
    } else {
      floats[float ? 'add' : 'delete'](made)
      own[SHARES.includes(value.word) ? 'delete' : 'add'](made)
      if (value.word === 'name') own.delete(value.name)
      said.push(`${name(made)} = ${it}`)
    }
    const { remark } = source(frame, i)
    return `${said.map((line) => `    ${line}`).join('\n')}${remark && `  # ${remark}`}\n`
  })
  const helpers = helpersOf(HELPERS, NEED, called).map((one) => `\n${HELPERS[one]}\n`)
  const inputs = [x, P, ...given].map(name)
  return `${head('#', frame, 'It needs numpy: python3 filter.py')}import numpy as np

${helpers.join('')}
def column(entries):
    return np.array(entries, dtype=float).reshape(-1, 1)

def step(${inputs.join(', ')}):
    """The estimate and its covariance behind one step."""
${body.join('')}    return ${name(x)}, ${name(P)}

${constants.map(([one, m]) => `${name(one)} = ${data(m)}\n`).join('')}# ${ofEachStep(varying.map(name))}
STEPS = [
${steps.map((step) => `    (${step.map(data).join(', ')}),\n`).join('')}]

${name(x)}, ${name(P)} = ${start.map(data).join(', ')}
for k, (${[...varying.map(name), 'expected_x', 'expected_P'].join(', ')}) in enumerate(STEPS):
    ${name(x)}, ${name(P)} = step(${inputs.join(', ')})
    for found, expected in ((${name(x)}, expected_x), (${name(P)}, expected_P)):
        off = np.max(np.abs(found - expected)) / max(1, np.max(np.abs(expected)))
        if not off <= ${TOLERANCE} or found.shape != expected.shape:
            raise SystemExit(f"Step {k + 1} is off by {off}.")
print(f"Steps that are right: {len(STEPS)}.")
`
}
