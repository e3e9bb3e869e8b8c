/**
 * Draws a still picture of each figure into target/stills, with the figure's own view code and the module's build for
 * Node: one for each widget in its usual state, and one for each figure that the text opens in another state. Each is
 * there once more, in target/stills/apart, with its panels in a file beside it.
 */

import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseHTML } from 'linkedom'
import { apart } from './apart.mjs'
import { coarse } from '../draw/path.js'
import { drawStill } from '../figure/still.js'
import { WIDGETS } from '../widgets/index.js'

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))))
const out = join(root, 'target/stills')
const estimate = createRequire(import.meta.url)(join(root, 'target/pkg/node/estimate_wasm.js'))

rmSync(out, { recursive: true, force: true })
mkdirSync(join(out, 'apart'), { recursive: true })
coarse()
for (const [name, load] of Object.entries(WIDGETS)) await draw(name, await load(), {})
// The book's program, which reads the text, has written which figures open in a state of their own.
for (const { id, name, start } of JSON.parse(readFileSync(join(root, 'target/opened.json'), 'utf8'))) {
  await draw(id, await WIDGETS[name](), start)
}
console.log(
  `target/stills: ${readdirSync(out)
    .filter((name) => name.endsWith('.svg'))
    .join(', ')}`,
)

/**
 * @param {string} name
 * @param {import('../figure/spec.js').FigureSpec} spec
 * @param {{ step?: number, params?: object }} given
 */
async function draw(name, spec, given) {
  const state = { step: given.step ?? spec.still ?? spec.start.step, params: { ...spec.start.params, ...given.params } }
  const log = spec.log ? [estimate[spec.lab].parse(readFileSync(join(root, spec.log), 'utf8'))] : []
  const lab = estimate[spec.lab].from(...log, { version: 1, lab: spec.name, ...state })
  const { still, words } = drawStill(
    emptyPage(),
    spec,
    lab.frame(),
    estimate[spec.lab].parameters(),
    spec.aside?.whole(lab),
  )
  write(name, still.outerHTML, words)
  writeFileSync(join(out, 'apart', `${name}.svg`), await apart(still, name, join(root, 'target/fonts')))
  writeFileSync(join(out, 'apart', `${name}.html`), still.outerHTML)
  lab.free()
}

function emptyPage() {
  return parseHTML('<!doctype html><html><body></body></html>').document
}

/** @param {string} name @param {string} svg @param {string} words */
function write(name, svg, words) {
  writeFileSync(join(out, `${name}.svg`), svg)
  writeFileSync(join(out, `${name}.txt`), `${words}\n`)
}
