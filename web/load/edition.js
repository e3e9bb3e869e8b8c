/**
 * A page that was open while a new edition of the book was published. Names of files carry a hash of their content:
 * what the page has not fetched yet is no longer on the server, and trying again never helps. Reloading does.
 */

import { button } from '../draw/dom.js'
import { withState } from '../figure/state-in-url.js'

const PATIENCE_MS = 5000

/**
 * Whether the server no longer has the script that this page was written with. A server that does not answer says
 * nothing.
 */
export async function isReplaced() {
  const script = /** @type {HTMLScriptElement | null} */ (document.querySelector('script[type="module"][src]'))
  if (!script) return false
  try {
    const { status } = await fetch(script.src, {
      method: 'HEAD',
      cache: 'no-store',
      signal: AbortSignal.timeout(PATIENCE_MS),
    })
    return status === 404 || status === 410
  } catch {
    return false
  }
}

/** Says in `into`, instead of what stands there, that a new edition is there, with a button. @param {Element} into */
export function sayReplaced(into) {
  into.textContent =
    'There is a new edition of this book: reload this page to go on. Your place, your answers ' +
    'and your figures stay as they are. '
  button(document, into, 'Reload', reload)
}

/** Loads the page anew, with the figures in the state they are in. */
function reload() {
  const { hash } = location
  let address = location.href
  for (const widget of /** @type {NodeListOf<HTMLElement & { state: any }>} */ (
    document.querySelectorAll('.widget[data-state="live"]')
  )) {
    if (widget.dataset.figure && widget.state) address = withState(address, widget.dataset.figure, widget.state)
  }
  const url = new URL(address)
  url.hash = hash
  history.replaceState(history.state, '', url)
  location.reload()
}
