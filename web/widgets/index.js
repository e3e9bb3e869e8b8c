/**
 * The figures: what the list says of each, and its script, which is fetched when the first of its kind comes near the
 * screen.
 */

import { FIGURES } from '../../target/figures.js'

/**
 * @typedef {object} Listed what the list of figures says of one (crates/labs/src/figures.rs)
 * @property {string} name its lab's name in a state, the name of its folder and of its page
 * @property {string} tag the custom element
 * @property {string} lab its lab's class in the module
 * @property {string} build the build of the module that has the class
 * @property {boolean} world whether the lab stands on something from outside, as on a log
 * @property {string | null} was its name in old addresses
 */

/** @type {Record<string, () => Promise<import('../figure/spec.js').FigureSpec>>} */
export const WIDGETS = Object.fromEntries(
  FIGURES.map((listed) => [
    listed.name,
    async () => ({ ...(await import(`./${listed.name}/index.js`)).figure, ...listed }),
  ]),
)
