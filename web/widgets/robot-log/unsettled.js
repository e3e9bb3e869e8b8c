/** Several σ that are wrong, or that nobody has said of a log: they are found together. */

import { named } from './named.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */
/** @typedef {import('estimate-wasm').Parameter[]} Known */

/**
 * The σ that a fit is to find together, by their names: where the verdict names one, all that the readings say are
 * wrong, and those with which the page begins, whatever the log is.
 * @param {LogJudgement} judgement @param {Record<string, any>} params
 * @param {Known} known
 */
export function unsettled(judgement, params, known) {
  const all = named(judgement)
  if (all.length === 0 || all.some(({ fault }) => fault !== 'sigma')) return []
  const open = judgement.suspects.filter(
    (suspect) => suspect.fault === 'sigma' && (suspect.standing !== 'cleared' || isUsual(suspect, params, known)),
  )
  return open.map(({ name }) => name ?? '')
}

/**
 * Whether a σ is the one with which the page begins; none that readings bring is.
 * @param {import('estimate-wasm').LogSuspect} suspect @param {Record<string, any>} params @param {Known} known
 */
export const isUsual = ({ name, claims }, params, known) =>
  !claims && known.some((one) => one.name === name && one.default === params[one.name])

const WORDS = ['no', 'one', 'two', 'three', 'four', 'five', 'six', 'seven']

/** @param {number} count */
const word = (count) => WORDS[count] ?? String(count)

/** As a reader counts them. @param {unknown[]} all */
export const counted = ({ length }) => (length === 2 ? 'both' : `all ${word(length)}`)

/**
 * What is said of a σ that the verdict names.
 * @param {LogJudgement} judgement @param {Record<string, any>} params @param {Known} known
 */
export function unsettledWords(judgement, params, known) {
  const begins = named(judgement).some((suspect) => suspect.fault === 'sigma' && isUsual(suspect, params, known))
  const all = unsettled(judgement, params, known)
  const others = all.length - named(judgement).length
  const first = begins ? ' That σ is the one with which the page begins, whatever the log is.' : ''
  if (others <= 0) return first
  const more = others === 1 ? 'Another σ is' : `The ${word(others)} others are`
  return `${first} ${more} as uncertain: a fit finds ${counted(all)} together.`
}
