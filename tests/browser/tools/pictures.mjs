// The pictures of the README, light and dark: panels and controls of some figures. Run by scripts/pictures.
import { statSync, writeFileSync } from 'node:fs'
import path from 'node:path'
import { chromium } from 'playwright-core'
import { PNG } from 'pngjs'
import { serve } from '../../../scripts/static-server.mjs'
import { withState } from '../../../web/figure/state-in-url.js'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist, root } from '../places.mjs'

/**
 * Name of the picture, how many pixels it has for one of the page, the figure with its id, its lab, and the state to
 * show.
 * @type {[string, number, string, string, string, number, Record<string, unknown>][]}
 */
const PICTURES = [
  ['knob', 1.5, 'observer-bench', 'fig-bench', 'observer-bench', 12, {}],
  ['picture', 1, 'picture', 'fig-picture', 'picture', 0, {}],
  ['loop', 1, 'loop-closure', 'fig-loop', 'loop-closure', 120, {}],
]

const site = await serve({ folder: dist, base: BASE })
const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
try {
  for (const theme of /** @type {const} */ (['light', 'dark'])) {
    for (const [name, deviceScaleFactor, widget, id, lab, step, params] of PICTURES) {
      // As wide as in the chapter.
      const page = await browser.newPage({
        viewport: { width: 880 + 36, height: 1600 },
        deviceScaleFactor,
        colorScheme: theme,
        reducedMotion: 'reduce',
        serviceWorkers: 'block',
      })
      await page.goto(withState(`${site.url}figure/${widget}/`, id, { version: 1, lab, step, params }))
      const figure = page.locator(`${widget}[data-state=live]`)
      await figure.waitFor()
      await page.waitForFunction((tag) => document.querySelector(tag).settled, widget)
      await page.evaluate(() => document.fonts.ready)
      const { x, y, width } = /** @type {any} */ (await figure.boundingBox())
      const below = /** @type {any} */ (await figure.locator('.live .readouts').boundingBox())
      const shot = PNG.sync.read(
        await page.screenshot({
          animations: 'disabled',
          clip: { x: x - 8, y: y - 8, width: width + 16, height: below.y - y },
        }),
      )
      const file = path.join(root, 'content/images', `${name}-${theme}.png`)
      writeFileSync(file, PNG.sync.write(shot, { colorType: 2, deflateLevel: 9, filterType: -1 }))
      console.log(
        `content/images/${name}-${theme}.png: ${shot.width} × ${shot.height}, ` +
          `${Math.round(statSync(file).size / 1000)} kB`,
      )
      await page.close()
    }
  }
} finally {
  await browser.close()
  await site.close()
}
