/**
 * Before the first paint: scripts are on, theme and notation are as the reader left them, and the text waits a moment
 * for its faces (style sheets stand before this script, so they are known), so that no line moves once it is there.
 */

const root = document.documentElement
root.classList.add('js')
try {
  const theme = localStorage.getItem('theme')
  if (theme === 'light' || theme === 'dark') root.dataset.theme = theme
  const notation = localStorage.getItem('notation')
  if (notation === 'thrun') root.dataset.notation = notation
} catch {
  // Without storage a page begins as everyone's does.
}

// A script that is lost leaves the page as it is without scripts: everything open, nothing to press that would not answer.
addEventListener('error', ({ target }) => {
  if (!(target instanceof HTMLScriptElement)) return
  root.classList.remove('js')
  root.dataset.notation = 'choset'
}, true)

const show = () => root.classList.remove('waiting')
const faces = ['400 1em Text', 'italic 400 1em Text', '400 1em Plain'].map((face) => document.fonts.load(face))
root.classList.add('waiting')
setTimeout(show, 1200)
Promise.all(faces).then(show, show)
