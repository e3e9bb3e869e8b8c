// Every widget's work per frame at a sixth of this processor's speed: the time its turn takes in the script, and the
// whole main thread's (style, layout and paint included). Prints the table of the README; nothing fails on a time.
import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist } from './places.mjs'

const WIDGETS = ['odometry-hook', 'observer-bench', 'kalman-picture', 'observability-probe']
const SECONDS = 6

const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
console.log('| widget, at 6× throttle | frames | script, median | script, 95 % | main thread, mean |\n|---|---:|---:|---:|---:|')
try {
  for (const tag of WIDGETS) {
    const context = await browser.newContext({ viewport: DESKTOP, serviceWorkers: 'block', reducedMotion: 'no-preference' })
    const page = await context.newPage()
    await page.addInitScript(() => {
      const costs = (globalThis.frameCosts = [])
      const ask = globalThis.requestAnimationFrame.bind(globalThis)
      globalThis.requestAnimationFrame = (turn) => ask((now) => {
        const start = performance.now()
        turn(now)
        costs.push(performance.now() - start)
      })
    })
    await page.goto(site.url + 'kalman/')
    if ((await page.locator(tag).count()) === 0) { await context.close(); continue }
    await page.locator(tag).first().scrollIntoViewIfNeeded()
    await page.locator(`${tag}[data-state="live"]`).first().waitFor()
    const wire = await context.newCDPSession(page)
    await wire.send('Performance.enable')
    await wire.send('Emulation.setCPUThrottlingRate', { rate: 6 })
    const spent = async () => (await wire.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value
    const element = page.locator(tag).first()
    const play = element.getByRole('button', { name: 'Play' })
    if (await play.count()) await play.click()
    const handle = element.locator('.live .handle').first()
    await page.evaluate(() => { globalThis.frameCosts.length = 0 })
    const before = await spent()
    const until = Date.now() + SECONDS * 1000
    if (await handle.count()) {
      // Dragging is the dearest thing a hand can do: each move runs the whole scenario again.
      await handle.scrollIntoViewIfNeeded()
      const { x, y, width, height } = await handle.boundingBox()
      const [cx, cy] = [x + width / 2, y + height / 2]
      await page.mouse.move(cx, cy)
      await page.mouse.down()
      for (let i = 0; Date.now() < until; i++) await page.mouse.move(cx + 40 * Math.sin(i / 9), cy + 30 * Math.cos(i / 7))
      await page.mouse.up()
    } else await page.waitForTimeout(SECONDS * 1000)
    const main = (await spent()) - before
    const costs = (await page.evaluate(() => globalThis.frameCosts)).sort((a, b) => a - b)
    const ms = (value) => `${value.toFixed(1)} ms`
    console.log(`| ${tag} | ${costs.length} | ${ms(costs[costs.length >> 1] ?? 0)} | ${ms(costs[Math.floor(costs.length * 0.95)] ?? 0)} | ${ms((1000 * main) / Math.max(1, costs.length))} |`)
    await context.close()
  }
} finally {
  await browser.close()
  await site.close()
}
