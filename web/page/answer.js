/**
 * Compares a reader's answer with a question's key. The key stands encoded in the page, so that nobody reads it in
 * passing.
 */

/** Letters of the longest number that anybody needs to type. */
export const LONGEST = 40

/**
 * @typedef {{ path: string, is?: string, least?: number, most?: number }} Condition of a figure's frame
 * @typedef {{ right?: number, values?: number[], unit?: string, tolerance?: number, bounds?: number[],
 *   direction?: boolean, near?: number[][], conditions?: Condition[] }} Key
 */

/** @param {HTMLElement} question @returns {Key} */
export function keyOf({ dataset }) {
  const bytes = (dataset.key ?? '').match(/../g) ?? []
  return JSON.parse(new TextDecoder().decode(Uint8Array.from(bytes, (byte) => parseInt(byte, 16))) || '{}')
}

/** A number within this part of the right one is close. */
const CLOSE = 0.05
/** Rounding of the machine, as a part of half a digit. */
const SLACK = 1e-9

/**
 * The verdict on numbers: right within the tolerance or the bounds, or rounded by the reader to two digits or more;
 * else which of the well-known wrong answers they are; whether they are the right one in too few digits to tell; or
 * whether they are close, which no direction is. Null when the text holds other than the key asks for. A well-known
 * wrong answer comes first: it may be what the right one is rounded to.
 * @param {Key} key
 * @param {string} text
 * @returns {{ right: boolean, near: number, nearly: boolean, close: boolean } | null}
 */
export function judge({ values = [], unit = '', tolerance = 0, bounds, direction = false, near = [] }, text) {
  const bare = withoutUnit(text, unit)
  const readings = values.length > 1 ? [vector(bare)] : [bare, ungrouped(bare)].map((one) => [one])
  const given = readings
    .map((words) => ({ words, entries: words.map(number) }))
    .filter(({ entries }) => entries.length === values.length && !entries.includes(null))
    .map(({ words, entries }) => ({ words, entries: /** @type {number[]} */ (entries) }))
    .filter(({ entries }) => !direction || entries.some((entry) => entry !== 0))
  if (given.length === 0) return null
  const meets = (/** @type {number[]} */ wanted) =>
    given.some(({ entries }) => gap(entries, wanted, direction) <= tolerance)
  /** Whether each entry is the wanted one, or one within the tolerance, rounded to the digits that stand there. */
  const rounds = (/** @type {number[]} */ wanted, digits = 2) =>
    !direction &&
    given.some(({ words, entries }) =>
      entries.every((entry, i) => {
        const [half, off] = [halfOfLast(words[i], digits), Math.abs(entry - wanted[i])]
        return off <= tolerance || (half !== null && tolerance <= half * (1 + SLACK) && off <= half + tolerance)
      }),
    )
  const known = near.findIndex(meets)
  const rounded = near.findIndex((wanted) => rounds(wanted))
  const right = bounds ? given.some(({ entries: [entry] }) => bounds[0] <= entry && entry <= bounds[1]) : meets(values)
  const verdict = { right, near: -1, nearly: false, close: false }
  if (right) return verdict
  if (known >= 0) return { ...verdict, near: known }
  if (rounds(values)) return bounds || rounded >= 0 ? { ...verdict, nearly: true } : { ...verdict, right: true }
  if (rounded >= 0) return { ...verdict, near: rounded }
  if (rounds(values, 1)) return { ...verdict, nearly: true }
  const size = Math.max(...values.map(Math.abs))
  return { ...verdict, close: !direction && given.some(({ entries }) => gap(entries, values, false) <= CLOSE * size) }
}

/**
 * Half of what one counts for in the last digit of a number that has at least so many digits, of which zeros at the
 * end of a whole number count only where they are needed for that; null for fewer, and for a fraction.
 * @param {string} text
 * @param {number} digits
 */
function halfOfLast(text, digits) {
  const parts = /^[-+\u2212]?(\d*)(?:[.,](\d*))?(?:e([-+]?\d+))?$/i.exec(text.trim())
  if (!parts) return null
  const [, whole = '', behind = '', power = '0'] = parts
  const written = (whole + behind).replace(/^0+/, '')
  const zeros = behind ? 0 : (/0*$/.exec(written)?.[0].length ?? 0)
  if (written.length < digits) return null
  return 0.5 * 10 ** (Number(power) - behind.length + Math.min(zeros, written.length - digits))
}

/**
 * The text without the question's unit behind it, with m² also written m^2 or m2.
 * @param {string} text
 * @param {string} unit
 */
function withoutUnit(text, unit) {
  const trimmed = text.trim()
  const written = unit && [unit, unit.replace('²', '^2'), unit.replace('²', '2')].find((one) => trimmed.endsWith(one))
  return written ? trimmed.slice(0, -written.length) : trimmed
}

/**
 * A number whose thousands are parted, without the marks: 6,600 is 6600. It may also be 6.6 with a decimal comma, so a
 * text has both readings, and the key decides.
 * @param {string} text
 */
function ungrouped(text) {
  const mark = /^[-+\u2212]?[1-9]\d{0,2}([,' \u00a0\u2009\u202f])\d{3}(\1\d{3})*(\.\d*)?$/.exec(text.trim())?.[1]
  return mark ? text.replaceAll(mark, '') : text
}

/**
 * The largest distance between entries; of unit vectors, with the better sign, if only the direction counts.
 * @param {number[]} a
 * @param {number[]} b
 * @param {boolean} direction
 * @returns {number}
 */
function gap(a, b, direction) {
  if (!direction) return Math.max(...a.map((entry, i) => Math.abs(entry - b[i])))
  const [of, to] = [unitVector(a), unitVector(b)]
  return Math.min(
    ...[1, -1].map((sign) =>
      gap(
        of.map((entry) => sign * entry),
        to,
        false,
      ),
    ),
  )
}

/** @param {number[]} v */
function unitVector(v) {
  const largest = Math.max(...v.map(Math.abs)) || 1
  const scaled = v.map((entry) => entry / largest)
  const length = Math.hypot(...scaled) || 1
  return scaled.map((entry) => entry / length)
}

/**
 * The words of numbers between spaces, commas or semicolons; with semicolons or spaces a comma may be a decimal one.
 * @param {string} text
 */
function vector(text) {
  if (text.length > 8 * LONGEST) return []
  const inner = text
    .trim()
    .replace(/^[[(]|[\])]$/g, '')
    .replace(/\s*\/\s*/g, '/')
    .trim()
  const between = inner.includes(';') ? /\s*;\s*/ : /,\s/.test(inner) || !/\s/.test(inner) ? /\s*,\s*/ : /\s+/
  return inner.split(between)
}

/**
 * A decimal with point or comma, or a fraction.
 * @param {string} text
 */
export function number(text) {
  if (text.length > LONGEST) return null
  const parts = text
    .replace(/\u2212/g, '-')
    .replace(',', '.')
    .split('/')
    .map((word) => word.trim())
  if (parts.length > 2 || parts.some((word) => !/^[-+]?(\d+(\.\d*)?|\.\d+)(e[-+]?\d+)?$/i.test(word))) return null
  const value = parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0])
  return Number.isFinite(value) ? value : null
}

/**
 * The indices of the conditions that a frame does not meet.
 * @param {Key} key
 * @param {any} frame
 */
export function unmet({ conditions = [] }, frame) {
  return conditions.flatMap(({ path, is, least = -Infinity, most = Infinity }, i) => {
    const value = path.split('.').reduce((at, name) => at?.[name], frame)
    const met = is === undefined ? typeof value === 'number' && value >= least && value <= most : String(value) === is
    return met ? [] : [i]
  })
}
