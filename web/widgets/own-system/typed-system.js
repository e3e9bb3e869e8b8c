/** The system that is typed: as one string, as a text, beside another, and what it lacks. */

import { MATRICES, MOST, partOf, systemOf } from './presets.js'

/**
 * What a new state, input or reading needs to make a system: the diagonal of F and of W may not be empty.
 * @param {string} name @param {number} count @param {any} params
 */
export function grown(name, count, params) {
  const copy = (/** @type {number[][]} */ m) =>
    Array.from({ length: MOST }, (_, i) => Array.from({ length: MOST }, (_, j) => m[i]?.[j] ?? 0))
  if (name === 'states') {
    const f = copy(params.f)
    // What stays as it is: in continuous time, what has no rate of change.
    const alone = (/** @type {number} */ i) => i >= params.states && f[i].every((entry) => entry === 0)
    for (let i = 0; i < count && !params.continuous; i += 1) if (alone(i)) f[i][i] = 1
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
    params.period,
    params.continuous,
    ...[...MATRICES, 'K', 'P'].map((name) => partOf(name, params)),
  ])
}

/** A system as it may be pasted; what is empty, or usual, is left out. @param {any} params */
export function written(params) {
  const matrices = Object.entries(systemOf(params))
    .filter(([, m]) => m[0].length > 0)
    .map(([name, m]) => `${name} = [${m.map((row) => row.join(' ')).join('; ')}]`)
  const [start] = partOf('P', params)
  if (start.some((variance) => variance !== 1)) matrices.push(`P0 = diag([${start.join(' ')}])`)
  if (params.period > 0) matrices.push(`T = ${params.period}`)
  if (params.continuous) matrices.push('sampled = c2d(ss(F, G, H, 0), T)')
  return matrices.join('\n')
}

/** Whether the parameters hold this system. @param {any} system @param {any} params */
export function same(system, params) {
  return (
    ['states', 'inputs', 'readings', 'continuous'].every((name) => system[name] === params[name]) &&
    MATRICES.every((name) => String(partOf(name, system)) === String(partOf(name, params)))
  )
}

/** What the lab's parameters are called on the page. */
const NAMES = /** @type {Record<string, string>} */ ({
  period: 'The length of a step',
  start: 'The variance of the start',
  spread: 'The variance of the start',
  logTolerance: 'The tolerance',
})

/** The lab’s name of a parameter, before what it says of it. */
const PARAMETER = /^(?:state\.)?(?:params\.)?\w+(?:\[\d+\])*:\s*/
/** What it says where a reading without noise has nothing left to tell. */
const INNOVATION = /innovation covariance/

/**
 * What the lab says of a system that it refuses, with the letter of the matrix, or what the reader knows it as. The lab
 * names its parameter first, which no reader has seen.
 * @param {unknown} error
 * @param {import('./letters.js').Places} [places] of the matrices in a text
 */
export function wordsOf(error, places = {}) {
  const { message, argument = '' } = /** @type {{ message: string, argument?: string }} */ (error)
  const place = argument.split('.').pop() ?? ''
  const [name] = /^\w*/.exec(place) ?? ['']
  const of = /^[fghvwk]$/.test(name) ? name.toUpperCase() : NAMES[name]
  const at = [...place.matchAll(/\[(\d+)\]/g)].map(([, index]) => Number(index) + 1)
  const where = at.length === 2 && of?.length === 1 ? `, row ${at[0]}, column ${at[1]}:` : ''
  const said = INNOVATION.test(message)
    ? 'a reading without noise tells nothing, or only what another tells: give it noise, or leave it out'
    : argument === ''
      ? message
      : message.replace(PARAMETER, '')
  // The page counts rows and columns from 1.
  const counted = said.replace(/\((\d+), (\d+)\)/g, (_, i, j) => `(${Number(i) + 1}, ${Number(j) + 1})`)
  const { name: called = of, line } = places[/** @type {'V'} */ (of)] ?? {}
  // A sentence of its own stands behind a colon, what is said of the matrix does not.
  const joined = where || /^(?:has|is|must|needs) /.test(counted) ? where : ':'
  return of ? `${line ? `Line ${line}: ` : ''}${called}${joined} ${counted}` : counted
}
