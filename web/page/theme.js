/**
 * Before the first paint of a figure's own page: scripts are on, and the theme is the one that the address asks for.
 */

const root = document.documentElement
root.classList.add('js')
const theme = new URLSearchParams(location.search).get('theme')
if (theme === 'light' || theme === 'dark') root.dataset.theme = theme

// Without its script the page is as it is for readers without scripts: a still picture with nothing to press.
addEventListener(
  'error',
  ({ target }) => {
    if (target instanceof HTMLScriptElement) root.classList.remove('js')
  },
  true,
)

export {}
