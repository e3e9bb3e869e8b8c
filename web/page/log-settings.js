/**
 * The settings of a log as a file that the page reads again: what the filter is told, and how the files’ columns are
 * read. A file with anything in it that is not known is refused by name, and changes nothing.
 */

import { NONE, areCorrections, isCorrected, numbers, plain } from './log-corrections.js'
import { openingOf } from './log-numbers.js'
import { NotOpen } from './log-saved-files.js'

/** @typedef {import('estimate-wasm').LogFile} LogFile */
/** @typedef {import('estimate-wasm').LogContents} LogContents */
/** @typedef {import('estimate-wasm').Parameter} Parameter */
/** @typedef {import('../widgets/robot-log/change.js').Change} Change */
/** @typedef {{ column: number, header: string, unit: string | null } | null} SavedValue */
/**
 * @typedef {{
 *   name: string, role: string, header: string[], values: Record<string, SavedValue>, wheels: LogFile['wheels'],
 *   only?: string | null, frame?: string, origin?: [number, number], again?: number,
 *   clockShift?: number,
 * }} SavedFile with `again`, of which of the files it is another reading,
 * `only` where a column tells the rows of several robots apart, and it was said whose are read,
 * `frame` where it was said which frame and clock a truth has, and `origin` where that is at a point,
 * `clockShift` what is added to the times of one that does not meet the motion, s, where that was said
 */
/**
 * @typedef {object} SavedLog what tells a log from another, whatever it was read from
 * @property {number} steps @property {number[]} span @property {string} motion @property {number} landmarks
 * @property {Record<string, number>} readings
 * @property {number[]} [start] where its first readings say that it began, where they do
 */
/**
 * @typedef {{ params: Record<string, any>, files: SavedFile[], missing: string[], log: SavedLog | null,
 *   corrections: import('estimate-wasm').LogCorrections }} Settings
 */

const FORMAT = 'robot-motion log settings'
const VERSION = 1
/** A larger file is none of these, bytes. */
export const MOST_SETTINGS = 1_000_000
const LOG = ['steps', 'span', 'motion', 'landmarks', 'readings']
/** What the frame and the clock of a truth may be. */
const FRAMES = ['same', 'moved', 'at', 'own']
const WHEELS = ['ticks', 'radius', 'base', 'counting']

/** Whether a file is one of settings, whatever it is called: it begins with what it is. @param {Blob} file */
export const isSettings = async (file) =>
  /^\s*\{\s*"format"\s*:\s*"robot-motion log settings"/.test(await file.slice(0, 200).text())

/**
 * @param {Record<string, unknown>} params @param {LogFile[]} files
 * @param {LogContents | null} [contents] of the log that they make
 */
export function settingsText(params, files, contents = null) {
  const saved = files
    .filter(({ role }) => role !== 'log')
    .map(({ name, role, header, values, wheels, several, frame, clock, again }) => ({
      name,
      role,
      header,
      values: Object.fromEntries(
        values.map(({ name: value, column, unit }) => [
          value,
          column === null ? null : { column, header: header[column], unit },
        ]),
      ),
      wheels,
      ...(again === null ? {} : { again }),
      ...(several && !several.asked ? { only: several.only } : {}),
      ...(frame?.said ? { frame: frame.said } : {}),
      ...(frame?.origin ? { origin: frame.origin } : {}),
      ...(clock && clock.said !== null ? { clockShift: clock.said } : {}),
    }))
  const log = contents ? { log: logOf(contents) } : {}
  const corrected = contents && isCorrected(contents) ? { corrections: plain(contents.corrections) } : {}
  const all = { format: FORMAT, version: VERSION, settings: params, files: saved, ...log, ...corrected }
  return `${JSON.stringify(all, (_, value) => (ArrayBuffer.isView(value) ? Array.from(listOf(value)) : value), 2)}\n`
}

/** @param {LogContents} contents @returns {SavedLog} */
const logOf = ({ steps, span, motion, landmarks, readings, opening }) => ({
  steps,
  span: [...span],
  motion,
  landmarks: landmarks.length,
  readings: Object.fromEntries(Object.entries(readings).sort()),
  ...(opening ? { start: [...opening.start] } : {}),
})

/** Starts of one log differ by this at most, where its rows were written with fewer digits: m, rad. */
const ROUNDED = 1e-3

/**
 * Whether settings were saved of this log: two of the same length may begin at two places.
 * @param {SavedLog} saved @param {LogContents} contents
 */
function isOf({ start, ...saved }, contents) {
  const { start: begins, ...log } = logOf(contents)
  const near = !start || !begins || start.every((one, i) => Math.abs(one - begins[i]) < ROUNDED)
  return near && JSON.stringify(saved) === JSON.stringify(log)
}

/** @param {any} view a list of numbers */
const listOf = (view) => /** @type {Float64Array} */ (view)

/**
 * Reads such a file. What is wrong with it is an error whose words name the place.
 * @param {string} text @param {Parameter[]} known what the page’s filter can be told
 * @returns {Settings}
 */
export function readSettings(text, known) {
  /** @type {any} */
  let read
  try {
    read = JSON.parse(text)
  } catch {
    throw new Error('it is no JSON: it was changed, or is another file.')
  }
  only(read, ['format', 'version', 'settings', 'files', 'log', 'corrections'], 'the file')
  if (read.format !== FORMAT) throw new Error(`format is not “${FORMAT}”: it is another file.`)
  if (read.version !== VERSION) throw new Error(`version is ${shown(read.version)}; this page reads ${VERSION}.`)
  only(
    read.settings,
    known.map(({ name }) => name),
    'settings',
  )
  for (const one of known) if (one.name in read.settings) setting(read.settings[one.name], one)
  if (!Array.isArray(read.files)) throw new Error('files is no list.')
  read.files.forEach(file)
  const log = read.log ?? null
  if (log !== null) only(log, [...LOG, 'start'], 'log', LOG)
  if (log?.start !== undefined && !numbers(log.start, 3)) throw new Error(`log.start is ${shown(log.start)}.`)
  const corrections = read.corrections ?? NONE
  if (!areCorrections(corrections))
    throw new Error(
      'corrections are not two factors, a turn for each metre, places of landmarks, what ranges are taken shorter ' +
        'and a part.',
    )
  const missing = known.filter(({ name }) => !(name in read.settings))
  const usual = Object.fromEntries(missing.map((one) => [one.name, one.default]))
  const names = missing.map(({ name }) => name)
  return { params: { ...usual, ...read.settings }, files: read.files, missing: names, log, corrections }
}

/** @param {unknown} value */
function shown(value) {
  const text = JSON.stringify(value) ?? 'missing'
  return text.length > 30 ? `${text.slice(0, 29)}…` : text
}

/**
 * @param {unknown} value @param {string[]} names that it may have @param {string} where
 * @param {string[]} [all] that it has to have
 */
function only(value, names, where, all = []) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) throw new Error(`${where} is no object.`)
  for (const name of Object.keys(value))
    if (!names.includes(name)) throw new Error(`${where} has “${name}”, which is not known here.`)
  for (const name of all) if (!(name in value)) throw new Error(`${where} has no ${name}.`)
}

const SENSORS = ['fix', 'heading', 'range', 'bearing']
/** @param {unknown} value @param {(one: unknown) => boolean} fits one value, or each sensor’s */
const bySensor = (value, fits) =>
  value !== null && typeof value === 'object' && !Array.isArray(value)
    ? Object.entries(value).every(([sensor, one]) => SENSORS.includes(sensor) && fits(one))
    : fits(value)
/**
 * The settings that are no number and no yes or no: what they may be.
 * @type {Record<string, [(value: unknown) => boolean, string]>}
 */
const MADE = {
  gate: [
    (value) => bySensor(value, (one) => one === null || (typeof one === 'number' && one > 0 && one < 1)),
    'a probability between 0 and 1, null, or such by sensor',
  ],
  every: [
    (value) => bySensor(value, (one) => typeof one === 'number' && one >= 0),
    'a number of seconds, or such by sensor',
  ],
  start: [(value) => value === null || numbers(value, 3), 'x, y and the heading, or null'],
  withheld: [(value) => value === null || numbers(value, 2), 'two times, or null'],
}

/** @param {unknown} value @param {Parameter} parameter */
function setting(value, { name, default: usual, least, greatest }) {
  const where = `settings.${name} is ${shown(value)}`
  const made = MADE[name]
  if (made) {
    if (!made[0](value)) throw new Error(`${where}; it is ${made[1]}.`)
  } else if (typeof usual === 'boolean') {
    if (typeof value !== 'boolean') throw new Error(`${where}; it is true or false.`)
  } else if (typeof value !== 'number' || value < least || value > greatest)
    throw new Error(`${where}; it is a number between ${least} and ${greatest}.`)
}

/** @param {any} it @param {number} i @param {any[]} all */
function file(it, i, all) {
  const where = `files[${i}]`
  const names = ['name', 'role', 'header', 'values', 'wheels']
  only(it, [...names, 'only', 'frame', 'origin', 'clockShift', 'again'], where, names)
  if (it.frame !== undefined && !FRAMES.includes(it.frame)) throw new Error(`${where}.frame is ${shown(it.frame)}.`)
  if ((it.frame === 'at') !== numbers(it.origin, 2)) throw new Error(`${where}.origin is ${shown(it.origin)}.`)
  if (it.clockShift !== undefined && !numbers([it.clockShift], 1))
    throw new Error(`${where}.clockShift is ${shown(it.clockShift)}.`)
  if (it.only !== undefined && it.only !== null && typeof it.only !== 'string')
    throw new Error(`${where}.only is no text.`)
  for (const name of ['name', 'role']) if (typeof it[name] !== 'string') throw new Error(`${where}.${name} is no text.`)
  const texts = Array.isArray(it.header) && it.header.every((/** @type {unknown} */ one) => typeof one === 'string')
  if (!texts) throw new Error(`${where}.header is no list of texts.`)
  only(it.values, Object.keys(it.values ?? {}), `${where}.values`)
  for (const [name, value] of Object.entries(it.values)) {
    if (value === null) continue
    only(value, ['column', 'header', 'unit'], `${where}.values.${name}`, ['column', 'header', 'unit'])
    const { column, header, unit } = /** @type {any} */ (value)
    if (!Number.isInteger(column) || column < 0 || it.header[column] !== header)
      throw new Error(`${where}.values.${name}: column ${shown(column)} is not called ${shown(header)}.`)
    if (unit !== null && typeof unit !== 'string') throw new Error(`${where}.values.${name}.unit is no text.`)
  }
  const { again } = it
  if (again !== undefined && !(Number.isInteger(again) && again >= 0 && again < i && all[again].again === undefined))
    throw new Error(`${where}.again is ${shown(again)}; it is the place of a file before it.`)
  if (it.wheels !== null) only(it.wheels, WHEELS, `${where}.wheels`, WHEELS)
}

/**
 * Of settings that were saved of another log and say where that began: what the page says, and the start of this log
 * where its first readings tell it; null of others.
 * @param {Settings} settings @param {LogContents} contents of the log that is open
 * @returns {{ words: string, patch: Record<string, any> } | null}
 */
export function startsElsewhere({ params, log }, contents) {
  const same = !log || isOf(log, contents)
  if (same || contents.truth || params.start === null) return null
  if (!contents.opening) return { words: ' They start it where the log began of which they were saved.', patch: {} }
  const patch = { ...openingOf(contents, params.fixSigmaScale) }
  return { words: ' The start is this log’s own: they were saved of another one.', patch }
}

/**
 * Whether a log in the book’s own format, which says itself how it is read, holds what the settings were saved for, as
 * the rows of a log do that the page has written. Settings of tables are of no use to another one: that is an error.
 * @param {Settings} settings @param {LogFile[]} files that are open @param {LogContents} contents of their log
 */
export function isSameLog({ files: saved, log }, files, contents) {
  if (saved.length === 0 || files.length === 0 || files.some(({ role }) => role !== 'log')) return false
  if (log && isOf(log, contents)) return true
  const [open, tables] = [files, saved].map((all) => all.map(({ name }) => name).join(', '))
  const other = log
    ? `has ${contents.steps} rows of motion and readings where that log has ${log.steps}, or other times or sensors`
    : 'may be another: the settings do not say what that log held'
  throw new NotOpen(`it is of a log from ${tables}. ${open} is in the book’s own format and ${other}.`)
}
