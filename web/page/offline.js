/** Registers the service worker, which keeps the book for reading offline. */

export function offline() {
  if (!('serviceWorker' in navigator) || !isSecureContext) return
  const root = new URL(document.documentElement.dataset.root ?? '', location.href)
  navigator.serviceWorker.register(new URL('sw.js', root), { scope: root.pathname }).catch(() => {
    // Where a host or a browser forbids it, the book can be read online only.
  })
}
