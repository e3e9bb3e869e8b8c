/** What is said of a program, in a sentence. */

import { BUGS } from '../bug-museum/words.js'

/** @typedef {import('estimate-wasm').WriteFrame} Frame */

/** Whether nothing has been written yet. @param {Frame} frame */
export const isEmpty = ({ made, faults }) => made.length === 0 && faults[0]?.message.startsWith('The program is empty')

/** Whether an exercise asks where the fault is, and nothing is changed yet. @param {Frame} frame */
export const isRiddle = ({ params }) => params.text === null && params.begin.startsWith('mend-')

/** @param {Frame} frame */
export function verdict(frame) {
  if (isRiddle(frame)) return 'Not a right filter. Find the line at fault, and change it.'
  if (isEmpty(frame)) return 'Nothing is written yet. A step predicts the estimate, and a reading corrects it.'
  const { faults, outcome, bug, line, breaks, sentences, observer, stopped } = frame
  if (lacks(frame)) return `No filter yet: n${faults[0].message.split(':')[0].slice(1)}.`
  if (faults.length > 0) return `No filter yet: ${counted(faults.length)}, the first in line ${faults[0].line}.`
  if (outcome === 'unfinished') return sentences[0]
  const at = line === null ? '' : ` See line ${line}.`
  if (bug !== null) return `The museum’s bug “${BUGS[bug].name}”.${at}`
  if (outcome === 'right') {
    const reserve = sentences.some((said) => said.includes('not symmetric')) ? ' Its P is not quite symmetric.' : ''
    return breaks ? `A right filter, whose digits break where nothing is known.${reserve}` : `A right filter.${reserve}`
  }
  if (outcome === 'refused') return `No filter yet: line ${line ?? 1} has no value.`
  if (observer) return 'No Kalman filter: an observer with a fixed gain.'
  return `Not a right filter.${stopped ? ` Its run ends early.` : at}`
}

const counted = (/** @type {number} */ n) => (n === 1 ? 'one fault' : `${n} faults`)

/** Whether all that is wrong is that a line is missing: no line has a fault. @param {Frame} frame */
export const lacks = ({ faults, line }) => faults.length > 0 && line === null

/** Why, in sentences: the faults themselves stand in a list. @param {Frame} frame */
export const reasons = (frame) => {
  const { faults, outcome, sentences, stopped } = frame
  if (faults.length > 0 || isRiddle(frame)) return []
  return [
    ...(outcome === 'unfinished' ? sentences.slice(1) : sentences),
    ...(stopped ? [`The run stands still: ${stopped.message}`] : []),
  ]
}

/** What a screen reader hears when typing rests. @param {Frame} frame */
export function announce(frame) {
  if (isEmpty(frame) || isRiddle(frame)) return verdict(frame)
  const [first] = frame.faults
  if (lacks(frame)) return `No filter yet. ${first.message}`
  const why = first ? `Line ${first.line}, column ${first.column}: ${first.message}` : (reasons(frame)[0] ?? '')
  return `${verdict(frame)} ${why}`
}
