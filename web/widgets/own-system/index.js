/**
 * A system of the reader's own: its matrices are typed or pasted, and the core says what an observer can know of it,
 * where a gain puts its eigenvalues, and whether the filter's covariance settles.
 */

import { fixed, power } from '../../draw/numbers.js'
import { drawDisc } from './disc.js'
import { buildEditor } from './editor.js'
import { drawGain, drawRun, drawVariance } from './history.js'
import { limitWords } from './limit.js'
import { buildMore } from './more.js'
import { counted, decimalsOf, seconds, short } from './names.js'
import { MOST, PRESETS, paramsOf, runOf } from './presets.js'
import { drawRanks } from './ranks.js'
import { buildShown } from './shown.js'
import { same } from './typed-system.js'
import { endIsOpen, limitIsOpen, observed } from './undecided.js'
import { describe, rootsOf, settles, shownState, verdict } from './words.js'

/** @typedef {import('estimate-wasm').OwnFrame} Frame */

// State: the rail robot that reads its position.

const start = { params: paramsOf(PRESETS[0]), step: 40 }

// Model: the lab `OwnSystem`. What follows only reads its frame.

/** @param {Frame} frame @param {Frame} before */
function announce(frame, before) {
  const step = frame.step === before.step ? '' : `Step ${frame.step}. `
  return verdict(frame) === verdict(before) ? step.trim() : step + verdict(frame)
}

// View: five panels, each in a file of the folder, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts(frame) {
  const { rank, params, noise, input, doubled, eigenvalues, decay } = frame
  const decimals = decimalsOf(eigenvalues, 3)
  const slowest = decay[0]
  const i = shownState(params)
  const open = endIsOpen(frame, 0)
  return [
    { key: 'radius', label: 'Largest modulus', value: fixed(frame.spectralRadius, decimals), headline: true },
    {
      key: 'steps',
      label: 'Steps until 5 %',
      value: open ? 'undecided' : slowest.steps === null ? 'never' : counted(Math.ceil(slowest.steps)),
    },
    {
      key: 'seconds',
      label: 'Slowest time constant',
      value: open
        ? 'undecided'
        : slowest.seconds !== null
          ? seconds(slowest.seconds)
          : params.period > 0
            ? '–'
            : 'needs a step’s length',
    },
    { key: 'rank', label: 'Rank', value: `${rank.rank} of ${params.states}` },
    { key: 'observable', label: 'Observable', value: observed(frame) },
    { key: 'detectable', label: 'Detectable', value: frame.detectable },
    { key: 'noise', label: 'Noise reaches all', value: noise.reachable },
    { key: 'stabilizable', label: 'Stabilizable by noise', value: noise.stabilizable },
    { key: 'input', label: 'Inputs reach all', value: params.inputs === 0 ? 'there are none' : input.reachable },
    {
      key: 'settled',
      label: 'Filter’s covariance settles',
      value: settles(frame),
    },
    { key: 'tolerance', label: 'Tolerance', value: power(frame.tolerance), more: true },
    {
      key: 'gain',
      label: 'Gain, by rows',
      value: withoutRounding(frame)
        .map((row) => row.map(short).join(', '))
        .join('; '),
      more: true,
      wide: true,
    },
    { key: 'movable', label: 'Eigenvalues a gain moves', value: `${frame.movable} of ${params.states}`, more: true },
    {
      key: 'limit',
      label: 'Filter’s limit P, before a reading, by rows',
      value: limitIsOpen(frame) ? 'undecided' : limitWords(frame.limitP),
      kin: 'prediction',
      more: true,
      wide: true,
    },
    {
      key: 'roots',
      label: 'Eigenvalues',
      value: rootsOf(eigenvalues)
        .map((root, j) =>
          decay[j].seconds === null || endIsOpen(frame, j) ? root : `${root} (${seconds(decay[j].seconds)})`,
        )
        .join(', '),
      more: true,
      wide: true,
    },
    {
      key: 'depends',
      label: 'A larger start, another limit',
      value: limitIsOpen(frame) ? 'undecided' : doubled.converged ? (doubled.dependsOnStart ? 'yes' : 'no') : '–',
      more: true,
    },
    {
      key: 'error',
      label: 'Error of the shown state',
      value: fixed(frame.truth[i] - frame.estimate[i], 3),
      kin: 'truth',
      more: true,
    },
    { key: 'step', label: 'Step', value: String(frame.step), more: true },
  ]
}

// Controls.

const FROM = ['filter', 'hand', 'placement']

/** A matrix of as many rows and columns as the lab takes. @param {(i: number, j: number) => number} entry */
const square = (entry) => Array.from({ length: MOST }, (_, i) => Array.from({ length: MOST }, (_, j) => entry(i, j)))

/** A gain to go on from: an entry that is rounding beside the largest is 0. @param {number[][]} gain */
export function handed(gain) {
  const none = 1e-14 * Math.max(...gain.flat().map(Math.abs))
  return gain.map((row) => row.map((entry) => (Math.abs(entry) < none ? 0 : entry)))
}

/**
 * The gain as it is shown. Of the filter's, an entry is 0 that rounding leaves beside those of its reading: with each
 * state in units of its own σ, so that no unit makes an entry small, less than 10⁻¹² of the largest. So many digits the
 * limit that it is computed from has not. What the reader sets is shown as it is set.
 * @param {Pick<Frame, 'K' | 'limitP'> & { params: Pick<Frame['params'], 'gain'> }} frame
 */
export function withoutRounding({ K, limitP, params }) {
  if (params.gain !== 'filter' || limitP === null) return K
  const part = (/** @type {number} */ i, /** @type {number} */ j) => Math.abs(K[i][j]) / Math.sqrt(limitP[i][i])
  const largest = K[0].map((_, j) => Math.max(...K.map((_, i) => part(i, j)).filter(Number.isFinite)))
  return K.map((row, i) => row.map((entry, j) => (part(i, j) < 1e-12 * largest[j] ? 0 : entry)))
}

/**
 * A slider for one entry of the gain.
 * @param {number} i
 * @param {number} j
 * @returns {import('../../figure/controls.js').Control}
 */
function entry(i, j) {
  return {
    kind: 'range',
    name: `k${i}${j}`,
    label: `{K}_{${i + 1}${j + 1}}`,
    ends: [-3, 3],
    step: 0.01,
    get: (params) => params.k[i]?.[j] ?? 0,
    set: (value, params) => ({
      k: square((r, c) => (r === i && c === j ? value : (params.k[r]?.[c] ?? 0))),
    }),
    scale: (value) => value,
    words: (_, frame) => fixed(frame.params.k[i]?.[j] ?? 0, 2),
    shown: ({ params }) => params.gain === 'hand' && i < params.states && j < params.readings,
    enabled: (params) => params.gain === 'hand' && i < params.states && j < params.readings,
  }
}

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  { kind: 'custom', name: 'system', build: buildEditor },
  {
    kind: 'choice',
    name: 'gain',
    label: 'Gain',
    options: [
      { value: FROM[0], label: 'by the filter' },
      { value: FROM[1], label: 'by hand' },
      { value: FROM[2], label: 'by placement' },
    ],
    // By hand the reader goes on from the gain that was there.
    set: (value, params, frame) =>
      value === 'hand'
        ? {
            gain: value,
            k: square((i, j) => handed(frame.K)[i]?.[j] ?? params.k[i]?.[j] ?? 0),
          }
        : { gain: value },
  },
  ...[0, 1, 2, 3].flatMap((i) => [0, 1, 2, 3].map((j) => entry(i, j))),
  { kind: 'custom', name: 'shown', build: buildShown },
  { kind: 'custom', name: 'more', build: buildMore },
]

/** Whether the system is one of the presets, and none of the reader's own. @param {Frame} frame */
const isPreset = ({ params }) => PRESETS.some((preset) => same(paramsOf(preset), params))

/** Eigenvalues to begin with, where the reader is to place them. */
const PLACED = {
  gain: 'placement',
  poles: [
    [0.5, 0.3],
    [0, 0],
    [0.2, 0],
    [0.3, 0],
  ],
}

/**
 * Beside a system of the reader's own there stands what fits any: the others would put a preset in its place.
 * @type {import('../../figure/spec.js').Try[]}
 */
const tries = [
  {
    name: 'blind',
    label: 'Read the velocity alone',
    change: () => ({ ...paramsOf(PRESETS[1]), gain: 'filter', ...runOf(40) }),
    shown: isPreset,
  },
  {
    name: 'bias',
    label: 'Add a bias to a sensor',
    change: () => ({ ...paramsOf(PRESETS[5]), gain: 'filter', ...runOf(40) }),
    shown: isPreset,
  },
  {
    name: 'place',
    label: 'Place the eigenvalues yourself',
    change: (frame) => (isPreset(frame) ? { ...paramsOf(PRESETS[2]), ...PLACED, ...runOf(40) } : PLACED),
    shown: (frame) => isPreset(frame) || frame.movable > 0,
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: true,
  pace: 4,
  panels: [
    { name: 'disc', width: 356, height: 356, handles: true, draw: drawDisc },
    { name: 'run', width: 312, height: 300, draw: drawRun },
    { name: 'gain', width: 312, height: 190, draw: drawGain },
    { name: 'variance', width: 312, height: 190, draw: drawVariance },
    { name: 'ranks', width: 312, height: 170, handles: true, draw: drawRanks },
  ],
  // What is dragged in the disc changes the verdict’s lines, which therefore stand below it.
  layout: {
    narrow: ['controls', 'ranks', 'disc', 'verdict', 'tries', 'readouts', 'run', 'gain', 'variance'],
    medium: [
      'controls controls controls controls controls controls',
      'ranks ranks ranks ranks ranks ranks',
      'disc disc disc run run run',
      'verdict verdict verdict verdict verdict verdict',
      'gain gain gain variance variance variance',
      'tries tries tries tries tries tries',
      'readouts readouts readouts readouts readouts readouts',
    ],
    wide: [
      'controls controls controls',
      'ranks ranks ranks',
      'disc run gain',
      'disc run variance',
      'verdict verdict verdict',
      'tries tries tries',
      'readouts readouts readouts',
    ],
    columns: { medium: '1fr 1fr 1fr 1fr 1fr 1fr', wide: '1fr 1fr 1fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series: ({ series, params }) => {
    const all = Array.from({ length: params.states }, (_, i) => i)
    return {
      step: series.step,
      ...Object.fromEntries(
        all.flatMap((i) => [
          [`x${i + 1}`, series.truth[i]],
          [`estimate${i + 1}`, series.estimate[i]],
          [`variance${i + 1}`, series.variance[i]],
        ]),
      ),
      ...Object.fromEntries(
        all.flatMap((i) =>
          series.gain[i]
            .slice(0, params.readings)
            .map((/** @type {number[]} */ values, /** @type {number} */ j) => [`R${i + 1}${j + 1}`, values]),
        ),
      ),
    }
  },
}
