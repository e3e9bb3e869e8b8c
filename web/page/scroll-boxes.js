/** Makes each box that scrolls sideways reachable by the Tab key, so that it can be scrolled by keys. Boxes that fit stay as they are. */

export function scrollBoxes() {
  const boxes = [...document.querySelectorAll('.scroll-box')]
  const check = (/** @type {Element[]} */ some) => {
    const wide = some.map((box) => box.scrollWidth > box.clientWidth + 1)
    some.forEach((box, i) => {
      if (wide[i] === box.hasAttribute('tabindex')) return
      if (wide[i]) {
        const name = box.matches('pre') ? 'Code' : box.querySelector('table') ? 'Table' : 'Formula'
        for (const [key, value] of [['tabindex', '0'], ['role', 'group'], ['aria-label', `${name}, scrolls sideways`]]) box.setAttribute(key, value)
      } else for (const key of ['tabindex', 'role', 'aria-label']) box.removeAttribute(key)
    })
  }
  const eye = new ResizeObserver((entries) => check(entries.map(({ target }) => target)))
  for (const box of boxes) eye.observe(box)
}
