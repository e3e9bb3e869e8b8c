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
  // Nothing is lost by that, until something else is typed.
  await again.getByRole('button', { name: 'Back to yours' }).click()
  await until(again, right, 'the text is there again')
  assert.equal(await area.inputValue(), LINES.join('\n'))
  await page.reload()
  await until(await figure(page, NAME), right, 'and the browser keeps it')
  await again.getByRole('button', { name: 'As it began' }).click()
  await until(again, ({ params }) => params.text === null, 'it is as it began')
  await area.fill('x = F x')
  await area.blur()
  await until(again, ({ params }) => params.text === 'x = F x', 'another is read')
  await again.getByRole('button', { name: 'As it began' }).waitFor()
  assert.equal(await again.getByRole('button', { name: 'Back to yours' }).count(), 0)
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

test('500 worlds are counted in a worker', async (t) => {
  const { it } = await openWriting(t, '?program=joseph')
  await it.locator('.live .panel-worlds', { hasText: 'over 500 worlds' }).waitFor()
  assert.deepEqual((await frameOf(it)).faults, [])
})

test('Cancel stops a count, and what comes after that is not shown', async (t) => {
  const { it } = await openWriting(t, '?program=joseph')
  const counted = (/** @type {number} */ count) =>
    it.locator('.live .panel-worlds', { hasText: `over ${count} worlds` })
  await counted(500).waitFor()
  // A worker that answers when it is told to, in the place of the figure's own.
  await it.evaluate((host) => {
    const { beside } = host.figure
    const { value } = beside
    host.asked = []
    /** @type {any} */
    const port = { post: (message) => host.asked.push(message), onmessage: null }
    host.found = (count) => port.onmessage({ kind: 'found', id: host.asked[0].id, found: { ...value, count } })
    beside.port = Promise.resolve(port)
  })
  await it.getByRole('button', { name: 'The short form' }).click()
  await counted(0).waitFor()
  // The bar with its button appears when a count has gone on for a while.
  await it.evaluate(async (host) => {
    const appeared = () => host.asked.length > 0 && !host.querySelector('.progress').hidden
    while (!appeared()) {
      if (host.asked.length > 0) host.found(20)
      await new Promise((resolve) => requestAnimationFrame(resolve))
    }
  })
  await counted(20).waitFor()
  await it.locator('.progress').getByRole('button', { name: 'Cancel' }).click()
  await it.locator('.progress').waitFor({ state: 'hidden' })
  // What was under way when the button was pressed comes still, and two frames are drawn.
  await it.evaluate(async (host) => {
    host.found(40)
    for (let frame = 0; frame < 2; frame += 1) {
      host.figure.ask()
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
    }
  })
  assert.match(String(await it.locator('.live .panel-worlds').textContent()), /over 20 worlds/)
  assert.deepEqual(await it.evaluate((host) => host.asked.map(({ kind }) => kind)), ['count', 'cancel'])
})

test('a copy says how long its test is, and a program that has none says why', async (t) => {
  const { it } = await openWriting(t, '?program=kalman')
  await it.locator('.write-copies summary').click()
  const said = it.locator('.write-copies .write-said')
  await said.filter({ hasText: /^main\.rs: its test is the first 10 steps of this run\.$/ }).waitFor()
  await it.getByRole('combobox', { name: 'Begin with' }).selectOption('sequential')
  await said.filter({ hasText: /^This program cannot be copied: .*p = 2/ }).waitFor()
  assert.equal(await it.getByRole('textbox', { name: 'The program in that language' }).isVisible(), false)
})
