/** The markup that shows a figure on another page, and the address of the page that holds the figure alone. */

import { withState } from './state-in-url.js'

/** The frame needs scripts and nothing else; with popups its link to the chapter opens in a tab of its own. */
const SANDBOX = 'allow-scripts allow-popups allow-popups-to-escape-sandbox'

/**
 * @param {object} figure
 * @param {string} figure.page the address of the figure's own page
 * @param {string} figure.id under which the address holds the state
 * @param {string} figure.title
 * @param {number} figure.height pixels
 * @param {import('./state-in-url.js').State} state
 */
export function markup({ page, id, title, height }, state) {
  const src = new URL(withState(page, id, state))
  src.hash = ''
  const attributes = {
    src: src.href,
    title,
    width: '100%',
    height: String(Math.ceil(height)),
    style: 'border: 0',
    sandbox: SANDBOX,
    loading: 'lazy',
  }
  return `<iframe ${Object.entries(attributes)
    .map(([name, value]) => `${name}="${escaped(value)}"`)
    .join(' ')}></iframe>`
}

/** @param {string} text */
function escaped(text) {
  return text.replace(/&/g, '&amp;').replace(/"/g, '&quot;').replace(/</g, '&lt;')
}

/**
 * The address of the page with this figure alone.
 * @param {Document} document
 * @param {string} tag
 */
export function pageOf(document, tag) {
  const root = new URL(document.documentElement.dataset.root ?? './', document.location.href)
  return new URL(`figure/${tag}/`, root).href
}
