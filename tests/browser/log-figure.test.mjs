// The figure of a robot's log in the chapter: its time line by keys and by a finger, and what paper shows of it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { PHONE, frameOf, open, openFigure, until } from './harness.mjs'

for (const touch of [false, true]) {
  test(`the time line is moved by ${touch ? 'a finger' : 'keys'}`, async (t) => {
    const { page, it } = await openFigure(t, 'robot-log', { viewport: PHONE, touch })
    const handle = it.locator('.live [role=slider][aria-label="Time of the drive"]')
    await handle.scrollIntoViewIfNeeded()
    const { step, rows } = await frameOf(it)
    assert.equal(step, rows)
    if (touch) {
      const { x, y, width, height } = await handle.boundingBox()
      const session = await page.context().newCDPSession(page)
      const at = (px) => [{ x: px, y: y + height / 2 }]
      await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(x + width / 2) })
      for (let i = 1; i <= 8; i++)
        await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(x + width / 2 - 12 * i) })
      await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
      await until(it, ({ step }) => step < rows * 0.9 && step > 0, 'the finger led back')
      return
    }
    await handle.focus()
    await page.keyboard.press('ArrowLeft')
    const back = await until(it, ({ step }) => step < rows, 'a step back')
    assert.match(await handle.getAttribute('aria-valuetext'), /\smin .* of 32\smin/)
    await page.keyboard.press('Home')
    await until(it, ({ step }) => step === 0, 'the start')
    await page.keyboard.press('End')
    await until(it, ({ step }) => step === rows, 'the end')
    assert.ok(back.step > rows * 0.9)
  })
}

test('the section on paper has the still, its panels and its title', async (t) => {
  const page = await open(t, { viewport: { width: 794, height: 1123 } })
  await page.emulateMedia({ media: 'print' })
  const still = page.locator('#fig-log .still')
  const { height } = await still.boundingBox()
  assert.ok(height > 500, `${height}`)
  assert.equal(await page.locator('#fig-log .still > .panel:visible').count(), 8)
  assert.ok(await page.locator('#fig-log .figure-title').isVisible())
  assert.ok(!(await page.locator('#fig-log .live').isVisible()))
})
