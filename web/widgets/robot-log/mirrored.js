/** What is counted the other way round, in words: turns, or bearings. */

/** @typedef {import('./looks.js').Log | null} Log */

/** @param {Log} log */
export function mirroredSentence(log) {
  const heading = log?.readings?.heading
    ? ', or the headings are in another unit, from north or from the axis of x'
    : ''
  return (
    'The turns have the wrong sign: choose the unit of ω that turns the other way, or change their sign ' +
    `in the file. If they are right, x and y of the places are exchanged${heading}.`
  )
}

export const MIRRORED_BEARINGS =
  'The bearings are counted clockwise, and taken for counter-clockwise ones: choose the unit of the bearing that ' +
  'says clockwise, or change their sign in the file.'
