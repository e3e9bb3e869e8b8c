/** Which landmarks of a map are ghosts: those founded on what the map had already. Only a simulation can know. */

/** @param {import('estimate-wasm').LoopFrame} frame @returns {Set<number>} their numbers in the map */
export function ghosts({ map }) {
  const [known, found] = [/** @type {Set<number>} */ (new Set()), /** @type {Set<number>} */ (new Set())]
  for (const { id, truth } of map.landmarks) {
    if (known.has(truth)) found.add(id)
    known.add(truth)
  }
  return found
}
