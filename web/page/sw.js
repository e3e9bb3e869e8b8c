/**
 * Keeps the whole book for reading offline. Every file of this edition is fetched once, into a store named for the
 * place and the edition. Pages come from the network while it answers, so that a new edition shows at once; files with
 * a hash in their name never change and come from the store.
 *
 * A new edition's worker waits, as browsers have it, until no page of the old one is open, and only then clears the old
 * store: an open page still finds the scripts of its own edition there, which are no longer on the server.
 */

const VERSION = '__VERSION__'
const FILES = __PRECACHE__
// Stores belong to the origin: another copy of the book, in a folder beside this one, has its own.
const PREFIX = `book-${new URL(registration.scope).pathname}#`
const STORE = PREFIX + VERSION
/** How long the network may take for a page before a reader sees the kept one, milliseconds. */
const PATIENCE_MS = 2500

addEventListener('install', (event) => event.waitUntil(fill()))
addEventListener('activate', (event) => event.waitUntil(clean().then(() => clients.claim())))

async function fill() {
  const store = await caches.open(STORE)
  await Promise.all(
    FILES.map(async ({ url }) => {
      const address = new URL(url, registration.scope).href
      const known = isHashed(address) ? await caches.match(address) : undefined
      const answer = known ?? (await fetch(address, { cache: isHashed(address) ? 'default' : 'no-cache' }))
      if (!answer.ok) throw new Error(`${url}: ${answer.status}`)
      await store.put(address, answer)
    }),
  )
}

async function clean() {
  const old = (await ours()).filter((name) => name !== STORE)
  await Promise.all(old.map((name) => caches.delete(name)))
}

/** The names of this copy's stores: of this edition first, then of those before and after it. */
async function ours() {
  const names = (await caches.keys()).filter((name) => name.startsWith(PREFIX))
  return names.sort((a, b) => Number(b === STORE) - Number(a === STORE))
}

addEventListener('fetch', (event) => {
  const { request } = event
  const url = new URL(request.url)
  if (request.method !== 'GET' || !url.href.startsWith(registration.scope)) return
  event.respondWith(isHashed(url.href) ? lasting(request) : fresh(request))
})

/** A file that never changes: an open page may be of another edition than this worker. @param {Request} request */
async function lasting(request) {
  for (const name of await ours()) {
    const answer = await (await caches.open(name)).match(request.url)
    if (answer) return answer
  }
  return fetch(request)
}

/**
 * From the network, unless it fails, takes too long or has nothing but an error: then what is kept.
 * @param {Request} request
 */
async function fresh(request) {
  const network = fetch(request).then(whole)
  const silence = new Promise((resolve) => {
    setTimeout(resolve, PATIENCE_MS)
  })
  const answer = await Promise.race([network, silence]).catch(() => undefined)
  if (answer && answer.status < 500 && answer.status !== 429) return answer
  return (await stored(request)) ?? network
}

/**
 * An answer of which everything has come: a server may send the beginning of a page and then hang.
 * @param {Response} answer
 */
async function whole(answer) {
  await answer.clone().arrayBuffer()
  return answer
}

/**
 * A figure's state in the address does not make it another page, and a folder is its index.
 * @param {Request} request
 */
async function stored(request) {
  const store = await caches.open(STORE)
  const plain = request.url.replace(/[?#].*$/, '')
  const names = [plain, plain.replace(/\/$/, '/index.html'), plain.replace(/\/index\.html$/, '/')]
  for (const name of names) {
    const answer = await store.match(name)
    if (answer) return answer
  }
  return undefined
}

function isHashed(address) {
  return /[-.][A-Za-z0-9]{8,}\.\w+$/.test(address)
}
