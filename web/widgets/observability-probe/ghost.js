/**
 * The ghost, which starts elsewhere and drives the same ticks: what it reads beside what the robot reads, both without
 * noise.
 */

import { fixed } from '../../draw/numbers.js'
import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

const degrees = (/** @type {number} */ angle) => (angle * 180) / Math.PI

/** What is said of a ghost that is there. @param {Frame} frame */
export function ofTheGhost({ ghost, params, step }) {
  if (!ghost?.byHand) return 'The ghost drives where the robot drives: turn one of its dials.'
  const { moved, rangeGap, bearingGap } = ghost
  if (step === 0) return `The ghost begins ${fixed(moved, 2)} m from the robot: let both drive.`
  const where = `The ghost has been up to ${fixed(moved, 2)} m from the robot.`
  const bearings = bearingGap === null ? '' : ` and its bearings by ${fixed(degrees(bearingGap), 1)}°`
  if (rangeGap > 1e-9 || (bearingGap ?? 0) > 1e-9)
    return `${where} Its ranges differ by up to ${fixed(rangeGap, 2)} m${bearings}.`
  return (
    `${where} It reads what the robot reads${params.count === 1 ? '' : ' of every landmark'}: ` +
    'no filter can tell the two apart.'
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawRanges(panel, frame) {
  draw(panel, frame, 'ranges: robot, and ghost dashed (m)', ({ range, ghostRange }) => [range, ghostRange])
}

/** @param {Panel} panel @param {Frame} frame */
export function drawBearings(panel, frame) {
  draw(panel, frame, 'bearings: robot, and ghost dashed (°)', ({ bearing, ghostBearing }) => [
    bearing.map(degrees),
    ghostBearing.map(degrees),
  ])
}

/**
 * @param {Panel} panel
 * @param {Frame} frame
 * @param {string} title
 * @param {(readings: import('estimate-wasm').GhostReadings) => number[][]} pick
 */
function draw(panel, { ghost, series }, title, pick) {
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title,
        steps: series.step,
        lines: (ghost?.readings ?? []).flatMap((readings, i) => {
          const [robot, copy] = pick(readings)
          return [
            { key: `robot${i}`, values: robot, name: String(i + 1), kin: /** @type {const} */ ('measurement') },
            { key: `ghost${i}`, values: copy, name: '', shape: 'ghost dashed' },
          ]
        }),
      }),
  )
}

/** Columns of the CSV. @param {Frame} frame @returns {Record<string, number[]>} */
export function sketch({ series, ghost }) {
  const all = /** @type {Record<string, number[]>} */ ({ ...series })
  for (const [i, readings] of (ghost?.readings ?? []).entries()) {
    for (const [name, values] of Object.entries(readings)) all[`${name}${i + 1}`] = values
  }
  return all
}
