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
 * @property {string} [pin] on a narrow figure, the panel that stays in sight; the first row's if not given
 * @property {(frame: any) => boolean} [pins] whether it stays in sight now; always if not given
 * @property {string} [along] on a narrow figure, the row from which on the sentence stays in sight, at the lower edge
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
 * The panel that stays in sight on a narrow figure while what moves it passes below: the one that the layout names, or
 * the first.
 * @param {import('./spec.js').FigureSpec} spec
 */
export const pinOf = ({ panels, layout: { narrow, pin = narrow[0] } }) =>
  panels.find(({ name, height }) => name === pin && typeof height === 'number')

/**
 * The layout as custom properties, for the style rule of the element that holds the parts (web/build/layouts.mjs).
 * The panel that stays in sight reaches from its row over all that follow, and a box of its shape keeps its place; the
 * sentence reaches over those before it, and its words, unseen, keep its own.
 * @param {import('./spec.js').FigureSpec} spec
 */
export function layoutOf(spec) {
  const { narrow, along, medium, wide = medium, columns } = spec.layout
  const styles = {
    narrow: [further(narrow.includes('readouts') ? narrow : [...narrow, 'readouts']), 'minmax(0,1fr)'],
    medium: [medium, columns.medium],
    wide: [wide, columns.wide ?? columns.medium],
  }
  const rows = Object.entries(styles).map(
    ([name, [rows, widths]]) =>
      `--${name}:${template(/** @type {string[]} */ (rows), String(widths), Boolean(spec.stages))}`,
  )
  const pin = pinOf(spec)
  const place = pin
    ? [`--first:${pin.name}`, `--from:${narrow.indexOf(pin.name) + 1}`, `--shape:${pin.width}/${pin.height}`]
    : []
  const said = along ? [`--said:${narrow.indexOf(along) + 1}/${narrow.indexOf('verdict') + 2}`] : []
  return [...rows, ...place, ...said].join(';')
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
