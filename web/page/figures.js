/** Fetches the script of a figure and lets it take over the element. */

import { hideFailure, showFailure } from '../core/failure.js'
import { defineFigure } from '../core/figure.js'
import { inTime } from '../core/patience.js'

/**
 * @param {HTMLElement} host
 * @param {typeof import('../widgets/index.js').WIDGETS} widgets
 */
export async function awaken(host, widgets) {
  const load = widgets[host.localName]
  if (!load) return
  hideFailure(host)
  try {
    defineFigure(await inTime(load()))
  } catch {
    showFailure(host, 'its script could not be fetched', () => awaken(host, widgets))
  }
}
