/**
 * Error against claimed σ over the last ticks, and the bias of the wheel where it is a state. A cursor stands at the
 * tick that the map shows; the reader moves the robot by it.
 */

import { timePlot } from '../../draw/time-plot.js'
import { learned } from './bias.js'

/** @typedef {import('estimate-wasm').HookFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */
/** @typedef {import('../../figure/spec.js').View} View */

/** Ticks of an arrow key. */
const STRIDE = 10

/** @param {Panel} panel @param {Frame} frame @param {View} view */
export function drawPosition(panel, frame, view) {
  draw(
    panel,
    frame,
    view,
    'position: error *e* and claimed *σ* (m)',
    ({ position, sigmaPosition }) => [position, sigmaPosition],
    0.5,
  )
}

/** @param {Panel} panel @param {Frame} frame @param {View} view */
export function drawHeading(panel, frame, view) {
  const degrees = (/** @type {number[]} */ values) => values.map((value) => (value * 180) / Math.PI)
  draw(
    panel,
    frame,
    view,
    'heading: error *e* and claimed *σ* (°)',
    ({ heading, sigmaHeading }) => [degrees(heading), degrees(sigmaHeading)],
    5,
  )
}

/**
 * The learned bias within one σ on either side, and the true one.
 * @param {Panel} panel
 * @param {Frame} frame
 * @param {View} view
 */
export function drawWheel(panel, frame, view) {
  const { series, params } = farthest(frame, view)
  const within = (/** @type {number} */ sigmas) =>
    series.epsilon.map((/** @type {number} */ value, /** @type {number} */ i) => {
      const { bias, sigma } = learned(value, series.sigmaEpsilon[i])
      return 100 * (bias + sigmas * sigma)
    })
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: 'wheel’s bias: learned, true dashed (%)',
        steps: series.step,
        least: 640,
        include: [-1, 1],
        unit: '{k}',
        lines: [
          { key: 'upper', values: within(1), name: '±*σ*', kin: 'posterior', shape: 'thin' },
          // Within so narrow a band there is no room for more names; the title tells the lines apart.
          { key: 'lower', values: within(-1), name: '', kin: 'posterior', shape: 'thin' },
          { key: 'learned', values: within(0), name: '', kin: 'posterior' },
          { key: 'true', values: series.step.map(() => 100 * params.bias), name: '', kin: 'truth', shape: 'dashed' },
        ],
        cursor: cursorAt(frame, view),
      }),
  )
}

/** @param {Frame} frame @param {View} view @returns {import('../../draw/time-plot.js').Cursor} */
const cursorAt = ({ step }, view) => ({
  step,
  label: 'Tick shown on the map',
  value: `tick ${step}`,
  stride: STRIDE,
  view,
})

/**
 * Whether the curves of the frame that has come farthest still begin before the step that is shown.
 * @param {Frame} far
 * @param {{ step: number }} frame
 */
export const whole = (far, { step }) => far.series.step[0] <= step

/**
 * The frame whose curves are drawn: of one run the one that has come farthest, so that a reader can go back and on
 * again.
 * @param {Frame} frame
 * @param {View} view
 * @returns {Frame}
 */
const farthest = (frame, { memory: { far } }) => (far && whole(far, frame) ? far : frame)

/**
 * @param {Panel} panel
 * @param {Frame} frame
 * @param {View} view
 * @param {string} title
 * @param {(series: Frame['series']) => number[][]} pick
 * @param {number} least
 */
function draw(panel, frame, view, title, pick, least) {
  const { series } = farthest(frame, view)
  const [error, sigma] = pick(series)
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title,
        steps: series.step,
        least: 640,
        include: [0, least],
        unit: '{k}',
        lines: [
          {
            key: 'sigma',
            values: sigma,
            name: '*σ*',
            kin: frame.params.fixes ? 'posterior' : 'prediction',
            shape: frame.params.fixes ? 'solid' : 'dashed',
          },
          { key: 'error', values: error, name: '*e*', kin: 'truth' },
        ],
        cursor: cursorAt(frame, view),
      }),
  )
}
