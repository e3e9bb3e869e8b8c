// Access: no axe violation on any page in either theme, nor in what a reader can call up over one.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { readFileSync } from 'node:fs'
import { PNG } from 'pngjs'
import { comeTo, figure, FIGURE_PAGES, open, PAGES, PHONE, quiet, turn, walkDown } from './harness.mjs'

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

/** The rules that read colours: nothing else on a page depends on its theme. */
const COLOURS = ['color-contrast', 'link-in-text-block']

/** What axe finds on the page as it stands, or in its parts that a selector names; of these rules, or of all. */
async function faults(page, { within, rules } = {}) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axe)
  const { violations } = await page.evaluate(
    ([parts, only]) =>
      globalThis.axe.run(parts ?? document, { resultTypes: ['violations'], ...(only && { runOnly: only }) }),
    [within, rules],
  )
  return violations
    .map(
      (rule) =>
        `${rule.id}: ${rule.help}\n` +
        rule.nodes
          .slice(0, 4)
          .map((node) => `    ${node.target.join(' ')} ${node.any.concat(node.all, node.none)[0]?.message ?? ''}`)
          .join('\n'),
    )
    .join('\n')
}

/** Axe finds nothing in the light theme, nor of colours in the dark one. */
async function isAccessible(page, within) {
  await turn(page, 'light')
  assert.equal(await faults(page, { within }), '', 'light')
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor)
  const light = await paper()
  await turn(page, 'dark')
  assert.notEqual(await paper(), light)
  assert.equal(await faults(page, { within, rules: COLOURS }), '', 'dark')
}

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

/**
 * Takes the sections out of the chapter, and the blocks of these except headings, that hold none of these elements: axe
 * measures everything that is laid out, and what is called up over the chapter changes nothing in them.
 */
const alone = (page, ...selectors) =>
  page.evaluate((kept) => {
    const holds = (block) => kept.some((selector) => block.matches(selector) || block.querySelector(selector))
    for (const section of document.querySelectorAll('.chapter > section')) section.hidden = !holds(section)
    for (const block of document.querySelectorAll('.chapter > section > :not(h2, h3, h4)')) block.hidden = !holds(block)
  }, selectors)

/** What a reader can call up, and what it is read with. */
const CALLED_UP = {
  'the search open': async (page) => {
    await page.locator('[data-open-search]').first().click()
    await page.locator('dialog.search input').fill('innovation')
    await page.locator('dialog.search li a').first().waitFor()
    await alone(page)
  },
  "Thrun's letters": async (page) => {
    await page.locator('[data-set-notation="thrun"]').click()
    await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
    await alone(page, '.in-thrun', '.widget')
    // Parts of the text are laid out, and what scrolls in them gets its name, when a reader comes near them.
    await walkDown(page)
  },
  'a term explained and its kin lit': async (page) => {
    const term = page.locator('.term-prediction.term, .term-posterior.term, .term-measurement.term').first()
    await term.focus()
    await page.locator('.popover:not([hidden])').waitFor()
    await page.locator('.widget[data-lit]').waitFor({ state: 'attached' })
    // The others fade.
    await quiet(page)
    await alone(page, ':focus', '[data-lit]')
    assert.ok((await page.locator('.popover').isVisible()) && (await page.locator('.widget[data-lit]').isVisible()))
  },
}
for (const [what, act] of Object.entries(CALLED_UP)) {
  test(`axe finds nothing with ${what}, in both themes`, async (t) => {
    const page = await open(t)
    await page.waitForLoadState('networkidle')
    await act(page)
    await isAccessible(page)
  })
}

test('axe finds nothing in the chapter on a phone', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await walkDown(page)
  assert.equal(await faults(page), '')
})

test('axe finds nothing with the contents called up on a phone, in both themes', async (t) => {
  const page = await open(t, { viewport: PHONE, touch: true })
  await page.waitForLoadState('networkidle')
  await page.locator('[data-open-contents]').tap()
  await page.locator('.toc[data-open]').waitFor()
  await alone(page)
  await isAccessible(page)
})

test('axe finds nothing in answered questions, their exercises and the progress, in both themes', async (t) => {
  const page = await open(t)
  const chapter = page.url()
  const answer = async (id, give) => {
    await comeTo(page, `#quiz-${id}`, `form#quiz-${id}`)
    const form = page.locator(`#quiz-${id}`)
    await give(form)
    await form.locator('[type=submit]').click()
    return form.getAttribute('data-answered')
  }
  const choose = (words) => (form) => form.locator('.quiz-choice').filter({ hasText: words }).locator('input').check()
  const type = (text) => (form) => form.getByRole('textbox').fill(text)
  assert.equal(await answer('one-landmark', choose('How far the whole scene is turned')), 'right')
  await comeTo(page, '[data-score]', '[data-score] h2')
  await isAccessible(page, ['#quiz-one-landmark', '[data-score]'])
  await page.goto(`${chapter}exercises/`)
  assert.equal(await answer('unseen-detectable', choose('does not grow')), 'wrong')
  assert.equal(await answer('unseen-direction', type('1 2 -1')), 'right')
  assert.equal(await answer('constant', type('7')), null, 'a wrong number may be mended once')
  assert.equal(await answer('constant', type('8')), 'wrong')
  await comeTo(page, '[data-score]', '[data-score] h2')
  await isAccessible(page, ['#ex-unseen', '#ex-constant', '[data-score]'])
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
