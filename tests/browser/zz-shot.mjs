import { chromium } from 'playwright-core'
import { serve } from '../../scripts/static-server.mjs'
import { withState } from '../../web/figure/state-in-url.js'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist } from './places.mjs'
const [widget, tag, ...shots] = process.argv.slice(2)
const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
try {
  for (const shot of shots) {
    const { name, width, theme = 'light', params = {} } = JSON.parse(shot)
    const page = await browser.newPage({
      viewport: { width, height: 1300 },
      colorScheme: theme,
      reducedMotion: 'reduce',
      serviceWorkers: 'block',
    })
    page.on('console', (m) => console.log(name, m.text()))
    page.on('pageerror', (m) => console.log(name, String(m)))
    await page.goto(withState(`${site.url}figure/${widget}/`, tag, { version: 1, lab: widget, step: 0, params }))
    const figure = page.locator(`${widget}[data-state=live]`)
    await figure.waitFor()
    await page.waitForTimeout(2500)
    await figure.screenshot({ path: `/tmp/shot-${name}.png` })
    await page.close()
  }
} finally {
  await browser.close()
  await site.close?.()
  process.exit(0)
}
