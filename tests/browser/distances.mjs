// How far a reader of the chapter's first half has to read from one thing to move to the next: the picture at the head,
// then the figures. Prints each way in pixels and in screens of 900 px, and fails where one is longer than two screens,
// or three on a phone: its column holds two thirds of the words that a wide one has in the same height.
//   node tests/browser/distances.mjs [WIDTH]
import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist } from './places.mjs'

/** The part of the text behind the first half. */
const BEHIND = 'ekf'
const SCREEN = 900

const width = Number(process.argv[2] ?? 1440)
const most = width < 700 ? 3 : 2
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
try {
  const page = await browser.newPage({
    viewport: { width, height: SCREEN },
    isMobile: width < 700,
    serviceWorkers: 'block',
  })
  await page.goto(`${site.url}kalman/`)
  await page.locator('.vignette .handle').waitFor({ state: 'attached' })
  const places = await page.evaluate(async (behind) => {
    for (const part of document.querySelectorAll('.chapter > section')) part.style.contentVisibility = 'visible'
    await document.fonts.ready
    const end = document.querySelector(`[data-part=${behind}]`).getBoundingClientRect().top + scrollY
    return [...document.querySelectorAll('.vignette, .widget'), null]
      .map((it) => {
        if (!it) return { name: 'the end of the first half', top: end, bottom: end }
        const { top, bottom } = it.getBoundingClientRect()
        const name = it.closest('figure')?.querySelector('.figure-title')?.textContent.trim() ?? 'the head'
        return { name, top: top + scrollY, bottom: bottom + scrollY }
      })
      .filter(({ top }) => top <= end)
      .sort((a, b) => a.top - b.top)
  }, BEHIND)
  for (const [i, { name, top }] of places.entries()) {
    const way = top - (places[i - 1]?.bottom ?? 0)
    const long = way > most * SCREEN
    if (long) process.exitCode = 1
    const [pixels, screens] = [String(Math.round(way)).padStart(6), (way / SCREEN).toFixed(1).padStart(5)]
    console.log(`${pixels} px ${screens} screens ${long ? '!' : ' '} to ${name}`)
  }
} finally {
  await browser.close()
  await site.close()
}
