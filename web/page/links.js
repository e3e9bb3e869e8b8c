/**
 * Checks what the address says of figures when the page opens, because the figures themselves may be far below. A state
 * that cannot be read, or that the figure's lab refuses, is named at the top of the text.
 */

import { button, part } from '../draw/dom.js'
import { readState } from '../figure/state-in-url.js'
import { loadBuild } from '../load/modules.js'

const MOST = 5

/** @param {typeof import('../widgets/index.js').WIDGETS} widgets */
export async function links(widgets) {
  const named = new Set([...new URLSearchParams(location.search).keys()].filter((key) => key.startsWith('fig-')))
  const wrong = []
  for (const id of named) {
    const host = /** @type {HTMLElement | null} */ (document.getElementById(id)?.querySelector('.widget') ?? null)
    if (!host) {
      wrong.push(`The link names a figure that this page does not have: ${id.slice(0, 40)}.`)
      continue
    }
    // If the figure's script cannot be fetched, the name of its lab is unknown; the rest is checked all the same.
    const spec = await widgets[host.dataset.widget ?? '']?.().catch(() => null)
    const state = readState(location.href, id, spec?.name)
    if (state === 'mangled' || (state && spec && (await isRefused(spec, state)))) {
      const title = host.closest('figure')?.querySelector('.figure-title')?.lastChild?.textContent?.trim() ?? id
      wrong.push(`The link’s state of the figure “${title}” could not be read: the figure shows its usual state.`)
    }
  }
  if (wrong.length > 0) notice(wrong)
}

/**
 * Whether the lab refuses the parameters. If the module cannot be fetched nothing is known, and the figure will say so
 * itself.
 * @param {import('../figure/spec.js').FigureSpec} spec
 * @param {import('../figure/state-in-url.js').State} state
 */
async function isRefused(spec, state) {
  if (spec.world) return false
  const loaded = await loadBuild(spec.build)
  if (!loaded.ok) return false
  try {
    const labs = /** @type {any} */ (loaded.module)
    labs[spec.lab].from({ ...state, step: 0 }).free()
    return false
  } catch {
    return true
  }
}

/** @param {string[]} wrong */
function notice(wrong) {
  const main = document.querySelector('main')
  if (!main) return
  const box = document.createElement('div')
  box.className = 'figure-failure link-notice'
  const words = part(document, box, 'p', '')
  words.setAttribute('role', 'status')
  button(document, box, 'Dismiss', () => {
    box.remove()
    main.focus({ preventScroll: true })
  })
  main.prepend(box)
  const more = wrong.length > MOST ? ` And ${wrong.length - MOST} more.` : ''
  // A screen reader speaks a status when its words change, not when it is added with them.
  setTimeout(() => {
    words.textContent = wrong.slice(0, MOST).join(' ') + more
  }, 50)
}
