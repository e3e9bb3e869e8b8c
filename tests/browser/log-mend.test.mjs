// What the verdict names is set at a press below it, and undone at another; the focus and the page keep their place.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { frameOf, until } from './harness.mjs'
import { file, openLog } from './own-log.mjs'

/**
 * A circle among three landmarks, begun far from where the filter starts; ranges have an error of about 0.2 m. So long
 * that a verdict on it takes several frames.
 */
function circle() {
  const places = [
    [0, 0],
    [20, 2],
    [8, 18],
  ]
  const rows = places.map(([x, y], i) => `L,${i + 1},${x},${y}`)
  for (let k = 0; k < 2000; k++) {
    const t = k / 10
    const [x, y] = [10 + 5 * Math.sin(0.2 * t), 12 - 5 * Math.cos(0.2 * t)]
    rows.push(`V,${t},1,0.2`)
    const [px, py] = places[k % 3]
    if (k % 2 === 0) rows.push(`R,${t},${(k % 3) + 1},${Math.hypot(px - x, py - y) + 0.3 * Math.sin(7.3 * k * k)}`)
  }
  return file('circle.csv', rows.join('\n'))
}

test('a start that the verdict names is set at a press, and undone at another', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 1440, height: 900 } })
  assert.equal(await page.locator('.log-mend').isVisible(), false, 'nothing is named of the log that the page brings')
  await choose(circle())
  const bar = page.locator('robot-log .live .log-mend')
  const press = bar.getByRole('button', { name: 'Set the start so' })
  await press.waitFor()
  assert.match(await page.locator('.log-strip').innerText(), /The verdict names another start, which Fit does not look/)
  await press.focus()
  // How far it moves while it is there and waits: the next verdict may come within a frame.
  const moved = await press.evaluateHandle((one) => {
    const y = () => one.getBoundingClientRect().y
    const first = y()
    return {
      far: new Promise((told) => {
        let far = 0
        requestAnimationFrame(function look() {
          if (!one.isConnected) return told(far)
          far = Math.max(far, Math.abs(y() - first))
          requestAnimationFrame(look)
        })
      }),
    }
  })
  await press.press('Enter')
  const back = bar.getByRole('button', { name: 'Undo' })
  assert.equal(await back.evaluate((one) => one === document.activeElement), true, 'the next key undoes it')
  const far = await moved.evaluate(({ far }) => far)
  assert.ok(far < 0.5, `the press stays where it was while the next verdict comes: ${far}`)
  const { params } = await until(it, (frame) => frame.params.start && frame.judgement, 'the verdict from the start on')
  const [x, y] = params.start
  assert.ok(Math.hypot(x - 10, y - 7) < 0.5, `the robot started at 10 m, 7 m: ${x}, ${y}`)
  assert.equal(await press.count(), 0, 'the start is named no more')
  await back.press('Enter')
  await until(it, (frame) => frame.params.start === null && frame.judgement, 'the verdict as before')
  await press.waitFor()
  assert.equal(await back.isVisible(), false)
  assert.equal((await frameOf(it)).params.start, null)
})
