/** A figure that could not come to life says so beside its still, and offers to try again. */

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
  const button = document.createElement('button')
  button.type = 'button'
  button.className = 'button'
  button.textContent = 'Try again'
  button.addEventListener('click', async () => {
    await again()
    await decided(host)
    // The button is gone, and the focus with it: back to what stands in its place.
    if (document.activeElement !== document.body) return
    const next = host.querySelector('.figure-failure button, .live :is(button, input, select, [tabindex]):not(:disabled)')
    if (next instanceof HTMLElement || next instanceof SVGElement) next.focus({ preventScroll: true })
  })
  words.append(button)
  host.append(words)
}

/** @param {HTMLElement} host */
export function hideFailure(host) {
  host.querySelector('.figure-failure')?.remove()
  // What comes next begins where a figure begins.
  if (host.dataset.state === 'failed') host.dataset.state = 'still'
}

/** Until the figure is alive, or has failed once more. @param {HTMLElement} host @returns {Promise<void>} */
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
