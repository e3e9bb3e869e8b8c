/** What few readers turn, behind a fold: the tolerance of the rank, and the inputs of the run. */

import { buildControl } from '../../figure/controls.js'
import { part } from '../../draw/dom.js'
import { fixed, power } from '../../draw/numbers.js'
import { short } from './names.js'

/** @type {import('../../figure/controls.js').Control[]} */
const CONTROLS = [
  {
    kind: 'range',
    name: 'logTolerance',
    label: 'Tolerance',
    ends: [-14, -1],
    step: 0.1,
    words: (_, frame) => power(frame.tolerance),
  },
  {
    kind: 'range',
    name: 'start',
    label: '{Pstart}, all variances',
    ends: [-3, 4],
    step: 0.1,
    scale: (value) => Math.log10(Math.max(value, 1e-3)),
    set: (value) => ({ start: Number((10 ** value).toPrecision(3)) }),
    words: (_, frame) => `× ${short(frame.params.start)}`,
  },
  {
    kind: 'range',
    name: 'input',
    label: 'Inputs of the run',
    ends: [-5, 5],
    step: 0.1,
    words: (value) => fixed(value, 1),
  },
]

/** @param {Document} document @param {import('./editor.js').Change} change */
export function buildMore(document, change) {
  const element = document.createElement('details')
  element.setAttribute('class', 'more own-more')
  part(document, element, 'summary', '').textContent = 'More'
  const into = part(document, element, 'div', 'params')
  const shown = CONTROLS.map((control) => buildControl(document, control, change, {}))
  into.append(...shown.map((one) => one.element))
  return {
    element,
    /** @param {any} params @param {any} frame */
    show(params, frame) {
      for (const one of shown) one.show(params, frame)
    },
  }
}
