// Notes how high each part of each chapter is, in web/build/heights.json: a browser that has put off laying out a part
// takes that height for it. Run by scripts/heights.
import { writeFileSync } from 'node:fs'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { WIDTHS } from '../../../web/build/heights.mjs'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist, EXERCISES, root } from '../places.mjs'

/** The pages of each chapter; a chapter is named by the folder it is served from. */
const CHAPTERS = { kalman: ['kalman/', EXERCISES, 'kalman/rust/'] }

/** Each part's height on the open page, all of it laid out: [part, pixels][]. */
export async function partHeights(page) {
  await page.evaluate(async () => {
    for (const part of document.querySelectorAll('.chapter > section')) part.style.contentVisibility = 'visible'
    document.body.getBoundingClientRect()
    await document.fonts.ready
  })
  return page.evaluate(() =>
    [...document.querySelectorAll('.chapter > section')].map((part) => [
      part.dataset.part,
      Math.round(part.getBoundingClientRect().height),
    ]),
  )
}

async function heights() {
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
  try {
    const found = {}
    for (const [chapter, pages] of Object.entries(CHAPTERS)) {
      found[chapter] = {}
      for (const width of WIDTHS) {
        const page = await browser.newPage({
          viewport: { width, height: 800 },
          isMobile: width < 700,
          serviceWorkers: 'block',
        })
        /**
         * Parts of one name (the terms, the works cited) have the height that they have on the chapter's first page.
         */
        const known = new Set()
        for (const at of pages) {
          await page.goto(site.url + at)
          for (const [part, height] of await partHeights(page)) {
            if (!known.has(part)) (found[chapter][part] ??= []).push(height)
            known.add(part)
          }
        }
        await page.close()
      }
    }
    return found
  } finally {
    await browser.close()
    await site.close()
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const found = await heights()
  const lines = Object.entries(found).map(
    ([chapter, parts]) =>
      `  "${chapter}": {\n${Object.entries(parts)
        .map(([part, at]) => `    "${part}": ${JSON.stringify(at)}`)
        .join(',\n')}\n  }`,
  )
  writeFileSync(path.join(root, 'web/build/heights.json'), `{\n${lines.join(',\n')}\n}\n`)
  console.log(
    `web/build/heights.json: ${Object.values(found).reduce((sum, parts) => sum + Object.keys(parts).length, 0)} ` +
      `parts at ${WIDTHS.join(', ')} px; ./scripts/build puts them into the style`,
  )
}
