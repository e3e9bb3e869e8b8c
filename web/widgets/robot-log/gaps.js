/** Stretches of a log in which no motion is read, in words, and whether a fault can be told beside them. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogJudgement['gaps'][number]} Gap */

/** Beside a gap of more than this share of the longest stretch without one, no other fault is told. */
const MUCH = 0.05

/** @param {[number, number]} stretch */
const length = ([from, to]) => to - from

/** The longest of some gaps; undefined where there is none. @param {Gap[]} gaps */
export const longest = (gaps) => [...gaps].sort((one, other) => length(other.longest) - length(one.longest))[0]

/** Whether the log is to be cut before anything else is told of it. @param {Gap[]} gaps */
export function cutsFirst(gaps) {
  const gap = longest(gaps)
  return Boolean(gap) && length(gap.longest) > MUCH * length(gap.between)
}

/** What is held over a gap looks like any fault of the motion. @param {Gap} gap */
export function bridged({ what, count, longest }) {
  const [from, to] = longest.map((time) => fixed(time, 1))
  const rows = what === 'held' || what === 'odometry' ? 'rows of motion' : what
  const held = what === 'odometry' ? 'the row after it is taken for all since' : 'what was read last is held meanwhile'
  const more = count > 1 ? ` (the longest of ${count} such gaps)` : ''
  return (
    `No ${rows} from ${from} to ${to} s after the first row${more}: ${held}, ` +
    'which looks like a fault of the motion. Cut the log there first.'
  )
}

/** What is said beside a gap in which any fault may hide. */
export const HIDDEN = 'The readings do not fit what is held, and what else is wrong shows once the log is cut.'
