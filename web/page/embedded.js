/**
 * What a figure's own page and the page around its frame say to each other. The figure tells its height; of all
 * messages that it receives it believes one, the theme, and from the page around it only.
 */

/** The types of the two messages; the page on hosting documents them. */
const HEIGHT = 'robot-motion:height'
const THEME = 'robot-motion:theme'

/** How often one height is told, until the reader does something. */
const MOST_TOLD = 8

/**
 * Decides which heights are told. Where the page around the frame changes the frame's width for each height, and the
 * figure its height for each width, the two would go on for ever: from some time on only greater heights are told.
 */
export class Heights {
  constructor() {
    this.last = 0
    /** @type {Map<number, number>} */
    this.told = new Map()
  }

  /** Whether this height is to be told now. @param {number} height */
  tells(height) {
    const times = this.told.get(height) ?? 0
    if (height === this.last || (times >= MOST_TOLD && height < this.last)) return false
    this.last = height
    this.told.set(height, times + 1)
    return true
  }

  /** The reader has done something: what changes now may be new. */
  touched() {
    this.told.clear()
  }
}

/** Tells the page around the frame how high the figure is, whenever that changes. */
export function tellHeight() {
  if (parent === window) return
  const page = document.documentElement
  const heights = new Heights()
  for (const kind of ['pointerdown', 'keydown'])
    addEventListener(kind, () => heights.touched(), { capture: true, passive: true })
  new ResizeObserver(() => {
    const height = Math.ceil(page.getBoundingClientRect().height)
    // Nothing in it is a secret, and the page around the frame may be anyone's.
    if (heights.tells(height)) parent.postMessage({ type: HEIGHT, height }, '*')
  }).observe(page)
}

export function takeTheme() {
  addEventListener('message', ({ source, data }) => {
    if (source !== parent || parent === window || data?.type !== THEME) return
    if (data.theme === 'light' || data.theme === 'dark') document.documentElement.dataset.theme = data.theme
    else if (data.theme === 'auto') delete document.documentElement.dataset.theme
  })
}
