/**
 * Before the first paint: scripts are on, theme and notation are as the reader left them. The text stays hidden for a
 * moment until its fonts are there and, after a reload, until the reader's place is on the screen: so nothing moves
 * once it shows. (The style sheets stand before this script, so the fonts are known.)
 */

import { keepPlace } from './place.js'

const root = document.documentElement
root.classList.add('js')
try {
  const theme = localStorage.getItem('theme')
  if (theme === 'light' || theme === 'dark') root.dataset.theme = theme
  const notation = localStorage.getItem('notation')
  if (notation) root.dataset.notation = notation
} catch {
  // Without storage the page begins with the usual settings.
}

// Where a script cannot be fetched the page is as it is without scripts: everything open, and no button that would not
// answer.
addEventListener(
  'error',
  ({ target }) => {
    if (!(target instanceof HTMLScriptElement)) return
    root.classList.remove('js')
    root.dataset.notation = 'choset'
  },
  true,
)

const show = () => root.classList.remove('waiting')
const faces = ['400 1em Text', 'italic 400 1em Text', '400 1em Plain']
// A short page may show a formula at once, which other faces make wider or narrower; the chapter begins with text.
if (root.dataset.page === 'page' && document.querySelector('link[rel="preload"][href*="KaTeX"]'))
  faces.push('400 1em KaTeX_Main', 'italic 400 1em KaTeX_Math')
root.classList.add('waiting')
setTimeout(show, 1200)
Promise.all([...faces.map((face) => document.fonts.load(face)), keepPlace()]).then(show, show)
