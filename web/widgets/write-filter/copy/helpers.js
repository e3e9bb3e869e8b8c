/** The functions of a language that a copy calls. */

/**
 * Those that are called, and those that these call, in the order of the list.
 * @param {Record<string, string>} helpers @param {Record<string, string[]>} need @param {Set<string>} called
 */
export function helpersOf(helpers, need, called) {
  const wanted = new Set()
  const want = (/** @type {string} */ name) => {
    wanted.add(name)
    for (const other of need[name] ?? []) want(other)
  }
  for (const name of called) want(name)
  return Object.keys(helpers).filter((name) => wanted.has(name))
}
