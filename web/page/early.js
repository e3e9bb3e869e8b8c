/** Before the first paint: scripts are on, and the reader's theme and notation are as they left them. */

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
