// In no figure does a name cover another or lose a part of itself at an edge: many states, at each width that a reader
// may have.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { FIGURES } from '../../target/figures.js'
import { openFigure, RELEASE, root, settled } from './harness.mjs'
import { STATES } from './label-states.mjs'

const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

/** A phone, a tablet, a desk; before a release the widths between them too. */
const WIDTHS = RELEASE ? [320, 390, 768, 900, 1024, 1280, 1440] : [320, 768, 1280]

/**
 * What is wrong with the texts of a figure's panels: each pair that overlaps, each text that reaches out of its panel.
 */
const faults = (host) =>
  [...host.querySelectorAll('.live .panel')].flatMap((svg) => {
    const panel = svg.getBoundingClientRect()
    const texts = [...svg.querySelectorAll('text')].flatMap((text) => {
      // The letters' own height: a line of text has room above and below.
      const { left, right, top, bottom } = text.getBoundingClientRect()
      const spare = (bottom - top) * 0.2
      return right - left > 1 && text.checkVisibility()
        ? [{ words: text.textContent, left: left + 0.5, right: right - 0.5, top: top + spare, bottom: bottom - spare }]
        : []
    })
    const name = svg.getAttribute('class')
    const cut = texts.filter(
      ({ left, right, top, bottom }) =>
        left < panel.left - 2 || right > panel.right + 2 || top < panel.top - 3 || bottom > panel.bottom + 3,
    )
    const pairs = texts.flatMap((a, i) =>
      texts
        .slice(i + 1)
        .filter((b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
        .map((b) => [a, b]),
    )
    return [
      ...cut.map(({ words }) => `${name}: “${words}” is cut`),
      ...pairs.map(([a, b]) => `${name}: “${a.words}” and “${b.words}”`),
    ]
  })

/** Where nothing is said of a figure: each of its parameters at either end, or at each of its words. */
const ends = ({ name, words, least, greatest, default: usual }) =>
  (words ?? (typeof usual === 'boolean' ? [!usual] : typeof usual === 'number' ? [least, greatest] : []))
    .filter((value) => typeof value !== 'number' || Math.abs(value) < 1e6)
    .flatMap((value) => [{ [name]: value }, { [name]: usual }])

for (const { name: tag, lab } of FIGURES) {
  const states = STATES[tag] ?? [{}, { step: 0 }, { step: 1 }, ...core[lab].parameters().flatMap(ends)]
  test(`no name in the ${tag} covers another or is cut`, async (t) => {
    const { page, it } = await openFigure(t, tag)
    const found = []
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 900 })
      for (const state of states) {
        await it.evaluate(
          async (host, change) => {
            if (change) host.figure.change(change)
            // A new width is noticed at the end of a frame, and drawn in the next.
            await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
          },
          Object.keys(state).length ? state : null,
        )
        await settled(it)
        for (const fault of await it.evaluate(faults)) found.push(`${width} px, ${JSON.stringify(state)}: ${fault}`)
      }
      await it.evaluate(
        (host, start) => host.figure.change(start),
        await it.evaluate((host) => ({
          ...Object.fromEntries(
            Object.values(host.figure.shell.limits).map(({ name, default: value }) => [name, value]),
          ),
          step: host.figure.spec.start.step,
        })),
      )
      await settled(it)
    }
    assert.deepEqual([...new Set(found)].slice(0, 30), [], `${found.length} in all`)
  })
}
