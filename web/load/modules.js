/** The builds of the module, by the list of figures: each is fetched, with its script, when it is first needed. */

import { BUILDS } from 'module-builds'
import { FIGURES } from '../../target/figures.js'
import { inTime } from './timeouts.js'

/** @typedef {import('./loader.js').Loaded<any>} Loaded */

/**
 * @param {string} build
 * @returns {Promise<Loaded>} never throws: a failure is an answer, and the next call tries again
 */
export async function loadBuild(build) {
  try {
    const { load } = await inTime(BUILDS[build]())
    return load()
  } catch {
    return { ok: false, why: 'its script could not be fetched' }
  }
}

/** The build that has the lab of the figure called `name`. @param {string} name @returns {Promise<Loaded>} */
export function loadLab(name) {
  return loadBuild(FIGURES.find((figure) => figure.name === name)?.build ?? '')
}
