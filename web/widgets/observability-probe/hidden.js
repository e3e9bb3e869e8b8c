/** The directions that no output sees: as strokes on the map, and how the heading turns along them. */

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('estimate-wasm').ProbeRanks} Ranks */

/** Half the length of a drawn direction, metres. */
const ARM = 0.9
/** A direction that turns by more than this for each metre, radians, is drawn as a turn in place. */
const IN_PLACE = 20
/** Of several hidden directions any mix is hidden too: so many of a basis are drawn. */
const DRAWN = 2

/** @param {number[]} direction */
const inPlace = ([dx, dy, turn]) => (dx === 0 && dy === 0) || Math.abs(turn) > IN_PLACE

/**
 * A line through the estimate, or null for a turn in place. Where two of one kind are drawn, their names count them.
 * @param {Frame} frame
 * @returns {{ key: string, shape: string, words: string, ends: [number, number][] | null }[]}
 */
export function hidden({ estimate: [x, y], frozen, alongPath }) {
  // Before the first step there is no path, and nothing is said of one.
  const driven = alongPath.steps > 0 ? [{ name: 'path', shape: 'direction', ranks: alongPath }] : []
  return [{ name: 'frozen', shape: 'level', ranks: frozen }, ...driven].flatMap(
    ({ name, shape, ranks: { directions } }) =>
      directions.slice(0, DRAWN).map((direction, i) => ({
        key: `${name}${i}`,
        shape,
        words: directions.length > 1 ? `${name} ${i + 1}` : name,
        ends: inPlace(direction) ? null : [-ARM, ARM].map((arm) => [x + arm * direction[0], y + arm * direction[1]]),
      })),
  )
}

/** How the heading turns along the hidden directions that are drawn. @param {Ranks} ranks */
export function turns({ directions }) {
  const several = directions.length > 1
  const drawn = directions.slice(0, DRAWN)
  const said = drawn.map((direction, i) => {
    const turn = inPlace(direction) ? 'on the spot' : `${Math.round(Math.abs(direction[2] * 180) / Math.PI)}°`
    return `${several ? `${i + 1}: ` : ''}${turn}${inPlace(direction) || i < drawn.length - 1 ? '' : ' a metre'}`
  })
  return said.join(', ') || '–'
}
