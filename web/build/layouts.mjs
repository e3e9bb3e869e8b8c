/**
 * Where the parts of each figure stand, as style rules: said once, for its stills and for the living figure, and not in
 * each of them.
 */

import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { layoutOf } from '../figure/layout.js'
import { WIDGETS } from '../widgets/index.js'

/** Figures whose pages have a style sheet of their own: it takes their rules, and a chapter does without. */
const APART = ['own-system', 'write-filter']

/**
 * Writes into `folder` `layouts.css`, and a file for each figure apart.
 * @param {string} folder
 * @returns {Promise<string>} the folder
 */
export async function styleLayouts(folder) {
  /** @type {Map<string, string[]>} */
  const files = new Map()
  for (const [name, load] of Object.entries(WIDGETS)) {
    const file = APART.includes(name) ? name : 'layouts'
    const rule = `[data-widget=${name}]>:is(.still,.live){${layoutOf(await load())}}`
    files.set(file, [...(files.get(file) ?? []), rule])
  }
  mkdirSync(folder, { recursive: true })
  for (const [file, rules] of files) writeFileSync(join(folder, `${file}.css`), `${rules.join('\n')}\n`)
  return folder
}
