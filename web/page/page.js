/**
 * Wakes a page: the switches at once, everything else when it is needed. This script may run while the page is still
 * being read, so that the first figure does not wait for the last section.
 */

import { hideFailure, showFailure } from '../figure/failure.js'
import { inTime } from '../load/timeouts.js'
import { WIDGETS } from '../widgets/index.js'
import { whenNear, whenRead } from './when-near.js'
import { openForPrint } from './print.js'
import { say, switches } from './switches.js'

document.documentElement.classList.add('js')
openForPrint()
whenNear('.widget', (host) => bring(/** @type {HTMLElement} */ (host)))

/** What a press on an element with this attribute does. @type {Record<string, (element: Element) => void>} */
const PRESSES = {
  'data-open-search': search,
  'data-print': () => print(),
  'data-grow': (link) => {
    const widget = document.querySelector(`${link.getAttribute('href')} .widget`)
    const stage = link.getAttribute('data-grow') ?? ''
    if (widget && stage > (widget.getAttribute('data-stage') ?? '3')) widget.setAttribute('data-stage', stage)
    const shows = link.getAttribute('data-shows')
    if (widget && shows)
      import('./show-part.js').then(
        ({ showPart }) => showPart(widget, shows),
        () => {},
      )
  },
  'data-run-checks': (button) =>
    import('./checks.js').then(
      ({ check }) => check(/** @type {HTMLButtonElement} */ (button)),
      () => say('The checks could not be fetched: reload this page for them.'),
    ),
}
document.addEventListener('click', ({ target }) => {
  const link = target instanceof Element ? target.closest('a[href^="#"]') : null
  if (link) unfold(link.getAttribute('href') ?? '')
  for (const [attribute, act] of Object.entries(PRESSES)) {
    const pressed = target instanceof Element ? target.closest(`[${attribute}]`) : null
    if (pressed) act(pressed)
  }
})
document.addEventListener('keydown', (event) => {
  const typing =
    event.target instanceof Element &&
    event.target.closest('select, textarea, input:not([type="radio"], [type="checkbox"], [type="range"])')
  if (event.key !== '/' || typing || event.ctrlKey || event.metaKey || event.altKey) return
  event.preventDefault()
  search()
})
whenRead(() => {
  goWhereItIs()
  addEventListener('hashchange', goWhereItIs)
  for (const waiting of document.querySelectorAll('[data-needs-js]')) waiting.removeAttribute('hidden')
  switches()
  if ([...new URLSearchParams(location.search).keys()].some((key) => key.startsWith('fig-')))
    import('./links.js').then(({ links }) => links(WIDGETS))
  questions()
  if (document.querySelector('.own-log')) import('./log.js').then(({ ownLog }) => ownLog(), withoutLog)
})
idle(() => {
  import('./when-idle.js').then(({ later }) => later())
})

/**
 * A browser opens what holds the target of an address; a derivation that is itself the target opens too.
 * @param {string} hash
 */
function unfold(hash) {
  const block = document.getElementById(hash.slice(1))
  if (block?.matches('.derivation')) block.setAttribute('open', '')
}

/** An address that names an exercise or a section of another page leads there, with what it says of figures. */
function goWhereItIs() {
  unfold(location.hash)
  // `:target` is not known yet when a page that the browser holds has just been read.
  const item = document.getElementById(location.hash.slice(1))?.closest('.exercise-elsewhere, .part-elsewhere')
  const there = item?.querySelector('a')?.href.split('#')[0]
  if (there) location.replace(there + location.search + location.hash)
}

function search() {
  import('./search.js').then(
    ({ openSearch }) => openSearch(),
    () => say('The search could not be fetched: reload this page for it.'),
  )
}

/**
 * Brings the script of the questions when one of them, a figure that waits for its answer or the place of the score
 * comes near.
 */
function questions() {
  const locks = [...document.querySelectorAll('.quiz[data-unlocks]')].map(
    (quiz) => `#${quiz.getAttribute('data-unlocks')}`,
  )
  let coming = false
  whenNear(['.quiz', '[data-score]', ...locks].join(), () => {
    if (!coming) import('./quiz.js').then(({ quizzes }) => quizzes(), withoutQuizzes)
    coming = true
  })
}

/** A log whose script is lost cannot be opened, and the page says so. */
function withoutLog() {
  const [intake, words] = ['.log-intake', '.log-without'].map((place) => document.querySelector(place))
  if (intake && words) intake.textContent = words.textContent
}

/** Questions whose script is lost are as they are without scripts: nothing to press, and the answers there. */
function withoutQuizzes() {
  for (const part of document.querySelectorAll('.quiz [data-needs-js]')) part.remove()
  for (const quiz of document.querySelectorAll('.quiz')) quiz.setAttribute('data-answered', '')
}

/**
 * @param {HTMLElement} host
 * @param {boolean} [again] whether the reader asks for it after a failure
 * @returns {Promise<void>}
 */
async function bring(host, again = false) {
  try {
    const { awaken } = await inTime(import('./figures.js'))
    hideFailure(host)
    await awaken(host, WIDGETS)
  } catch (error) {
    showFailure(host, 'its script could not be fetched', () => bring(host, true))
    if (again)
      await import('../load/reload-if-back.js').then(
        ({ reloadIfThere }) => reloadIfThere(error, host.dataset.figure),
        () => location.reload(),
      )
  }
}

/** @param {() => void} act */
function idle(act) {
  const start = () =>
    'requestIdleCallback' in window ? requestIdleCallback(act, { timeout: 2000 }) : setTimeout(act, 200)
  if (document.readyState === 'complete') start()
  else addEventListener('load', start, { once: true })
}
