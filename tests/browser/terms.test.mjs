// A coloured word lights its kin in the nearest figure and says what it means. With the mouse, with the keys and with a
// finger.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, open, PHONE, quiet } from './harness.mjs'
import { listening, popover, rest } from './popover.mjs'

const KINDS = ['prediction', 'posterior', 'measurement', 'truth']
const lit = (page) =>
  page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('.widget[data-lit]')].map((widget) => [
        widget.closest('figure').id,
        widget.dataset.lit,
      ]),
    ),
  )
/** The figure whose box is nearest to an element. */
const nearest = (element) =>
  element.evaluate((word) => {
    const y = word.getBoundingClientRect().top
    const away = (figure) => {
      const { top, bottom } = figure.querySelector('.widget').getBoundingClientRect()
      return Math.max(top - y, y - bottom, 0)
    }
    return [...document.querySelectorAll('figure')]
      .filter((figure) => figure.querySelector('.widget'))
      .sort((a, b) => away(a) - away(b))[0].id
  })
/** A word of each colour that stands near a figure, in the text. */
const word = (page, kind) => page.locator(`main p a.term.term-${kind}`).first()

test('hovering a coloured word lights its kin in the nearest figure and shows what it means', async (t) => {
  const page = await open(t)
  await listening(page)
  for (const kind of KINDS) {
    const it = word(page, kind)
    await it.scrollIntoViewIfNeeded()
    await it.hover()
    await popover(page).waitFor({ state: 'visible' })
    const key = await it.getAttribute('data-term')
    const meaning = await page.locator(`#gloss-${key} dd`).evaluate((entry) => entry.textContent)
    assert.equal(
      await popover(page)
        .locator('dd')
        .first()
        .evaluate((entry) => entry.textContent),
      meaning,
    )
    assert.deepEqual(await lit(page), { [await nearest(it)]: kind })
    const box = await popover(page).boundingBox()
    const view = page.viewportSize()
    assert.ok(
      box.x >= 0 && box.x + box.width <= view.width && box.y >= 0 && box.y + box.height <= view.height,
      'all of it is on the screen',
    )
    await rest(page)
    await popover(page).waitFor({ state: 'hidden' })
    assert.deepEqual(await lit(page), {}, 'it goes out when the mouse leaves')
  }
})

test('in the lit figure its kin stay and the others fade, in a still and in a live one', async (t) => {
  const page = await open(t)
  await listening(page)
  const widget = await figure(page, 'observer-bench')
  const kin = widget.locator('xpath=ancestor::figure').locator('figcaption a.term, figcaption [data-kin]').first()
  const caption = (await kin.count()) ? kin : page.locator('a.term-posterior').first()
  await caption.scrollIntoViewIfNeeded()
  await caption.hover()
  const kind = await caption.evaluate((it) => it.dataset.kin)
  const id = await nearest(caption)
  assert.deepEqual(await lit(page), { [id]: kind })
  await quiet(page)
  const seen = await page.locator(`#${id} .widget`).evaluate((it, own) => {
    const shown = [...it.querySelectorAll('[data-kin]:not(.handle), .handle[data-kin] > *')].filter((mark) =>
      mark.checkVisibility(),
    )
    const opacity = (mark) => Number(getComputedStyle(mark).opacity)
    const kinOf = (mark) => mark.closest('[data-kin]').dataset.kin
    const isWord = (mark) => mark.matches('text, .readout')
    const others = shown.filter((mark) => kinOf(mark) !== own && !mark.matches('.handle-reach'))
    return {
      kin: shown.filter((mark) => kinOf(mark) === own).map(opacity),
      others: others.filter((mark) => !isWord(mark)).map(opacity),
      words: others.filter(isWord).map(opacity),
    }
  }, kind)
  assert.ok(seen.kin.length > 0 && seen.kin.every((opacity) => opacity > 0.9), `kin at ${seen.kin}`)
  assert.ok(seen.others.length > 0 && seen.others.every((opacity) => opacity < 0.5), `others at ${seen.others}`)
  assert.ok(seen.words.length > 0 && seen.words.every((opacity) => opacity === 1), 'words can still be read')
})

test('a coloured symbol in a formula lights its kin as its word does', async (t) => {
  const page = await open(t)
  await listening(page)
  for (const kind of KINDS.slice(0, 3)) {
    const it = page.locator(`main p .katex .term-${kind} i`).locator('visible=true').first()
    // What the symbol before has opened may lie over this one.
    await page.mouse.move(2, 2)
    await popover(page).waitFor({ state: 'hidden' })
    await it.scrollIntoViewIfNeeded()
    await rest(page)
    const { x, y, width, height } = await it.boundingBox()
    await page.mouse.move(x + width / 2, y + height / 2)
    assert.deepEqual(await lit(page), { [await nearest(it)]: kind })
  }
})

test('every coloured symbol and every number in a formula can be pointed at', async (t) => {
  const page = await open(t)
  await page.evaluate(() =>
    document.querySelectorAll('details').forEach((block) => {
      block.open = true
    }),
  )
  const { all, missed } = await page.evaluate(() => {
    // Each run of signs, as it stands on the page; the hats let the pointer through.
    const leaves = [
      ...document.querySelectorAll('main .katex :is([class*="term-"], [data-number]):not(math *)'),
    ].flatMap((part) => {
      const runs = []
      const texts = document.createTreeWalker(part, NodeFilter.SHOW_TEXT)
      while (texts.nextNode())
        if (!texts.currentNode.parentElement?.closest('.accent-body')) runs.push(texts.currentNode)
      return runs
    })
    const boxOf = (text) => {
      const range = document.createRange()
      range.selectNodeContents(text)
      return range.getBoundingClientRect()
    }
    const seen = leaves.filter((leaf) => boxOf(leaf).width > 2)
    const missed = seen.filter((leaf) => {
      const holder = /** @type {any} */ (leaf.parentElement)
      const box = holder.closest('.scroll-box, .katex-display') ?? holder
      box.scrollIntoView({ block: 'center' })
      holder.scrollIntoView({ block: 'nearest', inline: 'center' })
      const { left, top, width, height } = boxOf(leaf)
      return !holder
        .closest('[class*="term-"], [data-number]')
        .contains(document.elementFromPoint(left + width / 2, top + height / 2))
    })
    return {
      all: seen.length,
      missed: missed.map(
        (leaf) => `${leaf.textContent} in ${leaf.parentElement?.closest('.katex').textContent.slice(0, 80)}`,
      ),
    }
  })
  assert.ok(all > 200, `${all} symbols`)
  assert.deepEqual(missed, [])
})

test("the keys bring a word's meaning, Escape takes it away, Enter goes to the entry", async (t) => {
  const page = await open(t)
  await listening(page)
  const it = word(page, 'posterior')
  // From the link before it, by Tab.
  await it.evaluate((link) => {
    const links = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"]')].filter(
      (element) => element.checkVisibility() && !element.closest('[inert]'),
    )
    links[links.indexOf(link) - 1].focus()
  })
  await page.keyboard.press('Tab')
  assert.ok(await it.evaluate((link) => link === document.activeElement))
  await popover(page).waitFor({ state: 'visible' })
  assert.equal(await it.getAttribute('aria-describedby'), 'popover')
  assert.deepEqual(Object.values(await lit(page)), ['posterior'])
  await page.keyboard.press('Escape')
  await popover(page).waitFor({ state: 'hidden' })
  assert.equal(await it.getAttribute('aria-describedby'), null)
  await page.keyboard.press('Enter')
  await page.waitForURL(/#gloss-/)
  assert.ok(await page.evaluate(() => document.querySelector(location.hash).checkVisibility()))
})

test('a finger opens a word and a number, and a tap elsewhere closes them', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await listening(page)
  for (const it of [word(page, 'prediction'), page.locator('main p a.number').first()]) {
    const here = new URL(page.url()).hash
    await it.scrollIntoViewIfNeeded()
    await it.tap()
    await popover(page).waitFor({ state: 'visible' })
    assert.equal(new URL(page.url()).hash, here, 'the page stays where it is')
    const { x, width } = await popover(page).boundingBox()
    assert.ok(x >= 0 && x + width <= PHONE.width)
    if ((await it.getAttribute('class')).includes('term-'))
      assert.deepEqual(Object.values(await lit(page)), ['prediction'])
    // A second tap closes it too.
    await it.tap()
    await popover(page).waitFor({ state: 'hidden' })
    await it.tap()
    await popover(page).waitFor({ state: 'visible' })
    await page.locator('.site-title').evaluate((title) => title.scrollIntoView)
    await page.touchscreen.tap(3, 400)
    await popover(page).waitFor({ state: 'hidden' })
  }
})
