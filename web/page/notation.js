/**
 * Thrun's letters. A page carries its formulas in Choset's; the other reading of those that differ is a file of its own,
 * fetched once when a reader first asks for it.
 */

/** @type {Promise<void> | undefined} */
let coming

/** The formulas of this page in Thrun's letters, put beside Choset's. */
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
  const response = await fetch('thrun.json')
  if (!response.ok) throw new Error(`thrun.json: ${response.status}`)
  const { version, readings } = await response.json()
  // Of another build than the page: its numbers name other formulas.
  if (version !== document.documentElement.dataset.readings) throw new Error('thrun.json', { cause: 'version' })
  return readings
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
