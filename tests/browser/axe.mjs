// What axe finds on a page.
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
import { turn } from './harness.mjs'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

/** The rules that read colours: nothing else on a page depends on its theme. */
export const COLOURS = ['color-contrast', 'link-in-text-block']

/**
 * What axe finds on the page as it stands, or in its parts that selectors name; of these rules alone, without these, or
 * of all.
 *
 * @param {any} page
 * @param {{ within?: string[], rules?: string[], without?: string[] }} [wishes]
 */
export async function faults(page, { within, rules, without = [] } = {}) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axe)
  const { violations } = await page.evaluate(
    ([parts, only, off]) =>
      globalThis.axe.run(parts ?? document, {
        resultTypes: ['violations'],
        rules: Object.fromEntries(off.map((rule) => [rule, { enabled: false }])),
        ...(only && { runOnly: only }),
      }),
    [within, rules, without],
  )
  return violations
    .map(
      (rule) =>
        `${rule.id}: ${rule.help}\n` +
        rule.nodes
          .slice(0, 4)
          .map((node) => `    ${node.target.join(' ')} ${node.any.concat(node.all, node.none)[0]?.message ?? ''}`)
          .join('\n'),
    )
    .join('\n')
}

/** Axe finds nothing in the light theme, nor of colours in the dark one. */
export async function isAccessible(page, within) {
  await turn(page, 'light')
  assert.equal(await faults(page, { within }), '', 'light')
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor)
  const light = await paper()
  await turn(page, 'dark')
  assert.notEqual(await paper(), light)
  assert.equal(await faults(page, { within, rules: COLOURS }), '', 'dark')
}
