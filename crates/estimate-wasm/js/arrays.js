// Vectors and matrices across the border in one call for all of them, where Rust would need one for each entry.
//
// They lie one behind another in a row of numbers: a matrix as [rows, columns, entries row by row …], a vector as
// [-1, length, entries …], and in an answer what is not there as [-2, 0].
//
// The readers take plain arrays of finite numbers, and Float64Arrays as rows and vectors, and nothing else. Whatever is
// unusual (a hole, a NaN, a number too many, a getter that throws) is left to the decoder in Rust, which reads the
// argument again and names what is wrong with it. A getter or a proxy may do and answer anything in between, so every
// value is looked at after it was read, and read once; and when a getter calls the module and its memory grows, `to` is
// left with a length of 0.

/** The most rows, columns and entries of a vector. */
const MOST = 16
/** In the place of a matrix's rows: a vector follows. */
const VECTOR = -1
/** In the place of a matrix's rows: there is none. */
const NOTHING = -2

/**
 * Writes the arrays in these fields of an object.
 *
 * @param {any} object @param {string[]} names @param {Float64Array} to @returns {boolean} whether all of them are plain
 */
export function readFields(object, names, to) {
  try {
    if (typeof object !== 'object' || Array.isArray(object)) return false
    let end = 0
    for (const name of names) if ((end = read(object[name], to, end)) === 0) return false
    return end <= to.length
  } catch {
    return false
  }
}

/**
 * Writes one array.
 *
 * @param {any} array @param {Float64Array} to @returns {boolean} whether it is plain
 */
export function readArray(array, to) {
  try {
    const end = read(array, to, 0)
    return end > 0 && end <= to.length
  } catch {
    return false
  }
}

/**
 * Writes the numbers of a short array or Float64Array.
 *
 * @param {any} array @param {Float64Array} to @returns {number} how many; -1 of what is not plain
 */
export function readNumbers(array, to) {
  try {
    const length = lengthOf(array)
    if (!(length <= to.length)) return -1
    for (let i = 0; i < length; i++) {
      const number = array[i]
      if (!Number.isFinite(number)) return -1
      to[i] = number
    }
    return length <= to.length ? length : -1
  } catch {
    return -1
  }
}

/** The length of a short array or Float64Array; NaN of what is none. @param {any} array */
function lengthOf(array) {
  if (!Array.isArray(array) && !(array instanceof Float64Array)) return NaN
  const { length } = array
  return Number.isInteger(length) && length >= 0 && length <= MOST ? length : NaN
}

/**
 * @param {any} array @param {Float64Array} to @param {number} from where to write it
 * @returns {number} where it ends, or 0 of what is not plain
 */
function read(array, to, from) {
  const rows = lengthOf(array)
  if (Number.isNaN(rows)) return 0
  let end = from + 2
  let columns = VECTOR
  for (let i = 0; i < rows; i++) {
    const entry = array[i]
    if (i === 0 && typeof entry === 'object') columns = lengthOf(entry)
    else if (columns !== VECTOR && lengthOf(entry) !== columns) return 0
    if (Number.isNaN(columns)) return 0
    if (columns === VECTOR) {
      if (!Number.isFinite(entry)) return 0
      to[end++] = entry
    } else {
      for (let j = 0; j < columns; j++) {
        const number = entry[j]
        if (!Number.isFinite(number)) return 0
        to[end++] = number
      }
    }
  }
  to[from] = columns === VECTOR ? VECTOR : rows
  to[from + 1] = columns === VECTOR ? rows : columns
  return end
}

/**
 * Puts arrays on an object, in fields of these names.
 *
 * @param {Record<string, any>} object @param {string[]} names @param {Float64Array} from
 */
export function putFields(object, names, from) {
  let at = 0
  for (const name of names) {
    const [rows, columns] = [from[at], from[at + 1]]
    at += 2
    if (rows === NOTHING) object[name] = null
    else if (rows === VECTOR) object[name] = numbers(from, at, columns)
    else object[name] = matrix(from, at, rows, columns)
    at += (rows === VECTOR ? 1 : rows) * columns
  }
}

/** @param {Float64Array} entries row by row @param {number} rows */
export const matrixOf = (entries, rows) => matrix(entries, 0, rows, entries.length / rows)

/** @param {Float64Array} from @param {number} at @param {number} rows @param {number} columns */
function matrix(from, at, rows, columns) {
  const all = []
  for (let i = 0; i < rows; i++) all.push(numbers(from, at + i * columns, columns))
  return all
}

/** @param {Float64Array} from @param {number} at @param {number} count */
function numbers(from, at, count) {
  const all = []
  for (let i = 0; i < count; i++) all.push(from[at + i])
  return all
}
