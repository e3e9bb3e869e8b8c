/** After one visit the book is there without a network. */

export function offline() {
  if (!('serviceWorker' in navigator) || !isSecureContext) return
  const root = new URL(document.documentElement.dataset.root ?? '', location.href)
  navigator.serviceWorker.register(new URL('sw.js', root), { scope: root.pathname }).catch(() => {
    // A host that forbids it serves the book all the same.
  })
}
