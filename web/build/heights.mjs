/**
 * How high each part of a chapter is, as style rules. A browser puts off laying out what is far from the screen, and
 * needs a height for it meanwhile: with one near the real height the scroll bar is right and a link leads to the right
 * place at once. The heights are measured by `scripts/heights` and kept in heights.json: a build needs no browser, and
 * a list that lags behind costs a little of that precision, nothing else.
 */

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'

/**
 * The widths of the window at which heights are measured, pixels. From the third on the column of text has one width.
 */
export const WIDTHS = [320, 390, 600, 768, 1280]
/** The width from which the contents, or the notes, have a column of their own; as in columns.css. */
const WIDE = '75rem'

/** Chapter → part → its height at each of WIDTHS. @typedef {Record<string, Record<string, number[]>>} Heights */

/** Writes `heights.css` into `folder`. @param {string} folder @returns {string} the folder */
export function styleHeights(folder) {
  /** @type {Heights} */
  const heights = JSON.parse(readFileSync(new URL('heights.json', import.meta.url), 'utf8'))
  const parts = Object.entries(heights).flatMap(([chapter, list]) =>
    Object.entries(list).map(([part, at]) => ({
      selector: `[data-chapter=${chapter}]>[data-part=${part}]`,
      at,
    })),
  )
  const rules = (/** @type {(at: number[]) => string} */ height) =>
    parts.map(({ selector, at }) => `${selector}{contain-intrinsic-block-size:auto ${height(at)}}`).join('')
  const between = (/** @type {number} */ i) => (/** @type {number[]} */ at) =>
    line([WIDTHS[i], at[i]], [WIDTHS[i + 1], at[i + 1]])
  const css = [
    rules((at) => `${at[3]}px`),
    `@media(min-width:${WIDE}){${rules((at) => `${at[4]}px`)}}`,
    `@media(max-width:${WIDTHS[2]}px){${rules(between(1))}}`,
    `@media(max-width:${WIDTHS[1]}px){${rules(between(0))}}`,
  ]
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, 'heights.css'), `${css.join('\n')}\n`)
  return folder
}

/**
 * The straight line through two points (width of the window, height), both in pixels, as a length.
 * @param {[number, number]} a @param {[number, number]} b
 */
function line([x, y], [u, v]) {
  const slope = (v - y) / (u - x)
  return `calc(${Math.round(y - slope * x)}px + ${Math.round(slope * 100)}vw)`
}
