/** Which of the suspects of a verdict are named. */

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').LogSuspect} Suspect */
/** @typedef {import('./looks.js').Log} Log */

/** A suspect this near to the first, in log-likelihood, is named beside it. */
export const NEAR = 3

/** What is likeliest where nothing mends by itself. @param {LogJudgement} judgement */
const likeliest = ({ suspects: [first], other, thinning }) => (other && first && !thinning ? [first] : [])

/**
 * Whether an antenna that stands elsewhere may be what is named: its course runs ahead of the robot in each turn, as a
 * turn rate that is late, or a heading that is early, does.
 * @param {Suspect[]} all that are named @param {Record<string, any>} params @param {Log | null} log
 */
export const mayBeCourse = ([first], { fixes, headings }, log) =>
  Boolean(log?.course && fixes && headings && first?.fault === 'clock' && !first.own && !first.with) &&
  ['delayTurn', 'delayHeading'].includes(first.name ?? '')

/**
 * The landmarks that the page has mended so before: of two faults of one, that is mended once more before another is
 * named.
 * @param {Suspect['fault']} fault @param {Log | null} log @returns {number[][]}
 */
const mended = (fault, log) =>
  (fault === 'displaced' ? log?.corrections?.landmarks : fault === 'landmark-bias' ? log?.corrections?.ranges : null) ??
  []

/** What may be no fault stands behind one that is. @param {Suspect[]} suspects */
function sureBefore(suspects) {
  const is = suspects[0].own
    ? suspects.find(({ standing, own, mended }) => standing !== 'cleared' && !own && !mended)
    : undefined
  return is ? [is, ...suspects.filter((one) => one !== is)] : suspects
}

/**
 * The faults that a judgement names: none, one, or two where the readings do not tell which it is.
 * @param {LogJudgement} judgement @param {Log | null} [log]
 */
export function named({ suspects, other, thinning }, log = null) {
  if (!suspects[0] || suspects[0].standing === 'cleared' || other || (thinning && !thinning.either)) return []
  const [first, ...others] = sureBefore(suspects)
  if (first.standing === 'sure' || thinning) return [first]
  // What was held against the truth, and is not the first, mends nothing; what may be no fault is none to choose.
  const rival = others.find(
    ({ standing, excess, mended, own }) => standing !== 'cleared' && excess > first.excess - NEAR && !mended && !own,
  )
  if (!rival) return [first]
  const [id] = first.landmarks ?? []
  const before = [first, rival].filter(({ fault }) => mended(fault, log).some(([one]) => one === id))
  return before.length === 1 && rival.landmarks?.[0] === id ? before : [first, rival]
}

/**
 * What a verdict names, or what is likeliest where nothing mends by itself.
 * @param {LogJudgement} judgement @param {Log | null} [log]
 */
export const told = (judgement, log = null) => [...named(judgement, log), ...likeliest(judgement)]
