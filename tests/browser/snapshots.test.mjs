// Pictures of every figure, on its own page, and of three regions of the chapter, light and dark, desktop and phone,
// against references.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { DESKTOP, open, openFigure, PHONE, quiet, turn } from './harness.mjs'
import { colour, compare, differenceOf, reference, tolerance } from './snapshots.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

const REGIONS = [
  ['head', '.chapter-head'],
  ['derivation', 'details.derivation'],
  ['quiz', '.quiz'],
]
/** @type {[string, typeof PHONE][]} */
const SIZES = [
  ['desktop', DESKTOP],
  ['phone', PHONE],
]
/** On its own page a figure fills the window but for the margins. With these widths it is as wide as in the chapter. */
const FIGURE_WIDTHS = { desktop: 880 + 36, phone: 358 + 36 }
/**
 * Tall enough for every figure: a picture of one that is taller than the window makes the page scroll as it is taken.
 */
const TALL = 2400

/** Moves a part so that it begins on a whole pixel: a part of a pixel lower every letter is drawn differently. */
const onWholePixels = (part) =>
  part.evaluate((it) => {
    it.style.position = 'relative'
    it.style.top = '0'
    it.style.top = `${-((it.getBoundingClientRect().top + scrollY) % 1)}px`
  })

/** Compares a part of a page as it is in the light and in the dark. */
async function inBothThemes(page, part, name, size) {
  for (const theme of ['light', 'dark']) {
    await turn(page, theme)
    // What came to life above it meanwhile may have moved it by a part of a pixel.
    await onWholePixels(part)
    compare(await part.screenshot({ animations: 'disabled' }), `${name}-${theme}-${size}`)
  }
}

for (const [size, viewport] of SIZES) {
  test(`regions of the chapter look as they did, ${size}`, async (t) => {
    const page = await open(t, { viewport: { ...viewport, height: TALL }, touch: size === 'phone' })
    // All sections are laid out first: one above the region that came to be laid out later would move it by parts of a
    // pixel.
    await page.evaluate(() =>
      document.querySelectorAll('.chapter > section').forEach((section) => {
        section.style.contentVisibility = 'visible'
      }),
    )
    await page.evaluate(() => document.fonts.ready)
    for (const [name, selector] of REGIONS) {
      const region = page.locator(selector).first()
      if (name === 'derivation')
        await region.evaluate((block) => {
          block.open = true
        })
      await region.scrollIntoViewIfNeeded()
      // A question gets its controls when it comes near the screen.
      if (name === 'head') await page.locator('.vignette .handle').waitFor({ state: 'attached' })
      if (name === 'quiz') await region.locator('input').first().waitFor()
      await quiet(page)
      await inBothThemes(page, region, name, size)
    }
  })
  for (const tag of Object.keys(WIDGETS)) {
    test(`the ${tag} looks as it did, ${size}`, async (t) => {
      const { page, it } = await openFigure(t, tag, {
        viewport: { width: FIGURE_WIDTHS[size], height: TALL },
        touch: size === 'phone',
      })
      await page.evaluate(() => document.fonts.ready)
      await page.mouse.move(0, 0)
      await inBothThemes(page, it, tag, size)
    })
  }
}

test('a figure that lost what is coloured in it is refused', (t) => {
  for (const tag of Object.keys(WIDGETS)) {
    for (const theme of ['light', 'dark']) {
      for (const [size] of SIZES) {
        const whole = reference(`${tag}-${theme}-${size}`)
        assert.equal(differenceOf(whole, whole).part, 0)
        const part = colour(whole)
        t.diagnostic(`${tag}-${theme}-${size}: ${(100 * part).toFixed(1)} % of its ink`)
        assert.ok(
          part > 0.01 && part > 4 * tolerance(whole),
          `${tag}-${theme}-${size} would differ in ${(100 * part).toFixed(1)} % of its ink`,
        )
      }
    }
  }
})
