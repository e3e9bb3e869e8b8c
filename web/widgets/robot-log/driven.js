/** Odometry that reads too long or too short, in words: by which factors, and which wheels do so. */

import { decimal } from '../../draw/numbers.js'
import { plusMinus, rounded } from './sized.js'

/** @typedef {import('estimate-wasm').LogSuspect['sizes'][number]} Size */
/** @typedef {import('./looks.js').Log | null} Log */

/** How many times the distances, and where it turns the turns, are to be taken. @param {Size[]} sizes */
export const factors = (sizes) => sizes.map((size) => 1 + rounded(size))

/** How much farther or less far than it reads. @param {Size} size @param {[string, string]} words more and less */
function much({ value, ...size }, [more, less]) {
  return `${plusMinus({ ...size, value: Math.abs(value) }, 100)} % ${value > 0 ? more : less}`
}

/** @param {Size[]} sizes @param {Log} log */
export function odometrySentence(sizes, log) {
  const [far, turned] = sizes
  if (far.end) return 'The distances of odometry are not those that the robot drives: mend their unit.'
  const times = (/** @type {number} */ factor) => `${decimal(factor, 4)} times`
  const [along, about] = factors(sizes)
  const drives = `The robot drives ${much(far, ['farther', 'less far'])}`
  if (!turned) return `${drives} than odometry reads: take the distances ${times(along)} as they are read.`
  const both = `the distances ${times(along)} and the turns ${times(about)} as they are read`
  return (
    `${drives} and turns ${much(turned, ['more', 'less'])} than odometry reads: take ${both}. ` +
    `${log?.wheels ? 'A' : 'Of two wheels a'} radius ${times(along)} and a base ${times(along / about)} as long as ` +
    'was said do the same.'
  )
}
