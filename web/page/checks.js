/** The chapter's checks, run in the reader's own browser. */

import { loadModule } from '../core/module.js'
import { fixed } from '../core/words.js'

export function checks() {
  const button = /** @type {HTMLButtonElement | null} */ (document.querySelector('[data-run-checks]'))
  button?.addEventListener('click', async () => {
    button.disabled = true
    say('The checks are running.')
    const loaded = await loadModule()
    if (loaded.ok) setTimeout(() => run(loaded.module), 30)
    else say(`The checks could not run: ${loaded.why}.`)
    button.disabled = false
  })
}

/** @param {string} words */
function say(words) {
  const summary = document.querySelector('.check-summary')
  if (summary) summary.textContent = words
}

/** @param {any} estimate */
function run(estimate) {
  const begin = performance.now()
  /** @type {{ id: number, actual: unknown, passed: boolean, milliseconds?: number }[]} */
  let results
  try {
    results = estimate.chapterChecks()
  } catch (error) {
    return say(error instanceof Error ? error.message : 'The checks could not run.')
  }
  const whole = performance.now() - begin
  for (const { id, actual, passed } of results) {
    const row = /** @type {HTMLElement | null} */ (document.querySelector(`[data-check="${Number(id)}"]`))
    if (!row) continue
    row.dataset.passed = String(passed)
    const here = row.querySelector('[data-here]')
    if (here) here.textContent = `${passed ? '✓' : '✗'} ${words(actual)}`
  }
  const right = results.filter(({ passed }) => passed).length
  say(`${right} of ${results.length} checks pass in this browser; together they took ${fixed(whole, 0)} ms.`)
}

/** @param {unknown} value */
function words(value) {
  return typeof value === 'number' ? fixed(value, 6) : String(value)
}
