/**
 * Words and numbers explain themselves: a popover shows the gloss of a term or the source of a number, and a coloured
 * word highlights the marks of its colour in the nearest figure.
 */

import { PATIENCE_MS } from '../load/timeouts.js'

const KINDS = ['prediction', 'posterior', 'measurement', 'truth']
/** A coloured symbol of a formula explains itself as a word does. */
const SYMBOLS = KINDS.map((kind) => `.term-${kind}`).join()
const CALLERS = `.term, .number, .formula-numbers, [data-number], ${SYMBOLS}`

export function terms() {
  const box = document.createElement('div')
  box.className = 'popover'
  box.id = 'popover'
  box.hidden = true
  // Inside a landmark, like everything on the page: a screen reader that moves by landmarks would miss it elsewhere.
  document.querySelector('main')?.append(box)
  /** @type {Element | null} */
  let owner = null
  let pinned = false
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer

  const hide = () => {
    clearTimeout(timer)
    owner?.removeAttribute('aria-describedby')
    owner = null
    pinned = false
    box.hidden = true
  }
  const show = async (/** @type {Element} */ caller) => {
    clearTimeout(timer)
    if (owner === caller) return
    hide()
    owner = caller
    const entries = await entriesOf(caller)
    // The reader may have moved on meanwhile.
    if (owner !== caller) return
    if (entries.length === 0) return hide()
    const list = document.createElement('dl')
    list.append(...entries)
    box.replaceChildren(list)
    if (caller.matches('a')) caller.setAttribute('aria-describedby', 'popover')
    box.hidden = false
    place(box, caller)
  }
  const later = (/** @type {() => void} */ act, /** @type {number} */ wait) => {
    clearTimeout(timer)
    timer = setTimeout(act, wait)
  }
  const callerOf = (/** @type {EventTarget | null} */ target) =>
    target instanceof Element ? target.closest(CALLERS) : null

  document.addEventListener('pointerover', (event) => {
    if (event.pointerType !== 'mouse') return
    light(event.target)
    const caller = callerOf(event.target)
    if (caller) later(() => show(caller), 160)
    else if (box.contains(/** @type {Node} */ (event.target))) clearTimeout(timer)
    // What has the focus keeps its explanation: a page that scrolls to it moves under a mouse that lies still.
    else if (owner && !pinned && owner !== document.activeElement) later(hide, 220)
    else clearTimeout(timer)
  })
  document.addEventListener('focusin', (event) => {
    light(event.target)
    const caller = callerOf(event.target)
    if (caller) show(caller)
    else if (!box.contains(/** @type {Node} */ (event.target))) hide()
  })
  document.addEventListener('click', (event) => {
    const caller = callerOf(event.target)
    if (!caller) {
      if (!box.contains(/** @type {Node} */ (event.target))) hide()
      return
    }
    light(event.target)
    // A symbol within a link leads where the link leads.
    if (caller.matches(SYMBOLS) && !caller.matches('a') && caller.closest('a, button, label, summary')) return
    // A click or a tap opens the popover; Enter (detail 0) follows the link to the entry.
    if (event.detail === 0 || event.ctrlKey || event.metaKey || event.shiftKey) return
    event.preventDefault()
    if (owner === caller && pinned) return hide()
    show(caller)
    pinned = true
  })
  document.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') hide()
  })
}

/** What explains a word or a number, as copies without ids. @param {Element} caller @returns {Promise<Element[]>} */
async function entriesOf(caller) {
  const { term, number, numbers } = /** @type {HTMLElement} */ (caller).dataset
  const kind = KINDS.find((one) => caller.classList.contains(`term-${one}`))
  if (term ?? (!number && !numbers && kind)) return copies(document, [`gloss-${term ?? kind}`])
  // A number in the text names its entry in its address alone.
  const linked = /** @type {Partial<HTMLAnchorElement>} */ (caller).hash?.replace('#number-', '') ?? ''
  const ids = (numbers ?? number ?? linked)
    .split(' ')
    .slice(0, MOST)
    .map((id) => `number-${id}`)
  listed ??= listOfNumbers().catch(() => {
    listed = null
    return LOST
  })
  const found = await listed
  return found === LOST ? [lost()] : copies(found, ids)
}

/**
 * The page that lists the numbers of this one, fetched when a reader first asks for one.
 * @type {Promise<Document> | null}
 */
let listed = null
const LOST = document.implementation.createHTMLDocument('')
/** A popover explains at most so many numbers of a formula. */
const MOST = 4

async function listOfNumbers() {
  const address = new URL('numbers/', location.href)
  const answer = await fetch(address, { signal: AbortSignal.timeout(PATIENCE_MS) })
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`)
  const page = new DOMParser().parseFromString(await answer.text(), 'text/html')
  for (const link of page.querySelectorAll('a')) link.href = new URL(link.getAttribute('href') ?? '', address).href
  return page
}

/** @param {Document} from @param {string[]} ids */
function copies(from, ids) {
  return ids
    .map((id) => from.getElementById(id))
    .filter((entry) => entry !== null)
    .map((entry) => {
      const copy = document.importNode(entry, true)
      for (const part of [copy, ...copy.querySelectorAll('[id]')]) part.removeAttribute('id')
      return copy
    })
}

function lost() {
  const words = document.createElement('dd')
  words.textContent = 'What computes this number is in a list that could not be fetched: are you offline?'
  return words
}

/** @param {HTMLElement} box @param {Element} caller */
function place(box, caller) {
  const at = caller.getClientRects()[0] ?? caller.getBoundingClientRect()
  const { width, height } = box.getBoundingClientRect()
  const left = Math.max(12, Math.min(at.left, document.documentElement.clientWidth - width - 12))
  const above = at.bottom + height + 12 > innerHeight && at.top > height + 12
  box.style.left = `${left + scrollX}px`
  box.style.top = `${(above ? at.top - height - 8 : at.bottom + 8) + scrollY}px`
}

/** @type {HTMLElement | null} */
let lit = null

/** @param {EventTarget | null} target */
function light(target) {
  const kin = target instanceof Element ? kinOf(target) : null
  const widget = kin && target instanceof Element ? nearest(target) : null
  if (lit && lit !== widget) delete lit.dataset.lit
  lit = widget
  if (widget && kin) widget.dataset.lit = kin
}

/** @param {Element} element */
function kinOf(element) {
  if (element.closest('.widget')) return null
  const holder = element.closest('[data-kin], .term-prediction, .term-posterior, .term-measurement, .term-truth')
  if (!holder) return null
  return (
    /** @type {HTMLElement} */ (holder).dataset.kin ??
    KINDS.find((kind) => holder.classList.contains(`term-${kind}`)) ??
    null
  )
}

/**
 * The figure nearest to an element. Nothing lies nearer than the part of the text that holds it, and the boxes of the
 * parts are known without laying them out: so only figures in near parts are measured.
 * @param {Element} element
 * @returns {HTMLElement | null}
 */
function nearest(element) {
  const y = element.getBoundingClientRect().top
  const away = (/** @type {Element} */ of) => {
    const { top, bottom } = of.getBoundingClientRect()
    return Math.max(top - y, y - bottom, 0)
  }
  const widgets = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('.widget')])
  const found = widgets
    .map((widget) => ({ widget, atLeast: away(widget.closest('section') ?? widget) }))
    .sort((a, b) => a.atLeast - b.atLeast)
  let [best, least] = [/** @type {HTMLElement | null} */ (null), Infinity]
  for (const { widget, atLeast } of found) {
    if (atLeast >= least) break
    const distance = away(widget)
    if (distance < least) [best, least] = [widget, distance]
  }
  return best
}
