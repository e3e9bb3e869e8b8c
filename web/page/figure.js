/** A page with one figure and nothing else, as other pages embed it. */

import { WIDGETS } from '../widgets/index.js'
import { takeTheme, tellHeight } from './embedded.js'
import { awaken } from './figures.js'

tellHeight()
takeTheme()
if (parent !== window) {
  // The chapter would not fit the frame.
  for (const link of document.links) link.target = '_blank'
}
const host = /** @type {HTMLElement | null} */ (document.querySelector('.widget'))
if (host) {
  // A chapter may show a figure twice, and a link holds the state under the name of either.
  const named = [...new URLSearchParams(location.search).keys()].find((key) => /^fig-[\w-]{1,40}$/.test(key))
  if (named) host.dataset.figure = named
  awaken(host, WIDGETS)
}
