/** Draws each figure's default state with its own view code over the module's Node build, into target/stills. */

import { mkdirSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseHTML } from 'linkedom'
import { drawStill } from './core/still.js'
import { WIDGETS } from './widgets/index.js'

const root = dirname(dirname(fileURLToPath(import.meta.url)))
const out = join(root, 'target/stills')
const estimate = createRequire(import.meta.url)(join(root, 'target/pkg/node/estimate_wasm.js'))

mkdirSync(out, { recursive: true })
for (const [tag, load] of Object.entries(WIDGETS)) {
  const spec = await load()
  const lab = estimate[spec.lab].from({ version: 1, lab: spec.name, ...spec.start })
  const { document } = parseHTML('<!doctype html><html><body></body></html>')
  const { html, words } = drawStill(document, spec, lab.frame())
  writeFileSync(join(out, `${tag}.svg`), html)
  writeFileSync(join(out, `${tag}.txt`), `${words}\n`)
  lab.free()
}
console.log(`target/stills: ${Object.keys(WIDGETS).join(', ')}`)
