/** The names of the states, which a link carries as Unicode numbers, and directions of the state in words. */

import { fixed } from '../../draw/numbers.js'

const MOST = 12
/** The most decimals of an eigenvalue. */
const DIGITS = 7

/** A name as its numbers; letters that mean something in a label's notation are left out. @param {string} name */
export function lettersOf(name) {
  const letters = [...name.replace(/[*_^{}\n]/g, '')].slice(0, MOST).map((letter) => letter.codePointAt(0) ?? 0)
  return [...letters, ...Array(MOST - letters.length).fill(0)]
}

/** What the reader has called state `i`; empty where nothing. @param {any} params @param {number} i */
export function givenName(params, i) {
  return (params.names[i] ?? [])
    .filter((/** @type {number} */ code) => code >= 32 && code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000))
    .map((/** @type {number} */ code) => String.fromCodePoint(code))
    .join('')
    .replace(/[*_^{}]/g, '')
    .trim()
}

/** @param {any} params @param {number} i */
export function nameOf(params, i) {
  return givenName(params, i) || `x${'₁₂₃₄₅₆₇₈₉'[i]}`
}

/**
 * A number with at most three digits that say something, small and large ones by their power of ten.
 * @param {number} value
 */
export function short(value) {
  const size = Math.abs(value)
  const text =
    size !== 0 && (size < 0.01 || size >= 1e4)
      ? value.toExponential(1).replace('e+', 'e')
      : String(Number(value.toPrecision(3)))
  return text.replace(/-/g, '−')
}

/**
 * Decimals by which eigenvalues that differ are told apart, and none that dies out looks like 1; as few as usual where
 * seven do not suffice.
 * @param {{ re: number, im: number, modulus: number }[]} eigenvalues
 * @param {number} least
 */
export function decimalsOf(eigenvalues, least) {
  const apart = (/** @type {number} */ a, /** @type {number} */ b) => Math.abs(a - b) > 1e-9
  for (let decimals = least; decimals <= DIGITS; decimals += 1) {
    const text = (/** @type {number} */ value) => value.toFixed(decimals)
    const same = eigenvalues.some(
      (one, i) =>
        (apart(one.modulus, 1) && text(one.modulus) === text(1)) ||
        eigenvalues
          .slice(0, i)
          .some(
            (other) =>
              (apart(one.re, other.re) || apart(one.im, other.im)) &&
              text(one.re) === text(other.re) &&
              text(one.im) === text(other.im),
          ),
    )
    if (!same) return decimals
  }
  return least
}

/** So many letters fit a box of a matrix. */
const FIT = 7

/** A number for a box: digits that fit, small and large ones by their power of ten. @param {number} value */
export function fitted(value) {
  const size = Math.abs(value)
  const plain = size === 0 || (size >= 1e-3 && size < 1e5)
  for (let digits = 6; digits > 1; digits -= 1) {
    const rounded = Number(value.toPrecision(digits))
    const text = plain ? String(rounded) : rounded.toExponential().replace('e+', 'e')
    if (text.length <= FIT) return text
  }
  return value.toExponential(0).replace('e+', 'e')
}

/** A number of steps, to two digits: `670`, `6.6 × 10⁴`. @param {number} count */
export const steps = (count) => fixed(Number(count.toPrecision(2)), 0)

/** A number of steps, to two digits where there are thousands. @param {number} count */
export const counted = (count) => (count < 1e4 ? String(count) : steps(count))

/** A time in seconds: `0.12 s`, `20 s`, `3.4e3 s`. @param {number} seconds */
export const seconds = (seconds) => `${short(seconds)} s`

/** A sum of states: `position + 0.5 · velocity`. @param {number[]} direction @param {any} params */
export function sumOf(direction, params) {
  const parts = direction.flatMap((factor, i) => (factor === 0 ? [] : [{ factor, name: nameOf(params, i) }]))
  return parts
    .map(({ factor, name }, k) => {
      const size = Math.abs(factor)
      const sign = k === 0 ? (factor < 0 ? '−' : '') : factor < 0 ? ' − ' : ' + '
      return `${sign}${Math.abs(size - 1) < 5e-4 ? '' : `${short(size)} · `}${name}`
    })
    .join('')
}

/** Several of them: `a`, `a and b`, `a, b and c`. @param {number[][]} directions @param {any} params */
export function sumsOf(directions, params) {
  const all = directions.map((direction) => sumOf(direction, params))
  return all.length < 2 ? all.join('') : `${all.slice(0, -1).join(', ')} and ${all[all.length - 1]}`
}
