/** A program as Rust on nalgebra, the matrices of this book’s crates: each has its size in its type. */

import { head, identifiers, ofEachStep, remarks, source, TOLERANCE } from './frame.js'
import { helpersOf } from './helpers.js'
import { isNumber } from './node.js'
import { RESERVED } from './reserved.js'
import { typed, written } from './typed.js'

/** @typedef {import('./node.js').Node} Node */

/** @type {Record<string, string>} */
const HELPERS = {
  symmetric: `fn symmetric<const N: usize>(a: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    0.5 * (a + a.transpose())
}`,
  wrap: `/// An angle in (−π, π].
fn wrap(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}`,
  f: `/// Where the robot is after a move: along its heading, then the turn.
fn f(x: SMatrix<f64, 3, 1>, u: SMatrix<f64, 2, 1>) -> SMatrix<f64, 3, 1> {
    matrix![x[0] + u[0] * x[2].cos(); x[1] + u[0] * x[2].sin(); wrap(x[2] + u[1])]
}`,
  h: `/// Range and bearing of a landmark, the bearing from the landmark.
fn h(x: SMatrix<f64, 3, 1>, l: SMatrix<f64, 2, 1>) -> SMatrix<f64, 2, 1> {
    let (dx, dy) = (x[0] - l[0], x[1] - l[1]);
    matrix![dx.hypot(dy); wrap(dy.atan2(dx) - x[2])]
}`,
}
/** @type {Record<string, string[]>} */
const NEED = { f: ['wrap'], h: ['wrap'] }

/** @type {Record<string, [string, number]>} */
const SIGNS = {
  plus: ['+', 1],
  minus: ['-', 1],
  times: ['*', 2],
  scale: ['*', 2],
  over: ['/', 2],
  shrink: ['/', 2],
}
/** @type {Record<string, string>} */
const METHODS = {
  transpose: 'transpose()',
  det: 'determinant()',
  trace: 'trace()',
  norm: 'norm()',
  inv: 'try_inverse().expect("a matrix that has an inverse")',
  chol: 'cholesky().expect("a matrix that is positive definite").l()',
}
const MAPS = ['sqrt', 'sin', 'cos', 'exp', 'abs']

/** @param {number} x */
const float = (x) => (Number.isInteger(x) && Math.abs(x) < 1e21 ? x.toFixed(1) : String(x).replace('e+', 'e'))
/** @param {[number, number]} sides */
const type = ([rows, columns]) => `SMatrix<f64, ${rows}, ${columns}>`
/** @param {[number, number]} sides */
const of = (sides) => type(sides).replace('<', '::<')

/** @param {string[][]} rows @param {[number, number]} sides */
function literal(rows, sides) {
  if (sides[0] * sides[1] === 0) return `${of(sides)}::zeros()`
  return `matrix![${rows.map((row) => row.join(', ')).join('; ')}]`
}
/** @param {number[][]} m */
const data = (m) =>
  literal(
    m.map((row) => row.map(float)),
    [m.length, m[0]?.length ?? 1],
  )

/** @param {(name: string) => string} name */
function printer(name) {
  /** @type {Set<string>} */
  const called = new Set()
  const call = (/** @type {string} */ one, /** @type {string[]} */ ...parts) => {
    called.add(one)
    return `${one}(${parts.join(', ')})`
  }
  /** @param {Node} it @param {number} [least] the rank below which it stands in brackets */
  function text(it, least = 0) {
    const [found, rank] = ranked(it)
    return rank < least ? `(${found})` : found
  }
  /** @param {Node} it @returns {[string, number]} */
  function ranked(it) {
    const { word, parts, sides, ends = [] } = it
    const [a, b] = parts
    const scalar = isNumber(it)
    if (word === 'number') return [float(it.number), 5]
    if (word === 'pi') return ['PI', 5]
    if (word === 'name') return [name(it.name), 5]
    if (word === 'item') return [`${text(a, 4)}[0]`, 5]
    if (word === 'lift') return [`matrix![${text(a)}]`, 5]
    if (word === 'entry') {
      const [top, , left] = a.ends ?? []
      const whole = a.parts[0]
      return [`${text(whole, 4)}[${whole.sides[1] === 1 ? top : `(${top}, ${left})`}]`, 5]
    }
    if (SIGNS[word]) {
      const [sign, rank] = SIGNS[word]
      return [`${text(a, rank)} ${sign} ${text(b, rank + 1)}`, rank]
    }
    if (word === 'negative') return [`-${text(a, 4)}`, 3]
    if (word === 'solve') return [`${text(a, 4)}.lu().solve(&${text(b, 4)}).expect("a matrix that has an inverse")`, 4]
    if (word === 'eye') return [`${of(sides)}::identity()`, 5]
    if (word === 'zeros') return [`${of(sides)}::zeros()`, 5]
    if (word === 'part') {
      const [top, , left] = ends
      return [`${text(a, 4)}.fixed_view::<${sides.join(', ')}>(${top}, ${left}).into_owned()`, 4]
    }
    if (word === 'power') return [`${text(a, 4)}.${scalar ? 'powi' : 'pow'}(${it.number})`, 4]
    if (word === 'diag')
      return a.sides[1] === 1 ? [`SMatrix::from_diagonal(&${text(a, 4)})`, 5] : [`${text(a, 4)}.diagonal()`, 4]
    if (word === 'row' || word === 'stack') return [joined(it), 5]
    if (METHODS[word]) return [`${text(a, 4)}.${METHODS[word]}`, 4]
    if (word === 'sym') return [call('symmetric', text(a)), 5]
    if (word === 'f' || word === 'h') return [call(word, text(a), text(b)), 5]
    if (word === 'wrap') {
      if (scalar) return [call('wrap', text(a)), 5]
      called.add('wrap')
      return [`${text(a, 4)}.map(wrap)`, 4]
    }
    if (MAPS.includes(word) && !scalar) return [`${text(a, 4)}.map(f64::${word})`, 4]
    // A method of a bare number needs its type.
    const whose = a.word === 'number' ? `${text(a)}_f64` : text(a, 4)
    return [`${whose}.${word}(${b ? text(b) : ''})`, 4]
  }
  /** @param {Node} it */
  function joined(it) {
    const rows = written(it)
    if (rows)
      return literal(
        rows.map((row) => row.map((part) => text(part))),
        it.sides,
      )
    let at = 0
    const filled = it.parts.map((part) => {
      const [top, left] = it.word === 'row' ? [0, at] : [at, 0]
      at += part.sides[it.word === 'row' ? 1 : 0]
      const by = isNumber(part) ? `matrix![${text(part)}]` : text(part, 4)
      return `all${view(part.sides, top, left)}.copy_from(&${by}); `
    })
    return `{ let mut all = ${of(it.sides)}::zeros(); ${filled.join('')}all }`
  }
  return { text, called }
}
/** @param {[number, number]} sides @param {number} top @param {number} left */
const view = (sides, top, left) => `.fixed_view_mut::<${sides.join(', ')}>(${top}, ${left})`

/** @param {import('./frame.js').Frame} frame */
export function rust(frame) {
  const { given, x, P, start, constants, varying, steps } = frame
  const names = identifiers([x, P, ...given, ...frame.lines.map(({ name }) => name)], RESERVED.rust, HELPERS)
  const name = (/** @type {string} */ one) => names.get(one) ?? one
  const lines = typed(frame.lines, new Set([x, P, ...given]))
  const { text, called } = printer(name)
  const matrices = new Set([x, P, ...given])
  const body = lines.map(({ name: made, part, sides, value }, i) => {
    const whole = sides[0] === 1 && sides[1] === 1 && !matrices.has(made)
    let line = `let ${name(made)} = ${text(value)};`
    if (part && !whole) {
      const [top, bottom, left, right] = part
      const one = bottom - top === 1 && right - left === 1
      const at = sides[1] === 1 ? top : `(${top}, ${left})`
      const filled = one
        ? `${name(made)}[${at}] = ${text(value)};`
        : `${name(made)}${view([bottom - top, right - left], top, left)}.copy_from(&${text(value, 4)});`
      line = `let mut ${name(made)} = ${name(made)};\n    ${filled}`
    }
    const { formula, remark } = source(frame, i)
    const said = [...remarks(frame, i), remark ? `${formula}; ${remark}` : formula]
    return `${said.map((words) => `    // ${words}\n`).join('')}    ${line}\n`
  })
  const used = new Set([...called, ...helpersOf(HELPERS, NEED, called)])
  const helpers = helpersOf(HELPERS, NEED, called).map((one) => `${HELPERS[one]}\n\n`)
  const pi = [/\bPI\b/.test(body.join('')) ? 'PI' : '', used.has('wrap') ? 'TAU' : ''].filter((one) => one)
  const sizes = new Map([[x, start[0]], [P, start[1]], ...constants])
  varying.forEach((one, i) => sizes.set(one, steps[0][i]))
  const typeOf = (/** @type {string} */ one) => {
    const m = sizes.get(one) ?? []
    return type([m.length, m[0]?.length ?? 1])
  }
  const all = [x, P, ...given]
  const types = [...varying, x, P].map(typeOf)
  const fixed = constants.map(([one, m]) => `    let ${name(one)}: ${typeOf(one)} = ${data(m)};\n`)
  return `${head('//', frame, 'It needs nalgebra: cargo add nalgebra')}#![allow(non_snake_case, unused_variables)]

use nalgebra::{SMatrix, matrix};
${pi.length > 0 ? `use std::f64::consts::${pi.length > 1 ? '{PI, TAU}' : pi[0]};\n` : ''}
${helpers.join('')}/// One step: the estimate and its covariance behind it.
#[rustfmt::skip]
fn step(${all.map((one) => `${name(one)}: ${typeOf(one)}`).join(', ')}) -> (${typeOf(x)}, ${typeOf(P)}) {
${body.join('')}    (${name(x)}, ${name(P)})
}

#[rustfmt::skip]
fn main() {
${fixed.join('')}    // ${ofEachStep(varying.map(name))}
    let steps: [(${types.join(', ')}); ${steps.length}] = [
${steps.map((step) => `        (${step.map(data).join(', ')}),\n`).join('')}    ];
    let (mut ${name(x)}, mut ${name(P)}): (${typeOf(x)}, ${typeOf(P)}) = (${start.map(data).join(', ')});
    for (k, (${[...varying.map(name), 'expected_x', 'expected_P'].join(', ')})) in steps.into_iter().enumerate() {
        (${name(x)}, ${name(P)}) = step(${all.map(name).join(', ')});
        let off = ((${name(x)} - expected_x).amax() / expected_x.amax().max(1.0))
            .max((${name(P)} - expected_P).amax() / expected_P.amax().max(1.0));
        assert!(off <= ${TOLERANCE}, "step {} is off by {off}", k + 1);
    }
    println!("Steps that are right: ${steps.length}.");
}
`
}
