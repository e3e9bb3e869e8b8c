/** Fetches the module with the labs of the figures late in the chapter, and its script, when the first of them comes near. */

import { inTime } from './timeouts.js'

/** @returns {Promise<import('./loader.js').Loaded<any>>} never throws: a failure is an answer, and the next call tries again */
export async function loadLate() {
  try {
    const { loadLateModule } = await inTime(import('./late-module.js'))
    return loadLateModule()
  } catch {
    return { ok: false, why: 'its script could not be fetched' }
  }
}
