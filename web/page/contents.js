/** The table of contents marks the section that is being read; on a small screen a button opens it over the text. */

export function follow() {
  const nav = /** @type {HTMLElement | null} */ (document.querySelector('.toc'))
  if (!nav) return
  /**
   * The parts of the text with their headings and the links to these.
   * @type {{ part: Element, headings: [Element, HTMLAnchorElement][] }[]}
   */
  const parts = []
  let known = 0
  /** The script of a page may add an entry of its own, such as that of a report. */
  const collect = () => {
    const links = nav.querySelectorAll('a')
    if (links.length === known) return
    known = links.length
    parts.length = 0
    for (const link of links) {
      const heading = document.getElementById(decodeURIComponent(link.hash.slice(1)))
      const part = heading?.closest('main section')
      if (!heading || !part) continue
      if (parts.at(-1)?.part !== part) parts.push({ part, headings: [] })
      parts.at(-1)?.headings.push([heading, link])
    }
  }
  const above = (/** @type {Element} */ element) => element.getBoundingClientRect().top <= innerHeight * 0.3
  let tell = (/** @type {HTMLAnchorElement | undefined} */ _) => {}
  /** @type {HTMLAnchorElement | undefined} */
  let current
  const update = () => {
    collect()
    // The box of a part is known before its content is laid out, and the last one that has begun is on the screen:
    // measuring only its headings makes the browser lay out nothing that it had put off.
    const begun = parts.filter(({ part }) => above(part))
    const passed = begun
      .pop()
      ?.headings.filter(([heading]) => above(heading))
      .pop()
    const link = (passed ?? begun.pop()?.headings.at(-1) ?? parts[0]?.headings[0])?.[1]
    if (link === current) return
    current?.removeAttribute('aria-current')
    current = link
    link?.setAttribute('aria-current', 'location')
    tell(link)
    if (link && getComputedStyle(nav).position === 'sticky') {
      const top = link.offsetTop - nav.clientHeight / 2
      nav.scrollTo({ top })
    }
  }
  let asked = false
  addEventListener(
    'scroll',
    () => {
      if (asked) return
      asked = true
      requestAnimationFrame(() => {
        asked = false
        update()
      })
    },
    { passive: true },
  )
  update()
  drawer(nav)
  // Nobody needs the bar who has not scrolled; a reader may have scrolled before this script came.
  const bring = () =>
    import('./bar.js').then(
      ({ bar }) => {
        tell = bar()
        tell(current)
      },
      () => {},
    )
  if (scrollY > 0) bring()
  else addEventListener('scroll', bring, { once: true, passive: true })
}

/** @param {HTMLElement} nav */
function drawer(nav) {
  const OPENS = '[data-open-contents]'
  /** The button that opened it. @type {HTMLElement | undefined} */
  let opener
  const expanded = (/** @type {boolean} */ on) => {
    nav.toggleAttribute('data-open', on)
    for (const button of document.querySelectorAll(OPENS)) button.setAttribute('aria-expanded', String(on))
  }
  const close = () => expanded(false)
  document.addEventListener('click', ({ target }) => {
    const button = target instanceof Element ? target.closest(OPENS) : null
    if (!(button instanceof HTMLElement)) return
    if (nav.hasAttribute('data-open')) return close()
    opener = button
    expanded(true)
    const here = nav.querySelector('[aria-current]') ?? nav.querySelector('a')
    if (here instanceof HTMLElement) here.focus()
  })
  nav.addEventListener('click', (event) => {
    if (event.target instanceof Element && event.target.closest('a')) close()
  })
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !nav.hasAttribute('data-open')) return
    close()
    opener?.focus({ preventScroll: true })
  })
  // Whoever leaves the contents by the Tab key is in the text again, and they must not cover it.
  nav.addEventListener('focusout', ({ relatedTarget }) => {
    if (
      nav.hasAttribute('data-open') &&
      relatedTarget instanceof Element &&
      !nav.contains(relatedTarget) &&
      !relatedTarget.closest(OPENS)
    )
      close()
  })
  document.addEventListener('pointerdown', (event) => {
    const inside = event.target instanceof Element && (nav.contains(event.target) || event.target.closest(OPENS))
    if (!inside) close()
  })
}
