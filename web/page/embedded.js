/**
 * What a figure's own page and the page around its frame say to each other. The figure tells its height; of all
 * messages that it receives it believes one, the theme, and from the page around it only.
 */

/** The types of the two messages; the page on hosting documents them. */
const HEIGHT = 'robot-motion:height'
const THEME = 'robot-motion:theme'

/** Tells the page around the frame how high the figure is, whenever that changes. */
export function tellHeight() {
  if (parent === window) return
  const page = document.documentElement
  let told = 0
  new ResizeObserver(() => {
    const height = Math.ceil(page.getBoundingClientRect().height)
    if (height === told) return
    told = height
    // Nothing in it is a secret, and the page around the frame may be anyone's.
    parent.postMessage({ type: HEIGHT, height }, '*')
  }).observe(page)
}

export function takeTheme() {
  addEventListener('message', ({ source, data }) => {
    if (source !== parent || parent === window || data?.type !== THEME) return
    if (data.theme === 'light' || data.theme === 'dark') document.documentElement.dataset.theme = data.theme
    else if (data.theme === 'auto') delete document.documentElement.dataset.theme
  })
}
