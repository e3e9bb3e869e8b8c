/** The limit of the filter's covariance, in words. */

import { short } from './names.js'

/** More rows than these are too long for a line: of such a matrix the diagonal is shown. */
const ROWS = 4
/** So many digits the limit has not, in units of the states' own σ. */
const ROUNDING = 1e-12

/**
 * Its rows; a covariance that is rounding beside its variances is 0.
 * @param {number[][] | null} limit
 */
export function limitWords(limit) {
  if (limit === null) return 'none'
  if (limit.length > ROWS) return `diagonal ${limit.map((row, i) => short(row[i])).join(', ')}`
  const least = (/** @type {number} */ i, /** @type {number} */ j) => ROUNDING * Math.sqrt(limit[i][i] * limit[j][j])
  const entry = (/** @type {number} */ value, /** @type {number} */ i, /** @type {number} */ j) =>
    short(Math.abs(value) < least(i, j) ? 0 : value)
  return limit.map((row, i) => row.map((value, j) => entry(value, i, j)).join(', ')).join('; ')
}
