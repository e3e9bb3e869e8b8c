/** What each sensor and each landmark says by itself, in a table: one that stands out is at fault. */

import { button, part } from '../draw/dom.js'
import { fixed } from '../draw/numbers.js'
import { landmarkName, looksOf } from '../widgets/robot-log/looks.js'
import { percent } from '../widgets/robot-log/words.js'

/** @typedef {import('../widgets/robot-log/looks.js').Frame} Frame */
/** @typedef {import('../widgets/robot-log/looks.js').Source} Source */
/** @typedef {{ name: string, source: Source, cells: string[] }} Row */

const DEGREES = 180 / Math.PI
const SENSORS = /** @type {const} */ ([
  ['fix', 'Positions'],
  ['heading', 'Headings'],
  ['range', 'Ranges'],
  ['bearing', 'Ranges with bearings'],
])

/** @param {Frame} frame @returns {string[]} */
export function headsOf({ bearings }) {
  return ['Readings', 'Refused', 'Mean, σ', 'NIS', 'Lag 1', ...(bearings ? ['Bearings’ mean, °'] : [])]
}

/** A row for each sensor that has readings, and one for each landmark. @param {Frame} frame @returns {Row[]} */
export function rowsOf(frame) {
  const { summary, byLandmark, landmarkStatistics, bearings, meanBearing } = frame
  const { sensors } = summary
  /** @typedef {{ used: number, refused: number, nis?: number | null, lag1?: number | null }} Sums */
  const cells = (
    /** @type {Sums} */ { used, refused, nis, lag1 },
    /** @type {number | null | undefined} */ mean,
    /** @type {number | null | undefined} */ bearing,
  ) => [
    (used + refused).toLocaleString('en'),
    used + refused > 0 ? percent(refused / (used + refused)) : '–',
    ...[mean, nis, lag1].map((value) => fixed(value, 2)),
    ...(bearings ? [bearing === null || bearing === undefined ? '–' : fixed(DEGREES * bearing, 2)] : []),
  ]
  /** @type {Row[]} */
  const rows = []
  for (const [sensor, name] of SENSORS) {
    const said = sensors[sensor]
    if (!said) continue
    const source = { sensor, landmark: null, bearing: false }
    rows.push({ name, source, cells: cells(said, said.meanInnovation, sensor === 'bearing' ? meanBearing : null) })
  }
  const sensor = sensors.bearing ? 'bearing' : 'range'
  const each = byLandmark.map((seen, i) => ({ ...seen, ...landmarkStatistics[i] }))
  for (const seen of each.sort((a, b) => a.id - b.id)) {
    if (seen.used + seen.refused === 0) continue
    const source = { sensor, landmark: seen.id, bearing: false }
    rows.push({
      name: `Landmark ${landmarkName(frame, seen.id)}`,
      source,
      cells: cells(seen, seen.mean, seen.meanBearing),
    })
  }
  return rows
}

export class SourceTable {
  /** @param {(looks: any) => void} look */
  constructor(look) {
    this.look = look
    this.box = document.createElement('div')
    this.box.className = 'log-sources table-box scroll-box'
    this.said = ''
  }

  /** @param {Frame} frame */
  show(frame) {
    const { source } = looksOf(frame)
    const rows = rowsOf(frame)
    const said = JSON.stringify([rows, source])
    if (said === this.said) return
    this.said = said
    const focused = document.activeElement?.getAttribute('data-source')
    this.box.replaceChildren()
    if (rows.length === 0) return
    const table = part(document, this.box, 'table', 'log-table has-heads')
    part(document, table, 'caption', '').textContent = 'Each sensor and landmark by itself'
    const head = part(document, part(document, table, 'thead', ''), 'tr', '')
    for (const words of ['', ...headsOf(frame)]) {
      const cell = part(document, head, words ? 'th' : 'td', '')
      if (words) cell.setAttribute('scope', 'col')
      cell.textContent = words
    }
    const body = part(document, table, 'tbody', '')
    for (const row of rows) {
      const line = part(document, body, 'tr', '')
      const cell = part(document, line, 'th', '')
      cell.setAttribute('scope', 'row')
      const key = JSON.stringify(row.source)
      const on = key === JSON.stringify(source)
      const choose = button(
        document,
        cell,
        row.name,
        () => this.look({ source: on ? null : row.source, touched: null }),
        'try',
      )
      choose.setAttribute('aria-pressed', String(on))
      choose.setAttribute('data-source', key)
      for (const words of row.cells) part(document, line, 'td', '').textContent = words
      if (key === focused) choose.focus({ preventScroll: true })
    }
  }
}
