/** Fetches a figure's script and hands the element to it. */

import { defineFigure } from '../core/figure.js'

/**
 * @param {HTMLElement} host
 * @param {typeof import('../widgets/index.js').WIDGETS} widgets
 */
export async function awaken(host, widgets) {
  const load = widgets[host.localName]
  if (!load) return
  host.querySelector('.figure-failure')?.remove()
  try {
    defineFigure(await load())
  } catch {
    host.dataset.state = 'failed'
    const words = document.createElement('p')
    words.className = 'figure-failure'
    words.setAttribute('role', 'status')
    words.append('This figure is a still picture: its script could not be fetched. ')
    const again = document.createElement('button')
    again.type = 'button'
    again.className = 'button'
    again.textContent = 'Try again'
    again.addEventListener('click', () => awaken(host, widgets))
    words.append(again)
    host.append(words)
  }
}
