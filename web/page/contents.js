/** The contents follow the reader; on a small screen they come out when called. */

export function follow() {
  const nav = /** @type {HTMLElement | null} */ (document.querySelector('.toc'))
  if (!nav) return
  /** @type {Map<Element, HTMLAnchorElement>} */
  const links = new Map()
  for (const link of nav.querySelectorAll('a')) {
    const heading = document.getElementById(decodeURIComponent(link.hash.slice(1)))
    if (heading) links.set(heading, link)
  }
  const headings = [...links.keys()]
  /** @type {HTMLAnchorElement | undefined} */
  let current
  const update = () => {
    let here = headings[0]
    for (const heading of headings) {
      if (heading.getBoundingClientRect().top > innerHeight * 0.3) break
      here = heading
    }
    const link = links.get(here)
    if (link === current) return
    current?.removeAttribute('aria-current')
    current = link
    link?.setAttribute('aria-current', 'location')
    if (link && getComputedStyle(nav).position === 'sticky') {
      const top = link.offsetTop - nav.clientHeight / 2
      nav.scrollTo({ top })
    }
  }
  let asked = false
  addEventListener('scroll', () => {
    if (asked) return
    asked = true
    requestAnimationFrame(() => {
      asked = false
      update()
    })
  }, { passive: true })
  update()
  drawer(nav)
}

/** @param {HTMLElement} nav */
function drawer(nav) {
  const button = document.querySelector('[data-open-contents]')
  if (!button) return
  const close = () => {
    nav.removeAttribute('data-open')
    button.setAttribute('aria-expanded', 'false')
  }
  button.addEventListener('click', () => {
    if (nav.hasAttribute('data-open')) return close()
    nav.setAttribute('data-open', '')
    button.setAttribute('aria-expanded', 'true')
    nav.querySelector('a')?.focus()
  })
  nav.addEventListener('click', (event) => {
    if (event.target instanceof Element && event.target.closest('a')) close()
  })
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !nav.hasAttribute('data-open')) return
    close()
    if (button instanceof HTMLElement) button.focus()
  })
  document.addEventListener('pointerdown', (event) => {
    const inside = event.target instanceof Node && (nav.contains(event.target) || button.contains(event.target))
    if (!inside) close()
  })
}
