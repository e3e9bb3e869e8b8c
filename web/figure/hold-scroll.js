/** Keeps in place what the reader reads, or has just pressed, while a figure changes its height. */

/**
 * Keeps the upper edge of what is about to grow where it is, if any of it is on the screen. A browser would keep what
 * stands below it and scroll the figure away from under the reader's eyes.
 * @param {Element} host
 */
export function keepTop(host) {
  const { top, bottom, height } = host.getBoundingClientRect()
  if (bottom < 0) return keepHeight(host, height)
  if (top > innerHeight) return
  const root = document.documentElement
  root.style.setProperty('overflow-anchor', 'none')
  // The figure has its new height after the next layout, and a browser scrolls to its anchor after that one.
  requestAnimationFrame(() => requestAnimationFrame(() => root.style.removeProperty('overflow-anchor')))
}

/**
 * Until its words are in it, a figure is lower than it was. Chromium 148 scrolls back by that much when the figure
 * stands above the screen, and does not scroll forth again when the words have come.
 * @param {Element} host @param {number} height
 */
function keepHeight(host, height) {
  const { style } = /** @type {HTMLElement} */ (host)
  style.setProperty('min-height', `${height}px`)
  requestAnimationFrame(() => requestAnimationFrame(() => style.removeProperty('min-height')))
}

/** For so many frames after the figure has answered its parts may still find their sizes. */
const FRAMES = 12
/** So long a figure may need to answer, milliseconds. */
const PATIENCE_MS = 3000

/**
 * Keeps what the reader presses in a figure under the finger: above it matrices grow and sentences get longer. It stays
 * while the finger is down, or the press would end on something else, and until the figure has answered.
 * @param {Element} into @param {() => boolean} busy whether the figure has still to answer
 */
export function keepPressed(into, busy) {
  let presses = 0
  const { documentElement: page } = into.ownerDocument
  /** @param {Element} pressed @param {() => boolean} down whether the finger is still on it */
  const hold = (pressed, down) => {
    const mine = ++presses
    const { top } = pressed.getBoundingClientRect()
    let began = performance.now()
    let y = scrolledBy(pressed)
    let left = FRAMES
    // A browser that anchors on what stands below a figure would scroll by all that opens above it.
    page.style.setProperty('overflow-anchor', 'none')
    const keep = () => {
      if (down()) began = performance.now()
      const now = pressed.getBoundingClientRect()
      // Who scrolls meanwhile, the page or a part of it, wants to be elsewhere, and a figure out of sight does not
      // answer.
      if (
        mine !== presses ||
        left === 0 ||
        now.height === 0 ||
        scrolledBy(pressed) !== y ||
        performance.now() - began > PATIENCE_MS
      ) {
        if (mine === presses) page.style.removeProperty('overflow-anchor')
        return
      }
      if (Math.abs(now.top - top) >= 1) scrollBy({ top: now.top - top, behavior: 'instant' })
      y = scrolledBy(pressed)
      if (!down() && !busy()) left--
      requestAnimationFrame(keep)
    }
    requestAnimationFrame(keep)
  }
  // A press by a key has no finger.
  into.addEventListener(
    'click',
    ({ target }) => {
      const pressed = target instanceof Element ? target.closest(PRESSED) : null
      if (pressed) hold(pressed, () => false)
    },
    true,
  )
  into.addEventListener('pointerdown', ({ target }) => {
    const pressed = target instanceof Element ? target.closest(`${PRESSED}, input[type="range"]`) : null
    if (!pressed) return
    let down = true
    const lift = new AbortController()
    for (const end of ['pointerup', 'pointercancel'])
      addEventListener(end, () => lift.abort(), { signal: lift.signal, capture: true })
    lift.signal.addEventListener('abort', () => (down = false))
    hold(pressed, () => down)
  })
}

/**
 * Keeps a slider where it is that has the focus, while words above it get longer: the next key moves it on.
 * @param {Element} host
 * @returns {() => void} to be called once all is drawn
 */
export function keepFocused(host) {
  const { activeElement: hand } = host.ownerDocument
  if (!hand?.matches('input[type="range"]') || !host.contains(hand)) return () => {}
  const { top, bottom } = hand.getBoundingClientRect()
  if (bottom < 0 || top > innerHeight) return () => {}
  return () => {
    const by = hand.getBoundingClientRect().top - top
    if (Math.abs(by) >= 1) scrollerOf(hand).scrollBy({ top: by, behavior: 'instant' })
  }
}

/** What scrolls an element: a part of the page, or the page. @param {Element} element */
function scrollerOf(element) {
  for (let around = element.parentElement; around; around = around.parentElement)
    if (around.scrollHeight > around.clientHeight && /auto|scroll/.test(getComputedStyle(around).overflowY))
      return around
  return element.ownerDocument.documentElement
}

/** What a press holds in place. */
const PRESSED = 'button, label, summary'

/**
 * By how much an element has been moved up by all that scrolls around it, the page among it, pixels.
 * @param {Element} element
 */
function scrolledBy(element) {
  let sum = 0
  for (let around = element.parentElement; around; around = around.parentElement) sum += around.scrollTop
  return sum
}
