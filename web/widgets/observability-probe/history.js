/** Trace, NEES and NIS over the run. */

import { timePlot } from '../../draw/time-plot.js'

/** @typedef {import('estimate-wasm').ProbeFrame} Frame */
/** @typedef {import('../../figure/shell.js').Panel} Panel */

/** @param {Panel} panel @param {Frame} frame */
export function drawTrace(panel, { series }) {
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title: 'tr {P} (m² + rad²); dashed: two, ranges only',
        steps: series.step,
        log: true,
        lines: [
          { key: 'trace', values: series.trace, name: 'here', kin: 'posterior' },
          { key: 'reference', values: series.reference, name: 'two', kin: 'truth', shape: 'dashed' },
        ],
      }),
  )
}

/**
 * NEES or NIS with its band. The band of NIS is that of its degrees of freedom, which change where a sighting is not
 * used.
 * @param {Panel} panel @param {Frame} frame @param {'nees' | 'nis'} which
 */
export function drawConsistency(panel, { series, bands }, which) {
  const dofs = which === 'nees' ? [3] : [...new Set(series.nisDof.filter((dof) => dof > 0))]
  const high = Math.max(1, ...dofs.map((dof) => bands[dof][1]))
  const end = (/** @type {0 | 1} */ side) => series.nisDof.map((dof) => bands[dof][side])
  const [dof] = dofs
  const steady = dofs.length === 1
  panel.pen.draw(
    (pen) =>
      void timePlot(pen, panel, {
        title:
          which === 'nees'
            ? 'NEES, and where 95 % should lie'
            : dofs.length > 1
              ? 'NIS; its band dips where a sighting is unused'
              : 'NIS, and where 95 % should lie',
        steps: series.step,
        include: [0, 1.2 * high],
        rules: steady
          ? [
              { key: 'low', at: bands[dof][0] },
              { key: 'high', at: bands[dof][1], name: '95 %' },
              { key: 'mean', at: dof, name: String(dof) },
            ]
          : [],
        lines: [
          {
            key: which,
            values: series[which],
            name: '',
            kin: which === 'nees' ? 'posterior' : 'measurement',
            shape: 'thin',
          },
          ...(steady
            ? []
            : [
                { key: 'low', values: end(0), name: '', shape: 'thin' },
                { key: 'high', values: end(1), name: '95 %', shape: 'thin' },
                { key: 'mean', values: series.nisDof, name: String(series.nisDof.at(-1)), shape: 'thin' },
              ]),
        ],
      }),
  )
}
