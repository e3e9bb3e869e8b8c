/** What is said of a log’s file besides its choices: what is wrong, what is not read, what frame a truth may have. */

/** @typedef {import('estimate-wasm').LogFile} LogFile */

/** How long the list of columns that are not read may be, letters. */
const MOST_UNREAD = 90

/** What is wrong with a file, below its name. @param {NonNullable<LogFile['fault']>} fault */
export function faultWords({ line, column, message }) {
  return `Line ${line}, character ${column}: ${message}${/[.?]$/.test(message) ? '' : '.'}`
}

/**
 * Of which other files something is wrong or asked, in one sentence; empty where of none.
 * @param {LogFile[]} files @param {number} but the file of which it is said already; −1 where of none
 */
export function othersWords(files, but) {
  const others = files.filter((_, i) => i !== but)
  const wrong = others.filter(({ fault }) => fault).map(({ name, fault }) => `${name} is wrong in line ${fault?.line}`)
  const asked = others.filter(({ asks }) => asks.length > 0).map(({ name }) => `${name} asks something`)
  const all = [...wrong, ...asked]
  return all.length > 0 ? `Besides, ${all.join(', ')}: see below.` : ''
}

/**
 * The columns of a file that are not read, in one short sentence; empty where all are.
 * @param {string[]} names
 */
export function unreadWords(names) {
  /** @type {string[]} */
  const listed = []
  let length = 0
  for (const name of names.map(short)) {
    length += name.length + 2
    if (length > MOST_UNREAD && listed.length > 0) break
    listed.push(name)
  }
  const more = names.length - listed.length
  if (listed.length === 0) return ''
  return `Not read: ${listed.join(', ')}${more > 0 ? ` and ${more} more` : ''}.`
}

/**
 * What a truth’s frame and clock may be, in words.
 * @param {NonNullable<LogFile['frame']>} frame
 * @returns {[string, string][]}
 */
export function framesOf({ foreign, beside, origin, own }) {
  const at = /** @type {[string, string][]} */ (origin ? [['at', `same axes, origin at ${origin.join(', ')}`]] : [])
  if (beside) return [['same', 'origin in the first latitude and longitude'], ...at]
  /** @type {[string, string][]} */
  const options = foreign
    ? [
        ['same', 'origin and axes of the positions'],
        ['moved', 'same axes, another origin: moved onto the positions'],
        ...at,
      ]
    : [['same', own?.framed ? 'the same frame' : 'the same clock']]
  if (own) options.push(['own', ownWords(own)])
  return options
}

/**
 * What may be added to the times of a file that do not meet the motion’s, and the words for its clock.
 * @param {NonNullable<LogFile['clock']>} clock
 * @returns {[number, string][]}
 */
export function clocksOf({ said, zone, together }) {
  /** @type {[number, string][]} */
  const options = [[together, 'its own: taken to begin with the motion, perhaps seconds off']]
  if (zone !== null) options.unshift([zone, zoneWords(zone)])
  options.push([0, 'the motion’s: nothing is added'])
  if (said !== null && options.every(([one]) => one !== said))
    options.push([said, `its own: ${String(said).replace('-', '−')} s are added`])
  return options
}

/** @param {number} seconds */
function zoneWords(seconds) {
  // What GPS time is ahead of UTC by is no part of an hour.
  if (Math.abs(seconds) < 900) return `GPS time: ${Math.abs(seconds)} s are ${seconds > 0 ? 'added' : 'taken off'}`
  const days = seconds / 86400
  const [count, unit] = Number.isInteger(days) ? [days, 'day'] : [seconds / 3600, 'hour']
  const many = Math.abs(count) === 1 ? unit : `${unit}s`
  const is = many === unit ? 'is' : 'are'
  const another = unit === 'day' ? 'day' : 'zone'
  return `of another ${another}: ${Math.abs(count)} ${many} ${is} ${count > 0 ? 'added' : 'taken off'}`
}

/**
 * A latitude and a longitude in degrees, as they are typed; null of anything else: a W that is passed over is a place
 * elsewhere.
 * @param {string} text @returns {[number, number] | null}
 */
export function originOf(text) {
  const one = '([+\u2212-]?\\d+(?:\\.\\d+)?)\\s*°?'
  const found = text.trim().match(new RegExp(`^${one}(?:\\s*[,;]\\s*|\\s+)${one}$`))
  if (!found) return null
  const [latitude, longitude] = found.slice(1).map((number) => Number(number.replace('\u2212', '-')))
  return Math.abs(latitude) <= 90 && Math.abs(longitude) <= 360 ? [latitude, longitude] : null
}

/** @param {import('estimate-wasm').LogOwn} own */
function ownWords({ framed, mirrored, turn, delay }) {
  if (!framed) return `its own clock: taken ${Math.abs(delay).toFixed(2)} s ${delay < 0 ? 'earlier' : 'later'}`
  if (delay !== 0) return 'its own frame and clock'
  const done = [...(mirrored ? ['mirrored'] : []), ...(turn === 0 ? [] : ['turned']), 'moved']
  const last = done.pop()
  return `its own frame: ${done.length > 0 ? `${done.join(', ')} and ${last}` : last}`
}

/** The beginning of what stands in a field; of a date all that differs from row to row. @param {string} text */
export function short(text) {
  const most = text.includes(':') ? 29 : 16
  return text.length > most ? `${text.slice(0, most - 1)}…` : text || '(empty)'
}
