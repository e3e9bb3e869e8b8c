/** Brings what an answer is about into sight, unless its reader has moved meanwhile: no page moves under a finger. */

const ACTS = /** @type {const} */ (['pointerdown', 'keydown', 'wheel', 'touchstart'])

/**
 * Watches from now on whether the reader does anything. What it returns ends that, and scrolls to an element.
 * @returns {(element: Element) => void}
 */
export function sight() {
  const { scrollY: stood } = window
  const middle = document.elementFromPoint(innerWidth / 2, innerHeight / 2)
  const top = () => middle?.getBoundingClientRect().top ?? 0
  const lay = top()
  // What grows above the window moves its distance from the page's top, and nothing that is seen in it.
  const moved = () => Math.abs(scrollY - stood) > 1 && Math.abs(top() - lay) > 1
  let acted = false
  const act = () => {
    acted = true
  }
  for (const kind of ACTS) addEventListener(kind, act, { capture: true, passive: true, once: true })
  return (element) => {
    for (const kind of ACTS) removeEventListener(kind, act, { capture: true })
    if (acted || moved()) return
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches
    element.scrollIntoView({ block: 'start', behavior: still ? 'instant' : 'smooth' })
  }
}
