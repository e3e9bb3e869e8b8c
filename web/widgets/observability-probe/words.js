/**
 * What the Observability Probe says: its verdict on the two ranks, and its panels in words.
 */

import { fixed, power } from '../../draw/numbers.js'
import { ofTheGhost } from './ghost.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */

const NUMBERS = ['no', 'one', 'two', 'three']
const capital = (/** @type {string} */ words) => words[0].toUpperCase() + words.slice(1)

/** @param {Frame} frame */
export function verdict(frame) {
  const { params, sensor, frozen, alongPath, slam } = frame
  if (frame.ghost) return ofTheGhost(frame)
  if (slam) {
    const worst = slam.worst
      ? ` The worst stands ${fixed(slam.worst.error, 2)} m off, ${fixed(slam.worst.sigma, 1)} of its own σ.`
      : ''
    return (
      'The map is forgotten, and ranges with bearings found it anew: ' +
      `${slam.founded} founded, ${slam.matched} matched, ${slam.rejected} rejected.` +
      `${worst}${slam.full ? ' The map is full: it founds no more.' : ''}`
    )
  }
  const what =
    `${capital(NUMBERS[params.count])} ${params.count === 1 ? 'landmark' : 'landmarks'}, ` +
    `${sensor === 'range' ? 'range only' : 'range and bearing'}: rank ${frozen.rank} frozen at this pose`
  if (alongPath.steps === 0) return `${what}. No path is driven yet, so there is no rank along it.`
  return (
    `${what}, ${alongPath.rank} along the last ${alongPath.steps === 1 ? 'step' : `${alongPath.steps} steps`}. ` +
    `${ofTheRanks(params.count, frozen.rank, alongPath)}`
  )
}

/**
 * What two ranks of three say together.
 * @param {number} count
 * @param {number} frozen
 * @param {import('estimate-wasm').ProbeRanks} path
 */
function ofTheRanks(count, frozen, { rank, relative }) {
  const directions = (/** @type {number} */ many) => `${NUMBERS[many]} ${many === 1 ? 'direction' : 'directions'}`
  if (rank === 3)
    return frozen === 3
      ? 'Every direction of the pose is seen.'
      : `This pose alone hides ${directions(3 - frozen)}, and the path has shown ${frozen === 2 ? 'it' : 'them'}.`
  const hidden = 3 - rank
  if (frozen === 3)
    return count === 1
      ? 'The frozen test is too kind: turn the pose about the landmark, and no reading changes.'
      : `The frozen test counts ${directions(hidden)} more than the path has shown.`
  // What is hidden is so up to rounding; what a coarse tolerance leaves out is only seen badly.
  if (relative[rank] >= 1e-9)
    return `${capital(directions(hidden))} of the pose ${hidden === 1 ? 'falls' : 'fall'} below the tolerance.`
  return (
    `${capital(directions(hidden))} of the pose ${hidden === 1 ? 'is' : 'are'} hidden: ` +
    `no reading along the path changes with ${hidden === 1 ? 'it' : 'them'}.`
  )
}

/** @param {Frame} frame */
export function describe(frame) {
  const { estimate, error, ellipse, frozen, alongPath, trace, mean, ghost } = frame
  const ranks = (/** @type {import('estimate-wasm').ProbeRanks} */ r) =>
    `rank ${r.rank} of ${r.n}, smallest over largest singular value ${power(r.relative[r.relative.length - 1])}`
  const landmarks = frame.landmarks
    .filter(({ shown }) => shown)
    .map(({ x, y }, i) => `${i + 1} at ${fixed(x, 1)}, ${fixed(y, 1)}`)
    .join('; ')
  return {
    map:
      `Room A, 6 by 6 metres, step ${frame.step}. Landmarks: ${landmarks}. ` +
      `The estimate stands at ${fixed(estimate[0], 2)}, ${fixed(estimate[1], 2)}, ` +
      `off by ${fixed(Math.hypot(error[0], error[1]), 2)} metres; ` +
      `its ellipse has half-axes of ${fixed(ellipse.semiMajor, 2)} and ${fixed(ellipse.semiMinor, 2)} metres.` +
      `${ghost ? ` A ghost stands at ${fixed(ghost.pose[0], 2)}, ${fixed(ghost.pose[1], 2)}.` : ''}`,
    ranks:
      `Singular values on a logarithmic scale. Frozen: ${ranks(frozen)}. Along the path: ` +
      `${alongPath.steps === 0 ? 'no step yet' : ranks(alongPath)}.`,
    trace:
      `Trace of the pose covariance over time, now ${fixed(trace.total, 3)}; ` +
      `with two landmarks and ranges only it would be ${fixed(trace.reference, 3)}.`,
    ranges: ghost
      ? `Ranges over time, of the robot and of the ghost; they differ by up to ${fixed(ghost.rangeGap, 3)} metres.`
      : '',
    bearings:
      ghost && ghost.bearingGap !== null
        ? 'Bearings over time, of the robot and of the ghost; ' +
          `they differ by up to ${fixed((ghost.bearingGap * 180) / Math.PI, 1)} degrees.`
        : '',
    nees: ghost ? '' : `Normalized estimation error over time, mean ${fixed(mean.nees, 1)}; 3 is expected.`,
    nis: ghost
      ? ''
      : `Normalized innovation over time, mean ${fixed(mean.nisPerDof, 1)} for each degree of freedom; 1 is expected.`,
  }
}
