// Pictures of every widget and of three regions of the page, light and dark, desktop and phone, against references.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { DESKTOP, PHONE, figure, open, unlock } from './harness.mjs'
import { TOLERANCE, compare, differenceOf, reference } from './snapshots.mjs'

const WIDGETS = ['odometry-hook', 'observer-bench', 'kalman-picture', 'observability-probe']
const REGIONS = [['head', '.chapter-head'], ['derivation', 'details.derivation'], ['quiz', 'form.quiz']]

/** Wherever the text above ends: a part of a pixel lower every letter is another. */
const onWholePixels = (part) => part.evaluate((it) => {
  it.style.position = 'relative'
  it.style.top = `${-((it.getBoundingClientRect().top + scrollY) % 1)}px`
})

for (const theme of ['light', 'dark']) {
  for (const [size, viewport] of [['desktop', DESKTOP], ['phone', PHONE]]) {
    test(`widgets and regions look as they did, ${theme}, ${size}`, { timeout: 180_000 }, async (t) => {
      // Tall enough for every figure: a picture of one that is taller than the window makes the page scroll as it is taken.
      const page = await open(t, { theme, viewport: { ...viewport, height: 2400 }, touch: size === 'phone' })
      await page.evaluate(() => document.fonts.ready)
      // Before a figure's question is answered: an answer stays open.
      for (const [name, selector] of REGIONS) {
        const region = page.locator(selector).first()
        if (name === 'derivation') await region.evaluate((block) => { block.open = true })
        await region.scrollIntoViewIfNeeded()
        await onWholePixels(region)
        compare(await region.screenshot({ animations: 'disabled' }), `${name}-${theme}-${size}`)
      }
      for (const tag of WIDGETS) {
        const element = await figure(page, tag)
        await unlock(page, await element.getAttribute('data-figure'))
        await page.mouse.move(0, 0)
        await onWholePixels(element)
        compare(await element.screenshot({ animations: 'disabled' }), `${tag}-${theme}-${size}`)
      }
    })
  }
}

test('a figure that lost what is coloured in it is refused', (t) => {
  for (const tag of WIDGETS) {
    for (const theme of ['light', 'dark']) {
      for (const size of ['desktop', 'phone']) {
        const { whole, pale } = reference(`${tag}-${theme}-${size}`)
        assert.equal(differenceOf(whole, whole).part, 0)
        const { part } = differenceOf(pale, whole)
        t.diagnostic(`${tag}-${theme}-${size}: ${(100 * part).toFixed(1)} % of its ink`)
        assert.ok(part > 4 * TOLERANCE, `${tag}-${theme}-${size} would differ in ${(100 * part).toFixed(1)} % of its ink`)
      }
    }
  }
})
