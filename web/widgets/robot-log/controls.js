/** What a reader sets in the figure of a log. */

import { fixed } from '../../draw/numbers.js'

/** @typedef {import('estimate-wasm').LogFrame} Frame */

/**
 * A slider over powers of ten: its numbers are the logarithms.
 * @param {string} name
 * @param {import('../../draw/words.js').Words} label
 * @param {[number, number]} ends
 * @param {string} unit
 * @param {number} decimals
 */
function logarithmic(name, label, ends, unit, decimals) {
  const [least] = ends.map((end) => 10 ** end)
  return {
    kind: /** @type {const} */ ('range'),
    name,
    label,
    ends,
    step: 0.02,
    scale: (/** @type {number} */ value) => Math.log10(Math.max(value, least)),
    set: (/** @type {number} */ value) => ({ [name]: Number((10 ** value).toPrecision(3)) }),
    words: (/** @type {number} */ _, /** @type {Frame} */ frame) =>
      `${fixed(frame.params[/** @type {'sigmaRange'} */ (name)], decimals)} ${unit}`,
  }
}

const GATES = [null, 0.95, 0.99, 0.999]

/** Whether there may be ranges. @param {Frame} frame */
export const mapped = ({ landmarks }) => landmarks.length > 0
/** Whether ranges are the readings of the log. @param {Frame} frame */
const ranged = ({ landmarks, summary: { sensors } }) => landmarks.length > 0 || !(sensors.fix || sensors.heading)

/** @type {import('../../figure/controls.js').Control[]} */
export const controls = [
  { kind: 'toggle', name: 'sightings', label: 'ranges correct the estimate', shown: ranged },
  { kind: 'toggle', name: 'learn', label: 'learn the scale *ε*', shown: ranged },
  {
    kind: 'choice',
    name: 'gate',
    label: 'Gate',
    options: GATES.map((value) => ({ value, label: value === null ? 'off' : `${fixed(100 * value, 1)} %` })),
  },
  {
    kind: 'range',
    name: 'scale',
    label: 'Scale *ε* of the ranges',
    ends: [-0.2, 0.2],
    step: 0.001,
    words: (value) => `${fixed(100 * value, 1)} %`,
    enabled: ({ learn }) => !learn,
    shown: ranged,
  },
  {
    kind: 'range',
    name: 'offset',
    label: 'Offset of the ranges',
    ends: [-5, 5],
    step: 0.1,
    words: (value) => `${fixed(value, 1)} m`,
    shown: ranged,
  },
  { ...logarithmic('sigmaRange', '*σ*_ρ, of a range', [-1, 1], 'm', 2), shown: ranged },
  {
    ...logarithmic('sigmaBearing', '*σ*_β, of a bearing', [-3, 0], 'rad', 3),
    shown: (/** @type {Frame} */ frame) => frame.bearings,
  },
  logarithmic('sigmaDistance', '*σ*_d, of the distance', [-3, 0], 'm/√s', 3),
  logarithmic('sigmaTurn', '*σ*_θ, of the turn', [-3, 0], 'rad/√s', 3),
]
