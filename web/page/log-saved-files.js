/** How open files come to be read as saved settings say. */

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('../widgets/robot-log/change.js').Change} Change */
/** @typedef {import('./log-settings.js').SavedFile} SavedFile */
/** @typedef {import('./log-settings.js').SavedValue} SavedValue */

/** Settings are of files that are not open. */
export class NotOpen extends Error {}

/**
 * The next change by which open files come to be read as the settings say; null where they are. Files are found by
 * their names, and another recording by its columns’.
 * @param {SavedFile[]} saved @param {LogFile[]} files as they are read now
 * @returns {Change | null}
 */
export function nextChange(saved, files) {
  const places = saved.map((one) => placeOf(one, saved, files))
  const lost = saved.find(({ again }, i) => places[i] < 0 && again === undefined)
  if (lost) throw new NotOpen(`no open file is called ${lost.name} or has its columns.`)
  for (const [i, one] of saved.entries()) {
    const change = places[i] < 0 ? null : changeOf(one, files[places[i]])
    if (change) return { file: places[i], ...change }
  }
  // A table is read once more where its role says so, which may have been set just now.
  const none = saved[places.indexOf(-1)]
  if (none) throw new Error(`the open files have no ${none.name}.`)
  return null
}

/** @param {SavedFile} one @param {SavedFile[]} saved @param {LogFile[]} files @returns {number} */
function placeOf({ name, header, again }, saved, files) {
  if (again !== undefined) {
    const of = placeOf(saved[again], saved, files)
    if (of < 0) return -1
    const what = name.slice(saved[again].name.length)
    return files.findIndex((file) => file.again === of && file.name === `${files[of].name}${what}`)
  }
  const added = files.filter((file) => file.again === null)
  const named = added.findIndex((file) => file.name === name)
  if (named >= 0) return named
  const alike = added.flatMap((file, i) => (JSON.stringify(file.header) === JSON.stringify(header) ? [i] : []))
  return alike.length === 1 ? alike[0] : -1
}

/** @param {SavedFile} saved @param {LogFile} file @returns {Omit<Change, 'file'> | null} */
function changeOf(saved, { role: now, header, values: current, wheels: turning, several, frame: origin, clock }) {
  const { name, role, values, wheels, only: one, frame, origin: at, clockShift } = saved
  if (role !== now) return { role }
  for (const [value, wanted] of Object.entries(values)) {
    const found = current.find((one) => one.name === value)
    if (!found) throw new Error(`${name} read as ${role} has no ${value}.`)
    const column = wanted === null ? null : columnOf(wanted, header, name)
    if (column !== found.column) return { value, column }
    const unit = wanted?.unit ?? null
    if (column === null || unit === null || unit === found.unit) continue
    if (!found.units.includes(unit)) throw new Error(`${name}: ${value} is not read in ${unit}.`)
    return { value, unit }
  }
  if (one !== undefined && several && (several.asked || several.only !== one)) {
    if (one !== null && several.values.every(({ value }) => value !== one))
      throw new Error(`${name} has no rows of ${one}.`)
    return { only: one }
  }
  // Of another recording what was said may not bring its times to the motion's.
  const meets = clock && clockShift !== undefined && clockShift >= clock.meets[0] && clockShift <= clock.meets[1]
  if (meets && clock.said !== clockShift) return { clockShift }
  // Of another recording the truth may lie on the positions, or be in latitude and longitude: then nothing is said.
  const offered = { same: true, moved: origin?.foreign, own: Boolean(origin?.own) }
  if (at && (origin?.foreign || origin?.beside) && String(origin.origin) !== String(at)) return { origin: at }
  if (frame !== undefined && origin && origin.said !== frame && offered[/** @type {'same'} */ (frame)]) return { frame }
  if (!wheels) return null
  for (const wheel of /** @type {const} */ (['ticks', 'radius', 'base'])) {
    const number = wheels[wheel]
    if (number !== null && number !== turning?.[wheel]) return { wheel, number }
  }
  const { counting } = wheels
  return counting !== null && counting !== turning?.counting ? { counting } : null
}

/** @param {NonNullable<SavedValue>} wanted @param {string[]} header @param {string} name */
function columnOf({ column, header: called }, header, name) {
  if (header[column] === called) return column
  const at = header.indexOf(called)
  if (at < 0 || header.lastIndexOf(called) !== at) throw new Error(`${name} has no column “${called}”, or two of them.`)
  return at
}
