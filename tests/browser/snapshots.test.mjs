// Pictures of every widget and of three regions of the page, light and dark, desktop and phone, against references.
import { test } from 'node:test'
import { DESKTOP, PHONE, figure, open } from './harness.mjs'
import { compare } from './snapshots.mjs'

const WIDGETS = ['odometry-hook', 'observer-bench', 'kalman-picture', 'observability-probe']
const REGIONS = [['head', '.chapter-head'], ['derivation', 'details.derivation'], ['quiz', 'form.quiz']]

for (const theme of ['light', 'dark']) {
  for (const [size, viewport] of [['desktop', DESKTOP], ['phone', PHONE]]) {
    test(`widgets and regions look as they did, ${theme}, ${size}`, { timeout: 180_000 }, async (t) => {
      // Tall enough for every figure: a picture of one that is taller than the window makes the page scroll as it is taken.
      const page = await open(t, { theme, viewport: { ...viewport, height: 2400 }, touch: size === 'phone' })
      await page.evaluate(() => document.fonts.ready)
      for (const tag of WIDGETS) {
        const element = await figure(page, tag)
        await page.mouse.move(0, 0)
        // On whole pixels, wherever the text above ends.
        await element.evaluate((it) => { it.style.top = `${-((it.getBoundingClientRect().top + scrollY) % 1)}px` })
        compare(await element.screenshot({ animations: 'disabled' }), `${tag}-${theme}-${size}`)
      }
      for (const [name, selector] of REGIONS) {
        const region = page.locator(selector).first()
        if (name === 'derivation') await region.evaluate((block) => { block.open = true })
        await region.scrollIntoViewIfNeeded()
        compare(await region.screenshot({ animations: 'disabled' }), `${name}-${theme}-${size}`)
      }
    })
  }
}
