/**
 * Draws a still picture of each figure into target/stills, with the figure's own view code and the module's build for Node: one
 * for each widget in its usual state, and one for each figure that the text opens in another state.
 */

import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseHTML } from 'linkedom'
import { drawStill } from './core/still.js'
import { WIDGETS } from './widgets/index.js'

const root = dirname(dirname(fileURLToPath(import.meta.url)))
const out = join(root, 'target/stills')
const estimate = createRequire(import.meta.url)(join(root, 'target/pkg/node/estimate_wasm.js'))

rmSync(out, { recursive: true, force: true })
mkdirSync(out, { recursive: true })
for (const [tag, load] of Object.entries(WIDGETS)) draw(tag, await load(), {})

for (const path of readdirSync(join(root, 'content'), { recursive: true })) {
  if (!String(path).endsWith('.md')) continue
  const text = readFileSync(join(root, 'content', String(path)), 'utf8')
  for (const [, id, tag, start] of text.matchAll(/^:::figure\{#(\S+) widget="([^"]+)".* start='([^']+)'.*\}$/gm)) {
    if (WIDGETS[tag]) draw(id, await WIDGETS[tag](), JSON.parse(start))
  }
}
console.log(`target/stills: ${readdirSync(out).filter((name) => name.endsWith('.svg')).join(', ')}`)

/** @param {string} name @param {import('./core/spec.js').FigureSpec} spec @param {{ step?: number, params?: object }} given */
function draw(name, spec, given) {
  const state = { step: given.step ?? spec.still ?? spec.start.step, params: { ...spec.start.params, ...given.params } }
  const lab = estimate[spec.lab].from({ version: 1, lab: spec.name, ...state })
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const { html, words } = drawStill(document, spec, lab.frame(), estimate[spec.lab].parameters())
  writeFileSync(join(out, `${name}.svg`), html)
  writeFileSync(join(out, `${name}.txt`), `${words}\n`)
  lab.free()
}
