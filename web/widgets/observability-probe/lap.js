/** One lap of a track: each place of a closed path once. */

/** @typedef {{ x: number[], y: number[] }} Track */

/** How near to a corner counts as there, metres. */
const NEAR = 1e-6

/**
 * The points of the track's first lap from the first corner of the square on, so that its dashes stay where they are
 * while it is driven again; all of a track that is no whole lap. The ghost's track has its corners where the robot's
 * has them.
 * @param {Track} track @param {Track} truth @param {number[][]} square
 */
export function lap({ x, y }, truth, square) {
  const points = x.map((value, i) => [value, y[i]])
  const whole = square.reduce(
    (sum, [cx, cy], i) =>
      sum + Math.hypot(square[(i + 1) % square.length][0] - cx, square[(i + 1) % square.length][1] - cy),
    0,
  )
  const corner = truth.x.findIndex((value, i) => Math.hypot(value - square[0][0], truth.y[i] - square[0][1]) < NEAR)
  return once(points.slice(Math.max(0, corner)), whole) ?? once(points, whole) ?? points
}

/** As much of a line as is so long, or null where it is shorter. @param {number[][]} points @param {number} length */
function once(points, length) {
  for (let i = 1, gone = 0; i < points.length; i += 1) {
    const [[x1, y1], [x2, y2]] = [points[i - 1], points[i]]
    const piece = Math.hypot(x2 - x1, y2 - y1)
    const part = (length - gone) / piece
    if (part <= 1 + NEAR) return [...points.slice(0, i), [x1 + part * (x2 - x1), y1 + part * (y2 - y1)]]
    gone += piece
  }
  return null
}
