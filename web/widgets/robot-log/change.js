/** A change of how one file of a log is read. */

/**
 * @typedef {{ file: number, role?: string, value?: string, column?: number | null, unit?: string,
 *   wheel?: string, number?: number, counting?: string,
 *   only?: string | null, frame?: string }} Change with `value` the column or the unit is of that value
 */

/** @param {any} files a `LogFiles` @param {Change} change */
export function applyChange(files, { file, role, value, column, unit, wheel, number, counting, only, frame }) {
  if (role !== undefined) files.setRole(file, role)
  if (column !== undefined) files.setColumn(file, value, column)
  if (unit !== undefined) files.setUnit(file, value, unit)
  if (wheel !== undefined) files.setWheel(file, wheel, number)
  if (counting !== undefined) files.setCounting(file, counting)
  if (only !== undefined) files.setOnly(file, only)
  if (frame !== undefined) files.setFrame(file, frame)
}
