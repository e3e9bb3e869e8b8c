// On paper: every section open, stills instead of live figures, no controls, the addresses of links to be read. A print
// of the chapter takes long, so one serves all claims.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { getDocument } from 'pdfjs-dist/legacy/build/pdf.mjs'
import { EXERCISES, open, openFigure, walkDown } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'
import { printed, reproducible } from './tools/pdf.mjs'

/** The chapter has about 57 pages. What makes it longer by more than a few is looked at on paper first. */
const PAGES_AT_MOST = 59

/** A PDF, to be read. */
const reading = (pdf) =>
  getDocument({ data: new Uint8Array(pdf), verbosity: 0, isEvalSupported: false, useSystemFonts: false }).promise

/** The text of each page. */
async function pages(pdf) {
  const document = await reading(pdf)
  const texts = []
  for (let i = 1; i <= document.numPages; i++) {
    const { items } = await (await document.getPage(i)).getTextContent()
    texts.push(items.map((/** @type {any} */ item) => item.str + (item.hasEOL ? ' ' : '')).join(''))
  }
  return texts
}

/**
 * Whether a PDF has a structure for screen readers, a title, a language, and a bookmark for each section; and no
 * address of the server.
 */
async function isTaggedWithBookmarks(pdf, sections) {
  const document = await reading(pdf)
  assert.equal((await document.getMarkInfo())?.Marked, true)
  const info = /** @type {any} */ ((await document.getMetadata()).info)
  assert.match(info.Title, /Kalman/)
  assert.match(info.Language, /^en/)
  const titles = []
  const collect = (items) =>
    items.forEach((item) => {
      titles.push(plain(item.title))
      collect(item.items)
    })
  collect(await document.getOutline())
  assert.ok(sections.length >= 10)
  assert.deepEqual(
    sections
      .map((it) => plain(it).replace(/#$/, ''))
      .filter((it) => !titles.some((title) => title.includes(it) || it.includes(title))),
    [],
    'sections without a bookmark',
  )
  const kinds = JSON.stringify(await (await document.getPage(1)).getStructTree())
  assert.ok(kinds.includes('"role":"H1"') && kinds.includes('"role":"P"'), kinds.slice(0, 300))
  for (let i = 1; i <= document.numPages; i++) {
    const links = await (await document.getPage(i)).getAnnotations()
    assert.deepEqual(
      links.map(({ url }) => url).filter((url) => url?.includes('127.0.0.1')),
      [],
      `page ${i}`,
    )
  }
}

/** Which of these words stand on paper with nothing of their column right below them. */
async function alone(pdf, names) {
  const document = await reading(pdf)
  const found = []
  let seen = 0
  for (let i = 1; i <= document.numPages; i++) {
    /** @type {any[]} */
    const texts = (await (await document.getPage(i)).getTextContent()).items
    const items = texts.filter(({ str }) => str.trim())
    for (const [
      n,
      {
        str,
        transform: [, , , , x, y],
      },
    ] of items.entries()) {
      if (!names.has(str.trim())) continue
      seen += 1
      const next = items[n + 1]?.transform
      if (!(next && Math.abs(next[4] - x) < 12 && next[5] < y && next[5] > y - 24)) found.push(`page ${i}: ${str}`)
    }
  }
  return { found, seen }
}

const plain = (text) => text.replace(/[\s\u00ad\u200b]+/g, '').normalize('NFKC')

/** The first words of each block that is closed on the screen. */
const firstWords = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('main details:not(.numbers)')].flatMap((block) => {
      const first = [...block.querySelectorAll('p')].find(
        (p) => !p.closest('summary') && !p.querySelector('.katex, .number, a') && p.textContent.trim().length > 30,
      )
      return first ? [first.textContent.trim().slice(0, 24)] : []
    }),
  )

test('a PDF of the chapter, where nobody came near anything, has every section open and every drawing', async (t) => {
  const page = await open(t)
  // Headless Chromium 148 prints without what is to come late; the page asks for it when it is printed.
  await page.pdf({ format: 'A4', pageRanges: '1' })
  await page.waitForLoadState('networkidle')
  await page.waitForFunction(() => [...document.querySelectorAll('img.panel')].every((image) => image.complete))
  const closed = await firstWords(page)
  assert.ok(closed.length >= 5, `only ${closed.length} closed blocks were found`)
  const addresses = await page.locator('main a[href^="http"]').evaluateAll((all) => all.map((link) => link.href))
  const sections = await page.locator('main h2:not(.score-title)').allTextContents()
  const pdf = await printed(page)
  const texts = await pages(pdf)
  const whole = plain(texts.join(' '))
  t.diagnostic(`${texts.length} pages`)
  assert.ok(texts.length <= PAGES_AT_MOST, `${texts.length} pages`)
  // Each choice has a box to tick, also that of a question which has not been on the screen.
  assert.equal(texts.join('').split('☐').length - 1, await page.locator('.quiz-choice').count())
  assert.deepEqual(
    closed.filter((words) => !whole.includes(plain(words))),
    [],
    'these are not on paper',
  )
  // Drawings are printed also where they are files that come late, each with its words.
  for (const words of ['gain R(k) and its knob g', 'below the maximum:', 'density of', 'of the heading (degrees)'])
    assert.ok(whole.includes(plain(words)), `${words} is not on paper`)
  // Links lead nowhere on paper: their addresses are printed, each once.
  assert.ok(addresses.some((address) => address.startsWith('https://doi.org/')))
  const missing = addresses.filter((address) => whole.split(plain(address)).length !== 2)
  assert.deepEqual(missing, [], 'these are not on paper, or twice')
  // A figure's name, its picture and its words stay together.
  const figures = await page
    .locator('figure.figure-widget')
    .evaluateAll((all) =>
      all.map((it) => [
        (it.querySelector('.figure-title')?.lastChild ?? it.querySelector('figcaption .label')).textContent.trim(),
        it.querySelector('figcaption').textContent.trim().slice(0, 16),
      ]),
    )
  assert.ok(figures.length >= 4)
  const torn = figures.filter(
    ([title, words]) => !texts.some((text) => plain(text).includes(plain(title)) && plain(text).includes(plain(words))),
  )
  assert.deepEqual(torn, [], 'titles and captions on two pages')
  // What introduces something stands on its page.
  const lonely = texts
    .slice(0, -1)
    .filter((text) => /(Answer|Worked answer|Starter|Hint|\.rs)\s*$/.test(text))
    .map((text) => text.slice(-60))
  assert.deepEqual(lonely, [])
  const kinds = await page.locator('.note-kind:has(+ .note-title)').allTextContents()
  const { found, seen } = await alone(pdf, new Set(kinds.map((it) => it.trim())))
  assert.ok(seen >= kinds.length, `${seen} of ${kinds.length} kinds of notes were found`)
  assert.deepEqual(found, [], 'kinds of notes without their titles')
  const kept = reproducible(pdf)
  assert.equal(kept.length, pdf.length)
  await isTaggedWithBookmarks(kept, sections)
})

test('two prints of a page are the same file', async (t) => {
  const prints = []
  for (const before of [0, 5]) {
    const page = await open(t, { at: 'teaching/' })
    // Another browser's numbers for what is tagged; another second.
    await page.evaluate((count) => {
      for (let i = 0; i < count; i++) document.body.append(document.createElement('p'))
    }, before)
    await page.evaluate(() => {
      for (const p of document.querySelectorAll('body > p:empty')) p.remove()
    })
    // The next one has another date.
    await page.evaluate(async (then) => {
      while (Date.now() < then) await new Promise((resolve) => requestAnimationFrame(resolve))
    }, Date.now() + 1100)
    prints.push(await printed(page))
  }
  assert.ok(!prints[0].equals(prints[1]), 'the browser dates what it prints')
  assert.ok(reproducible(prints[0]).equals(reproducible(prints[1])))
})

test('with scripts off what is closed on the screen is open on paper', async (t) => {
  const page = await open(t, { scripts: false })
  const closed = await firstWords(page)
  assert.ok(closed.length >= 5, `only ${closed.length} closed blocks were found`)
  const whole = plain((await pages(await page.pdf({ format: 'A4', printBackground: true }))).join(' '))
  assert.deepEqual(
    closed.filter((words) => !whole.includes(plain(words))),
    [],
    'these are not on paper',
  )
  assert.ok(whole.includes('belowthemaximum:'), 'a drawing far down the page is on paper')
})

for (const [at, least] of /** @type {[string, number][]} */ ([
  ['kalman/', 40],
  [EXERCISES, 10],
]))
  test(`in print nothing to press is left on /${at}; figures and questions are as paper needs them`, async (t) => {
    // As wide as a sheet between its margins.
    const page = await open(t, { at, viewport: { width: 688, height: 1000 } })
    await walkDown(page)
    await page.emulateMedia({ media: 'print' })
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
    await page.evaluate(() => document.fonts.ready)
    const { stills, formulas, ...faults } = await page.evaluate(() => {
      const printed = (element) =>
        element?.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
        element.getClientRects().length > 0
      const all = (selector, of = document) => [...of.querySelectorAll(selector)]
      const lacks = (whole, part) => all(whole).flatMap((it) => (printed(it.querySelector(part)) ? [] : [it.id]))
      const boxes = all('.chapter .equation-body').filter((box) => box.getClientRects().length > 0)
      const over = (box) => (formula) => {
        const range = document.createRange()
        range.selectNodeContents(formula)
        const over = range.getBoundingClientRect().width - box.clientWidth
        return over > 1 ? [`${Math.round(over)} px: ${formula.textContent.slice(0, 60)}`] : []
      }
      return {
        stills: all('figure.figure-widget').map((figure) => all('.still > .panel', figure).filter(printed).length),
        formulas: boxes.length,
        controls: all('button, input, select, textarea')
          .filter(printed)
          .map((element) => element.outerHTML.slice(0, 120)),
        // Answers stand at the end, apart from their questions.
        reasons:
          all('.quiz').length -
          all('.answers > .quiz-answer').filter((it) => printed(it.querySelector('.quiz-why'))).length,
        prompts: lacks('.quiz', '.quiz-prompt'),
        answers: all('.exercise').length - all('.answers > .answer .details-body').filter(printed).length,
        drawings: lacks('.figure-drawing', '.drawing svg .mark'),
        progress: all('.score').filter(printed).length,
        // No two answers have the same name.
        twice: all('.answer-of')
          .map((it) => it.textContent)
          .filter((name, i, names) => names.indexOf(name) < i),
        // Pixels of paper: five points are 6.67.
        small: all('.still svg.panel')
          .filter((panel) => printed(panel) && panel.getScreenCTM().a * 12 < 6.67)
          .map((panel) => `${panel.closest('figure').id} ${panel.getAttribute('class')}`),
        wide: boxes.flatMap((box) => all('.katex-html', box).flatMap(over(box))),
      }
    })
    assert.ok(stills.length >= 1 && stills.every((count) => count >= 1), `pictures in each figure: ${stills}`)
    assert.ok(formulas > least, `${formulas} formulas`)
    const none = { controls: [], reasons: 0, prompts: [], answers: 0, drawings: [], progress: 0, twice: [], small: [] }
    assert.deepEqual(faults, { ...none, wide: [] })
  })

for (const tag of Object.keys(WIDGETS)) {
  test(`the page of the ${tag} prints what the figure shows, and no control`, async (t) => {
    const { page, it: element } = await openFigure(t, tag, { theme: 'dark' })
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' })
    const { controls, panels, ground } = await element.evaluate((it) => ({
      controls: [...it.querySelectorAll('button, input, select, summary')]
        .filter((control) => control.checkVisibility())
        .map((control) => control.textContent || control.ariaLabel),
      panels: [...it.querySelectorAll('.live .panel')].filter((panel) => panel.checkVisibility()).length,
      ground: getComputedStyle(document.body).getPropertyValue('--ink'),
    }))
    assert.deepEqual(controls, [])
    assert.ok(panels > 0, 'its panels')
    const light = await page.evaluate(() => {
      document.documentElement.dataset.theme = 'light'
      return getComputedStyle(document.body).getPropertyValue('--ink')
    })
    assert.equal(ground, light, 'ink for paper, also of a dark page')
  })
}
