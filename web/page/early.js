/**
 * Before the first paint: scripts are on, theme and notation are as the reader left them. The text stays hidden for a moment
 * until its fonts are there and, after a reload, until the reader's place is on the screen: so nothing moves once it shows.
 * (The style sheets stand before this script, so the fonts are known.)
 */

import { keepPlace } from './place.js'

const root = document.documentElement
root.classList.add('js')
try {
  const theme = localStorage.getItem('theme')
  if (theme === 'light' || theme === 'dark') root.dataset.theme = theme
  const notation = localStorage.getItem('notation')
  if (notation === 'thrun') root.dataset.notation = notation
} catch {
  // Without storage the page begins with the usual settings.
}

// Where a script cannot be fetched the page is as it is without scripts: everything open, and no button that would not answer.
addEventListener('error', ({ target }) => {
  if (!(target instanceof HTMLScriptElement)) return
  root.classList.remove('js')
  root.dataset.notation = 'choset'
}, true)

const show = () => root.classList.remove('waiting')
const faces = ['400 1em Text', 'italic 400 1em Text', '400 1em Plain'].map((face) => document.fonts.load(face))
root.classList.add('waiting')
setTimeout(show, 1200)
Promise.all([...faces, keepPlace()]).then(show, show)
