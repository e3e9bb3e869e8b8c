/** Fetches the script of a figure and lets it take over the element. */

import { reloadIfThere } from '../load/reload-if-back.js'
import { hideFailure, showFailure } from '../figure/failure.js'
import { defineFigure } from '../figure/element.js'
import { inTime } from '../load/timeouts.js'

/**
 * @param {HTMLElement} host
 * @param {typeof import('../widgets/index.js').WIDGETS} widgets
 * @param {boolean} [again] whether the reader asks for it after a failure
 */
export async function awaken(host, widgets, again = false) {
  const load = widgets[host.dataset.widget ?? '']
  if (!load) return
  hideFailure(host)
  try {
    defineFigure(await inTime(load()))
  } catch (error) {
    showFailure(host, 'its script could not be fetched', () => awaken(host, widgets, true))
    if (again) await reloadIfThere(error, host.dataset.figure)
  }
}
