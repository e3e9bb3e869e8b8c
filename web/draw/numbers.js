/** Numbers as a reader sees them, in a readout, a label or an announcement. */

const MINUS = '\u2212'

/**
 * Writes a number with a fixed number of decimals and a true minus sign. Infinity is `∞`, a missing number a dash.
 * @param {number | null | undefined} value
 * @param {number} [decimals]
 */
export function fixed(value, decimals = 2) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–'
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`
  if (Math.abs(value) >= 1e4)
    return value
      .toExponential(1)
      .replace('-', MINUS)
      .replace('e+', ' × 10^')
      .replace(/\^(\d+)$/, (_, power) => raised(power))
  return decimal(value, decimals)
}

/**
 * An error in metres, to the centimetre, below a decimetre to the millimetre.
 * @param {number | null | undefined} value
 */
export const metres = (value) => fixed(value, Math.abs(value ?? 1) < 0.0995 ? 3 : 2)

/**
 * The same of a finite number, but with all its digits however large it is: a place may lie far from its origin.
 * @param {number} value @param {number} [decimals]
 */
export function decimal(value, decimals = 3) {
  const text = value.toFixed(decimals)
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', MINUS)
}

/**
 * How much more probable something is than `other`, or than what was named before.
 * @param {number} times @param {string} [other]
 */
export function timesAsProbable(times, other) {
  if (times < 1.005) return `hardly more probable${other ? ` than ${other}` : ''}`
  const many = times < 9.95 ? fixed(times) : times < 999.5 ? fixed(times, 0) : 'more than 999'
  return `${many} times as probable${other ? ` as ${other}` : ''}`
}

/** @param {string} digits */
function raised(digits) {
  return [...digits].map((digit) => (digit === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)])).join('')
}

/** A positive number by its power of ten: `10⁻⁶`, or `3 × 10⁻⁴`. @param {number} value @param {string} [times] */
export function power(value, times = ' × ') {
  if (!(value > 0)) return '0'
  const exponent = Math.floor(Math.log10(value) + 1e-9)
  if (exponent === 0) return value.toFixed(value < 1.05 ? 0 : 1)
  const lead = Math.round(value / 10 ** exponent)
  return `${lead > 1 && lead < 10 ? `${lead}${times}` : ''}10${raised(String(exponent))}`
}

/**
 * Writes one complex number, as in `0.634 + 0.097 i`.
 * @param {{ re: number, im: number }} value
 * @param {number} [decimals]
 */
export function complex(value, decimals = 3) {
  if (Math.abs(value.im) < 10 ** -decimals / 2) return fixed(value.re, decimals)
  return `${fixed(value.re, decimals)} ${value.im < 0 ? MINUS : '+'} ${fixed(Math.abs(value.im), decimals)} i`
}
