// The letters of each face that a reader of the chapter meets: in every notation, in every figure alive. A program
// writes them to web/build/letters.json, after which fonts.mjs cuts the faces; a test sees that no page needs more.
import { writeFileSync } from 'node:fs'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist, EXERCISES, root } from '../places.mjs'

/** Walks the chapter in every notation until every figure is alive. @param {import('playwright-core').Page} page */
export async function readItAll(page) {
  for (const notation of ['thrun', 'common']) {
    await page.locator(`[data-set-notation="${notation}"]`).click()
    await page.waitForFunction((it) => document.documentElement.dataset.letters === it, notation)
  }
  await page.evaluate(() =>
    document.querySelectorAll('details').forEach((block) => {
      block.open = true
    }),
  )
  // All parts are laid out first: with every block open they are far higher than noted, and each would push the next
  // figure away.
  await page.evaluate(() =>
    document.querySelectorAll('.chapter > section').forEach((part) => {
      part.style.contentVisibility = 'visible'
    }),
  )
  for (const widget of await page.locator('.widget').all()) {
    await widget.scrollIntoViewIfNeeded()
    await widget.and(page.locator('[data-state="live"]')).waitFor()
  }
  await page.locator('[data-set-notation="choset"]').click()
  await page.waitForTimeout(300)
}

async function letters() {
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
  try {
    const page = await browser.newPage({ viewport: DESKTOP, serviceWorkers: 'block' })
    /** @type {Record<string, Set<string>>} */
    const faces = {}
    for (const at of ['kalman/', EXERCISES]) {
      await page.goto(site.url + at)
      await readItAll(page)
      const seen = await page.evaluate(() => {
        const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
        const found = []
        while (texts.nextNode()) {
          const parent = texts.currentNode.parentElement
          if (!parent || parent.closest('math, script, style')) continue
          const { fontFamily, fontWeight, fontStyle } = getComputedStyle(parent)
          const face = `${fontFamily.split(',')[0].replace(/["']/g, '')} ${fontWeight} ${fontStyle}`
          found.push([face, texts.currentNode.data])
        }
        return found
      })
      for (const [face, text] of seen) {
        faces[face] ??= new Set()
        for (const letter of text) if (letter >= ' ') faces[face].add(letter)
      }
    }
    const seen = Object.entries(faces).map(([face, all]) => [face, [...all].sort().join('')])
    return Object.fromEntries(seen.filter(([, all]) => all.trim()).sort(([a], [b]) => (a < b ? -1 : 1)))
  } finally {
    await browser.close()
    await site.close()
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const seen = await letters()
  const file = path.join(root, 'web/build/letters.json')
  writeFileSync(file, `${JSON.stringify(seen, null, 2)}\n`)
  console.log(
    `web/build/letters.json: ${Object.values(seen).reduce((sum, all) => sum + [...all].length, 0)} letters in ` +
      `${Object.keys(seen).length} faces; ./scripts/build cuts the faces to them`,
  )
}
