/** Hands text to the reader's clipboard. Where a browser does not allow that, the text stands in a box, selected. */

import { button, part } from '../draw/dom.js'

/** @param {string} text @returns {Promise<boolean>} whether the clipboard has it */
export async function copied(text) {
  // Chromium reports an attempt that a frame's permissions forbid in the console.
  const policy = /** @type {any} */ (document).featurePolicy
  if (policy && !policy.allowsFeature('clipboard-write')) return false
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    return false
  }
}

/**
 * A box with text to copy. A figure has one at most: the next takes its place.
 * @param {HTMLElement} into
 * @param {string} name what the text is
 * @param {string} text
 * @param {() => void} closed
 */
export function offer(into, name, text, closed) {
  const { ownerDocument: document } = into
  into.querySelector('.copy-box')?.remove()
  const box = part(document, into, 'div', 'copy-box')
  const label = part(document, box, 'label', '')
  part(document, label, 'span', '').textContent = name
  const area = /** @type {HTMLTextAreaElement} */ (part(document, label, 'textarea', ''))
  area.readOnly = true
  area.rows = Math.min(6, 1 + Math.ceil(text.length / 80))
  area.value = text
  const close = () => {
    box.remove()
    closed()
  }
  button(document, box, 'Close', close)
  box.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') close()
  })
  area.focus({ preventScroll: true })
  area.select()
}
