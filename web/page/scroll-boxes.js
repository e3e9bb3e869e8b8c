/**
 * Makes each box that scrolls sideways reachable by the Tab key, so that it can be scrolled by keys. Boxes that fit
 * stay as they are. A formula that is a little too wide is set a little smaller: cut off at its full stop it would not
 * look as if there were more. What goes on beyond an edge fades out there.
 */

/** The least size to which a formula is shrunk. */
const LEAST = 0.9

export function scrollBoxes() {
  const boxes = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('.scroll-box')])
  const check = (/** @type {HTMLElement[]} */ some) => {
    for (const box of some) if (box.style.fontSize) box.style.fontSize = ''
    // All are measured before one is changed.
    const sizes = some.map(({ scrollLeft, scrollWidth, clientWidth }) => ({ scrollLeft, scrollWidth, clientWidth }))
    const room = sizes.map(({ scrollWidth, clientWidth }) =>
      scrollWidth > clientWidth + 1 ? clientWidth / scrollWidth : 1,
    )
    for (const [i, box] of some.entries()) {
      const name = box.matches('pre') ? 'Code' : box.querySelector('table') ? 'Table' : 'Formula'
      const shrinks = name === 'Formula' && room[i] < 1 && room[i] > LEAST
      if (shrinks) box.style.fontSize = `${Math.floor(100 * room[i]) - 1}%`
      const wide = room[i] < 1 && !shrinks
      fade(box, wide ? sizes[i] : null)
      if (wide === box.hasAttribute('tabindex')) continue
      if (wide)
        for (const [key, value] of [
          ['tabindex', '0'],
          ['role', 'group'],
          ['aria-label', `${name}, scrolls sideways`],
        ])
          box.setAttribute(key, value)
      else for (const key of ['tabindex', 'role', 'aria-label']) box.removeAttribute(key)
    }
  }
  const eye = new ResizeObserver((entries) => check(entries.map(({ target }) => /** @type {HTMLElement} */ (target))))
  // A face that comes late makes a formula wider and leaves its box as it was.
  document.fonts.addEventListener('loadingdone', () =>
    check(boxes.filter((box) => box.checkVisibility({ contentVisibilityAuto: true }))),
  )
  for (const box of boxes) {
    eye.observe(box)
    box.addEventListener('scroll', () => fade(box, box), { passive: true })
  }
}

/**
 * Marks the edges beyond which a box goes on.
 * @param {HTMLElement} box
 * @param {{ scrollLeft: number, scrollWidth: number, clientWidth: number } | null} sizes null for one that fits
 */
function fade(box, sizes) {
  box.toggleAttribute('data-before', sizes !== null && sizes.scrollLeft > 1)
  box.toggleAttribute('data-after', sizes !== null && sizes.scrollLeft < sizes.scrollWidth - sizes.clientWidth - 1)
}
