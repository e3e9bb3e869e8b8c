/** What is read otherwise than the files of a log have it: by presses below the verdict, or by a file of settings. */

/** @typedef {import('estimate-wasm').LogCorrections} Corrections */

/** As the files have it. @type {Corrections} */
export const NONE = { driven: [1, 1], landmarks: [], ranges: [] }

/** @param {Corrections} one @param {Corrections} other */
export const sameCorrections = (one, other) => JSON.stringify(plain(one)) === JSON.stringify(plain(other))

/** How rows begin that the page has corrected before it wrote them. */
const MARK = '# corrected: '
/** The longest such line, bytes: a log has 500 landmarks at most. */
const MOST_MARK = 50_000

/** Rows of a log as a file: corrected ones say so. @param {string | Blob} rows @param {Corrections} corrections */
export const written = (rows, corrections) =>
  new Blob(isCorrected({ corrections }) ? [`${MARK}${JSON.stringify(plain(corrections))}\n`, rows] : [rows])

/** What the page has corrected in a file before it wrote it; null of another file. @param {Blob} file */
export async function markOf(file) {
  const [line] = (await file.slice(0, MOST_MARK).text()).split('\n')
  if (!line.startsWith(MARK)) return null
  try {
    const corrections = JSON.parse(line.slice(MARK.length))
    return areCorrections(corrections) ? /** @type {Corrections} */ (corrections) : null
  } catch {
    return null
  }
}

/** Whether a log is corrected. @param {{ corrections: Corrections }} contents */
export const isCorrected = ({ corrections }) => !sameCorrections(corrections, NONE)

/**
 * The numbers in lists, as a file has them; landmarks by their numbers, and a part where not all of the log is read.
 * Files of before have no ranges, and no turn for each metre where there is none.
 * @param {Omit<Corrections, 'ranges'> & Partial<Corrections>} corrections @returns {Corrections}
 */
export function plain({ driven: [far, much], landmarks, ranges = [], kept, swerve = 0 }) {
  const places = landmarks.map(([id, x, y]) => /** @type {[number, number, number]} */ ([id, x, y]))
  const shorter = ranges.map(([id, by]) => /** @type {[number, number]} */ ([id, by]))
  /** @param {number[]} one @param {number[]} other */
  const byId = ([one], [other]) => one - other
  const all = { driven: /** @type {[number, number]} */ ([far, much]), landmarks: places.sort(byId) }
  const part = kept ? { kept: /** @type {[number, number]} */ ([...kept]) } : {}
  const aside = swerve !== 0 ? { swerve } : {}
  return { ...all, ...aside, ranges: shorter.sort(byId), ...part }
}

/** Whether a file’s value is a list of so many numbers. @param {unknown} value @param {number} count */
export const numbers = (value, count) => Array.isArray(value) && value.length === count && value.every(Number.isFinite)

/** Whether a file’s value is such corrections. @param {any} value */
export function areCorrections(value) {
  const { driven, landmarks, ranges = [], kept = null, swerve = 0, ...others } = value ?? {}
  const factors = numbers(driven, 2) && driven.every((/** @type {number} */ one) => one > 0)
  const id = (/** @type {number[]} */ [one]) => Number.isInteger(one) && one >= 0
  const places = Array.isArray(landmarks) && landmarks.every((place) => numbers(place, 3) && id(place))
  const shorter = Array.isArray(ranges) && ranges.every((pair) => numbers(pair, 2) && id(pair))
  const part = kept === null || (numbers(kept, 2) && kept[0] < kept[1])
  return factors && Number.isFinite(swerve) && places && shorter && part && Object.keys(others).length === 0
}
