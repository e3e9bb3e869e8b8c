// The figure in which a reader writes a filter, in the page: what is typed is read when typing rests, undo takes it
// back, faults are marked beside their lines, the page's letters are the program's, and the text is in the link and
// kept by the browser.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, frameOf, open, until } from './harness.mjs'

const AT = 'kalman/filter/'
const NAME = 'write-filter'
const right = ({ outcome, params }) => outcome === 'right' && params.text !== null

/** @param {import('node:test').TestContext} t @param {string} [query] */
async function openWriting(t, query = '', wishes = {}) {
  const page = await open(t, { ...wishes, at: AT + query })
  const it = await figure(page, NAME)
  return { page, it, area: it.getByRole('textbox', { name: 'The program, a formula on each line' }) }
}

const LINES = [
  'x = F x + G u',
  "P = F P F' + V",
  'nu = y - H x',
  "S = H P H' + W",
  "R = P H' inv(S)",
  'x = x + R nu',
  'P = P - R H P',
]

test('a step typed from an empty box is called right, and is there again after a reload', async (t) => {
  const { page, it, area } = await openWriting(t)
  await it.getByRole('button', { name: 'Begin with an empty box' }).click()
  await until(it, ({ params }) => params.begin === 'empty', 'the box is empty')
  assert.equal(await area.inputValue(), '')
  assert.match(await it.locator('.live .verdict').innerText(), /^Nothing is written yet\./)
  assert.equal(await it.locator('.write-faults li').count(), 0)
  await area.focus()
  await page.keyboard.type(LINES.join('\n'))
  await until(it, right, 'the judge calls it right')
  assert.deepEqual((await frameOf(it)).faults, [])
  // Undo is the box's own: the program of one letter less is read again.
  await page.keyboard.press('Control+z')
  await until(it, ({ params }) => params.text !== LINES.join('\n'), 'undo is read')
  await page.keyboard.press('Control+Shift+z')
  await until(it, right, 'and what it took back')
  await page.reload()
  const again = await figure(page, NAME)
  await until(again, right, 'the browser has kept it')
  assert.equal(await area.inputValue(), LINES.join('\n'))
  await again.getByRole('button', { name: 'As it began' }).click()
  await until(again, ({ params }) => params.text === null, 'it is as it began')
  assert.equal(await area.inputValue(), '')
})

test('the chapter’s box, copied and pasted, is a right program in the letters of each notation', async (t) => {
  const page = await open(t)
  const steps = page.locator('#alg-kalman .algorithm-steps')
  const copied = {}
  for (const notation of ['choset', 'thrun', 'common']) {
    await page.evaluate((name) => document.querySelector(`[data-set-notation="${name}"]`).click(), notation)
    await page.waitForFunction((name) => (document.documentElement.dataset.letters ?? 'choset') === name, notation)
    await steps.evaluate((it) => {
      it.scrollIntoView({ behavior: 'instant' })
      getSelection()?.selectAllChildren(it)
    })
    await page.waitForFunction(() => {
      const clipboardData = new DataTransfer()
      document.dispatchEvent(new ClipboardEvent('copy', { clipboardData }))
      return clipboardData.getData('text/plain') !== ''
    })
    await page.keyboard.press('Control+c')
    copied[notation] = (await page.evaluate(() => navigator.clipboard.readText())).replace(/\r/g, '')
  }
  assert.match(copied.choset, /^x̂\(k\+1\|k\) = F x̂\(k\|k\) \+ G u\(k\) # \(8\.26\)$/m)
  assert.equal(copied.choset.split('\n').length, 8)
  const { it, area } = await openWriting(t, '?program=empty')
  for (const [notation, text] of Object.entries(copied)) {
    await it.page().evaluate((name) => (document.documentElement.dataset.notation = name), notation)
    await until(it, ({ params }) => params.notation === notation, notation)
    await area.fill(text)
    await area.blur()
    const { outcome, faults } = await until(it, ({ params }) => params.text === text, 'it is read')
    assert.deepEqual([outcome, faults], ['right', []], text)
  }
})

test('faults are listed with their places, marked beside their lines, and the first is said', async (t) => {
  const { it, area } = await openWriting(t)
  await area.fill(['x = F x + G u', 'P = F P F + q', 'y = H'].join('\n'))
  await area.blur()
  const { faults } = await until(it, (frame) => frame.faults.length > 0, 'faults')
  assert.deepEqual(
    await it.locator('.write-faults li').allInnerTexts(),
    faults.map(({ line, column, message }) => `Line ${line}, column ${column}: ${message}`),
  )
  const marked = await it.locator('.write-gutter .is-wrong').allInnerTexts()
  assert.deepEqual(
    marked.map((mark) => Number(mark.replace('▸', ''))),
    [...new Set(faults.map(({ line }) => line))],
  )
  assert.equal(await area.getAttribute('aria-invalid'), 'true')
  const status = it.locator('[role=status].visually-hidden')
  await status.filter({ hasText: `Line ${faults[0].line}, column ${faults[0].column}` }).waitFor({ state: 'attached' })
})

test('the page’s letters are the program’s, and the link has the text', async (t) => {
  const { page, it, area } = await openWriting(t, '?program=joseph')
  await until(it, ({ params }) => params.begin === 'joseph', 'the address names a program')
  await page.evaluate(() => (document.documentElement.dataset.notation = 'thrun'))
  await until(it, ({ params }) => params.notation === 'thrun', 'the letters change')
  assert.match(await area.inputValue(), /^mu = A mu \+ B u\nSigma = /)
  await area.fill(`${await area.inputValue()}\n# mine`)
  await area.blur()
  await until(it, right, 'it is right in any letters')
  await page.evaluate(() => (document.documentElement.dataset.notation = 'choset'))
  const { params } = await until(it, ({ params }) => params.notation === 'choset', 'and back')
  assert.match(params.text, /^x = F x \+ G u\n[\s\S]*# mine$/)
  await it.getByRole('button', { name: 'Copy link to this state' }).click()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  await page.evaluate(() => localStorage.clear())
  await page.goto(link)
  const linked = await figure(page, NAME)
  assert.equal((await until(linked, right, 'the link opens it')).params.text, params.text)
})

test('See it opens a bug with its line marked, and an exercise in place', async (t) => {
  const { page, it, area } = await openWriting(t, '?program=transposed#fig-filter')
  await until(it, ({ bug }) => bug === 'transposed', 'the bug is named')
  assert.match(await it.locator('.write-gutter .is-wrong').innerText(), /▸\s*3/)
  await page.locator('#ex-filter-mend-1').getByRole('link', { name: 'Begin with this program.' }).click()
  await until(it, ({ params }) => params.begin === 'mend-1', 'the exercise is open')
  await area.fill(LINES.join('\n'))
  await area.blur()
  await until(it, right, 'mended')
  const exercise = page.locator('#ex-filter-mend-1')
  await exercise
    .getByRole('button', { name: /Check|Look at/ })
    .first()
    .click()
})

test('500 worlds are counted in a worker, and a count can be stopped', async (t) => {
  const { it } = await openWriting(t, '?program=ekf')
  await until(it, ({ params }) => params.begin === 'ekf', 'the robot’s filter')
  const counted = () =>
    it.locator('.live .panel-worlds').evaluate((panel) => /over (\d+) worlds/.exec(panel.textContent)?.[1])
  await it.locator('.live .panel-worlds', { hasText: /over [1-9]\d* worlds/ }).waitFor()
  // The bar with its button appears after a moment only: this is what the button does.
  await it.evaluate((host) => host.figure.beside.cancel())
  const some = Number(await counted())
  assert.ok(some > 0 && some <= 500, `${some} worlds`)
  assert.equal(await it.evaluate((host) => host.figure.beside.progress), null)
  await it.getByRole('button', { name: 'Joseph’s form' }).click()
  await it.locator('.live .panel-worlds', { hasText: 'over 500 worlds' }).waitFor()
  assert.deepEqual((await frameOf(it)).faults, [])
})
