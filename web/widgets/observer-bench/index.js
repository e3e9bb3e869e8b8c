/**
 * The Observer Bench: turn the gain of an observer by hand, see the eigenvalues of its error move, then let the filter
 * choose the gain.
 */

import { fixed } from '../../draw/numbers.js'
import { drawDisc } from './disc.js'
import { drawError, drawGain, drawVariance } from './history.js'
import { drawPhase } from './phase.js'

/** @typedef {import('estimate-wasm').BenchFrame} Frame */

// State: the parameters that the lab declares, at their defaults, some steps on.

const start = { params: {}, step: 12 }

// Model: the lab `ObserverBench` in the module. What follows only reads its frame.

/** A factor with two decimals, or three where two would make it 1. @param {number} modulus */
function rate(modulus) {
  const words = fixed(modulus, 2)
  return words === '1.00' ? fixed(modulus, 3) : words
}

/** The filter has used no gain before its first step: its frame has the one that comes. @param {Frame} frame */
const before = ({ step, params }) => step === 0 && params.mode === 'filter'

/** @param {Frame} frame */
function verdict(frame) {
  const { pinned, diverged, params, modulus, spectralRadius, stableUpTo } = frame
  if (diverged)
    return `The estimate has left every bound, and the run has stopped. Turn the gain below ${fixed(stableUpTo, 2)}.`
  if (params.mode === 'fixed' && params.gain === 0)
    return 'Dead reckoning: no reading is used, and nothing takes an error back.'
  const factor = rate(pinned === null ? spectralRadius : modulus[1 - pinned])
  const other = pinned === null ? '' : ' The other eigenvalue is 1 for every gain: no gain takes a position error back.'
  // R(k) changes at every step. The eigenvalues of one step's matrix say what would happen if that gain were kept.
  if (params.mode === 'filter')
    return (
      (before(frame)
        ? 'No gain has been used yet. If the filter kept that of step 1, '
        : 'If the filter kept this step’s gain, ') +
      `${pinned === null ? 'every' : 'a velocity'} error would shrink by the ` +
      `factor ${factor} a step in the long run.${other}`
    )
  if (Number(factor) === 1)
    return `At the limit of stability: the factor a step is ${factor}, and an error neither dies out nor grows.`
  if (Number(factor) > 1) return `Unstable: in the long run the error grows by the factor ${factor} a step.`
  if (pinned === null) return `Stable: in the long run every error shrinks by the factor ${factor} a step.`
  return `A velocity error shrinks by the factor ${factor} a step.${other}`
}

/** @param {Frame} frame */
function describe(frame) {
  const { posterior, predicted } = frame
  const spread = (/** @type {import('estimate-wasm').BenchBelief} */ belief) =>
    `${fixed(Math.sqrt(belief.P[0][0]), 2)} metres and ${fixed(Math.sqrt(belief.P[1][1]), 2)} metres a second`
  const off = posterior.x.map((value, i) => value - frame.truth[i])
  const [one, two] = frame.eigenvalues
  const eigen =
    one.im !== 0
      ? `${fixed(one.re, 2)} ± ${fixed(Math.abs(one.im), 2)} i`
      : `${fixed(one.re, 2)} and ${fixed(two.re, 2)}`
  const last = (/** @type {number[]} */ values) => fixed(values[values.length - 1], 2)
  const { series } = frame
  return {
    phase:
      `Phase plane at step ${frame.step}, seen from the truth: ` +
      `the prediction’s ellipse, with standard deviations of ${spread(predicted)}, and the estimate’s, ` +
      `of ${spread(posterior)}; the estimate is off by ${fixed(off[0], 2)} metres and ${fixed(off[1], 2)} ` +
      'metres a second.',
    disc:
      `Unit disc: the ${frame.params.mode === 'filter' ? 'frozen ' : ''}eigenvalues of the error dynamics ` +
      `${before(frame) ? 'in step 1 ' : ''}are ` +
      `${eigen}${frame.pinned === null ? '' : ', one of them pinned at 1'}.`,
    gain: `Gain over time, ${frame.step === 0 ? 'none used yet' : `now ${last(series.r1)} and ${last(series.r2)}`}.`,
    variance: `Variances over time, now ${last(series.p11)} and ${last(series.p22)}.`,
    error: `Errors over time, truth minus estimate, now ${last(series.e1)} and ${last(series.e2)}.`,
  }
}

/** @param {Frame} frame @param {Frame} old */
function announce(frame, old) {
  const { params } = frame
  const step = frame.step === old.step ? '' : `Step ${frame.step}. `
  if (frame.diverged || before(frame) || params.sensor !== old.params.sensor || frame.stable !== old.stable)
    return step + verdict(frame)
  return params.mode === 'filter'
    ? `${step}Equivalent knob ${fixed(frame.equivalentKnob, 3)}.`
    : `${step}Gain ${fixed(params.gain, 2)}. ${verdict(frame)}`
}

// View: five panels, each in a file of the folder, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const pair = (/** @type {number[]} */ [a, b]) => `[${fixed(a, 3)}, ${fixed(b, 3)}]`
  const filters = frame.params.mode === 'filter'
  const unused = before(frame)
  return [
    {
      key: 'error',
      label: 'Position error: truth − estimate',
      value: fixed(frame.truth[0] - frame.posterior.x[0], 2),
      unit: 'm',
      wide: true,
      kin: 'truth',
      headline: true,
    },
    { key: 'step', label: 'Step', value: String(frame.step) },
    { key: 'gain', label: 'Gain {R}', value: unused ? '–' : pair(frame.R), kin: 'posterior', shown: filters },
    { key: 'own-gain', label: 'Gain {K}', value: pair(frame.R), kin: 'posterior', shown: !filters },
    { key: 'knob', label: 'Equivalent knob', value: fixed(unused ? null : frame.equivalentKnob, 3), more: true },
    { key: 'steady', label: '{R}_∞', value: pair(frame.steadyGain), kin: 'posterior', more: true },
    {
      key: 'innovation',
      label: 'Innovation {innov}',
      value: fixed(frame.innovation, 3),
      unit: frame.params.sensor === 'velocity' ? 'm/s' : 'm',
      kin: 'measurement',
      more: true,
    },
    {
      key: 'p11',
      label: '{P}_{11}',
      value: fixed(frame.posterior.P[0][0], 3),
      unit: 'm²',
      kin: 'posterior',
      more: true,
    },
  ]
}

// Controls.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  {
    kind: 'range',
    name: 'gain',
    wide: true,
    label: 'Gain *g*, in units of {R}_∞',
    get: (params, frame) => (params.mode === 'filter' && frame.step > 0 ? frame.equivalentKnob : params.gain),
    words: (value, frame) => fixed(before(frame) ? null : value, 2),
    notches: (/** @type {Frame} */ frame) => [
      { at: 0, name: '0' },
      { at: 1, name: '{R}_∞' },
      { at: frame.stableUpTo, name: `diverges past ${fixed(frame.stableUpTo, 2)}`, kind: 'limit' },
    ],
    enabled: (params) => params.mode === 'fixed',
  },
  { kind: 'toggle', name: 'mode', label: 'let the filter choose', on: 'filter', off: 'fixed' },
  {
    kind: 'choice',
    name: 'sensor',
    label: 'Sensor',
    options: [
      { value: 'velocity', label: 'velocity' },
      { value: 'position', label: 'position' },
    ],
  },
]

/**
 * A gain shows nothing before the first step: a phrase pressed there goes to where the figure opens.
 * @param {number} step
 */
const begun = (step) => (step === 0 ? { step: start.step } : {})

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  {
    name: 'past',
    label: 'Turn the gain past its limit',
    change: (/** @type {Frame} */ { stableUpTo, step }) => ({
      mode: 'fixed',
      gain: Math.min(6, Math.ceil(stableUpTo * 10 + 1) / 10),
      ...begun(step),
    }),
  },
  {
    name: 'reckon',
    label: 'Use no reading at all',
    change: (/** @type {Frame} */ { step }) => ({ mode: 'fixed', gain: 0, ...begun(step) }),
  },
  { name: 'filter', label: 'Let the filter choose, from the start', change: () => ({ mode: 'filter', step: 0 }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: true,
  beats: true,
  panels: [
    { name: 'phase', width: 580, height: 440, draw: drawPhase },
    { name: 'disc', width: 356, height: 356, draw: drawDisc },
    { name: 'gain', width: 312, height: 190, draw: drawGain },
    { name: 'variance', width: 312, height: 190, draw: drawVariance },
    { name: 'error', width: 312, height: 190, draw: drawError },
  ],
  layout: {
    // The knob and what it moves are on one screen: the disc, then the gain. What a button adds comes below it.
    narrow: ['phase', 'variance', 'controls', 'grow', 'disc', 'gain', 'verdict', 'tries', 'readouts', 'error'],
    medium: [
      'phase phase phase phase disc disc',
      'phase phase phase phase verdict verdict',
      'controls controls controls controls controls controls',
      'gain gain gain variance variance variance',
      'error error error tries tries tries',
    ],
    wide: ['phase phase disc', 'phase phase verdict', 'controls controls controls', 'gain variance error'],
    columns: { medium: Array(6).fill('1fr').join(' '), wide: '1fr 1fr 1fr' },
  },
  stages: {
    panels: { disc: 2, gain: 3, variance: 3, error: 3 },
    hand: { sensor: 2, tries: 2, mode: 3, readouts: 3, tools: 3, speed: 3, seed: 3 },
    grow: ['Show the eigenvalues', 'Show the whole bench'],
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series: (frame) => frame.series,
}
