/** Draws handles. In a browser they answer to pointer and keys. */

import { drag } from './drag.js'

/** @typedef {import('./spec.js').HandleSpec} HandleSpec */
/** @typedef {import('../draw/pen.js').Pen} Pen */

/**
 * Draws a ring with a dot, in a circle of 44 pixels that takes the finger. Draw the handles of a panel last, in a group
 * of their own, so that they keep the focus.
 * @param {Pen} pen
 * @param {string} key
 * @param {HandleSpec} handle
 */
export function drawHandle(pen, key, handle) {
  const [x, y] = handle.at
  return pen.group(
    key,
    {
      class: `handle ${handle.kin ?? ''}`.trim(),
      'data-kin': handle.kin,
      transform: `translate(${Math.round(x * 10) / 10} ${Math.round(y * 10) / 10})`,
    },
    (to) => {
      to.mark('circle', 'reach', { class: 'handle-reach', r: 22 })
      to.mark('circle', 'ring', { class: 'handle-ring', r: handle.small ? 6.5 : 10 })
      to.mark('circle', 'dot', { class: 'handle-dot', r: handle.small ? 2.5 : 3.5 })
      const [nx, ny] = handle.nameAt ?? [15, 4]
      if (handle.name)
        to.text('name', { class: 'handle-name', x: nx, y: ny, 'text-anchor': nx < 0 ? 'end' : 'start' }, handle.name)
    },
  )
}

/**
 * Draws handles that answer. An element gets its listeners once; they read its newest specification.
 * @param {(patch: Record<string, unknown>) => void} change
 * @param {() => void} settle draws what was changed before, so that a key starts from there and not from the last frame
 * @param {() => void} drop the reader has let a handle go
 */
export function liveHandles(change, settle, drop) {
  /** @type {WeakMap<Element, HandleSpec>} */
  const newest = new WeakMap()
  return (/** @type {Pen} */ pen, /** @type {string} */ key, /** @type {HandleSpec} */ handle) => {
    const element = drawHandle(pen, key, handle)
    const known = newest.has(element)
    newest.set(element, handle)
    const spec = () => /** @type {HandleSpec} */ (newest.get(element))
    const { now = 0, min = 0, max = 100 } = handle
    const aria = {
      role: 'slider',
      tabindex: '0',
      'aria-label': handle.label,
      'aria-valuetext': handle.value,
      'aria-valuenow': now,
      'aria-valuemin': min,
      'aria-valuemax': max,
    }
    for (const [name, value] of Object.entries(aria)) {
      if (element.getAttribute(name) !== String(value)) element.setAttribute(name, String(value))
    }
    if (known) return
    const frame = /** @type {SVGElement} */ (element).ownerSVGElement ?? element
    if (handle.pressed)
      frame.addEventListener('click', (event) => {
        const { target, clientX, clientY } = /** @type {MouseEvent} */ (event)
        if (/** @type {Element} */ (target).closest('.handle')) return
        const { left, top } = frame.getBoundingClientRect()
        change(spec().move(clientX - left, clientY - top))
      })
    frame.addEventListener('pointerdown', toNearest, true)
    drag(element, frame, {
      at: () => spec().at,
      move: (x, y) => change(spec().move(x, y)),
      drop,
      nudge: (dx, dy) => {
        settle()
        change(spec().nudge(dx, dy))
      },
      jump: (end) => {
        settle()
        const patch = spec().jump?.(end)
        if (patch) change(patch)
      },
    })
  }
}

/**
 * Where the reaches of handles overlap, the one whose ring is nearest to the pointer has it, whichever is drawn last.
 * @param {Event} event
 */
function toNearest(event) {
  const { target, clientX, clientY, isTrusted } = /** @type {PointerEvent} */ (event)
  const reach = /** @type {Element} */ (target)
  if (!isTrusted || !reach.matches('.handle circle')) return
  const off = (/** @type {Element} */ circle) => {
    const { left, top, width, height } = circle.getBoundingClientRect()
    return Math.hypot(left + width / 2 - clientX, top + height / 2 - clientY)
  }
  const rings = /** @type {Element} */ (event.currentTarget).querySelectorAll('.handle-ring')
  const own = /** @type {Element} */ (reach.parentElement)
  let [least, nearest] = [off(reach), own]
  for (const ring of rings)
    if (off(ring) < least - 0.5) [least, nearest] = [off(ring), /** @type {Element} */ (ring.parentElement)]
  if (nearest === own) return
  event.stopPropagation()
  event.preventDefault()
  nearest.dispatchEvent(new PointerEvent('pointerdown', /** @type {PointerEvent} */ (event)))
}
