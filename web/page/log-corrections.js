/** What is read otherwise than the files of a log have it: by presses below the verdict, or by a file of settings. */

/** @typedef {import('estimate-wasm').LogCorrections} Corrections */

/** As the files have it. @type {Corrections} */
export const NONE = { driven: [1, 1], landmarks: [] }

/** @param {Corrections} one @param {Corrections} other */
export const sameCorrections = (one, other) => JSON.stringify(plain(one)) === JSON.stringify(plain(other))

/**
 * Whether the open rows have been corrected before they were written: rows in the book’s own format that are called
 * otherwise than the files whose settings these are. Such rows the page writes.
 * @param {Corrections & { files?: string[] }} corrections
 * @param {import('estimate-wasm').LogFile[]} files that are open
 */
export const areWritten = ({ files: of = [] }, files) =>
  files.length > 0 && files.every(({ role, name }) => role === 'log' && !of.includes(name))

/** Whether a log is corrected. @param {{ corrections: Corrections }} contents */
export const isCorrected = ({ corrections }) => !sameCorrections(corrections, NONE)

/**
 * The numbers in lists, as a file has them; landmarks by their numbers.
 * @param {Corrections} corrections @returns {Corrections}
 */
export function plain({ driven: [far, much], landmarks }) {
  const places = landmarks.map(([id, x, y]) => /** @type {[number, number, number]} */ ([id, x, y]))
  return { driven: [far, much], landmarks: places.sort(([one], [other]) => one - other) }
}

/** @param {unknown} value @param {number} count */
const numbers = (value, count) => Array.isArray(value) && value.length === count && value.every(Number.isFinite)

/** Whether a file’s value is such corrections, of files by their names. @param {any} value */
export function areCorrections(value) {
  const { driven, landmarks, files = [], ...others } = value ?? {}
  const names = Array.isArray(files) && files.every((name) => typeof name === 'string')
  const factors = numbers(driven, 2) && driven.every((/** @type {number} */ one) => one > 0)
  const id = (/** @type {number[]} */ [one]) => Number.isInteger(one) && one >= 0
  const places = Array.isArray(landmarks) && landmarks.every((place) => numbers(place, 3) && id(place))
  return factors && places && names && Object.keys(others).length === 0
}
