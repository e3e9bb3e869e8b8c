/** A figure that could not come to life says so beside its still, and offers to try again. */

/**
 * @param {HTMLElement} host
 * @param {string} why
 * @param {() => void} again
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
  button.addEventListener('click', again)
  words.append(button)
  host.append(words)
}

/** @param {HTMLElement} host */
export function hideFailure(host) {
  host.querySelector('.figure-failure')?.remove()
}
