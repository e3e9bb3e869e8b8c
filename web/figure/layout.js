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

const TAIL = ['tries', 'controls', 'grow', 'readouts', 'tools']
/** On a narrow figure the button that shows what else there is stands before the numbers. */
const further = (/** @type {string[]} */ rows) => rows.flatMap((row) => (row === 'readouts' ? ['further', row] : row))

/**
 * Whether a panel stands behind the numbers on a narrow figure, where it waits with them.
 * @param {Layout} layout
 * @param {string} name
 */
export const isLater = ({ narrow }, name) =>
  narrow.includes('readouts') && narrow.indexOf(name) > narrow.indexOf('readouts')

/**
 * Whether on a narrow figure the first panel stays in sight while what moves it passes below.
 * @param {import('./spec.js').FigureSpec} spec
 */
export const isPinned = ({ panels: [{ name, height }], layout: { narrow } }) =>
  narrow[0] === name && typeof height === 'number'

/**
 * The layout as custom properties, for the style rule of the element that holds the parts (web/build/layouts.mjs).
 * Where the first panel stays in sight it reaches over all rows, and a box of its shape keeps its place in the first.
 * @param {import('./spec.js').FigureSpec} spec
 */
export function layoutOf(spec) {
  const { narrow, medium, wide = medium, columns } = spec.layout
  const styles = {
    narrow: [further(narrow.includes('readouts') ? narrow : [...narrow, 'readouts']), 'minmax(0,1fr)'],
    medium: [medium, columns.medium],
    wide: [wide, columns.wide ?? columns.medium],
  }
  const rows = Object.entries(styles).map(
    ([name, [rows, widths]]) =>
      `--${name}:${template(/** @type {string[]} */ (rows), String(widths), Boolean(spec.stages))}`,
  )
  const [{ name, width, height }] = spec.panels
  return [...rows, ...(isPinned(spec) ? [`--first:${name}`, `--shape:${width}/${height}`] : [])].join(';')
}

/** @param {string[]} rows @param {string} widths @param {boolean} grows */
function template(rows, widths, grows) {
  const columns = rows[0].split(' ').length
  const named = new Set(rows.join(' ').split(' '))
  const tail = TAIL.filter((part) => !named.has(part) && (part !== 'grow' || grows)).map((part) =>
    Array(columns).fill(part).join(' '),
  )
  const tracks = widths.split(' ').map((width) => (width.startsWith('minmax') ? width : `minmax(0,${width})`))
  // Where a part reaches over several rows, the last of them takes the room that the others leave.
  const reaches = (/** @type {number} */ i) =>
    rows[i]?.split(' ').some((part, column) => rows[i - 1]?.split(' ')[column] === part)
  const heights = rows.map((row, i) => `'${row}'${reaches(i) && !reaches(i + 1) ? '1fr' : 'auto'}`)
  return `${heights.join('')}${tail.map((row) => `'${row}'auto`).join('')}/${tracks.join(' ')}`
}
