/** Acts on elements as they come near the screen, those included that the parser has not reached yet. */

const NEAR = '900px 0px'

/**
 * @param {string} selector
 * @param {(element: Element) => void} act called once for each element
 */
export function whenNear(selector, act) {
  /** @type {Set<Element>} */
  const waiting = new Set()
  const come = (/** @type {Element} */ element) => {
    if (!waiting.delete(element)) return
    eye.unobserve(element)
    act(element)
  }
  const eye = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) if (isIntersecting) come(target)
    },
    { rootMargin: NEAR },
  )
  asParsed(selector, (element) => {
    waiting.add(element)
    eye.observe(element)
  })
  // The next press of Tab may lead further than that: into this part of the text, or one of its neighbours.
  const reach = (/** @type {EventTarget | null} */ target) => {
    const here = target instanceof Element ? target.closest('main section') : null
    for (const part of [here, here?.previousElementSibling, here?.nextElementSibling]) {
      for (const element of waiting) if (part?.contains(element)) come(element)
    }
  }
  document.addEventListener('focusin', ({ target }) => reach(target))
  // The focus may have been there before this script.
  reach(document.activeElement)
}

/** Calls `act` once, when `element` comes near the screen. @param {Element} element @param {() => void} act */
export function onceNear(element, act) {
  const eye = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return
      eye.disconnect()
      act()
    },
    { rootMargin: NEAR },
  )
  eye.observe(element)
}

/**
 * While the page is still being read, its elements are looked for once per frame. The last one found then may be
 * incomplete: an element is complete when something follows it.
 * @param {string} selector
 * @param {(element: Element) => void} act
 */
function asParsed(selector, act) {
  let seen = 0
  const look = () => {
    const whole = document.readyState !== 'loading'
    const found = document.querySelectorAll(selector)
    for (; seen < found.length && (whole || found[seen].nextElementSibling); seen++) act(found[seen])
    if (!whole) requestAnimationFrame(look)
  }
  look()
  // No frame comes while the tab is hidden.
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', look, { once: true })
}

/** Calls `act` once the whole page has been read: at once if it has. @param {() => void} act */
export function whenRead(act) {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', act, { once: true })
  else act()
}
