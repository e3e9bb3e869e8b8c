/**
 * Chromium 148 remembers that a script could not be fetched, as the standard has it, and answers every further import
 * with the same error. Once the server has the script again, only a reload brings it.
 */

import { fetchWithPatience } from './timeouts.js'

const SCRIPT = /\bhttps?:\S+\.js\b/

/**
 * Loads the page again, at `place`, if what could not be imported can be fetched now.
 * @param {unknown} error
 * @param {string | undefined} place
 */
export async function reloadIfThere(error, place) {
  const script = SCRIPT.exec(String(error))?.[0] ?? location.href
  const there = await fetchWithPatience(new URL(script)).then(
    () => true,
    () => false,
  )
  if (!there) return
  if (place) history.replaceState(history.state, '', `#${place}`)
  location.reload()
}
