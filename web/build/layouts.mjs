/**
 * Where the parts of each figure stand, as style rules: said once, for its stills and for the living figure, and not in
 * each of them.
 */

import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { layoutOf } from '../figure/layout.js'
import { WIDGETS } from '../widgets/index.js'

/** Writes `layouts.css` into `folder`. @param {string} folder @returns {Promise<string>} the folder */
export async function styleLayouts(folder) {
  const rules = await Promise.all(
    Object.entries(WIDGETS).map(
      async ([name, load]) => `[data-widget=${name}]>:is(.still,.live){${layoutOf(await load())}}`,
    ),
  )
  mkdirSync(folder, { recursive: true })
  writeFileSync(join(folder, 'layouts.css'), `${rules.join('\n')}\n`)
  return folder
}
