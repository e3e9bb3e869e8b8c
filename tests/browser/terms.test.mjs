// A coloured word lights its kin in the nearest figure and says what it means; a computed number says what computes it
// and which check watches over it. With the mouse, with the keys and with a finger.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, open, PHONE, quiet } from './harness.mjs'

const KINDS = ['prediction', 'posterior', 'measurement', 'truth']
const popover = (page) => page.locator('#popover')
/** Waits until the page listens. */
const listening = (page) => popover(page).waitFor({ state: 'attached' })
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
const rest = (page) => page.mouse.move(2, 2)
/**
 * Waits until an element has kept its place for a second: a part of the text that comes near is laid out, and a figure
 * in it comes to life.
 */
const resting = (it) =>
  it.evaluate(async (element) => {
    let [y, since] = [NaN, 0]
    while (performance.now() - since < 1000) {
      const { top } = element.getBoundingClientRect()
      if (top !== y) [y, since] = [top, performance.now()]
      await new Promise(requestAnimationFrame)
    }
  })

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
        if (!texts.currentNode.parentElement.closest('.accent-body')) runs.push(texts.currentNode)
      return runs
    })
    const boxOf = (text) => {
      const range = document.createRange()
      range.selectNodeContents(text)
      return range.getBoundingClientRect()
    }
    const seen = leaves.filter((leaf) => boxOf(leaf).width > 2)
    const missed = seen.filter((leaf) => {
      const holder = leaf.parentElement
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
        (leaf) => `${leaf.textContent} in ${leaf.parentElement.closest('.katex').textContent.slice(0, 80)}`,
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

/** The list of the chapter's numbers, by id. */
const entries = (page) =>
  page.evaluate(async () => {
    const list = new DOMParser().parseFromString(await (await fetch('numbers/')).text(), 'text/html')
    return Object.fromEntries(
      [...list.querySelectorAll('.number-entry')].map((entry) => [
        entry.id.replace('number-', ''),
        {
          value: entry.querySelector('.number-value')?.textContent,
          source: Boolean(entry.querySelector('.number-source')),
          check: Boolean(entry.querySelector('.number-check')),
        },
      ]),
    )
  })

test('a number whose list cannot be fetched says so, and is explained once the list is there', async (t) => {
  const page = await open(t, {
    expected: [/numbers\/|Failed to load|ERR_FAILED/],
    prepare: (it) => it.route('**/kalman/numbers/', (route) => route.abort()),
  })
  await listening(page)
  const number = page.locator('main p a.number').first()
  await number.focus()
  await popover(page).getByText('could not be fetched').waitFor()
  await page.keyboard.press('Escape')
  await page.unroute('**/kalman/numbers/')
  await number.evaluate((it) => it.blur())
  await number.focus()
  await popover(page).locator('.number-source').waitFor()
})

test('a number shows what computes it and which check pins it, hovered, focused, and inside a formula', async (t) => {
  const page = await open(t)
  await listening(page)
  const says = async (id) => {
    await popover(page).waitFor({ state: 'visible' })
    const [name, source, check] = await popover(page).evaluate((box) => [
      box.querySelector('dt code').textContent,
      box.querySelector('.number-source').href,
      box.querySelector('.number-check')?.href,
    ])
    assert.equal(name, id)
    assert.match(source, /\/source\/crates\/[a-z]+\/src\/.*\.rs\.html#L\d+$/)
    return check
  }
  // In the text, by mouse.
  const pinned = page.locator('main p a.number').filter({ visible: true })
  const ids = await pinned.evaluateAll((all) => all.map((number) => number.hash.replace('#number-', '')))
  const listed = await entries(page)
  const at = ids.findIndex((id) => listed[id].check)
  assert.ok(at >= 0, 'there is a number in the text that a check pins')
  await pinned.nth(at).scrollIntoViewIfNeeded()
  await resting(pinned.nth(at))
  await pinned.nth(at).hover()
  assert.match(await says(ids[at]), /\/check\/(index\.html)?#check-\d+$/)
  // The mouse can go into it and follow the link to the check.
  await popover(page).locator('.number-check').hover()
  await quiet(page)
  assert.ok(await popover(page).isVisible())
  await rest(page)
  await popover(page).waitFor({ state: 'hidden' })
  // By the keys.
  await pinned.nth(at).focus()
  await says(ids[at])
  await page.keyboard.press('Escape')
  // Digits inside a formula.
  const digits = page.locator('main .katex [data-number]:not(math *)').locator('visible=true').first()
  await digits.scrollIntoViewIfNeeded()
  await resting(digits)
  await digits.hover()
  await says(await digits.getAttribute('data-number'))
  await rest(page)
  await popover(page).waitFor({ state: 'hidden' })
  // And for the keys the mark beside the formula.
  const mark = page.locator('main p a.formula-numbers').first()
  await mark.focus()
  assert.ok(
    await mark.evaluate((it) => it.getBoundingClientRect().width > 5 && getComputedStyle(it).opacity === '1'),
    'what has the focus is to be seen',
  )
  await says((await mark.getAttribute('data-numbers')).split(' ')[0])
  // Enter goes to the list of all numbers.
  await page.keyboard.press('Enter')
  await page.waitForURL(/\/numbers\/#number-/)
  assert.ok(
    await page.evaluate(() => document.getElementById(decodeURIComponent(location.hash.slice(1))).checkVisibility()),
    'the entry is to be seen',
  )
})

test("every number printed is its entry's value, rounded", async (t) => {
  const page = await open(t)
  const listed = await entries(page)
  const printed = await page.evaluate(() =>
    [...document.querySelectorAll('main :is([data-number], a.number)')].map((number) => ({
      id: number.dataset.number ?? number.hash.replace('#number-', ''),
      text: number.textContent,
    })),
  )
  const all = printed.map(({ id, text }) => ({ id, text, ...listed[id] }))
  assert.ok(all.length > 150, `${all.length} numbers`)
  let read = 0
  for (const { id, text, value, source } of all) {
    assert.ok(value && source, `${id} has an entry`)
    const plain = text.replace(/[\s\u200b\u202f]/g, '').replace(/[−]/g, '-')
    const [, digits, percent] = /^(-?\d+(?:\.\d+)?)(%?)$/.exec(plain) ?? []
    // Powers of ten are written in two lines of text; the book's own tests read those.
    if (digits === undefined) continue
    read++
    const half = 0.5000001 * 10 ** -(digits.split('.')[1]?.length ?? 0)
    const exact = Number(value.replace('−', '-')) * (percent ? 100 : 1)
    assert.ok(Math.abs(Number(digits) - exact) <= half, `${id} is ${value}, printed ${text}`)
  }
  assert.ok(read > 0.8 * all.length, `${read} of ${all.length} could be read`)
})
