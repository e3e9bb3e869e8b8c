/**
 * What the three ways cost over 500 seeds, computed beside the run, a few seeds at a time, and anew for each schedule
 * of readings.
 */

import { SEEDS } from '../../figure/ensemble.js'
import { InParts, inOne } from '../../figure/in-parts.js'

/** Seeds of one call: about five milliseconds. */
const CALL = 20
/** What the costs do not depend on. */
const BESIDE = ['way', 'smooth', 'seed']

/** @typedef {{ rms: number, nees: number }} Cost */
/** @typedef {{ seeds: number, ways: Cost[] }} Costs the means so far */

/** @param {number[]} numbers of so many seeds @returns {Costs} */
function means(numbers) {
  const seeds = numbers.length / 6
  const mean = (/** @type {number} */ i) => {
    let sum = 0
    for (let k = i; k < numbers.length; k += 6) sum += numbers[k]
    return sum / seeds
  }
  return { seeds, ways: [0, 2, 4].map((i) => ({ rms: mean(i), nees: mean(i + 1) })) }
}

/** @type {import('../../figure/in-parts.js').Task<Costs>} */
export const counting = {
  parts: SEEDS,
  unit: 'seed',
  each: 6,
  stays: true,
  about: (params) => JSON.stringify(Object.entries(params).filter(([name]) => !BESIDE.includes(name))),
  wanted: () => true,
  compute: (lab, from) => lab.seeds(from, CALL),
  value: means,
}

/** @type {import('../../figure/spec.js').Aside} */
export const costs = {
  whole: (lab) => inOne(counting, lab),
  open: (changed) => new InParts(counting, changed, open),
}

/** A lab with these parameters. @param {any} params */
async function open(params) {
  const { loadLab } = await import('../../load/modules.js')
  const loaded = await loadLab('late-readings')
  if (!loaded.ok) throw new Error(loaded.why)
  return loaded.module.LateReadings.from({ version: 1, lab: 'late-readings', step: 0, params })
}
