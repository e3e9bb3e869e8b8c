/** What of the innovations does not look like noise, in words. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */

/** What the rows of a sensor are called. */
export const READINGS = { fix: 'positions', heading: 'headings', range: 'ranges', bearing: 'ranges with a bearing' }

/** How far apart they are taken, s. @param {LogJudgement['thinning'] & {}} thinning */
export const apart = ({ every }) => `${fixed(every, every < 1 ? 1 : 0)} s apart`

/**
 * What positions that go together leave to say alone: so many tell no more than a few do, and a fault would be named by
 * chance. Empty where there is more.
 * @param {LogJudgement} judgement
 */
export function alike({ thinning, other }) {
  if (!thinning || (thinning.either && !other)) return ''
  if (thinning.either) return wandering(thinning)
  const [all, few] = thinning.by.map((by) => fixed(by, 2))
  const [count, tells] = thinning.counts.map((count) => Math.round(count).toLocaleString('en'))
  return (
    'The positions go together: even with a σ so large that it allows for other errors, neighbouring innovations are ' +
    `correlated by ${all}. So ${count} of them tell about as much as ${tells} that err apart, and a fault would be ` +
    `named by chance. Take those first that are at least ${apart(thinning)}: they are correlated by ${few}.`
  )
}

/**
 * Positions that go together where another σ fits: that may be how little their errors change.
 * @param {LogJudgement['thinning'] & {}} thinning
 */
export const wandering = (thinning) =>
  'The positions err alike from one to the next: neighbouring innovations are correlated by ' +
  `${fixed(thinning.by[0], 2)}, as where a receiver’s errors wander. Then so many tell no more than a few, and the ` +
  `filter is too sure: take those that are at least ${apart(thinning)}.`

/** What does not look like noise beside no fault. @param {LogJudgement} judgement */
export function noisy({ noise: { nis, refused, correlated } }) {
  /** @param {LogJudgement['noise']['nis'] & {}} stretch */
  const when = ({ times: [from, to] }) => `from ${fixed(from, 1)} to ${fixed(to, 1)} s after the first row`
  const percent = (/** @type {number} */ share) => `${fixed(100 * share, share < 0.1 ? 1 : 0)} %`
  const all = [
    nis && `${when(nis)} NIS is ${fixed(nis.there, 1)}, and ${fixed(nis.elsewhere, 1)} elsewhere`,
    refused &&
      `${when(refused)} the gates refuse ${percent(refused.there)} of the readings, and ` +
        `${percent(refused.elsewhere)} elsewhere`,
    correlated &&
      `the innovations of the ${READINGS[correlated.sensor]} are correlated by ${fixed(correlated.by, 2)} from one ` +
        `to the next, where chance gives ±${fixed(correlated.chance, 2)}`,
  ].filter((one) => one !== null)
  return all.length > 0 && `Yet ${all.join('; ')}: something may be wrong, for a time, that was not looked for.`
}
