/** What of the innovations does not look like noise, in words. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogJudgement} LogJudgement */

/** What the rows of a sensor are called. */
export const READINGS = { fix: 'positions', heading: 'headings', range: 'ranges', bearing: 'ranges with a bearing' }

/**
 * Readings that go together: so many tell no more than a few do, and a fault would be named by chance.
 * @param {LogJudgement['thinning'] & {}} thinning
 */
export function alike({ sensor, every, by: [all, few], counts: [count, tells] }) {
  const rows = READINGS[sensor]
  return (
    `The ${rows} go together: even with a σ so large that it allows for other errors, neighbouring innovations are ` +
    `correlated by ${fixed(all, 2)}. So ${count.toLocaleString('en')} of them tell about as much as ` +
    `${fixed(tells, 0)} that err apart, and a fault would be named by chance. Take those first that are ` +
    `at least ${fixed(every, every < 1 ? 1 : 0)} s apart: they are correlated by ${fixed(few, 2)}.`
  )
}

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
