/** Which state the plots show: the reader chooses it by the name that it has. */

import { choose, select } from './fields.js'
import { nameOf } from './names.js'
import { MOST } from './presets.js'
import { shownState } from './words.js'

/** @param {Document} document @param {import('./editor.js').Change} change */
export function buildShown(document, change) {
  const element = document.createElement('div')
  const input = select(document, element, 'State in the plots', Array(MOST).fill(''))
  input.addEventListener('change', () => change({ shown: input.selectedIndex + 1 }))
  return {
    element,
    /** @param {any} params */
    show(params) {
      for (const [i, option] of [...input.options].entries()) {
        const name = nameOf(params, i)
        if (option.textContent !== name) option.textContent = name
        option.toggleAttribute('hidden', i >= params.states)
        option.toggleAttribute('disabled', i >= params.states)
      }
      choose(input, shownState(params))
    },
  }
}
