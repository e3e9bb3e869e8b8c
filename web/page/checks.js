/** The chapter's checks, run one after another in the reader's own browser. */

import { loadBuild } from '../load/modules.js'
import { fixed } from '../draw/numbers.js'

/** @typedef {import('estimate-wasm').Check} Check */

/** @param {HTMLButtonElement} button the one that was pressed */
export async function check(button) {
  if (button.disabled) return
  button.disabled = true
  say('The checks are running.')
  const loaded = await loadBuild('whole')
  if (loaded.ok) await run(loaded.module)
  else say(`The checks could not run: ${loaded.why}.`)
  button.disabled = false
}

/** @param {string} words */
function say(words) {
  const summary = document.querySelector('.check-summary')
  if (summary) summary.textContent = words
}

/** @param {typeof import('estimate-wasm')} estimate */
async function run(estimate) {
  const rows = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('[data-check]')])
  for (const row of rows) empty(row)
  let [right, whole] = [0, 0]
  for (const row of rows) {
    // Lets the browser draw the row before the next check blocks the page.
    await new Promise((resolve) => setTimeout(resolve))
    const begin = performance.now()
    /** @type {Pick<Check, 'passed'> & { words: string }} */
    let found
    try {
      const { passed, actual, tolerance } = estimate.chapterCheck(Number(row.dataset.check))
      found = { passed, words: actual.map((value) => short(value, tolerance)).join(', ') }
    } catch (error) {
      found = { passed: false, words: error instanceof Error ? error.message : 'could not run' }
    }
    const time = performance.now() - begin
    whole += time
    if (found.passed) right++
    show(row, found, time)
  }
  say(`${right} of ${rows.length} checks pass in this browser; together they took ${milliseconds(whole)}.`)
}

/** @param {HTMLElement} row */
function empty(row) {
  delete row.dataset.passed
  for (const cell of row.querySelectorAll('[data-here], [data-time]')) cell.textContent = '–'
}

/** @param {HTMLElement} row @param {{ passed: boolean, words: string }} found @param {number} time */
function show(row, { passed, words }, time) {
  row.dataset.passed = String(passed)
  const [here, took] = [row.querySelector('[data-here]'), row.querySelector('[data-time]')]
  if (here) here.textContent = `${passed ? '✓' : '✗'} ${words}`
  if (took) took.textContent = milliseconds(time)
}

/**
 * Browsers round their clocks to a tenth of a millisecond or more, so a short time is only bounded.
 * @param {number} time
 */
function milliseconds(time) {
  return time < 0.05 ? '<\u00a00.1\u00a0ms' : `${fixed(time, 1)}\u00a0ms`
}

/**
 * Seven significant digits, but none beyond the tolerance, as the book prints the values of the build.
 * @param {number} value
 * @param {number} tolerance
 */
function short(value, tolerance) {
  const size = Math.abs(value)
  const plain = value === 0 || (size >= 1e-4 && size < 1e6)
  const decimals =
    value === 0
      ? 0
      : Math.max(
          0,
          Math.min(12, 6 - Math.floor(Math.log10(size)), tolerance < 1 ? Math.ceil(-Math.log10(tolerance) - 1e-9) : 12),
        )
  const [digits, power] = plain ? [value.toFixed(decimals)] : value.toExponential(5).split('e')
  const lean = digits.includes('.') ? digits.replace(/\.?0+$/, '') : digits
  return (power === undefined ? lean : `${lean}e${power.replace('+', '')}`).replaceAll('-', '\u2212')
}
