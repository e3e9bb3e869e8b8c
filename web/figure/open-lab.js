/** The lab of a figure, in the state that the page opens it in or that the address holds. */

import { LAST_STEP, VERSION, readState } from './state-in-url.js'

/**
 * A figure's lab in its usual state (the page's `data-start`, else the specification's), and, where the address holds
 * another state, a second lab at the start of the run that leads there.
 * @param {any} module
 * @param {import('./spec.js').FigureSpec} spec
 * @param {string} figure
 * @param {string | undefined} given the page's
 * @returns {{ lab: any, linked: { lab: any, step: number } | null, mangled: boolean }}
 */
export function openLab(module, spec, figure, given) {
  const Lab = module[spec.lab]
  if (!Lab) throw new Error(`the module holds no ${spec.lab}`)
  const page = JSON.parse(given ?? '{}')
  const lab = Lab.from({
    version: VERSION,
    lab: spec.name,
    step: page.step ?? spec.start.step,
    params: { ...spec.start.params, ...page.params },
  })
  const state = readState(location.href, figure, spec.name)
  if (state === null) return { lab, linked: null, mangled: false }
  if (state === 'mangled' || state.step > LAST_STEP) return { lab, linked: null, mangled: true }
  try {
    return { lab, linked: { lab: Lab.from({ ...state, step: 0 }), step: state.step }, mangled: false }
  } catch {
    return { lab, linked: null, mangled: true }
  }
}
