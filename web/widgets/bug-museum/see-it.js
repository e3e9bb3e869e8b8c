/** Leads from a bug to the program that has it. */

import { part } from '../../draw/dom.js'

/** What is no formula: a setting of the world, which no program has. */
const SETTINGS = ['frozen-jacobian', 'late', 'open-gate']

/** @param {Document} document */
export function buildSeeIt(document) {
  const element = document.createElement('span')
  // A still is drawn once for all pages, and does not know where they are.
  const { root } = document.documentElement.dataset
  if (root === undefined) element.hidden = true
  return {
    element,
    /** @param {import('estimate-wasm').MuseumParams} params */
    show({ bug, lot }) {
      const known = root !== undefined && lot === 0 && bug !== 'none'
      const kind = !known ? '' : SETTINGS.includes(bug) ? 'setting' : bug
      if (element.dataset.shows === kind) return
      element.dataset.shows = kind
      element.replaceChildren()
      element.hidden = !known
      if (kind === 'setting') element.append('No formula: a setting of the world')
      else if (known) {
        const link = part(document, element, 'a', '')
        link.textContent = 'See it as a program'
        link.setAttribute('href', `${root}kalman/filter/?program=${bug}#fig-filter`)
      }
    },
  }
}
