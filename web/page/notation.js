/**
 * The letters of a notation. A page carries its formulas in Choset's letters. The formulas that read differently in
 * another notation are in a file beside the page, which is fetched when a reader first chooses that notation.
 */

import { PATIENCE_MS } from '../load/timeouts.js'

const root = document.documentElement
/** What has been fetched or is on its way. @type {Map<string, Promise<void>>} */
const coming = new Map()

/**
 * Shows the page in the letters of a notation, unless the reader has chosen another meanwhile.
 * @param {string} notation
 */
export async function show(notation) {
  if (notation !== 'choset') await here(notation)
  if (root.dataset.notation !== notation) return
  root.dataset.letters = notation
  for (const image of /** @type {NodeListOf<HTMLImageElement>} */ (document.querySelectorAll('img.panel'))) {
    image.src = image.src.replace(/(-thrun|-common)?$/, notation === 'choset' ? '' : `-${notation}`)
  }
}

/** @param {string} notation */
function here(notation) {
  const known = coming.get(notation)
  if (known) return known
  const put = fetched(notation).then((readings) => write(notation, readings))
  coming.set(notation, put)
  put.catch(() => coming.delete(notation))
  return put
}

/** @param {string} notation @returns {Promise<string[]>} */
async function fetched(notation) {
  if (!document.querySelector('[data-other]')) return []
  const file = `${notation}.json`
  const answer = await fetch(file, { signal: AbortSignal.timeout(PATIENCE_MS) })
  if (!answer.ok) throw new Error(`${file}: ${answer.status}`)
  const { readings = await kept(answer.url) } = matching(await answer.json())
  // Of another edition than the page: its numbers name other formulas.
  if (!readings) throw new Error(file, { cause: 'version' })
  return readings
}

/**
 * The readings of this page's edition, or none.
 * @param {{ version: string, readings: string[] }} found
 * @returns {{ readings?: string[] }}
 */
function matching({ version, readings }) {
  return version === root.dataset.readings ? { readings } : {}
}

/**
 * The page's own readings out of what was kept for reading offline, after a new edition has come.
 * @param {string} address
 */
async function kept(address) {
  if (!('caches' in globalThis)) return undefined
  for (const name of await caches.keys()) {
    const answer = await (await caches.open(name)).match(address)
    const { readings } = answer ? matching(await answer.json()) : {}
    if (readings) return readings
  }
  return undefined
}

/**
 * The reading of a formula in the page's own letters is its first element; the others stand behind it.
 * @param {string} notation
 * @param {string[]} readings as the book wrote them, by the number in `data-other`; empty where the page's own letters
 * stand
 */
function write(notation, readings) {
  const page = readings.map((html) => `<div>${html}</div>`).join('')
  const parsed = [...new DOMParser().parseFromString(page, 'text/html').body.children]
  for (const formula of document.querySelectorAll('[data-other]')) {
    const other = parsed[Number(formula.getAttribute('data-other'))].firstElementChild
    const reading = document.importNode(other ?? /** @type {Element} */ (formula.firstElementChild), true)
    reading.classList.add(`in-${notation}`)
    formula.append(reading)
  }
}
