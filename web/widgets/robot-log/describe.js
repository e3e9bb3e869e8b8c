/** Each panel of the figure of a log in words. */

import { fixed, metres } from '../../draw/numbers.js'
import { mapped } from './controls.js'
import { clock, percent } from './words.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */

/** @param {Frame} frame @returns {Record<string, string>} */
export function describe(frame) {
  const {
    summary,
    correlation,
    histogram,
    innovations,
    rangeLine,
    innovationLine,
    landmarks,
    nis,
    truth,
    hasTruth,
    errors,
    meanBearing,
  } = frame
  const known = truth ? 'true' : 'dead-reckoned'
  const error =
    summary.rmse === null
      ? 'how far off the estimate is nobody knows'
      : `the RMS error of the position so far is ${metres(summary.rmse)} metres, that of dead ` +
        `reckoning ${metres(frame.reckonedRmse)} metres`
  const none = 'no reading has been used'
  const outside = (/** @type {number[]} */ values, /** @type {number} */ band) =>
    values.filter((value) => Math.abs(value) > band).length
  const { time, normalized, used } = innovations
  const drawn =
    `${outside(normalized, 2)} of the ${time.length} drawn lie outside ±2 σ, ` +
    `${used.filter((one) => !one).length} were refused`
  const line = (/** @type {{ slope: number, offset: number, r2: number }} */ { slope, offset, r2 }) =>
    `a line of slope ${fixed(slope, 3)} and offset ${fixed(offset, 2)} metres explains ${percent(r2)} of it`
  const inner = (/** @type {{ slope: number, r2: number }} */ { slope, r2 }) =>
    `slope ${fixed(slope, 3)}, which explains ${percent(r2)}`
  const { values, band } = correlation
  const beyond = nis.mean.filter((mean, i) => mean < nis.low[i] || mean > nis.high[i]).length
  return {
    map:
      `Map of the drive after ${clock(frame.time)} of ${clock(frame.duration)}: ${landmarks.length} ` +
      `${landmarks.length === 1 ? 'landmark' : 'landmarks'}, ${truth ? 'the true track, ' : ''}the ` +
      `dead-reckoned track and the estimate; ${error}.`,
    innovations: `Normalized innovations over time: ${time.length === 0 ? none : drawn}.`,
    errors: !hasTruth ? '' : `Error of the position over time: ${errorNow(errors)}.`,
    bearings: !frame.bearings
      ? ''
      : `Normalized innovations of the bearings over time: ${
          meanBearing === null ? none : `their mean is ${fixed((180 / Math.PI) * meanBearing, 2)} degrees`
        }.`,
    ranges: !mapped(frame)
      ? ''
      : `Read less ${known} range, against the ${known} range: ` + `${rangeLine ? line(rangeLine) : 'no line yet'}.`,
    inner: !mapped(frame)
      ? ''
      : 'The filter’s own innovations against the range it expected: ' +
        `${innovationLine ? inner(innovationLine) : none}.`,
    histogram:
      'Histogram of the normalized innovations beside the standard normal density: ' +
      `${summary.meanInnovation === null ? none : spread(summary.meanInnovation, histogram.beyond)}.`,
    correlation:
      `Autocorrelation of the innovations at ${values.length} lags: ` +
      `${values.length === 0 ? none : `${outside(values, band)} outside the band of ±${fixed(band, 3)}`}.`,
    nis:
      `Normalized innovations squared, averaged over blocks of ${nis.block} readings: ` +
      `${nis.mean.length === 0 ? 'no block is full yet' : `${beyond} of ${nis.mean.length} outside the band`}.`,
  }
}

/** @param {Frame['errors']} errors */
function errorNow({ time, error, bound }) {
  if (time.length === 0) return 'nothing is driven yet'
  const last = (/** @type {number[]} */ values) => fixed(values[values.length - 1], 2)
  return `now ${last(error)} metres against a claimed 2 σ of ${last(bound)}`
}

/** @param {number} mean @param {number} beyond */
function spread(mean, beyond) {
  return `their mean is ${fixed(mean, 2)}, and ${percent(beyond)} lie beyond five σ`
}
