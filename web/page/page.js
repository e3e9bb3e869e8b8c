/** Wakes a page: the switches at once, everything else when it is needed. */

import { hideFailure, showFailure } from '../core/failure.js'
import { WIDGETS } from '../widgets/index.js'
import { openForPrint } from './print.js'
import { say, switches } from './switches.js'

document.documentElement.classList.add('js')
for (const waiting of document.querySelectorAll('[data-needs-js]')) waiting.removeAttribute('hidden')
switches()
openForPrint()

whenNear('.widget', (host) => bring(/** @type {HTMLElement} */ (host)))
if ([...new URLSearchParams(location.search).keys()].some((key) => key.startsWith('fig-'))) import('./links.js').then(({ links }) => links(WIDGETS))
if (document.querySelector('.quiz')) import('./quiz.js').then(({ quizzes }) => quizzes(), withoutQuizzes)
document.querySelector('[data-run-checks]')?.addEventListener('click', ({ target }) => import('./checks.js').then(({ check }) => check(/** @type {HTMLButtonElement} */ (target)), () => say('The checks could not be fetched.')))
document.querySelector('[data-open-search]')?.addEventListener('click', search)
document.addEventListener('keydown', (event) => {
  const typing = event.target instanceof Element && event.target.closest('select, textarea, input:not([type="radio"], [type="checkbox"], [type="range"])')
  if (event.key !== '/' || typing || event.ctrlKey || event.metaKey || event.altKey) return
  event.preventDefault()
  search()
})
idle(() => {
  import('./contents.js').then(({ follow }) => follow())
  import('./terms.js').then(({ terms }) => terms())
  import('./scroll-boxes.js').then(({ scrollBoxes }) => scrollBoxes())
  import('./offline.js').then(({ offline }) => offline())
})

function search() {
  import('./search.js').then(({ openSearch }) => openSearch(), () => say('The search could not be fetched.'))
}

/** Questions whose script is lost are as they are without scripts: nothing to press, and the answers there. */
function withoutQuizzes() {
  for (const part of document.querySelectorAll('.quiz [data-needs-js]')) part.remove()
  for (const quiz of document.querySelectorAll('.quiz')) quiz.setAttribute('data-answered', '')
}

/** @param {HTMLElement} host @returns {Promise<void>} */
async function bring(host) {
  try {
    const { awaken } = await import('./figures.js')
    hideFailure(host)
    await awaken(host, WIDGETS)
  } catch {
    showFailure(host, 'its script could not be fetched', () => bring(host))
  }
}

/** @param {string} selector @param {(element: Element) => void} act once for each, when it comes near the screen */
function whenNear(selector, act) {
  const eye = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) continue
      eye.unobserve(target)
      act(target)
    }
  }, { rootMargin: '900px 0px' })
  for (const element of document.querySelectorAll(selector)) eye.observe(element)
}

/** @param {() => void} act */
function idle(act) {
  const start = () => ('requestIdleCallback' in window ? requestIdleCallback(act, { timeout: 2000 }) : setTimeout(act, 200))
  if (document.readyState === 'complete') start()
  else addEventListener('load', start, { once: true })
}
