/** What the three sensors and the three ways are called, and how their readings are drawn. */

import { pixel } from '../../draw/path.js'
import { meaning } from '../../draw/plot.js'

export const SENSORS = ['sonar', 'laser', 'camera']
/** The number of the camera, whose readings come late. */
export const CAMERA = 2

/** The ways, as the frame lists them. */
export const WAYS = [
  { value: 'as-new', label: 'As if it were new' },
  { value: 'drop', label: 'Drop it' },
  { value: 'go-back', label: 'Go back' },
]

/** A sonar's reading is a dot, a laser's an upright cross, a camera's a diamond. */
const SHAPES = ['h0', 'm-4 0h8m-4-4v8', 'm0-5l4 5l-4 5l-4-5z']

/**
 * Draws the readings of a sensor that were used or that were not; what lies outside stands at the edge.
 * @param {import('../../draw/pen.js').Pen} pen
 * @param {string} key
 * @param {{ x: (value: number) => number, y: (value: number) => number }} scales
 * @param {[number, number]} edges the upper and the lower edge, pixels
 * @param {number} sensor
 * @param {[number, number][]} places
 */
export function drawReadings(pen, key, { x, y }, [top, bottom], sensor, places) {
  const at = (/** @type {[number, number]} */ [time, value]) =>
    `M${pixel(x(time))} ${pixel(Math.max(top, Math.min(bottom, y(value))))}${SHAPES[sensor]}`
  const shape = sensor === 0 ? 'points' : sensor === 1 ? 'line' : 'full'
  pen.mark('path', key, { ...meaning(shape, 'measurement'), d: places.map(at).join('') })
}
