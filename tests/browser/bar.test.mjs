// A reader far down the page scrolls up a little, and has section, contents, search and letters at hand; reading on,
// the bar goes.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { DESKTOP, open, PHONE, quiet } from './harness.mjs'

const shown = (page) =>
  page
    .locator('.bar')
    .evaluate((bar) => bar.hasAttribute('data-shown') && getComputedStyle(bar).visibility === 'visible')
/** Scrolls by the wheel, as a hand does: in steps. */
async function wheel(page, by) {
  for (let i = 0; i < 6; i++) {
    await page.mouse.wheel(0, by / 6)
    await quiet(page, 3)
  }
  await quiet(page)
}

for (const [device, viewport] of Object.entries({ phone: PHONE, desktop: DESKTOP })) {
  test(`scrolling up brings the bar on a ${device}, reading on sends it away, the page does not move`, async (t) => {
    const page = await open(t, {
      viewport,
      prepare: (made) =>
        made.addInitScript(() => {
          globalThis.shifts = []
          new PerformanceObserver((list) =>
            globalThis.shifts.push(...list.getEntries().map(({ value }) => value)),
          ).observe({ type: 'layout-shift', buffered: true })
        }),
    })
    await page.locator('.toc [aria-current]').waitFor({ state: 'attached' })
    await page.evaluate(() =>
      document
        .querySelector('#mathematics, h2[id] ~ h3[id], main section:nth-of-type(7)')
        .scrollIntoView({ behavior: 'instant' }),
    )
    await quiet(page)
    await page.locator('.bar').waitFor({ state: 'attached' })
    await page.mouse.move(viewport.width / 2, 400)
    await wheel(page, 400)
    assert.equal(await shown(page), false, 'reading on')
    for (const by of [-20, -20, -20, 60]) {
      await page.evaluate((top) => scrollBy({ top, behavior: 'instant' }), by)
      await quiet(page)
      if (by < 0) assert.equal(await shown(page), false, 'the page itself has scrolled')
    }
    await page.evaluate(() => {
      globalThis.shifts = []
    })
    await wheel(page, -120)
    assert.equal(await shown(page), true, 'scrolling up')
    assert.deepEqual(await page.evaluate(() => globalThis.shifts), [], 'nothing moves when it comes')
    // It names the section that the contents mark.
    assert.equal(
      await page.locator('.bar-section').textContent(),
      await page.locator('.toc [aria-current]').textContent(),
    )
    assert.ok((await page.locator('.bar').boundingBox()).height <= 48)

    await page.locator('.bar').getByRole('button', { name: 'Search' }).click()
    await page.getByRole('dialog', { name: 'Search' }).waitFor()
    await page.keyboard.press('Escape')
    await page
      .locator('.bar')
      .getByRole('button', { name: /Letters: Choset/ })
      .click()
    await page.waitForFunction(() => document.documentElement.dataset.notation === 'thrun')
    await page
      .locator('.bar')
      .getByRole('button', { name: /Letters: Thrun/ })
      .click()
    await page
      .locator('.bar')
      .getByRole('button', { name: /Letters: Common/ })
      .click()
    await page
      .locator('.bar')
      .getByRole('button', { name: /Letters: Choset/ })
      .waitFor()
    if (device === 'phone') {
      const contents = page.locator('.bar').getByRole('button', { name: 'Contents' })
      // By keys: from the section's link one Tab leads there.
      await page.locator('.bar-section').focus()
      await page.keyboard.press('Tab')
      assert.ok(await contents.evaluate((button) => button === document.activeElement))
      const y = await page.evaluate(() => scrollY)
      await page.keyboard.press('Enter')
      await page.locator('.toc[data-open]').waitFor()
      assert.equal(await page.evaluate(() => scrollY), y, 'the contents open over the text')
      await page.keyboard.press('Escape')
      assert.ok(await contents.evaluate((button) => button === document.activeElement), 'and give the focus back')
      await contents.evaluate((button) => button.blur())
    }
    await wheel(page, 300)
    assert.equal(await shown(page), false, 'reading on again')
    // A link leads to a heading that nothing covers.
    await page.evaluate(() => {
      location.hash = '#problem'
    })
    await quiet(page)
    assert.equal(await shown(page), false, 'a jump')
  })
}

test('the contents on a phone close when the Tab key leads out of them', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  // Before its script has come the button does nothing.
  await page.waitForLoadState('networkidle')
  await page.locator('.site-header [data-open-contents]').focus()
  await page.keyboard.press('Enter')
  await page.locator('.toc[data-open]').waitFor()
  await page.locator('.toc a').last().focus()
  assert.equal(await page.locator('.toc[data-open]').count(), 1, 'they stay while a reader goes through them')
  await page.keyboard.press('Tab')
  assert.equal(await page.locator('.toc[data-open]').count(), 0)
  assert.ok(await page.evaluate(() => document.activeElement?.closest('main')), 'the focus is in the text')
})
