/** The columns of the figure's CSV: its innovations, each at its own time, and what ranges are off by beside them. */

/** @typedef {import('estimate-wasm').LogFrame} Frame */

/**
 * Where no reading was looked at, ranges stand by themselves, held against where the robot was.
 * @param {Frame} frame
 * @returns {Record<string, any>}
 */
export function series({ innovations, ranges }) {
  if (innovations.time.length === 0) return { time: ranges.time, range: ranges.range, residual: ranges.residual }
  const { time, sensor, landmark, expected, innovation, normalized, used } = innovations
  return {
    time,
    sensor,
    ...(landmark.some((id) => id !== null) ? { landmark } : {}),
    ...(ranges.time.length > 0 ? beside(ranges, innovations) : {}),
    expected,
    innovation,
    normalized,
    used: used.map(Number),
  }
}

/**
 * Of each innovation of a sighting its range and that one's residual; null of another sensor's.
 * @param {Frame['ranges']} ranges @param {Frame['innovations']} innovations
 */
function beside(ranges, { time, sensor }) {
  let at = 0
  const range = []
  const residual = []
  for (const [i, when] of [...time].entries()) {
    const sighted = sensor[i] === 'range' || sensor[i] === 'bearing'
    while (sighted && at < ranges.time.length && ranges.time[at] < when) at += 1
    const found = sighted && ranges.time[at] === when
    range.push(found ? ranges.range[at] : null)
    residual.push(found ? ranges.residual[at] : null)
    if (found) at += 1
  }
  return { range, residual }
}
