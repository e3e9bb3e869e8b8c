/**
 * The line about the likeliest numbers of a map: whether the cells of the map tell where it runs, and where a finer map
 * has to look.
 */

/** Of two numbers, the χ² quantile of 95 % is −2 ln 0.05. */
export const LIMIT = -2 * Math.log(0.05)
/** What lies within the line has to be this many cells thick for the line to be told. */
const THICK = 3
/** Cells beside what lies within, and the share of it where that reaches the edge of a finer map. */
const MARGIN = 1.5
const BEYOND = 0.5

/**
 * What lies within the line: the columns and rows that it reaches, how many cells, the most, and whether it reaches the
 * edge of the map.
 * @typedef {{ columns: [number, number], rows: [number, number], count: number, most: number, edge: boolean }} Within
 */

/** @param {number[]} values by rows @param {number} size cells to a side @returns {Within} */
export function within(values, size) {
  const most = values.reduce((sum, value) => Math.max(sum, value), -Infinity)
  const [columns, rows] = [span(), span()]
  let count = 0
  for (const [i, value] of values.entries()) {
    if (!(value > most - LIMIT / 2)) continue
    count += 1
    reach(columns, i % size)
    reach(rows, Math.floor(i / size))
  }
  const edge = [columns, rows].some(([from, to]) => from === 0 || to === size - 1)
  return { columns, rows, count, most, edge }
}

/** @returns {[number, number]} */
const span = () => [Infinity, -Infinity]

/** @param {[number, number]} ends @param {number} at */
function reach(ends, at) {
  ends[0] = Math.min(ends[0], at)
  ends[1] = Math.max(ends[1], at)
}

/**
 * Whether the cells tell where the line runs: neither too few lie within it, nor a ridge that is thinner than they are.
 * @param {Within} found
 */
export function tells({ columns, rows, count }) {
  const long = Math.max(columns[1] - columns[0], rows[1] - rows[0]) + 1
  return count / long >= THICK
}

/**
 * Where a finer map looks: as many places over what lies within, and a little beside it.
 * @param {number[]} places of one axis @param {[number, number]} ends that what lies within reaches
 * @param {boolean} edge whether that is the edge of a map that was finer already
 */
export function closer(places, [from, to], edge) {
  const step = places[1] - places[0]
  const beside = edge ? Math.max(MARGIN, BEYOND * (to - from + 1)) : MARGIN
  const [low, high] = [places[from] - beside * step, places[to] + beside * step]
  return places.map((_, i) => low + ((high - low) * i) / (places.length - 1))
}
