/** A figure that could not come to life says so beside its still, and offers to try again. */

import { isReplaced, sayReplaced } from '../load/edition.js'
import { button, focusFirst } from '../draw/dom.js'

/**
 * @param {HTMLElement} host
 * @param {string} why
 * @param {() => void | Promise<void>} again
 */
export function showFailure(host, why, again) {
  hideFailure(host)
  host.dataset.state = 'failed'
  const words = document.createElement('p')
  words.className = 'figure-failure'
  words.setAttribute('role', 'status')
  words.append(`This figure is a still picture: ${why}. `)
  button(document, words, 'Try again', async () => {
    await again()
    await decided(host)
    // The button that had the focus is gone.
    if (document.activeElement === document.body) focusFirst(host)
  })
  host.append(words)
  isReplaced().then((replaced) => {
    if (replaced && words.isConnected) sayReplaced(words)
  })
}

/** @param {HTMLElement} host */
export function hideFailure(host) {
  host.querySelector('.figure-failure')?.remove()
  // The figure starts again from its still picture.
  if (host.dataset.state === 'failed') host.dataset.state = 'still'
}

/** Waits until the figure is alive or has failed again. @param {HTMLElement} host @returns {Promise<void>} */
function decided(host) {
  return new Promise((resolve) => {
    const look = () => {
      if (!/live|failed/.test(host.dataset.state ?? '')) return
      eye.disconnect()
      resolve()
    }
    const eye = new MutationObserver(look)
    eye.observe(host, { attributeFilter: ['data-state'] })
    look()
  })
}
