// What a log asks of the page that shows it: tasks of the page's own thread longer than 50 ms while the mower's log is
// opened, replayed and played, and the same for a log of a million rows, which is told of on its way and given up.
// Prints; fails on nothing.
//   node tests/browser/long-log.mjs
import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist } from './places.mjs'

const ROWS = 1_000_000
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
const page = await browser.newPage({ viewport: DESKTOP })
await page.addInitScript(() => {
  globalThis.tasks = []
  new PerformanceObserver((list) =>
    globalThis.tasks.push(...list.getEntries().map(({ duration }) => Math.round(duration))),
  ).observe({ type: 'longtask', buffered: true })
})
const tasks = (what) =>
  page
    .evaluate(() => globalThis.tasks.splice(0))
    .then((all) => {
      console.log(`${what}: ${all.length === 0 ? 'no task above 50 ms' : `tasks of ${all.join(', ')} ms`}`)
    })
const settled = () =>
  page.waitForFunction(
    () => document.querySelector('robot-log').settled && !document.querySelector('robot-log').figure.run.playing,
    undefined,
    { timeout: 120_000 },
  )

await page.goto(`${site.url}figure/robot-log/`)
await page.locator('robot-log[data-state="live"]').waitFor()
await settled()
await tasks('The page of the figure, until it is alive')
for (const name of [
  'Switch the ranges on',
  'Gate them',
  'Take an offset off',
  'Scale them',
  'Let the filter learn the scale',
]) {
  await page.locator('.live').getByRole('button', { name }).click()
  await settled()
}
await tasks('Five replays of the mower’s log')
await page.locator('.live').getByRole('button', { name: 'Play' }).click()
await page.waitForTimeout(3000)
await page.locator('.live').getByRole('button', { name: 'Pause' }).click()
await tasks('Three seconds of play')

await page.goto(`${site.url}log/`)
await page.locator('robot-log[data-state="live"]').waitFor()
await settled()
await page.evaluate(async (rows) => {
  const parts = ['L,1,0,10\n']
  for (let i = 0; i < rows / 2; i++) parts.push(`O,${i / 10},0.1,0.01\nR,${i / 10},1,10\n`)
  globalThis.long = new File(parts, 'long.csv')
  globalThis.tasks.length = 0
}, ROWS)
await page.waitForTimeout(300)
await page.evaluate(() => {
  globalThis.tasks.length = 0
})
const began = Date.now()
await page.evaluate(() => {
  globalThis.words = new Set()
  const look = () => {
    const box = document.querySelector('robot-log .progress:not([hidden]) span')
    if (box) globalThis.words.add(box.textContent)
    requestAnimationFrame(look)
  }
  look()
  const data = new DataTransfer()
  data.items.add(globalThis.long)
  document
    .querySelector('h1')
    .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
})
await page.locator('.log-answer').getByText('long.csv').waitFor({ timeout: 120_000 })
console.log(`${ROWS.toLocaleString('en')} rows read after ${((Date.now() - began) / 1000).toFixed(1)} s`)
await page.waitForFunction((rows) => document.querySelector('robot-log').frame.step === rows, ROWS, {
  timeout: 300_000,
})
console.log(
  `… and replayed after ${((Date.now() - began) / 1000).toFixed(1)} s; ` +
    `the progress was told ${await page.evaluate(() => globalThis.words.size)} times`,
)
await tasks('Reading and replaying them')
await page.locator('.live').getByRole('button', { name: 'Let the filter learn the scale' }).click()
await page.locator('robot-log .progress button').click()
const given = Date.now()
await settled()
console.log(
  `A second replay was given up; the page had settled ${Date.now() - given} ms later, ` +
    `with the log of ${await page.evaluate(() => document.querySelector('robot-log').frame.rows)} rows ` +
    'on the screen',
)
await tasks('Giving it up')
await browser.close()
await site.close()
