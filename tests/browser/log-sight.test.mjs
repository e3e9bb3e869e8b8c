// Files are chosen at the top of a page whose figure is further down: their answer comes into sight, once.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { PHONE, until } from './harness.mjs'
import { SMALL, drop, file, openLog } from './own-log.mjs'

const [GYRO, RANGES] = [
  ['gyro.csv', 'time (s),x (rad/s),y (rad/s),z (rad/s)\n0,0,0,0.1\n1,0,0,0.1\n2,0,0,0.1\n'],
  ['book.csv', 'L,7,3,4\nS,0,0.1\nR,0.5,7,4.9\nS,1,0.1\nR,1,7,4.8\n'],
]
const topOf = (it) => it.evaluate((element) => element.getBoundingClientRect().top)
const shown = (page) => page.locator('.log-answer p').filter({ hasText: 'Files: ' })

for (const viewport of [{ width: 1440, height: 900 }, { width: 900, height: 900 }, PHONE]) {
  test(`at ${viewport.width} px what was read comes into sight, and then nothing moves`, async (t) => {
    const { page, it, choose, answer } = await openLog(t, { viewport })
    await choose(file('small.csv', SMALL))
    await shown(page).filter({ hasText: 'small.csv' }).waitFor()
    await page.waitForFunction(() => scrollY > 200)
    const top = await topOf(answer)
    assert.ok(top >= 0 && top < 120, `the answer is at ${top}`)
    const figure = await topOf(it)
    assert.ok(figure > 0 && figure < viewport.height / 2, `the figure is at ${figure}`)
    await until(it, ({ summary }) => summary.used === 2, 'the ranges correct')
    assert.ok(Math.abs((await topOf(answer)) - top) < 1, 'nothing moves once it is there')
  })
}

test('a page whose reader presses while a file is read stays where it is', async (t) => {
  const { page } = await openLog(t)
  const stood = await page.evaluate(
    ([name, text]) => {
      const data = new DataTransfer()
      data.items.add(new File([text], name))
      const heading = document.querySelector('h1')
      heading.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
      heading.dispatchEvent(new PointerEvent('pointerdown', { bubbles: true }))
      return scrollY
    },
    ['small.csv', SMALL],
  )
  await shown(page).filter({ hasText: 'small.csv' }).waitFor()
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))))
  assert.equal(await page.evaluate(() => scrollY), stood)
})

test('a question is marked where it is answered, and the log that comes of it corrects with its ranges', async (t) => {
  const { page, it } = await openLog(t)
  await drop(page, [GYRO, RANGES])
  const asked = page.locator('.log-file .asked')
  await asked.waitFor()
  assert.equal(await asked.count(), 1)
  assert.equal(await page.locator('.log-file.asks > .log-value').count(), 3, 'what it is, the time, and what is asked')
  await asked.locator('select').selectOption({ label: 'z (rad/s)' })
  await until(it, ({ params, summary }) => params.sightings && summary.used === 2, 'the ranges are used')
  assert.equal(await page.locator('.log-file .asked').count(), 0)
})
