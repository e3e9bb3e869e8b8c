// A chapter as a PDF, from its print view: tagged, with bookmarks. Run by scripts/pdf; the tests of paper print the
// same way.
import { spawnSync } from 'node:child_process'
import { writeFileSync } from 'node:fs'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist, root } from '../places.mjs'

/** The chapters and their parts with pages of their own, by the folders they are served from. */
const PRINTED = ['kalman', 'kalman/exercises', 'kalman/rust']

/** The open page on paper. @param {import('playwright-core').Page} page */
export async function printed(page) {
  // A link to another page of the site would lead to the address that it is printed from.
  await page.evaluate(() => {
    for (const link of document.querySelectorAll('a[href]')) {
      if (link.origin === location.origin && link.pathname !== location.pathname) link.removeAttribute('href')
    }
    // Headless Chromium 148 does not fetch what is to come late.
    for (const image of document.querySelectorAll('img[loading=lazy]')) image.loading = 'eager'
  })
  await page.waitForFunction(() => [...document.images].every((image) => image.complete))
  return page.pdf({ format: 'A4', printBackground: true, tagged: true, outline: true })
}

/**
 * A PDF without what differs from one print of a commit to the next: the time is that of the commit (or of
 * SOURCE_DATE_EPOCH), and the browser's numbers for what is tagged count from 1. All keeps its length: a PDF knows its
 * parts by where they begin.
 * @param {Buffer} pdf
 */
export function reproducible(pdf) {
  const commit = spawnSync('git', ['log', '-1', '--format=%ct'], { cwd: root, encoding: 'utf8' }).stdout
  const time = new Date(1000 * Number(process.env.SOURCE_DATE_EPOCH || commit || 0))
    .toISOString()
    .replace(/\D/g, '')
    .slice(0, 14)
  const text = pdf.toString('latin1').replace(/(\/(?:CreationDate|ModDate) \(D:)\d{14}\+00'00'/g, `$1${time}+00'00'`)
  const tags = /(?<=\(node)\d{8}(?=\))/g
  const ranks = new Map([...new Set(text.match(tags))].sort().map((tag, i) => [tag, String(i + 1).padStart(8, '0')]))
  return Buffer.from(
    text.replace(tags, (tag) => ranks.get(tag)),
    'latin1',
  )
}

async function pdfs() {
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
  try {
    for (const folder of PRINTED) {
      const page = await browser.newPage({ viewport: DESKTOP, serviceWorkers: 'block' })
      await page.goto(`${site.url}${folder}/`)
      await page.waitForFunction(() => !document.documentElement.classList.contains('waiting'))
      const file = path.join(dist, folder, `${path.basename(folder)}.pdf`)
      const pdf = reproducible(await printed(page))
      writeFileSync(file, pdf)
      console.log(`${path.relative(root, file)}: ${Math.round(pdf.length / 1000)} kB`)
      await page.close()
    }
  } finally {
    await browser.close()
    await site.close()
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await pdfs()
