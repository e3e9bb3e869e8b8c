/**
 * The reader's place, by element. Parts of the text far from the screen have an estimated height until they are laid
 * out, so a number of pixels from the top does not name a place for long; a paragraph does. For each entry of the
 * browser's history the session's store holds which block is at the top of the screen, how far from the edge, and which
 * blocks are unfolded.
 */

const KEY = 'places'
/** Entries of the history whose places are kept. */
const MOST = 50
/** Pixels below the upper edge of the window: what ends above this line has been read. */
const LINE = 24
/**
 * For so many frames after the page has loaded the browser itself may still scroll, to the place that the address
 * names.
 */
const BROWSER_FRAMES = 3
/**
 * The place is asserted for this many frames after the page has loaded: fonts and parts nearby still find their sizes.
 */
const FRAMES = 15
const PATIENCE_MS = 10_000
/** What holds blocks; everything else is a block. */
const HOLDERS =
  'main, article, section, div:not(.scroll-box), ol, ul, li, dl, details, figure, blockquote, table, tbody'

/**
 * @typedef {{ block: string | null, top: number, open: string[] }} Place `block` is null at the very top of the page
 */

/**
 * Begins to note the place, and goes back to a noted one.
 * @returns {Promise<void>} done when the place is on the screen
 */
export function keepPlace() {
  try {
    sessionStorage.setItem(`${KEY}:test`, '')
    sessionStorage.removeItem(`${KEY}:test`)
  } catch {
    // Without a store the browser does what it can.
    return Promise.resolve()
  }
  history.scrollRestoration = 'manual'
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let soon
  addEventListener(
    'scroll',
    () => {
      clearTimeout(soon)
      soon = setTimeout(note, 250)
    },
    { passive: true },
  )
  // A link within the page begins a new entry; what is left is noted before.
  addEventListener('click', note, true)
  addEventListener('pagehide', note)
  // Pressing a link again leads to its place once more, within the same entry: only another entry has a place to go
  // back to.
  let present = entry()
  addEventListener('popstate', () => {
    const was = present
    present = entry()
    const place = present === was ? undefined : noted()
    if (place) hold(place)
  })
  addEventListener('hashchange', () => {
    present = entry()
  })
  const place = noted()
  return place ? hold(place) : Promise.resolve()
}

/** The name of the present entry of the history; it gets one when it has none. */
function entry() {
  const state = history.state
  if (typeof state?.entry === 'string') return state.entry
  const name = `e${Date.now().toString(36)}${Math.random().toString(36).slice(2)}`
  history.replaceState({ ...state, entry: name }, '')
  return name
}

/** @returns {Record<string, Place>} */
function places() {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? '{}')
  } catch {
    return {}
  }
}

/** @returns {Place | undefined} */
function noted() {
  return places()[entry()]
}

function note() {
  // While a place is being restored the page is not where the reader wants it.
  if (holding) return
  const block = scrollY > 0 ? blockAt(LINE) : null
  if (scrollY > 0 && !block) return
  const open = [...document.querySelectorAll('main details[open]')].map(pathTo)
  const all = places()
  const now = entry()
  delete all[now]
  all[now] = { block: block && pathTo(block), top: block?.getBoundingClientRect().top ?? 0, open }
  for (const old of Object.keys(all).slice(0, -MOST)) delete all[old]
  try {
    sessionStorage.setItem(KEY, JSON.stringify(all))
  } catch {
    // A full store keeps what it has.
  }
}

/** The innermost block that ends below `line`. @param {number} line @returns {Element | null} */
function blockAt(line) {
  let found = document.querySelector('main')
  while (found?.matches(HOLDERS)) {
    const next = [...found.children].find((child) => child.getBoundingClientRect().bottom > line)
    if (!next) break
    found = /** @type {HTMLElement} */ (next)
  }
  return found
}

/**
 * Where an element stands: the nearest element with a name that holds it, and the way down from there by numbers of
 * children.
 * @param {Element} element
 */
function pathTo(element) {
  const way = []
  for (let at = /** @type {Element | null} */ (element); at; at = at.parentElement) {
    const part = at.getAttribute('data-part')
    if (at.id || part)
      return [at.id ? `#${CSS.escape(at.id)}` : `[data-part="${CSS.escape(part ?? '')}"]`, ...way].join('>')
    way.unshift([...(at.parentElement?.children ?? [])].indexOf(at))
  }
  return ''
}

/** @param {string} path @returns {Element | null} as near as the page comes to it */
function follow(path) {
  const [name, ...way] = path.split('>')
  let at = name ? document.querySelector(name) : null
  for (const number of way) at = at?.children[Number(number)] ?? at
  return at
}

let holding = 0

/**
 * Puts a place on the screen as soon as the page has been read that far, and keeps it there until the page has settled
 * or the reader does something.
 * @param {Place} place
 * @returns {Promise<void>}
 */
function hold({ block, top, open }) {
  const mine = ++holding
  const began = performance.now()
  let left = FRAMES
  let last = NaN
  const leave = () => {
    left = 0
  }
  // Meanwhile the browser must not keep another place: that of what stands below a figure that comes alive and grows.
  document.documentElement.classList.add('place-held')
  const end = () => document.documentElement.classList.remove('place-held')
  for (const input of ['wheel', 'touchstart', 'pointerdown', 'keydown'])
    addEventListener(input, leave, { once: true, passive: true })
  return new Promise((placed) => {
    const assert = () => {
      if (mine !== holding) return placed()
      const there = document.readyState === 'loading' ? isRead(block) : true
      if (there) {
        for (const path of open) follow(path)?.setAttribute('open', '')
        const element = block === null ? null : follow(block)
        const off = element ? element.getBoundingClientRect().top - top : -scrollY
        // The place is off by as much as the page has been scrolled: a script, or a reader's tool, wants to be
        // elsewhere.
        if (Math.abs(off) > 0.5 && left < FRAMES - BROWSER_FRAMES && Math.abs(off + scrollY - last) < 2) left = 0
        else if (Math.abs(off) > 0.5) scrollBy({ top: off, behavior: 'instant' })
        last = scrollY
        placed()
        const coming = element?.closest('.figure-widget')?.querySelector('.widget[data-state=loading]')
        if (document.readyState === 'complete' && !coming && left > 0) left--
      }
      if (left > 0 && performance.now() - began < PATIENCE_MS) return void requestAnimationFrame(assert)
      holding = 0
      end()
      placed()
    }
    requestAnimationFrame(assert)
  })
}

/** Whether the parser has passed the block, and a screen of text after it. @param {string | null} block */
function isRead(block) {
  if (block === null) return true
  const part = document.querySelector(block.split('>')[0])?.closest('section')
  return Boolean(part?.nextElementSibling)
}
