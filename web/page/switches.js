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
  group('notation', recall('notation') === 'thrun' ? 'thrun' : 'choset', (value) => {
    root.dataset.notation = value
    remember('notation', value)
    if (value === 'thrun') bringThrun()
    else say('')
  })
  if (root.dataset.notation === 'thrun') bringThrun()
}

/** Fetches Thrun's letters. Until they are here the page shows Choset's; if the fetch fails, the switch goes back and says why. */
function bringThrun() {
  const back = /** @type {HTMLElement | null} */ (document.querySelector('[data-set-notation="choset"]'))
  say('')
  import('./notation.js').then(({ thrun }) => thrun()).catch((error) => {
    back?.click()
    say(error.cause === 'version' ? 'The book has changed since: reload this page for Thrun’s letters.' : 'Thrun’s letters could not be fetched.')
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
    for (const button of buttons) button.setAttribute('aria-pressed', String(button.getAttribute(`data-set-${name}`) === value))
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
