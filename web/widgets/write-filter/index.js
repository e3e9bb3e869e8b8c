/**
 * Write the filter: the reader's program, what is wrong with it, its run beside a right filter's, and its numbers in
 * many worlds.
 */

import { fixed } from '../../draw/numbers.js'
import { buildEditor } from './editor.js'
import { opened } from './programs.js'
import { describeRun, drawErrors, drawRun } from './run.js'
import { announce, verdict } from './words.js'
import { describeWorlds, drawWorlds, worlds } from './worlds.js'

/** @typedef {import('estimate-wasm').WriteFrame} Frame */

// State: the chapter's algorithm, and a run of it.

const start = { params: {}, step: 60 }

// Model: the lab `WriteFilter`. What follows only reads its frame.

/** @param {Frame} frame */
const describe = (frame) => ({
  run: describeRun(frame),
  errors: `Errors of the first two states against their claimed 2 σ, up to step ${frame.series.step.at(-1)}.`,
  worlds: describeWorlds(null),
})

// View: three panels, in the folder's files, and the numbers beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ step, nees, made, faults, stopped, series }) {
  // A program that does not run has made no step.
  const ran = stopped === null || series.step.length > 1
  return [
    { key: 'step', label: 'Step', value: ran ? String(step) : '–', headline: true },
    { key: 'nees', label: 'NEES of this step', value: fixed(nees ?? undefined, 2), kin: 'posterior' },
    { key: 'faults', label: 'Faults', value: String(faults.length) },
    { key: 'made', label: 'The program makes', value: made.slice(0, 12).join(', ') || '–' },
  ]
}

// Controls: the text, and what leads to it.

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [{ kind: 'custom', name: 'editor', build: buildEditor }]

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'empty', label: 'Begin with an empty box', change: () => opened('empty') },
  { name: 'kalman', label: 'The chapter’s algorithm', change: () => opened('kalman') },
  { name: 'observer', label: 'An observer with a gain of your own', change: () => opened('observer') },
  { name: 'joseph', label: 'Joseph’s form', change: () => opened('joseph') },
  { name: 'short', label: 'The short form', change: () => opened('short') },
  { name: 'forget', label: 'Forget {W}', change: () => opened('forget') },
  { name: 'transposed', label: '*F*^{⊤}*PF* for *FPF*^{⊤}', change: () => opened('transposed') },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  aside: worlds,
  seeded: true,
  slow: true,
  pace: 12,
  panels: [
    { name: 'run', width: 460, height: 330, draw: drawRun },
    { name: 'errors', width: 460, height: 300, draw: drawErrors },
    { name: 'worlds', width: 460, height: 200, aside: true, draw: drawWorlds },
  ],
  layout: {
    // Who writes looks at the text and at what is said of it: the pictures come after.
    along: 'controls',
    narrow: ['tries', 'controls', 'verdict', 'run', 'worlds', 'readouts', 'errors'],
    medium: ['tries tries', 'verdict verdict', 'controls controls', 'run errors', 'worlds readouts'],
    wide: ['tries tries', 'verdict verdict', 'controls run', 'controls worlds', 'controls errors'],
    columns: { medium: '1fr 1fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce,
  series: ({ series }) => ({ ...series }),
}
