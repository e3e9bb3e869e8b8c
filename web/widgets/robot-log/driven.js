/** Motion that reads too much or too little by a share, in words: by which factors, and which wheels do so. */

import { decimal, fixed } from '../../draw/numbers.js'
import { plusMinus, rounded } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */
/** @typedef {import('./looks.js').Log | null} Log */

/** Of turns that are less than they are read. */
export const DILUTED = 'Noise in the turns that are read looks the same: it may be no fault.'

/**
 * What noise of the turns may be of their share.
 * @param {number | null} dilution
 */
export const byNoise = (dilution) =>
  dilution
    ? `Noise in the turns that are read makes them look up to ${fixed(100 * dilution, 1)} % larger than they are: ` +
      'the ± counts that, and what is set may be as much too small.'
    : ''

/** How many times the distances, and where it turns the turns, are to be taken. @param {Size[]} sizes */
export const factors = (sizes) => sizes.map((size) => 1 + rounded(size))

/** How much farther or less far than it reads. @param {Size} size @param {[string, string]} words more and less */
function much({ value, ...size }, [more, less]) {
  return `${plusMinus({ ...size, value: Math.abs(value) }, 100)} % ${value > 0 ? more : less}`
}

/** A heading that is counted from elsewhere turns the way aside as well. */
const HEADING = ', or that of the headings, which may be counted from north or from the axis of x'

/** @param {Size[]} sizes @param {Log} log @param {boolean} own whether noise of the turns may be what it is */
export function odometrySentence(sizes, log, own = false) {
  const [far, turned] = sizes
  const headings = log?.readings?.heading ? HEADING : ''
  // Speeds of two wheels are no distances.
  const rates = log?.motion === 'velocity'
  const [ways, turns, reader] = rates
    ? ['speeds', 'turn rates', 'its wheels say']
    : ['distances', 'turns', 'odometry reads']
  if (far.end) {
    const what = rates ? 'The speeds of the wheels' : 'The distances of odometry'
    return `${what} are not those that the robot drives: mend their unit${headings}.`
  }
  const times = (/** @type {number} */ factor) => `${decimal(factor, 4)} times`
  const [along, about] = factors(sizes)
  const drives = `The robot drives ${much(far, ['farther', 'less far'])}`
  if (!turned) return `${drives} than ${reader}: take the ${ways} ${times(along)} as they are read.`
  const both = `the ${ways} ${times(along)} and the ${turns} ${times(about)} as they are read`
  const reads = `${drives} and turns ${much(turned, ['more', 'less'])} than ${reader}`
  if (own) return `${reads}.`
  const same = rates
    ? `Wheels ${times(along)} as large`
    : `${log?.wheels ? 'A' : 'Of two wheels a'} radius ${times(along)}`
  return `${reads}: take ${both}. ${same} and a base ${times(along / about)} as long as was said do the same.`
}

/** Ranges and ways that are off together. @param {Size[]} sizes the ranges’ scale and offset, and the ways’ share */
export function lengthsSentence([scale, offset, far]) {
  if (far.end || scale.end) return 'Neither the ranges nor the ways are those of the robot: mend their units.'
  const [ranges, metres] = [scale, offset].map((size) => ({ ...size, value: Math.abs(size.value) }))
  const [long, more] = [scale, offset].map(({ value }) => (value > 0 ? 'long' : 'short'))
  return (
    `The robot drives ${much(far, ['farther', 'less far'])} than is read, the ranges read ` +
    `${plusMinus(ranges, 100)} % too ${long} and ${plusMinus(metres)} m too ${more}: take all three so. ` +
    'Each makes up for a part of another, and none is right by itself.'
  )
}

/** Speeds and turn rates of two wheels that read too much or too little by one share. @param {Size[]} sizes */
export function wheelsSentence([size]) {
  if (size.end) return 'The speeds of the wheels are not those of the robot: mend their unit.'
  const times = `${decimal(factors([size])[0], 4)} times`
  return (
    `The robot drives and turns ${much(size, ['more', 'less'])} than its wheels say: ` +
    `take speeds and turn rates ${times} as they are read. Both wheels ${times} as large as was said do the same.`
  )
}

/** Turn rates that read too much or too little by a share. @param {Size[]} sizes @param {Log} log */
export function turnScaleSentence([size], log) {
  if (size.end) return 'The turn rates are not those of the robot: mend their unit.'
  const [about] = factors([size])
  const base = log?.wheels ? ` A distance between the wheels ${decimal(1 / about, 4)} times as long does the same.` : ''
  return (
    `The robot turns ${much(size, ['more', 'less'])} than its turn rates say: ` +
    `take them ${decimal(about, 4)} times as they are read.${base}`
  )
}

const DEGREES = 180 / Math.PI

/** By how much one wheel is larger, where they stand so far apart. @param {Size} much @param {number | null} base */
const by = (much, base) =>
  base === null ? `${plusMinus(much, 100)} % for each metre between the two` : `${plusMinus(much, 100 * base)} %`

/** Turns that are off by an angle for each metre. @param {Size[]} sizes @param {Log} log */
export function unequalSentence([size], log) {
  const left = size.value > 0
  const much = { ...size, value: Math.abs(size.value) }
  const side = left ? 'left' : 'right'
  const turns = `The robot turns ${plusMinus(much, DEGREES)}° more to the ${side} on each metre than is read`
  if (size.end) return `${turns}: mend the sizes of its wheels, or the unit of its turns.`
  const [larger, other] = left ? ['right', 'left'] : ['left', 'right']
  return (
    `${turns}: take the turns so. ` +
    `A ${larger} wheel that is larger than the ${other} by ${by(much, log?.base ?? null)} turns it so. ` +
    'If one wheel alone is off, ways and turns are wrong by half of that as well, which a verdict after this looks for.'
  )
}
