// Every widget's work per frame at a sixth of this processor's speed: its turn in the script, and the whole main
// thread's (style, layout and paint included). Both are time on the processor, as the browser's trace has it, so that
// what else the machine does counts for nothing. Prints the table of the README; nothing fails on a time.
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist, tagOf } from '../places.mjs'
import { WIDGETS } from '../../../web/widgets/index.js'

const SECONDS = 6
/** Before the count: a browser compiles what it has run a while. */
const WARM = 4
const THROTTLE = Number(process.env.THROTTLE ?? 6)

const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
console.log(
  '| widget, at 6× throttle | frames | script, median | script, 95 % | main thread, mean |\n|---|---:|---:|---:|---:|',
)
try {
  for (const tag of Object.keys(WIDGETS)) {
    const context = await browser.newContext({
      viewport: DESKTOP,
      serviceWorkers: 'block',
      reducedMotion: 'no-preference',
    })
    const page = await context.newPage()
    await page.goto(`${site.url}kalman/`)
    if ((await page.locator(tagOf(tag)).count()) === 0) {
      await context.close()
      continue
    }
    // A figure that waits for an answer gets one.
    for (const form of await page.locator('.quiz[data-unlocks]').all()) {
      await form.scrollIntoViewIfNeeded()
      await form.locator('input').first().check()
      await form.locator('[type="submit"]').click()
    }
    const element = page.locator(tagOf(tag)).first()
    await element.scrollIntoViewIfNeeded()
    // This one: another of its kind may be alive before it.
    await element.locator('.live').waitFor()
    const wire = await context.newCDPSession(page)
    const play = element.getByRole('button', { name: 'Play' })
    if (await play.count()) await play.click()
    const handle = element.locator('.live .handle-reach').first()
    const held = (await handle.count()) > 0
    let [x, y, turns] = [0, 0, 0]
    if (held) {
      await handle.scrollIntoViewIfNeeded()
      const box = /** @type {any} */ (await handle.boundingBox())
      ;[x, y] = [box.x + box.width / 2, box.y + box.height / 2]
      await page.mouse.move(x, y)
      await page.mouse.down()
    }
    /** Dragging is the dearest thing a hand can do: each move runs the whole scenario again. */
    const live = async (seconds) => {
      const until = Date.now() + seconds * 1000
      if (!held) return page.waitForTimeout(seconds * 1000)
      for (; Date.now() < until; turns++)
        await page.mouse.move(x + 40 * Math.sin(turns / 9), y + 30 * Math.cos(turns / 7))
    }
    await live(WARM)
    await wire.send('Emulation.setCPUThrottlingRate', { rate: THROTTLE })
    await browser.startTracing(page, {
      categories: ['devtools.timeline', 'toplevel', 'disabled-by-default-devtools.timeline'],
    })
    await live(SECONDS)
    const { turns: costs, main } = read(await browser.stopTracing())
    const ms = (micros = 0) => `${(micros / 1000).toFixed(1)} ms`
    console.log(
      `| ${tag} | ${costs.length} | ${ms(costs[costs.length >> 1])} | ` +
        `${ms(costs[Math.floor(costs.length * 0.95)])} | ${ms(main / Math.max(1, costs.length))} |`,
    )
    await context.close()
  }
} finally {
  await browser.close()
  await site.close()
}

/**
 * The turns of the animation frame on the page's main thread, in order of their cost, and all its tasks together.
 * @param {Buffer} trace
 */
function read(trace) {
  const { traceEvents } = JSON.parse(trace.toString())
  // The thread that turns: one of another page, in its last moments, may be in the trace as well.
  const threads = new Map()
  for (const event of traceEvents.filter(({ ph }) => ph === 'X')) {
    const thread = `${event.pid} ${event.tid}`
    if (!threads.has(thread)) threads.set(thread, [])
    threads.get(thread).push(event)
  }
  const turning = (events) => events.filter(({ name }) => name === 'FireAnimationFrame').length
  const events = [...threads.values()].sort((a, b) => turning(b) - turning(a))[0] ?? []
  const spent = (kind) => events.filter(({ name }) => name === kind).map(({ tdur }) => tdur ?? 0)
  return {
    turns: spent('FireAnimationFrame').sort((a, b) => a - b),
    main: spent('RunTask').reduce((sum, one) => sum + one, 0),
  }
}
