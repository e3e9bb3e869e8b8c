/** The phrases of the Probe. Each sets what the text's claim about it depends on, whatever a reader has set before. */

import { usual } from '../../figure/defaults.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */

export const degree = Math.PI / 180

/** What the phrases change, as it is at first. @param {any} lab */
const plainly = (lab) => usual(lab, 'sensor', 'stop', 'forget', 'ghost', 'tolerance')

/** The ends of laps at which the text compares traces. */
const COMPARED = [240, 480, 960, 1920]

/** @type {import('../../figure/spec.js').Try[]} */
export const tries = [
  {
    name: 'two',
    label: 'Two landmarks',
    change: (_, lab) => ({ ...plainly(lab), ...usual(lab, 'landmarks'), count: 2 }),
  },
  {
    name: 'line',
    label: 'Put the last landmark in line',
    change: (/** @type {Frame} */ { params }, lab) => {
      // A line takes a second landmark and no third, and ranges alone see that it is one; the lab puts it there.
      const shown = { ...plainly(lab), count: 2 }
      const other = lab.constructor.from({ ...lab.state(), params: { ...params, ...shown } })
      const last = shown.count - 1
      const at = Array.from(other.collinearPoint(last))
      other.free()
      return { ...shown, landmarks: params.landmarks.map((point, i) => (i === last ? at : point)) }
    },
  },
  {
    name: 'bearing',
    label: 'One landmark, range and bearing',
    change: (_, lab) => ({ ...plainly(lab), count: 1, sensor: 'range-bearing' }),
  },
  {
    name: 'ghost',
    label: 'Turn the world',
    change: (_, lab) => ({
      ...plainly(lab),
      count: 1,
      sensor: 'range-bearing',
      ghost: true,
      ghostAround: 10 * degree,
      ghostShift: 0,
      ghostTurn: 0,
    }),
  },
  {
    name: 'map',
    label: 'Forget the map',
    change: (_, lab) => ({
      ...plainly(lab),
      ...usual(lab, 'landmarks'),
      count: 3,
      sensor: 'range-bearing',
      forget: true,
    }),
  },
  {
    name: 'farther',
    label: 'Drive twice as far',
    change: ({ step }) => ({ step: COMPARED.find((end) => end > step) ?? COMPARED.at(-1) }),
  },
]
