/** Several σ that are wrong, or that nobody has said of a log: they are found together. */

import { cutsFirst } from './gaps.js'
import { told } from './named.js'
import { alike } from './noise.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').Parameter[]} Known */

/** The sensor that has a σ. @type {Record<string, string>} */
const SENSOR = {
  sigmaFix: 'fix',
  fixSigmaScale: 'fix',
  sigmaHeading: 'heading',
  headingSigmaScale: 'heading',
  sigmaRange: 'range',
  sigmaBearing: 'bearing',
}

/**
 * Whether a σ is all that is wrong, and larger, behind a gate. A fit finds the σ of what the gate lets through, and the
 * verdict that of all: each would take back what the other has set, for ever.
 * @param {import('estimate-wasm').LogSuspect[]} all that are told @param {LogJudgement} judgement
 * @param {Record<string, any>} params
 */
function isBehindItsGate([first, ...more], { suspects }, { gate }) {
  const sensor = SENSOR[first.name ?? '']
  const isOn = Boolean(gate && typeof gate === 'object' ? gate[sensor] : gate && sensor)
  const [size] = first.sizes
  const others = suspects.filter((one) => one.fault === 'sigma' && one !== first)
  return isOn && more.length === 0 && size.value > size.now && others.every(({ standing }) => standing === 'cleared')
}

/**
 * The σ that a fit is to find together, by their names: all of them where the verdict names one, as each was found
 * beside what the others were then.
 * @param {LogJudgement} judgement @param {Record<string, any>} params
 */
export function unsettled(judgement, params) {
  const all = told(judgement)
  if (all.length === 0 || all.some(({ fault }) => fault !== 'sigma')) return []
  if (isBehindItsGate(all, judgement, params)) return []
  return judgement.suspects.filter(({ fault }) => fault === 'sigma').map(({ name }) => name ?? '')
}

/**
 * Whether a σ is the one with which the page begins; none that readings bring is.
 * @param {import('estimate-wasm').LogSuspect} suspect @param {Record<string, any>} params @param {Known} known
 */
export const isUsual = ({ name, claims }, params, known) =>
  !claims && known.some((one) => one.name === name && one.default === params[one.name])

/** Whether any sensor has a gate. @param {Record<string, any>} params */
const isGated = ({ gate }) => (gate && typeof gate === 'object' ? Object.values(gate).some(Boolean) : Boolean(gate))

const WORDS = ['no', 'one', 'two', 'three', 'four', 'five', 'six', 'seven']

/** @param {number} count */
const word = (count) => WORDS[count] ?? String(count)

/** As a reader counts them. @param {unknown[]} all */
export const counted = ({ length }) => (length === 2 ? 'both' : `all ${word(length)}`)

const MOTION = ['sigmaDistance', 'sigmaTurn']
const BEHIND =
  ' The σ of the motion are those with which the page begins, and behind a gate they may be wrong unseen: Fit tells.'

/**
 * What is said of a σ that the verdict names; where it names nothing to mend behind a gate, of the σ of the motion.
 * @param {LogJudgement} judgement @param {Record<string, any>} params @param {Known} known
 */
export function unsettledWords(judgement, params, known) {
  // Beside a gap that is to be cut first no fault is named, and by readings that go together none is.
  if (alike(judgement) || (judgement.suspects[0]?.standing !== 'cleared' && cutsFirst(judgement.gaps))) return ''
  const usual = judgement.suspects.filter((one) => MOTION.includes(one.name ?? '') && isUsual(one, params, known))
  const settled = told(judgement).every(({ own }) => own)
  if (settled && usual.length === MOTION.length && isGated(params)) return BEHIND
  const begins = told(judgement).some((suspect) => suspect.fault === 'sigma' && isUsual(suspect, params, known))
  const all = unsettled(judgement, params)
  const first = begins ? ' That σ is the one with which the page begins, whatever the log is.' : ''
  if (all.length < 2) return first
  const open = judgement.suspects.filter(
    (one) => all.includes(one.name ?? '') && (one.standing !== 'cleared' || isUsual(one, params, known)),
  )
  const others = open.length - told(judgement).length
  const more =
    others <= 0 ? '' : others === 1 ? ' Another σ is as uncertain:' : ` The ${word(others)} others are as uncertain:`
  return more
    ? `${first}${more} a fit finds ${counted(all)} together.`
    : `${first} A fit finds ${counted(all)} together.`
}
