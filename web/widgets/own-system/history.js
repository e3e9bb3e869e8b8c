/** A simulated run, the filter's gain and the variances over the last steps. */

import { timePlot } from '../../draw/time-plot.js'
import { givenName } from './names.js'
import { shownState } from './words.js'

/** @typedef {import('estimate-wasm').OwnFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

const SHAPES = ['solid', 'dashed', 'thin', 'thin dashed']

/** So many curves have room for their names. */
const NAMED = 6

/** Steps as seconds, where the length of one is known. @param {Frame} frame */
const axis = ({ series, params: { period } }) => {
  const steps = [...series.step]
  return period > 0 ? { steps: steps.map((k) => k * period), unit: 's', least: 20 * period } : { steps, unit: '{k}' }
}

/** @param {Frame} frame @param {number} i @returns {string} */
const title = ({ params }, i) => givenName(params, i) || `*x*_${i + 1}`

/** @param {Panel} panel @param {Frame} frame */
export function drawRun(panel, frame) {
  const i = shownState(frame.params)
  const { truth, estimate, sigma } = frame.series
  const edge = (/** @type {number} */ sign) => estimate[i].map((value, k) => value + sign * 2 * sigma[i][k])
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: `a simulated run: ${title(frame, i)}, and ±2 *σ*`,
        ...axis(frame),
        include: [-1, 1],
        lines: [
          { key: 'above', values: edge(1), name: '', kin: 'posterior', shape: 'thin' },
          { key: 'below', values: edge(-1), name: '', kin: 'posterior', shape: 'thin' },
          { key: 'truth', values: truth[i], name: '*x*', kin: 'truth' },
          { key: 'estimate', values: estimate[i], name: '*x̂*', kin: 'posterior' },
        ],
      }),
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawGain(panel, frame) {
  const i = shownState(frame.params)
  const { gain } = frame.series
  const known = gain[i].slice(0, frame.params.readings)
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: `the filter’s gain {Rk} for ${title(frame, i)}`,
        ...axis(frame),
        include: [0, 0.1],
        lines: known.map((values, j) => ({
          key: String(j),
          values,
          name: `{R}_{${i + 1}${j + 1}}`,
          kin: /** @type {const} */ ('posterior'),
          shape: SHAPES[j % SHAPES.length],
        })),
      }),
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawVariance(panel, frame) {
  const { variance } = frame.series
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        // Another gain has other variances than the filter’s, of which the sentence speaks.
        title: frame.params.gain === 'filter' ? 'variances {Pk}' : 'variances {Pk} under the gain {K}',
        ...axis(frame),
        log: true,
        include: [0.5, 2],
        lines: variance.slice(0, frame.params.states).map((values, j) => ({
          key: String(j),
          values,
          // Names of more have no room; then the state that the other plots show has one.
          name: frame.params.states <= NAMED || j === shownState(frame.params) ? `{P}_{${j + 1}${j + 1}}` : '',
          kin: /** @type {const} */ ('posterior'),
          shape: SHAPES[j % SHAPES.length],
        })),
      }),
  )
}
