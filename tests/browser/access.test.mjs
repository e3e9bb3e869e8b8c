// Access: no axe violation on any page in either theme; keys, fingers and forced colours find what they need. What a
// reader calls up over a page is looked at in called-up.test.mjs.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { PNG } from 'pngjs'
import { COLOURS, faults, isAccessible } from './axe.mjs'
import { figure, FIGURE_PAGES, open, PAGES, PHONE, walkDown } from './harness.mjs'

const SOURCE = 'source/crates/estimate/src/kf.rs.html'
for (const at of [...PAGES, ...FIGURE_PAGES, SOURCE]) {
  test(`axe finds nothing on /${at} in both themes`, async (t) => {
    const page = await open(t, { at })
    if (at.startsWith('figure/')) await figure(page, at.split('/')[1])
    // Closed blocks are read too.
    await page.evaluate(() => {
      for (const block of document.querySelectorAll('details')) block.open = true
    })
    // Parts of the text are laid out, and what scrolls in them gets its name, when a reader comes near them.
    await walkDown(page)
    await isAccessible(page)
  })
}

test('axe finds nothing in the chapter on a phone, where colours are those of a desktop', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await walkDown(page)
  assert.equal(await faults(page, { without: COLOURS }), '')
})

test('by keys the first stop leads past the head, and each after it is in sight with nothing over it', async (t) => {
  const page = await open(t)
  await page.waitForLoadState('networkidle')
  await page.keyboard.press('Tab')
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the text')
  assert.ok((await page.locator('.skip-link').boundingBox()).x >= 0)
  await page.keyboard.press('Enter')
  assert.ok(await page.evaluate(() => document.activeElement === document.querySelector('main')))
  for (let stop = 0; stop < 120; stop++) {
    await page.keyboard.press('Tab')
    const fault = await page.evaluate(() => {
      const it = document.activeElement
      const { left, top, width, height } = it.getClientRects()[0] ?? new DOMRect()
      const over = document.elementFromPoint(left + width / 2, top + height / 2)
      const seen =
        it.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
        over &&
        (over.contains(it) || it.contains(over))
      return seen
        ? null
        : `${it.outerHTML.slice(0, 90)} at ${Math.round(left)}, ${Math.round(top)}, ` +
            `under ${over?.outerHTML.slice(0, 60)}`
    })
    assert.equal(fault, null)
  }
})

test('in forced colours no paper is painted between the letters of a formula', async (t) => {
  const page = await open(t, { prepare: (it) => it.emulateMedia({ forcedColors: 'active' }) })
  assert.deepEqual(
    await page
      .locator('.katex-html')
      .evaluateAll((all) => [...new Set(all.map((it) => getComputedStyle(it).forcedColorAdjust))]),
    ['none'],
  )
})

test('on a phone what stands alone and leads somewhere is at least 24 px wide and high', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await walkDown(page)
  const small = await page.evaluate(() => {
    const alone = (it) =>
      it.matches(
        'button, select, summary, textarea, :is(td, th) > a:not(.formula-numbers), .listing-path a, ' +
          '.quiz-figure a, .heading-link, .equation-number, input:not([type="radio"], [type="checkbox"])',
      )
    return [...document.querySelectorAll('a, button, input, select, textarea, summary')]
      .filter((it) => alone(it) && it.checkVisibility({ visibilityProperty: true }))
      .flatMap((it) => {
        const { width, height } = it.getBoundingClientRect()
        return width > 0 && (width < 24 || height < 24) && it.getClientRects().length === 1
          ? [`${it.outerHTML.slice(0, 80)}: ${width} × ${height}`]
          : []
      })
  })
  assert.deepEqual(small.slice(0, 10), [])
})

test('in forced colours a figure has its own paper, a slider its track, and the focus its ring', async (t) => {
  const page = await open(t, {
    theme: 'dark',
    prepare: (it) => it.emulateMedia({ forcedColors: 'active', colorScheme: 'dark' }),
  })
  await page.locator('[data-set-theme="light"]').click()
  const bench = await figure(page, 'observer-bench')
  const { paper, ink } = await bench.evaluate((it) => ({
    paper: getComputedStyle(it.querySelector('.live .panel')).backgroundColor,
    ink: getComputedStyle(it.querySelector('.live .axis')).stroke,
  }))
  const light = (colour) =>
    colour
      .match(/[\d.]+/g)
      .slice(0, 3)
      .reduce((sum, value) => sum + Number(value), 0) / 765
  assert.ok(!/, 0\)$/.test(paper) && Math.abs(light(paper) - light(ink)) > 0.3, `ink ${ink} on ${paper}`)

  const slider = bench.getByRole('slider', { name: /gain/i })
  await slider.focus()
  await page.keyboard.press('Home')
  const { style, width } = await slider.evaluate((it) => {
    const { outlineStyle: style, outlineWidth: width } = getComputedStyle(it)
    return { style, width }
  })
  assert.deepEqual({ style, width }, { style: 'solid', width: '2px' })
  await slider.evaluate((it) => it.blur())
  const picture = PNG.sync.read(await slider.screenshot())
  // Down a column far from the thumb: paper, track, paper.
  const x = Math.round(picture.width * 0.6)
  const column = Array.from({ length: picture.height }, (_, y) =>
    light([...picture.data.subarray(4 * (picture.width * y + x), 4 * (picture.width * y + x) + 3)].join(' ')),
  )
  const middle = column.slice(Math.round(picture.height * 0.35), Math.round(picture.height * 0.65))
  assert.ok(Math.max(...middle) - Math.min(...middle) > 0.5, 'there is a track')
})
