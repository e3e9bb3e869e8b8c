/**
 * The formulas in Thrun's letters. A page carries its formulas in Choset's letters. The formulas that read differently in
 * Thrun's are in a file beside the page, which is fetched when a reader first switches.
 */

import { PATIENCE_MS } from '../core/patience.js'

/** @type {Promise<void> | undefined} */
let coming

/** Puts the formulas of this page in Thrun's letters beside those in Choset's. */
export function thrun() {
  coming ??= fetched().then(
    (readings) => put(readings),
    (error) => {
      coming = undefined
      throw error
    },
  )
  return coming
}

/** @returns {Promise<string[]>} */
async function fetched() {
  if (!document.querySelector('[data-thrun]')) return []
  const answer = await fetch('thrun.json', { signal: AbortSignal.timeout(PATIENCE_MS) })
  if (!answer.ok) throw new Error(`thrun.json: ${answer.status}`)
  const { readings = await kept(answer.url) } = matching(await answer.json())
  // Of another edition than the page: its numbers name other formulas.
  if (!readings) throw new Error('thrun.json', { cause: 'version' })
  return readings
}

/** The readings of this page's edition, or none. @param {{ version: string, readings: string[] }} found @returns {{ readings?: string[] }} */
function matching({ version, readings }) {
  return version === document.documentElement.dataset.readings ? { readings } : {}
}

/** The page's own readings out of what was kept for reading offline, after a new edition has come. @param {string} address */
async function kept(address) {
  if (!('caches' in globalThis)) return undefined
  for (const name of await caches.keys()) {
    const answer = await (await caches.open(name)).match(address)
    const { readings } = answer ? matching(await answer.json()) : {}
    if (readings) return readings
  }
  return undefined
}

/** @param {string[]} readings as the book wrote them, by the number in `data-thrun` */
function put(readings) {
  const page = readings.map((html) => `<div>${html}</div>`).join('')
  const parsed = [...new DOMParser().parseFromString(page, 'text/html').body.children]
  for (const formula of document.querySelectorAll('[data-thrun]')) {
    const other = parsed[Number(formula.getAttribute('data-thrun'))]
    const reading = document.createElement(formula.localName)
    reading.className = 'in-thrun'
    reading.append(...[...other.childNodes].map((node) => document.importNode(node, true)))
    formula.append(reading)
  }
  document.documentElement.classList.add('two-notations')
}
