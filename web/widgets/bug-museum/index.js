/**
 * The museum of bugs: an extended Kalman filter that is right but for the bugs that the reader switches on, or that the
 * lot hides in it. By which panels is each of them seen?
 */

import { fixed } from '../../draw/numbers.js'
import { plain } from '../../draw/words.js'
import { drawCorrelation, drawFigures } from './figures.js'
import { drawCovariance, drawErrors, drawInnovations, drawNees, drawNis } from './history.js'
import { drawMap } from '../../draw/stadium.js'
import { SEEDS } from '../../figure/ensemble.js'
import { buildSeeIt } from './see-it.js'
import { FIGURES, NAMES, outside, share, shown, verdict } from './words.js'

/** @typedef {import('estimate-wasm').MuseumFrame} Frame */

// State: a whole run of a filter whose innovation is not wrapped.

const start = { params: { bug: 'unwrapped-innovation' }, step: 240 }
/** Hidden bugs in a row that unlock pairs. */
const UNLOCKS = 3
/** A greater number of a draw would make a long link. */
const LOTS = 1e6
/** The greatest that the lab takes. */
const GREATEST_LOT = 0xffffffff

// Model: the lab `BugMuseum` in the module. What follows only reads its frame.

/** @param {Frame} frame */
function describe(frame) {
  const {
    error,
    figures,
    readings,
    meanNees,
    driven,
    correlationBand: width,
    correlationRange,
    correlationBearing,
  } = frame
  const value = (/** @type {number} */ i) => shown(i, figures[i].value)
  const refused = readings.used.filter((used) => used === 0).length
  const out = [...correlationRange, ...correlationBearing].filter(
    (lag) => width !== null && Math.abs(lag) > width,
  ).length
  return {
    map:
      `The course from above after step ${driven}: three landmarks, the true track and the estimated one; ` +
      `the estimate is off by ${fixed(Math.hypot(error[0], error[1]), 2)} metres.`,
    errors: `Errors in x, y and heading over time against their claimed 2 σ; ${value(2)} of them lie beyond.`,
    nees:
      `Normalized estimation error over time, mean ${fixed(meanNees, 2)}; ` +
      `a right filter’s lies between ${fixed(figures[3].band[0], 1)} and ${fixed(figures[3].band[1], 1)} in ` +
      '95 of 100 runs.',
    nis: `Normalized innovation of each reading: ${readings.nis.length} readings, ${refused} of them refused.`,
    innovations: `Normalized innovations over time: mean ${value(8)} of the ranges and ${value(9)} of the bearings.`,
    correlation:
      `Autocorrelation of the innovations at ${correlationRange.length} lags: ` +
      `${out} of ${correlationRange.length + correlationBearing.length} outside the band.`,
    covariance: `Smallest eigenvalue of P over time, at least ${value(12)}, and its asymmetry, at most ${value(13)}.`,
    figures: [
      'Fourteen figures of the run against a right filter’s 95 % bands.',
      ...figures.flatMap((figure, i) => (outside(figure) ? [`Outside: ${plain(FIGURES[i].label)}, ${value(i)}.`] : [])),
    ].join(' '),
  }
}

// View: eight panels, in the folder's files, and what is said beside them.

/** @param {Frame} frame @returns {import('../../figure/shell.js').Readout[]} */
function readouts({ figures, driven, steps, seeds, params }) {
  const value = (/** @type {number} */ i) => shown(i, figures[i].value)
  const [low, high] = figures[3].band
  return [
    { key: 'nees', label: 'Mean NEES', value: value(3), kin: 'posterior', headline: true },
    { key: 'neesBand', label: 'Right filter, 95 % band', value: `${fixed(low, 2)} to ${fixed(high, 2)}` },
    {
      key: 'seedsOut',
      label: 'Seeds with NEES outside',
      value: seeds === 0 ? '–' : `${Math.round(100 * share(figures[3]))} %`,
      kin: 'posterior',
    },
    { key: 'seeds', label: 'Seeds counted', value: String(seeds) },
    { key: 'named', label: 'Named in a row', value: String(params.named) },
    { key: 'driven', label: 'Step of the run', value: `${driven} of ${steps}` },
    ...figures
      .map((_, i) => ({ key: FIGURES[i].name, label: FIGURES[i].label, value: value(i), more: true }))
      .filter(({ key }) => key !== 'nees'),
  ]
}

// Controls: the switches, and what it takes to hide a bug and to name it.

const fresh = { guess: 'none', secondGuess: 'none', committed: false }
// The switches and the names to guess take turns in the same places: a hidden bug has no switch, and without one there
// is nothing to name.
const open = (/** @type {Frame} */ { params }) => params.lot === 0
const drawn = (/** @type {Frame} */ { params }) => params.lot !== 0
const hidden = (/** @type {any} */ { lot, committed }) => lot !== 0 && !committed

const nextSeed = (/** @type {{ seed: number }} */ { seed }) => (seed % 4294967295) + 1

/**
 * The next draw of the lot, in another run: a bug that has been told is not known again by its picture. Whoever gives a
 * bug up unnamed begins to count anew. @param {boolean} pair
 */
const draw =
  (pair) =>
  (/** @type {Frame} */ { params, steps }) => ({
    ...fresh,
    bug: 'none',
    second: 'none',
    pair,
    lot: ((params.lot || Math.floor(Math.random() * LOTS)) % GREATEST_LOT) + 1,
    seed: nextSeed(params),
    named: hidden(params) ? 0 : params.named,
    many: false,
    step: steps,
  })

/** The lab says whether the name is right; the count in a row is kept here. @param {Frame} frame @param {any} lab */
function commit({ params }, lab) {
  const judge = lab.constructor.from({ ...lab.state(), params: { ...params, committed: true, many: false }, step: 0 })
  const { right } = judge.frame().answer
  judge.free()
  return { committed: true, named: right ? params.named + 1 : 0 }
}

/** @type {import('../../figure/controls.js').Control[]} */
const controls = [
  // A bug is there once.
  {
    kind: 'choice',
    name: 'bug',
    label: 'Bug',
    options: NAMES,
    shown: open,
    set: (bug, { second }) => ({ bug, second: second === bug ? 'none' : second }),
  },
  {
    kind: 'choice',
    name: 'second',
    label: 'and another',
    options: NAMES,
    shown: open,
    set: (second, { bug }) => ({ second: second === bug ? 'none' : second }),
  },
  { kind: 'choice', name: 'guess', label: 'It is', options: NAMES, shown: drawn, enabled: hidden },
  {
    kind: 'choice',
    name: 'secondGuess',
    label: 'and',
    options: NAMES,
    shown: drawn,
    enabled: (params) => params.pair && hidden(params),
  },
  { kind: 'action', name: 'again', label: 'Another run', change: ({ params }) => ({ seed: nextSeed(params) }) },
  { kind: 'action', name: 'hide', label: 'Hide a bug', change: draw(false) },
  {
    kind: 'action',
    name: 'pair',
    label: `Hide two bugs (after ${UNLOCKS} right in a row)`,
    change: draw(true),
    enabled: ({ named }) => named >= UNLOCKS,
  },
  // Behind those that stay, so that no other comes under the pointer.
  {
    kind: 'action',
    name: 'name',
    label: 'Name it',
    change: commit,
    shown: drawn,
    enabled: (params) => hidden(params) && params.guess !== 'none' && (!params.pair || params.secondGuess !== 'none'),
  },
  {
    kind: 'action',
    name: 'open',
    label: 'Back to the switches',
    change: () => ({ ...fresh, lot: 0, pair: false }),
    shown: drawn,
  },
  {
    kind: 'toggle',
    name: 'many',
    label: 'count over seeds',
    set: (many, _, frame) => ({ many, step: many ? SEEDS : frame.steps }),
  },
  {
    kind: 'range',
    name: 'step',
    label: 'Step of the run, or seeds',
    ends: [0, SEEDS],
    step: 1,
    get: (_, frame) => frame.step,
    set: (step) => ({ step }),
    words: (step) => String(step),
    notches: ({ params, steps }) => (params.many ? [] : [{ at: steps, name: 'a whole run' }]),
  },
  { kind: 'custom', name: 'seeIt', build: buildSeeIt },
]

/** @param {string} bug */
const one = (bug) => () => ({ ...fresh, bug, second: 'none', lot: 0, pair: false, many: false, step: 240 })

/** @type {import('../../figure/spec.js').Try[]} */
const tries = [
  { name: 'right', label: 'The right filter', change: one('none') },
  { name: 'gate', label: 'Open the gate', change: one('open-gate') },
  { name: 'twice', label: 'Use each reading twice', change: one('twice') },
  { name: 'seeds', label: `Count over ${SEEDS} seeds`, change: () => ({ many: true, step: SEEDS }) },
]

/** @type {import('../../figure/spec.js').Widget} */
export const figure = {
  start,
  seeded: true,
  slow: true,
  pace: 20,
  lap: 240,
  end: ({ params, steps }) => (params.many ? SEEDS : steps),
  panels: [
    { name: 'map', width: 520, height: 330, draw: drawMap },
    { name: 'figures', width: 420, height: 330, draw: drawFigures },
    { name: 'errors', width: 460, height: 330, draw: drawErrors },
    { name: 'innovations', width: 460, height: 330, draw: drawInnovations },
    { name: 'nees', width: 460, height: 200, draw: drawNees },
    { name: 'nis', width: 460, height: 200, draw: drawNis },
    { name: 'correlation', width: 460, height: 260, draw: drawCorrelation },
    { name: 'covariance', width: 460, height: 260, draw: drawCovariance },
  ],
  layout: {
    // The switches stand at the figures of the run, which are what a bug changes; what is said of a name goes along,
    // and the plots that explain it follow.
    narrow: [
      'figures',
      'tries',
      'controls',
      'verdict',
      'map',
      'readouts',
      'errors',
      'nees',
      'nis',
      'innovations',
      'correlation',
      'covariance',
    ],
    along: 'tries',
    medium: [
      'map figures',
      'verdict verdict',
      'tries tries',
      'controls controls',
      'readouts readouts',
      'errors innovations',
      'nees nis',
      'correlation covariance',
    ],
    columns: { medium: '1fr 1fr' },
  },
  tries,
  describe,
  controls,
  readouts,
  verdict,
  announce: (frame) => verdict(frame),
  series: ({ series, readings, figures, seeds, params }) => ({
    step: series.step,
    x: series.x,
    y: series.y,
    theta: series.theta,
    nees: series.nees,
    least: series.least,
    asymmetry: series.asymmetry,
    reading: readings.step,
    nis: readings.nis,
    range: readings.range,
    bearing: readings.bearing,
    used: readings.used,
    ...(seeds > 0
      ? {
          seed: Array.from({ length: seeds }, (_, i) => params.seed + i),
          ...Object.fromEntries(FIGURES.map(({ name }, i) => [`run_${name}`, figures[i].runs])),
        }
      : {}),
  }),
}
