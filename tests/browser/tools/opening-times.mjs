// How long after its address is asked for each figure's own page works, at a quarter of the processor's speed: printed,
// the slowest last. Fails on nothing.
//   node tests/browser/tools/opening-times.mjs [NAME …]
// THROTTLE names another factor.
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, FIGURE_PAGES, HANGS_MS, chromiumPath, dist } from '../places.mjs'

const rate = Number(process.env.THROTTLE ?? 4)
const wanted = process.argv.slice(2).map((name) => `figure/${name}/`)
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
const times = []
try {
  // The first page of a new browser waits for the browser: it is opened once and not counted.
  const first = await browser.newPage({ serviceWorkers: 'block' })
  await first.goto(site.url + FIGURE_PAGES[0])
  await first.close()
  for (const at of wanted.length > 0 ? wanted : FIGURE_PAGES) {
    // A context of its own: nothing of the page before is in its cache.
    const context = await browser.newContext({ viewport: DESKTOP, serviceWorkers: 'block' })
    const page = await context.newPage()
    const wire = await context.newCDPSession(page)
    await wire.send('Emulation.setCPUThrottlingRate', { rate })
    await page.addInitScript(() => {
      const look = () => {
        if (document.querySelector('.widget')?.dataset.state === 'live') globalThis.works = performance.now()
        else requestAnimationFrame(look)
      }
      requestAnimationFrame(look)
    })
    await page.goto(site.url + at)
    await page.waitForFunction(() => globalThis.works, null, { timeout: HANGS_MS })
    times.push({ at, seconds: (await page.evaluate(() => globalThis.works)) / 1000 })
    await context.close()
  }
} finally {
  await browser.close()
  await site.close()
}
for (const { at, seconds } of times.sort((a, b) => a.seconds - b.seconds)) console.log(`${seconds.toFixed(2)} s ${at}`)
console.log(`at ${rate}× throttle`)
