// When the first figure of the chapter is alive after the page's first paint, for a reader who scrolls to it at once,
// on a machine of a quarter of this one's speed: `node tests/browser/tools/first-figure.mjs [RUNS]`. THROTTLE names
// another factor.
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, PHONE, chromiumPath, dist } from '../places.mjs'

const runs = Number(process.argv[2] ?? 5)
const rate = Number(process.env.THROTTLE ?? 4)
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
const times = []
try {
  for (let i = 0; i < runs; i++) {
    const context = await browser.newContext({
      viewport: PHONE,
      isMobile: true,
      hasTouch: true,
      serviceWorkers: 'block',
    })
    const page = await context.newPage()
    const wire = await context.newCDPSession(page)
    await wire.send('Emulation.setCPUThrottlingRate', { rate })
    await page.addInitScript(() => {
      const painted = () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime
      const look = () => {
        const first = document.querySelector('.widget')
        if (painted() !== undefined) first?.scrollIntoView()
        if (first?.dataset.state === 'live') globalThis.alive = { painted: painted(), alive: performance.now() }
        else requestAnimationFrame(look)
      }
      requestAnimationFrame(look)
    })
    await page.goto(`${site.url}kalman/`)
    await page.waitForFunction(() => globalThis.alive, null, { timeout: 60_000 })
    const { painted, alive } = await page.evaluate(() => globalThis.alive)
    times.push(alive - painted)
    console.log(
      `first paint after ${(painted / 1000).toFixed(2)} s, ` +
        `the first figure alive ${((alive - painted) / 1000).toFixed(2)} s later`,
    )
    await context.close()
  }
} finally {
  await browser.close()
  await site.close()
}
console.log(`median ${(times.sort((a, b) => a - b)[Math.floor(runs / 2)] / 1000).toFixed(2)} s at ${rate}× throttle`)
