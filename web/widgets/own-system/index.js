/**
 * A system of the reader's own: its matrices are typed or pasted, and the core says what an observer can know of it,
 * where a gain puts its eigenvalues, and whether the filter's covariance settles.
 */

import { fixed, power } from '../../draw/numbers.js'
import { drawDisc } from './disc.js'
import { buildEditor } from './editor.js'
import { drawGain, drawRun, drawVariance } from './history.js'
import { short } from './names.js'
import { PRESETS, paramsOf } from './presets.js'
import { drawRanks } from './ranks.js'
import { buildShown } from './shown.js'
import { describe, shownState, verdict } from './words.js'

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
  const { rank, params, noise, input, settled, tried } = frame
  const i = shownState(params)
  return [
    { key: 'radius', label: 'Largest modulus', value: fixed(frame.spectralRadius, 3), headline: true },
    { key: 'rank', label: 'Rank', value: `${rank.rank} of ${params.states}` },
    { key: 'observable', label: 'Observable', value: frame.observable },
    { key: 'detectable', label: 'Detectable', value: frame.detectable },
    { key: 'noise', label: 'Noise reaches all', value: noise.reachable },
    { key: 'stabilizable', label: 'Stabilizable by noise', value: noise.stabilizable },
    { key: 'input', label: 'Inputs reach all', value: input.reachable },
    {
      key: 'settled',
      label: 'Covariance settles',
      value: settled === null ? (tried === null ? 'never' : `not in ${tried}`) : `in ${settled} steps`,
    },
    { key: 'tolerance', label: 'Tolerance', value: power(frame.tolerance), more: true },
    {
      key: 'gain',
      label: 'Gain, by rows',
      value: frame.K.map((row) => row.map(short).join(', ')).join('; '),
      more: true,
    },
    { key: 'movable', label: 'Eigenvalues a gain moves', value: `${frame.movable} of ${params.states}`, more: true },
    {
      key: 'limit',
      label: 'Diagonal of the limit',
      value: frame.limitP === null ? 'none' : frame.limitP.map((row, j) => short(row[j])).join(', '),
      kin: 'prediction',
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
    get: (params) => params.k[i][j],
    set: (value, params) => ({
      k: params.k.map((/** @type {number[]} */ row, /** @type {number} */ r) =>
        row.map((old, c) => (r === i && c === j ? value : old)),
      ),
    }),
    scale: (value) => value,
    words: (_, frame) => fixed(frame.params.k[i][j], 2),
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
            k: params.k.map((/** @type {number[]} */ row, /** @type {number} */ i) =>
              row.map((old, j) => frame.K[i]?.[j] ?? old),
            ),
          }
        : { gain: value },
  },
  ...[0, 1, 2, 3].flatMap((i) => [0, 1, 2, 3].map((j) => entry(i, j))),
  { kind: 'custom', name: 'shown', build: buildShown },
  {
    kind: 'range',
    name: 'start',
    label: '{Pstart}, times *I*',
    ends: [-3, 4],
    step: 0.1,
    scale: (value) => Math.log10(Math.max(value, 1e-3)),
    set: (value) => ({ start: Number((10 ** value).toPrecision(3)) }),
    words: (_, frame) => short(frame.params.start),
  },
  { kind: 'range', name: 'input', label: 'Inputs of the run', ends: [-5, 5], words: (value) => fixed(value, 1) },
]

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  {
    name: 'blind',
    label: 'Read the velocity alone',
    change: () => ({ ...paramsOf(PRESETS[1]), gain: 'filter', step: 40 }),
  },
  {
    name: 'bias',
    label: 'Add a bias to a sensor',
    change: () => ({ ...paramsOf(PRESETS[5]), gain: 'filter', step: 40 }),
  },
  {
    name: 'place',
    label: 'Place the eigenvalues yourself',
    change: () => ({
      ...paramsOf(PRESETS[2]),
      gain: 'placement',
      poles: [
        [0.5, 0.3],
        [0, 0],
        [0.2, 0],
        [0.3, 0],
      ],
      step: 40,
    }),
  },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: true,
  pace: 4,
  panels: [
    { name: 'disc', width: 356, height: 356, handles: true, draw: drawDisc },
    { name: 'ranks', width: 470, height: 170, handles: true, draw: drawRanks },
    { name: 'run', width: 470, height: 235, draw: drawRun },
    { name: 'gain', width: 470, height: 190, draw: drawGain },
    { name: 'variance', width: 470, height: 190, draw: drawVariance },
  ],
  layout: {
    narrow: ['controls', 'verdict', 'ranks', 'disc', 'tries', 'run', 'gain', 'variance', 'readouts'],
    medium: [
      'controls controls controls controls controls controls',
      'verdict verdict verdict verdict verdict verdict',
      'disc disc ranks ranks ranks ranks',
      'disc disc run run run run',
      'tries tries tries tries tries tries',
      'readouts readouts readouts readouts readouts readouts',
      'gain gain gain variance variance variance',
    ],
    columns: { medium: '1fr 1fr 1fr 1fr 1fr 1fr' },
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
