/** The system that is typed: as one string, as a text, beside another, and what it lacks. */

import { MATRICES, partOf, systemOf } from './presets.js'

/**
 * What a new state, input or reading needs to make a system: the diagonal of F and of W may not be empty.
 * @param {string} name @param {number} count @param {any} params
 */
export function grown(name, count, params) {
  const copy = (/** @type {number[][]} */ m) => m.map((row) => [...row])
  if (name === 'states') {
    const f = copy(params.f)
    for (let i = params.states; i < count; i += 1) if (f[i].every((entry) => entry === 0)) f[i][i] = 1
    return { f }
  }
  if (name !== 'readings') return {}
  const [h, w] = [copy(params.h), copy(params.w)]
  for (let i = params.readings; i < count; i += 1) {
    if (h[i].every((entry) => entry === 0) && i < params.states) h[i][i] = 1
    if (w[i].every((entry) => entry === 0)) w[i][i] = 1
  }
  return { h, w }
}

/** A system as one string, which tells it from others. @param {any} params */
export function keyOf(params) {
  return JSON.stringify([
    params.states,
    params.inputs,
    params.readings,
    ...[...MATRICES, 'K'].map((name) => partOf(name, params)),
  ])
}

/** A system as it may be pasted; what is empty is left out. @param {any} params */
export function written(params) {
  return Object.entries(systemOf(params))
    .filter(([, m]) => m[0].length > 0)
    .map(([name, m]) => `${name} = [${m.map((row) => row.join(' ')).join('; ')}]`)
    .join('\n')
}

/** Whether the parameters hold this system. @param {any} system @param {any} params */
export function same(system, params) {
  return (
    ['states', 'inputs', 'readings'].every((name) => system[name] === params[name]) &&
    MATRICES.every((name) => String(partOf(name, system)) === String(partOf(name, params)))
  )
}

/** What the lab says of a system that it refuses, with the letter of the matrix. @param {unknown} error */
export function wordsOf(error) {
  const { message, argument } = /** @type {{ message: string, argument?: string }} */ (error)
  const place = argument?.split('.').pop() ?? ''
  const letter = /^[fghvwk]\b/.test(place) ? `${place.charAt(0).toUpperCase()} ` : ''
  return `${letter}${message}`
}
