/**
 * Keeps the whole book: every file of this version is fetched once, into a store named for the place and the version, and
 * this place's older stores go. Pages come from the network while there is one, so that a new version shows at once; files
 * with a hash in their name never change and come from the store.
 */

const VERSION = '__VERSION__'
const FILES = __PRECACHE__
// Stores belong to the origin: another copy of the book, in a folder beside this one, has its own.
const PREFIX = `book-${new URL(registration.scope).pathname}#`
const STORE = PREFIX + VERSION

addEventListener('install', (event) => event.waitUntil(fill().then(() => skipWaiting())))
addEventListener('activate', (event) => event.waitUntil(clean().then(() => clients.claim())))

async function fill() {
  const store = await caches.open(STORE)
  await Promise.all(FILES.map(async ({ url }) => {
    const address = new URL(url, registration.scope).href
    const known = isHashed(address) ? await caches.match(address) : undefined
    const answer = known ?? await fetch(address, { cache: isHashed(address) ? 'default' : 'no-cache' })
    if (!answer.ok) throw new Error(`${url}: ${answer.status}`)
    await store.put(address, answer)
  }))
}

async function clean() {
  const names = await caches.keys()
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== STORE).map((name) => caches.delete(name)))
}

addEventListener('fetch', (event) => {
  const { request } = event
  const url = new URL(request.url)
  if (request.method !== 'GET' || !url.href.startsWith(registration.scope)) return
  event.respondWith(isHashed(url.href) ? stored(request).then((answer) => answer ?? fetch(request)) : fresh(request))
})

async function fresh(request) {
  try {
    return await fetch(request)
  } catch (error) {
    const answer = await stored(request)
    if (answer) return answer
    throw error
  }
}

/** A figure's state in the address does not make it another page, and a folder is its index. */
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
