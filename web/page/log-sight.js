/** Brings what an answer is about into sight, unless its reader has moved meanwhile: no page moves under a finger. */

const ACTS = /** @type {const} */ (['pointerdown', 'keydown', 'wheel', 'touchstart'])

/**
 * Watches from now on whether the reader does anything. What it returns ends that, and scrolls to an element.
 * @returns {(element: Element) => void}
 */
export function sight() {
  const { scrollY: stood } = window
  let acted = false
  const act = () => {
    acted = true
  }
  for (const kind of ACTS) addEventListener(kind, act, { capture: true, passive: true, once: true })
  return (element) => {
    for (const kind of ACTS) removeEventListener(kind, act, { capture: true })
    if (acted || Math.abs(scrollY - stood) > 1) return
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches
    element.scrollIntoView({ block: 'start', behavior: still ? 'instant' : 'smooth' })
  }
}
