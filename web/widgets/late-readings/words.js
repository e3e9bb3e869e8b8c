/** What the figure of late readings says: each sentence follows from the numbers of the frame. */

import { fixed } from '../../draw/numbers.js'
import { CAMERA, SENSORS } from './sensors.js'

/** @typedef {import('estimate-wasm').LateFrame} Frame */

const metres = (/** @type {number} */ value) => `${fixed(value, 2)} m`

/** @param {Frame} frame */
export function verdict(frame) {
  return [ofTheLate(frame), ofTheGap(frame)].filter(Boolean).join(' ')
}

/** @param {Frame} frame */
function ofTheLate(frame) {
  const { params, sensors, lag, travelled, ways, settled } = frame
  const [asNew, dropped, back] = ways.map(({ rms }) => rms)
  const camera = sensors[CAMERA]
  if (camera.period === 0) return 'The camera reads nothing, so nothing comes late.'
  if (params.delay === 0) return params.ownDelay ? oneLate(frame) : 'Nothing comes late: the three ways are one.'
  const seconds = `${fixed(params.delay, 2)} s`
  if (params.way === 'drop')
    return (
      `Without the late readings the error is ${metres(dropped)} (RMS from ${fixed(settled, 0)} s on); ` +
      `going back would leave ${metres(back)}.`
    )
  if (params.way === 'go-back')
    return (
      `Put where they were measured, the late readings leave an error of ${metres(back)} ` +
      `(RMS from ${fixed(settled, 0)} s on).` +
      (camera.mean === null ? '' : ` The camera’s mean innovation is ${mean(camera)}.`)
    )
  const side = lag < 0 ? 'ahead' : 'behind'
  const alone = sensors.every(({ period }, i) => i === CAMERA || period === 0)
  // The readings agree with an estimate that is behind with them.
  const hidden = alone && camera.mean !== null && lag > 0.1 && Math.abs(camera.mean) < 0.1 * lag
  const innovation = camera.mean === null ? '' : `, and the camera’s mean innovation is ${mean(camera)}`
  return (
    `In ${seconds} the robot drives ${metres(travelled)}. ` +
    `With late readings taken as new the estimate is ${metres(Math.abs(lag))} ${side} in the mean${innovation}` +
    `${hidden ? ': it hides the lag' : ''}. ` +
    `The error is ${metres(asNew)} (RMS); going back would leave ${metres(back)}.`
  )
}

/** @param {Frame} frame */
function oneLate({ picked, ways }) {
  const [asNew, dropped, back] = ways.map(({ rms }) => metres(rms))
  const late = picked ? fixed(picked.came - picked.measured, 2) : ''
  return (
    `One reading comes ${late} s late. As new it leaves an error of ${asNew} (RMS), dropped ${dropped}, ` +
    `in its place ${back}.`
  )
}

/** @param {Frame} frame */
function ofTheGap({ gap }) {
  if (!gap) return ''
  const smoothed =
    gap.sigmaSmoothed === null || gap.worstPlace === null
      ? ''
      : ` Afterwards it is at most ${metres(gap.sigmaSmoothed)}, ${place(gap.worstPlace)} of the gap.`
  return (
    `In the gap of ${fixed(gap.to - gap.from, 2)} s the claimed σ of the position grows from ` +
    `${metres(gap.sigmaBefore)} to ${metres(gap.sigmaAfter)}.${smoothed}`
  )
}

/** Where in a gap: in its middle third, or nearer to an end. @param {number} part */
const place = (part) =>
  part < 1 / 3 ? 'in the first third' : part > 2 / 3 ? 'in the last third' : 'in the middle third'

/** @param {import('estimate-wasm').LateSensor} sensor */
export const mean = ({ mean }) => (mean === null ? 'none' : metres(mean))

/** @param {Frame} frame */
export function describe(frame) {
  const { params, error, twoSigma, sensors, picked, end, ways } = frame
  const worst = Math.max(...error.map(Math.abs))
  const beyond = error.filter((value, i) => Math.abs(value) > twoSigma[i]).length
  const counts = sensors.map(
    ({ came, used }, i) => `${came.length} of the ${SENSORS[i]}, ${used.filter(Boolean).length} of them used`,
  )
  const hand = picked
    ? ` The camera’s reading in hand was measured at ${fixed(picked.measured, 2)} seconds and ` +
      `${params.removed ? 'is taken out' : picked.missing ? 'is missing' : `came at ${fixed(picked.came, 2)}`}.`
    : ''
  return {
    line:
      `Estimate less truth over ${fixed(end, 0)} seconds with the claimed 2 σ, and the readings: ` +
      `${counts.join('; ')}. ` +
      `The error is at most ${fixed(worst, 2)} metres, and beyond 2 σ at ` +
      `${fixed((100 * beyond) / error.length, 0)} % of the times.${hand}`,
    innovations: `Innovations of each sensor over time. ${sensors
      .map((sensor, i) => `Mean of the ${SENSORS[i]}: ${mean(sensor)}.`)
      .join(' ')}`,
    costs:
      'Error and NEES of each way. In this run: ' +
      `as new ${cost(ways[0])}; dropped ${cost(ways[1])}; gone back ${cost(ways[2])}.`,
  }
}

/** @param {import('estimate-wasm').LateCost} cost */
const cost = ({ rms, nees }) => `${fixed(rms, 2)} metres, NEES ${fixed(nees, 1)}`
