/** Gain, variance and error over the last steps. */

import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').BenchFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** @param {Panel} panel @param {Frame} frame */
export function drawGain(panel, frame) {
  const { step } = frame.series
  // A gain is used from the first step on: what the run begins with is the next one's.
  const [r1, r2, knob] = [frame.series.r1, frame.series.r2, frame.series.knob].map((values) =>
    step[0] === 0 ? [NaN, ...values.slice(1)] : values,
  )
  const [s1, s2] = frame.steadyGain
  // A gain that the filter computes has one letter, and one that is set has another.
  const filters = frame.params.mode === 'filter'
  const letter = filters ? '{R}' : '{K}'
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: `gain ${filters ? '{Rk}' : '{K}'} and its knob *g*`,
        steps: step,
        include: [0, 1],
        unit: '{k}',
        rules: [
          { key: '1', at: s1 },
          { key: '2', at: s2 },
        ],
        lines: [
          { key: '1', values: r1, name: `${letter}_1`, kin: 'posterior' },
          { key: '2', values: r2, name: `${letter}_2`, kin: 'posterior', shape: 'dashed' },
          { key: 'knob', values: knob, name: '*g*', kin: null, shape: 'thin' },
        ],
      }),
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawVariance(panel, frame) {
  const { step, p11, p22 } = frame.series
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: 'variance (m², m²/s²), log scale',
        steps: step,
        log: true,
        include: [0.2, 4],
        unit: '{k}',
        lines: [
          { key: '1', values: p11, name: '{P}_{11}', kin: 'posterior' },
          { key: '2', values: p22, name: '{P}_{22}', kin: 'posterior', shape: 'dashed' },
        ],
      }),
  )
}

/** @param {Panel} panel @param {Frame} frame */
export function drawError(panel, frame) {
  const { step, e1, e2 } = frame.series
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: 'error: truth − estimate (m, m/s)',
        steps: step,
        include: [-1, 1],
        unit: '{k}',
        lines: [
          { key: '1', values: e1, name: '*e*_1', kin: 'truth' },
          { key: '2', values: e2, name: '*e*_2', kin: 'truth', shape: 'dashed' },
        ],
      }),
  )
}
