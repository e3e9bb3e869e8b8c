/**
 * Moves a handle by pointer and keys, as Red Blob Games describes it: the pointer is captured, the handle keeps its
 * distance from the pointer, and only a finger on the handle does not scroll the page.
 */

/**
 * @typedef {object} Dragged
 * @property {() => [number, number]} at where the handle is, in pixels of `frame`
 * @property {(x: number, y: number) => void} move
 * @property {(dx: number, dy: number) => void} nudge
 * @property {(end: 'home' | 'end') => void} [jump]
 * @property {() => void} [drop] the pointer has let go
 */

const ARROWS = /** @type {Record<string, [number, number]>} */ ({
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  PageUp: [0, 10],
  PageDown: [0, -10],
})

/**
 * @param {Element} handle
 * @param {Element} frame places are pixels from its upper left corner
 * @param {Dragged} dragged
 */
export function drag(handle, frame, dragged) {
  /** @type {{ id: number, dx: number, dy: number } | null} */
  let held = null
  const inFrame = (/** @type {PointerEvent} */ event) => {
    const { left, top } = frame.getBoundingClientRect()
    return [event.clientX - left, event.clientY - top]
  }
  const listen = (/** @type {string} */ kind, /** @type {(event: any) => void} */ act) =>
    handle.addEventListener(kind, act)

  listen('pointerdown', (/** @type {PointerEvent} */ event) => {
    if (event.button !== 0) return
    const [x, y] = inFrame(event)
    const [hx, hy] = dragged.at()
    held = { id: event.pointerId, dx: hx - x, dy: hy - y }
    handle.setPointerCapture(event.pointerId)
    handle.classList.add('dragging')
    const focusable = /** @type {HTMLElement | SVGElement} */ (handle)
    focusable.focus({ preventScroll: true })
    event.preventDefault()
  })
  listen('pointermove', (/** @type {PointerEvent} */ event) => {
    if (!held || held.id !== event.pointerId) return
    const [x, y] = inFrame(event)
    dragged.move(x + held.dx, y + held.dy)
  })
  const release = () => {
    if (!held) return
    held = null
    handle.classList.remove('dragging')
    dragged.drop?.()
  }
  listen('pointerup', release)
  listen('pointercancel', release)
  listen('lostpointercapture', release)

  // Some browsers start to scroll before they look at touch-action.
  handle.addEventListener('touchstart', (event) => event.preventDefault(), { passive: false })
  listen('keydown', (/** @type {KeyboardEvent} */ event) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return
    if (event.key === 'Home' || event.key === 'End') {
      if (!dragged.jump) return
      dragged.jump(event.key === 'Home' ? 'home' : 'end')
    } else {
      const arrow = ARROWS[event.key]
      if (!arrow) return
      const many = event.shiftKey && Math.abs(arrow[0] + arrow[1]) === 1 ? 10 : 1
      dragged.nudge(arrow[0] * many, arrow[1] * many)
    }
    event.preventDefault()
  })
}
