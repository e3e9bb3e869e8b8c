/** Trace, NEES and NIS over the run. */

import { timePlot } from '../../core/plot.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('../../core/shell.js').Panel} Panel */

/** @param {Panel} panel @param {Frame} frame */
export function drawTrace(panel, { series }) {
  panel.pen.draw((pen) => void timePlot(pen, panel, {
    title: { choset: 'tr *P* (m² and rad² added)', thrun: 'tr Σ (m² and rad² added)' },
    steps: series.step,
    log: true,
    lines: [
      { key: 'trace', values: series.trace, name: 'here', kin: 'posterior' },
      { key: 'reference', values: series.reference, name: 'two', kin: 'truth', shape: 'dashed' },
    ],
  }))
}

/** @param {Panel} panel @param {Frame} frame @param {'nees' | 'nis'} which */
export function drawConsistency(panel, { series, bands, nisDof }, which) {
  const band = bands[which]
  const expected = which === 'nees' ? 3 : nisDof
  const rules = band ? [{ key: 'low', at: band[0] }, { key: 'high', at: band[1], name: '95 %' }, { key: 'mean', at: expected, name: String(expected) }] : []
  panel.pen.draw((pen) => void timePlot(pen, panel, {
    title: which === 'nees' ? 'NEES, and where 95 % should lie' : 'NIS, and where 95 % should lie',
    steps: series.step,
    include: [0, band ? 1.2 * band[1] : 1],
    rules,
    lines: [{ key: which, values: series[which], name: '', kin: which === 'nees' ? 'posterior' : 'measurement', shape: 'thin' }],
  }))
}
