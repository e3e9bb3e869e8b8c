/** NEES, and errors beside what the filter claims of them, over the steps. */

import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').LoopFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** @param {Panel} panel @param {Frame} frame */
export function drawNees(panel, { series, neesBand: [low, high] }) {
  panel.pen.draw(() => {
    timePlot(panel.pen, panel, {
      title: 'NEES of the pose and its 95 % band',
      steps: series.step,
      log: true,
      include: [0.1, 20],
      lines: [{ key: 'nees', values: series.nees, name: '', kin: 'truth' }],
      rules: [
        { key: 'low', at: low },
        { key: 'high', at: high },
      ],
    })
  })
}

/** @param {Panel} panel @param {Frame} frame */
export function drawErrors(panel, { series }) {
  panel.pen.draw(() => {
    timePlot(panel.pen, panel, {
      title: '*e* and *σ*; mean *σ* of the map (m)',
      steps: series.step,
      include: [0, 0.3],
      lines: [
        { key: 'error', values: series.error, name: '*e*', kin: 'truth' },
        { key: 'sigma', values: series.sigma, name: '*σ*', kin: 'posterior' },
        { key: 'map', values: series.mapSigma, name: 'map', kin: 'posterior', shape: 'dashed' },
      ],
    })
  })
}
