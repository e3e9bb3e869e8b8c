/** Search: the index is fetched and built when the reader first asks. */

import MiniSearch from 'minisearch'
import { part } from '../draw/dom.js'
import { PATIENCE_MS } from '../load/timeouts.js'

/**
 * @typedef {{ id: string, page: string, of?: string, title: string, section: string, text: string, code?: string }}
 * Entry
 */

/** Said where there is no index. */
const NO_INDEX =
  'The search needs a list of all the words of this book, and that could not be fetched: ' +
  'are you offline? The next letter you type asks for it again.'

/** @type {HTMLDialogElement | null} */
let dialog = null

export function openSearch() {
  dialog ??= build()
  dialog.showModal()
  dialog.querySelector('input')?.select()
}

function build() {
  const made = document.createElement('dialog')
  made.className = 'search'
  made.setAttribute('aria-label', 'Search')
  const head = part(document, made, 'form', 'search-head')
  head.setAttribute('method', 'dialog')
  const label = part(document, head, 'label', '')
  label.append('Search the book')
  const input = /** @type {HTMLInputElement} */ (part(document, label, 'input', ''))
  input.type = 'search'
  input.autocomplete = 'off'
  const close = part(document, head, 'button', 'button')
  close.textContent = 'Close'
  const count = part(document, made, 'p', 'visually-hidden')
  count.setAttribute('role', 'status')
  const list = part(document, made, 'ol', 'search-results')
  document.body.append(made)

  /** @type {Promise<MiniSearch<Entry> | null> | null} */
  let ready = null
  const show = async () => {
    ready ??= index().catch(() => null)
    const found = await ready
    // The next letter asks for it again: the network may be back.
    if (!found) ready = null
    list.replaceChildren()
    if (!found) return void (list.textContent = count.textContent = NO_INDEX)
    const words = input.value.trim()
    const hits = words
      ? found
          .search(words, { prefix: true, fuzzy: 0.15, boost: { title: 3, code: 0.2 }, combineWith: 'AND' })
          .slice(0, 12)
      : []
    for (const hit of hits) list.append(result(hit, words))
    count.textContent = words ? `${hits.length} places found` : ''
    if (words && !hits.length) list.textContent = 'Nothing found.'
  }
  input.addEventListener('input', show)
  // In a search field Escape would only empty it.
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') made.close()
  })
  head.addEventListener('submit', (event) => {
    const first = list.querySelector('a')
    if (document.activeElement !== input || !first) return
    event.preventDefault()
    first.click()
  })
  made.addEventListener('click', (event) => {
    if (event.target === made || (event.target instanceof Element && event.target.closest('a'))) made.close()
  })
  return made
}

async function index() {
  const answer = await fetch(rooted('search.json'), { signal: AbortSignal.timeout(PATIENCE_MS) })
  if (!answer.ok) throw new Error(`search.json: ${answer.status}`)
  const found = new MiniSearch({
    fields: ['title', 'text', 'code'],
    storeFields: ['page', 'of', 'title', 'section', 'text', 'code'],
  })
  found.addAll(await answer.json())
  return found
}

/** @param {string} path */
function rooted(path) {
  return new URL((document.documentElement.dataset.root ?? '') + path, location.href).href
}

/** @param {any} hit @param {string} words */
function result(hit, words) {
  const item = document.createElement('li')
  const link = /** @type {HTMLAnchorElement} */ (part(document, item, 'a', ''))
  link.href = `${rooted(hit.page)}#${String(hit.id).split('#')[1] ?? ''}`
  part(document, link, 'strong', '').textContent = [hit.section, hit.of && `${hit.of} ·`, hit.title]
    .filter(Boolean)
    .join(' ')
  // The index is newer than this page: the place it names is in the new edition, which a reload brings.
  link.addEventListener('click', (event) => {
    if (link.pathname !== location.pathname || document.getElementById(decodeURIComponent(link.hash.slice(1)))) return
    event.preventDefault()
    location.hash = link.hash
    location.reload()
  })
  const word = words.toLowerCase().split(/\s+/)[0]
  const inText = hit.text.toLowerCase().includes(word) || !hit.code?.toLowerCase().includes(word)
  excerpt(part(document, link, 'span', ''), inText ? hit.text : hit.code, word)
  return item
}

/** The words around a hit, which is marked. @param {Element} into @param {string} text @param {string} word */
function excerpt(into, text, word) {
  const hit = text.toLowerCase().indexOf(word)
  // An excerpt begins with a word.
  const from = hit <= 60 ? 0 : text.lastIndexOf(' ', hit - 60) + 1
  const to = from + 160
  if (hit < 0) return into.append(`${text.slice(0, to)}…`)
  into.append(`${from ? '…' : ''}${text.slice(from, hit)}`)
  part(document, into, 'mark', '').textContent = text.slice(hit, hit + word.length)
  into.append(`${text.slice(hit + word.length, to)}${to < text.length ? '…' : ''}`)
}
