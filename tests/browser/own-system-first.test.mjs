// What a reader of the page of an own system sees first, and that nothing which is pressed there moves.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, open, openFigure, until } from './harness.mjs'

const TAG = 'own-system'

for (const [width, height, whole] of /** @type {[number, number, boolean][]} */ ([
  [390, 844, true],
  [360, 640, false],
  [900, 1100, true],
  [1440, 900, true],
])) {
  test(`the way in is on the first screen of ${width} by ${height}`, async (t) => {
    const page = await open(t, { at: 'system/', viewport: { width, height } })
    const it = await figure(page, TAG)
    const ends = async (/** @type {any} */ locator) => {
      const box = await locator.boundingBox()
      return box.y + box.height
    }
    // Whoever waits for a figure brings it into sight; a reader has not scrolled.
    await page.evaluate(() => scrollTo({ top: 0, behavior: 'instant' }))
    assert.ok((await ends(it.getByRole('combobox', { name: 'Preset' }))) < height)
    const paste = it.getByRole('button', { name: 'Paste a system' })
    assert.ok((await ends(paste)) < height)
    if (whole) assert.ok((await ends(it.getByRole('group', { name: 'Matrix F' }))) < height)
    // What opens stands below the button, which stays where it is.
    const before = await paste.boundingBox()
    const scrolled = await page.evaluate(() => scrollY)
    await paste.click()
    const area = it.locator('.own-paste textarea')
    await area.waitFor()
    const after = await paste.boundingBox()
    const moved = (await page.evaluate(() => scrollY)) - scrolled
    assert.ok(after && before && Math.abs(after.y + moved - before.y) < 1)
    const box = await area.boundingBox()
    assert.ok(box && box.y >= after.y + after.height)
  })
}

test('a program that is copied stands below its button, and a paste stays open beside it', async (t) => {
  const { it } = await openFigure(t, TAG)
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const paste = it.locator('.own-paste textarea').first()
  await paste.fill('F = [1 0; 0 0.5]\nH = [1 0]\nV = eye(2)\nW = 2')
  await until(it, ({ params }) => params.w[0][0] === 2, 'the system is taken')
  const copy = it.getByRole('button', { name: 'Copy as numpy' })
  await copy.scrollIntoViewIfNeeded()
  const before = await copy.boundingBox()
  await copy.click()
  await it.getByText('The system in numpy, copied').waitFor()
  const after = await copy.boundingBox()
  assert.ok(before && after && Math.abs(after.y - before.y) < 1)
  assert.match(await paste.inputValue(), /^F = \[1 0; 0 0\.5\]/)
})

test('beside a system of the reader’s own no phrase speaks of a preset, and placing keeps the system', async (t) => {
  const { it } = await openFigure(t, TAG)
  const velocity = it.getByRole('button', { name: 'Read the velocity alone' })
  assert.equal(await velocity.isVisible(), true)
  await it.getByRole('textbox', { name: 'F, row 1, column 2' }).fill('0.7')
  await until(it, ({ params }) => params.f[0][1] === 0.7, 'the entry is taken')
  await velocity.waitFor({ state: 'hidden' })
  await it.getByRole('button', { name: 'Place the eigenvalues yourself' }).click()
  const { params, placed } = await until(it, ({ params }) => params.gain === 'placement', 'a gain by placement')
  assert.deepEqual([params.f[0][1], placed], [0.7, true])
})
