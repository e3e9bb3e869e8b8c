/** Error against claimed σ over the last ticks. */

import { timePlot } from '../../core/time-plot.js'

/** @typedef {import('estimate-wasm').HookFrame} Frame */
/** @typedef {import('../../core/shell.js').Panel} Panel */

/** @param {Panel} panel @param {Frame} frame */
export function drawPosition(panel, frame) {
  const { position, sigmaPosition } = frame.series
  draw(panel, frame, 'position: error *e* and claimed *σ* (m)', position, sigmaPosition, 0.5)
}

/** @param {Panel} panel @param {Frame} frame */
export function drawHeading(panel, frame) {
  const degrees = (/** @type {number[]} */ values) => values.map((value) => (value * 180) / Math.PI)
  const { heading, sigmaHeading } = frame.series
  draw(panel, frame, 'heading: error *e* and claimed *σ* (°)', degrees(heading), degrees(sigmaHeading), 5)
}

/** @param {Panel} panel @param {Frame} frame @param {string} title @param {number[]} error @param {number[]} sigma @param {number} least */
function draw(panel, frame, title, error, sigma, least) {
  panel.pen.draw((pen) => void timePlot(pen, panel, {
    title,
    steps: frame.series.step,
    least: 160,
    include: [0, least],
    unit: { choset: '*k*', thrun: '*t*' },
    lines: [
      { key: 'sigma', values: sigma, name: '*σ*', kin: frame.params.fixes ? 'posterior' : 'prediction', shape: frame.params.fixes ? 'solid' : 'dashed' },
      { key: 'error', values: error, name: '*e*', kin: 'truth' },
    ],
  }))
}
