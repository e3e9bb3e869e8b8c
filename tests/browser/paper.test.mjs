// On paper: every section open, stills instead of live figures, no controls, the addresses of links to be read.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { getDocument } from 'pdfjs-dist/legacy/build/pdf.mjs'
import { open, walkDown } from './harness.mjs'

/** The text of each page. */
async function pages(pdf) {
  const document = await getDocument({ data: new Uint8Array(pdf), verbosity: 0, isEvalSupported: false, useSystemFonts: false }).promise
  const texts = []
  for (let i = 1; i <= document.numPages; i++) {
    const { items } = await (await document.getPage(i)).getTextContent()
    texts.push(items.map((item) => item.str + (item.hasEOL ? ' ' : '')).join(''))
  }
  return texts
}

const plain = (text) => text.replace(/[\s\u00ad\u200b]+/g, '').normalize('NFKC')

/** The first words of each block that is closed on the screen. */
const firstWords = (page) => page.evaluate(() => [...document.querySelectorAll('main details:not(.numbers)')].flatMap((block) => {
  const first = [...block.querySelectorAll('p')].find((p) => !p.closest('summary') && !p.querySelector('.katex, .number, a') && p.textContent.trim().length > 30)
  return first ? [first.textContent.trim().slice(0, 30)] : []
}))

test('a PDF of the chapter has every section open and no controls', { timeout: 120_000 }, async (t) => {
  const page = await open(t)
  await walkDown(page)
  const closed = await firstWords(page)
  assert.ok(closed.length >= 5, `only ${closed.length} closed blocks were found`)
  const texts = await pages(await page.pdf({ format: 'A4', printBackground: true }))
  const whole = plain(texts.join(' '))
  t.diagnostic(`${texts.length} pages`)
  assert.deepEqual(closed.filter((words) => !whole.includes(plain(words))), [], 'these are not on paper')
  // Links lead nowhere on paper: their addresses are printed, each once.
  const addresses = await page.locator('main a[href^="http"]').evaluateAll((all) => all.map((link) => link.href))
  assert.ok(addresses.some((address) => address.startsWith('https://doi.org/')))
  const missing = addresses.filter((address) => whole.split(plain(address)).length !== 2)
  assert.deepEqual(missing, [], 'these are not on paper, or twice')
  // A figure's name, its picture and its words stay together.
  const figures = await page.locator('figure.figure-widget').evaluateAll((all) => all.map((it) => [(it.querySelector('.figure-title')?.lastChild ?? it.querySelector('figcaption .label')).textContent.trim(), it.querySelector('figcaption').textContent.trim().slice(0, 16)]))
  assert.ok(figures.length >= 4)
  const torn = figures.filter(([title, words]) => !texts.some((text) => plain(text).includes(plain(title)) && plain(text).includes(plain(words))))
  assert.deepEqual(torn, [], 'titles and captions on two pages')
  // What introduces something stands on its page.
  const lonely = texts.slice(0, -1).filter((text) => /(Answer|Worked answer|Starter|Hint|\.rs)\s*$/.test(text)).map((text) => text.slice(-60))
  assert.deepEqual(lonely, [])
})

test('with scripts off what is closed on the screen is open on paper', { timeout: 120_000 }, async (t) => {
  const page = await open(t, { scripts: false })
  const closed = await firstWords(page)
  assert.ok(closed.length >= 5, `only ${closed.length} closed blocks were found`)
  const whole = plain((await pages(await page.pdf({ format: 'A4', printBackground: true }))).join(' '))
  assert.deepEqual(closed.filter((words) => !whole.includes(plain(words))), [], 'these are not on paper')
})

test('in print the figures are stills and nothing to press is left', async (t) => {
  const page = await open(t)
  await walkDown(page)
  await page.emulateMedia({ media: 'print' })
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
  const seen = await page.evaluate(() => {
    const visible = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && element.getClientRects().length > 0
    return {
      controls: [...document.querySelectorAll('button, input, select, textarea')].filter(visible).map((element) => element.outerHTML.slice(0, 120)),
      stills: [...document.querySelectorAll('figure.figure-widget')].map((figure) => [...figure.querySelectorAll('svg')].filter(visible).length),
    }
  })
  assert.deepEqual(seen.controls, [])
  assert.ok(seen.stills.length >= 1 && seen.stills.every((count) => count >= 1), `pictures in each figure: ${seen.stills}`)
})

test('on paper a question has its reasons, an exercise its answer, a drawing its lines, and there is no progress', async (t) => {
  const page = await open(t)
  await walkDown(page)
  await page.emulateMedia({ media: 'print' })
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
  const hidden = await page.evaluate(() => {
    const printed = (element) => element?.checkVisibility({ visibilityProperty: true, opacityProperty: true }) && element.getClientRects().length > 0
    const lacks = (all, part) => [...document.querySelectorAll(all)].filter((it) => !printed(it.querySelector(part))).map((it) => it.id)
    return {
      // Answers stand at the end, apart from their questions.
      reasons: document.querySelectorAll('.quiz').length - [...document.querySelectorAll('.answers > .quiz-answer')].filter((it) => printed(it.querySelector('.quiz-why'))).length,
      prompts: lacks('.quiz', '.quiz-prompt'),
      answers: document.querySelectorAll('.exercise').length - [...document.querySelectorAll('.answers > .answer .details-body')].filter(printed).length,
      drawings: lacks('.figure-drawing', '.drawing svg .mark'),
      progress: [...document.querySelectorAll('.score')].filter(printed).length,
    }
  })
  assert.deepEqual(hidden, { reasons: 0, prompts: [], answers: 0, drawings: [], progress: 0 })
})
