/** Starts the figure of a page that holds one figure and nothing else. */

import { WIDGETS } from '../widgets/index.js'
import { awaken } from './figures.js'

for (const host of document.querySelectorAll('.widget')) awaken(/** @type {HTMLElement} */ (host), WIDGETS)
