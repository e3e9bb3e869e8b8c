/** Landmarks whose places are wrong, in words: two that are exchanged, or one that stands elsewhere. */

import { fixed } from '../../draw/numbers.js'
import { landmarkName } from './looks.js'
import { plusMinus } from './sized.js'

/** @typedef {import('./looks.js').Log | null} Log */
/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */

/** Two that are taken for one another. @param {number[]} ids @param {Log} log */
export function exchanged(ids, log) {
  const [one, other] = ids.map((id) => landmarkName({ log }, id))
  const what = log?.names.length ? 'names' : 'numbers'
  return `Landmarks ${one} and ${other} are taken for one another: exchange their ${what} where their places are said.`
}

/** One that stands elsewhere. @param {number[]} ids @param {Size[]} sizes x and y, m @param {Log} log */
export function displaced([id], [x, y], log) {
  const far = fixed(Math.hypot(x.value - x.now, y.value - y.now), 2)
  return (
    `Landmark ${landmarkName({ log }, id)} stands ${far} m beside its place: ` +
    `write ${plusMinus(x)} m and ${plusMinus(y)} m where that is said.`
  )
}
