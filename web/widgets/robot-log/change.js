/** A change of how one file of a log is read. */

/**
 * @typedef {{ file?: number, role?: string, value?: string, column?: number | null, unit?: string,
 *   wheel?: string, number?: number, counting?: string,
 *   only?: string | null, frame?: string, origin?: [number, number],
 *   clockShift?: number,
 *   corrections?: import('estimate-wasm').LogCorrections }} Change with `value` the column or the unit is of that
 * value; corrections are of all files together
 */

/** @param {any} files a `LogFiles` @param {Change} change */
export function applyChange(files, change) {
  const { file, role, value, column, unit, wheel, number, counting, only, corrections } = change
  const { frame, origin, clockShift } = change
  if (role !== undefined) files.setRole(file, role)
  if (column !== undefined) files.setColumn(file, value, column)
  if (unit !== undefined) files.setUnit(file, value, unit)
  if (wheel !== undefined) files.setWheel(file, wheel, number)
  if (counting !== undefined) files.setCounting(file, counting)
  if (only !== undefined) files.setOnly(file, only)
  if (frame !== undefined) files.setFrame(file, frame)
  if (origin !== undefined) files.setOrigin(file, ...origin)
  if (clockShift !== undefined) files.setClockShift(file, clockShift)
  if (corrections === undefined) return
  const { driven, landmarks, ranges, kept, swerve } = corrections
  files.correct(driven, landmarks, ranges, kept, swerve)
}
