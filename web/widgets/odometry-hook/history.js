/** Error against claimed σ over the last ticks. A cursor stands at the tick that the map shows; the reader moves the robot by it. */

import { timePlot } from '../../core/time-plot.js'

/** @typedef {import('estimate-wasm').HookFrame} Frame */
/** @typedef {import('../../core/shell.js').Panel} Panel */
/** @typedef {import('../../core/spec.js').View} View */

/** Ticks of an arrow key. */
const STRIDE = 10

/** @param {Panel} panel @param {Frame} frame @param {View} view */
export function drawPosition(panel, frame, view) {
  draw(panel, frame, view, 'position: error *e* and claimed *σ* (m)', ({ position, sigmaPosition }) => [position, sigmaPosition], 0.5)
}

/** @param {Panel} panel @param {Frame} frame @param {View} view */
export function drawHeading(panel, frame, view) {
  const degrees = (/** @type {number[]} */ values) => values.map((value) => (value * 180) / Math.PI)
  draw(panel, frame, view, 'heading: error *e* and claimed *σ* (°)', ({ heading, sigmaHeading }) => [degrees(heading), degrees(sigmaHeading)], 5)
}

/** The frame whose curves are drawn: of one run the one that has come farthest, so that a reader can go back and on again. @param {Frame} frame @param {View} view */
function farthest(frame, { memory }) {
  const run = JSON.stringify(frame.params)
  if (memory.run !== run || !(memory.far?.step >= frame.step) || memory.far.series.step[0] > frame.step) memory.far = frame
  memory.run = run
  return memory.far
}

/** @param {Panel} panel @param {Frame} frame @param {View} view @param {string} title @param {(series: Frame['series']) => number[][]} pick @param {number} least */
function draw(panel, frame, view, title, pick, least) {
  const { series } = farthest(frame, view)
  const [error, sigma] = pick(series)
  panel.pen.draw((pen) => void timePlot(pen, panel, {
    title,
    steps: series.step,
    least: 640,
    include: [0, least],
    unit: { choset: '*k*', thrun: '*t*' },
    lines: [
      { key: 'sigma', values: sigma, name: '*σ*', kin: frame.params.fixes ? 'posterior' : 'prediction', shape: frame.params.fixes ? 'solid' : 'dashed' },
      { key: 'error', values: error, name: '*e*', kin: 'truth' },
    ],
    cursor: { step: frame.step, label: 'Tick shown on the map', value: `tick ${frame.step}`, stride: STRIDE, view },
  }))
}
