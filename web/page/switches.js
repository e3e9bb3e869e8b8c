/** The switches for theme and notation: two groups of buttons whose choice is kept between visits. */

import { recall, remember } from './storage.js'

export function switches() {
  const root = document.documentElement
  const theme = recall('theme')
  group('theme', theme === 'light' || theme === 'dark' ? theme : 'auto', (value) => {
    if (value === 'auto') delete root.dataset.theme
    else root.dataset.theme = value
    remember('theme', value === 'auto' ? null : value)
  })
  const known = [...document.querySelectorAll('[data-set-notation]')].map(
    (it) => it.getAttribute('data-set-notation') ?? '',
  )
  const notation = known.find((it) => it === recall('notation')) ?? 'choset'
  group('notation', notation, (value) => {
    root.dataset.notation = value
    remember('notation', value)
    bring(value)
  })
  if (notation !== 'choset') bring(notation)
}

/**
 * Shows the letters of a notation. Those that are not the page's own are fetched; until they are here the letters stay
 * as they are, and if the fetch fails, the switch goes back to the page's own and says why.
 * @param {string} notation
 */
function bring(notation) {
  const own = /** @type {HTMLElement | null} */ (document.querySelector('[data-set-notation="choset"]'))
  say('')
  import('./notation.js')
    .then(({ show }) => show(notation))
    .catch((error) => {
      own?.click()
      say(
        error.cause === 'version'
          ? 'The book has changed since: reload this page for these letters.'
          : 'These letters could not be fetched.',
      )
    })
}

/** Shows a message beside the switches, in place of the one before. @param {string} words */
export function say(words) {
  const tools = document.querySelector('.site-tools')
  let note = tools?.querySelector('[role=status]')
  if (!note) {
    note = document.createElement('span')
    note.setAttribute('role', 'status')
    tools?.append(note)
  }
  note.textContent = words
}

/**
 * @param {'theme' | 'notation'} name
 * @param {string} now
 * @param {(value: string) => void} choose
 */
function group(name, now, choose) {
  const buttons = [...document.querySelectorAll(`[data-set-${name}]`)]
  const show = (/** @type {string} */ value) => {
    for (const button of buttons)
      button.setAttribute('aria-pressed', String(button.getAttribute(`data-set-${name}`) === value))
  }
  for (const button of buttons) {
    button.addEventListener('click', () => {
      const value = button.getAttribute(`data-set-${name}`) ?? ''
      choose(value)
      show(value)
    })
  }
  show(now)
}
