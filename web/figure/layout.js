/**
 * Where the parts of a figure stand. A widget says which panels share a row, at three widths of the figure; what every
 * figure has follows below them in one order: what to try, controls, readouts, tools. The style sheet chooses by the
 * figure's own width.
 *
 * A row names an area for each column (`'map map ranks'`). On a narrow figure there is one column, and the widget may
 * put the parts that belong to the hand, such as `controls`, before its further panels.
 */

/**
 * @typedef {object} Layout
 * @property {string[]} narrow rows of one area each
 * @property {string[]} medium
 * @property {string[]} [wide] as on a medium figure if not given
 * @property {{ medium: string, wide?: string }} columns widths of the columns, as CSS writes them
 */

const TAIL = ['tries', 'controls', 'readouts', 'tools']

/**
 * The layout as custom properties, for the `style` of the element that holds the parts.
 * @param {Layout} layout
 */
export function placed({ narrow, medium, wide = medium, columns }) {
  const styles = {
    narrow: [narrow, 'minmax(0,1fr)'],
    medium: [medium, columns.medium],
    wide: [wide, columns.wide ?? columns.medium],
  }
  return Object.entries(styles)
    .map(([name, [rows, widths]]) => `--${name}:${template(/** @type {string[]} */ (rows), String(widths))}`)
    .join(';')
}

/** @param {string[]} rows @param {string} widths */
function template(rows, widths) {
  const columns = rows[0].split(' ').length
  const named = new Set(rows.join(' ').split(' '))
  const tail = TAIL.filter((part) => !named.has(part)).map((part) => Array(columns).fill(part).join(' '))
  const tracks = widths.split(' ').map((width) => (width.startsWith('minmax') ? width : `minmax(0,${width})`))
  // Where a part reaches over several rows, the last of them takes the room that the others leave.
  const reaches = (/** @type {number} */ i) =>
    rows[i]?.split(' ').some((part, column) => rows[i - 1]?.split(' ')[column] === part)
  const heights = rows.map((row, i) => `'${row}'${reaches(i) && !reaches(i + 1) ? '1fr' : 'auto'}`)
  return `${heights.join('')}${tail.map((row) => `'${row}'auto`).join('')}/${tracks.join(' ')}`
}
