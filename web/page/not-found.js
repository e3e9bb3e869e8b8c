/**
 * The page for an address that leads nowhere. A host serves it at that very address, at any depth, so it does not know
 * where the book's root is. It asks each folder above it for a file that only the root has, and then points its links
 * there.
 */

const html = document.documentElement
try {
  const theme = localStorage.getItem('theme')
  if (theme === 'light' || theme === 'dark') html.dataset.theme = theme
} catch {
  // Without storage the page has the usual theme.
}

/** No page of the book lies deeper than this. */
const MOST = 12

/** The path of the book's root, or null. */
async function home() {
  const folders = [...location.pathname.matchAll(/\//g)].map(({ index }) => location.pathname.slice(0, index + 1))
  for (const folder of folders.slice(0, MOST).reverse()) {
    const answer = await fetch(location.origin + folder + html.dataset.sign, { method: 'HEAD' }).catch(() => null)
    // Some hosts answer every address with a page: only a style sheet is the file that was asked for.
    if (answer?.ok && answer.headers.get('content-type')?.startsWith('text/css')) return folder
  }
  return null
}

home().then((folder) => {
  if (folder === null) return
  for (const link of /** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll('[data-place]'))) {
    link.href = location.origin + folder + link.dataset.place
  }
  html.dataset.found = 'true'
})
