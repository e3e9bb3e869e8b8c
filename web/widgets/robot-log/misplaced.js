/** Landmarks that are wrong, in words: two that are exchanged, one that stands elsewhere or whose ranges are off. */

import { fixed } from '../../draw/numbers.js'
import { landmarkName } from './looks.js'
import { digits, plusMinus } from './sized.js'

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

/** One whose ranges are off by a constant. @param {number[]} ids @param {Size[]} sizes metres @param {Log} log */
export function biased([id], [size], log) {
  const by = { ...size, value: Math.abs(size.value) }
  const [long, why, short] =
    size.value > 0
      ? ['long', 'as behind a wall or by a delay in its radio', 'shorter']
      : ['short', 'as by its radio', 'longer']
  return (
    `The ranges to landmark ${landmarkName({ log }, id)} alone read ${plusMinus(by)} m too ${long}, ${why}: ` +
    `take them ${digits(by)} m ${short}.`
  )
}
