// What the small figures do that no frame tells: an ellipse that grows before the reader's eyes, and a copy that is put
// down beside a cart under way.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { frameOf, openFigure, until } from './harness.mjs'

test('the ellipse grows to its touch before it is said where, and is small again under the next guess', async (t) => {
  const { page, it } = await openFigure(t, 'touch', { motion: 'no-preference' })
  const named = it.locator('.live svg text', { hasText: 'purple foot' })
  assert.equal(await named.count(), 0)
  await it.evaluate((host) => {
    const ellipse = host.querySelector('.live svg .outline.prediction')
    host.shapes = new Set([ellipse.getAttribute('d')])
    new MutationObserver(() => {
      if (!host.querySelector('.live svg circle.full.posterior')) host.shapes.add(ellipse.getAttribute('d'))
    }).observe(ellipse, { attributes: true })
  })
  await it.getByRole('button', { name: 'Grow' }).click()
  await named.waitFor()
  assert.ok((await it.evaluate((host) => host.shapes.size)) > 3, 'it grew on the way')
  const { touch, params } = await frameOf(it)
  assert.ok(params.grown && touch[0] < 4)
  await it.locator('.live svg [role=slider]').press('ArrowLeft')
  await until(it, (frame) => !frame.params.grown, 'another guess')
  await named.waitFor({ state: 'detached' })
  await page.waitForFunction(() => document.querySelector('lab-touch').settled)
})

test('a copy that is put down starts the run anew, and the cart stays where it was', async (t) => {
  const { it } = await openFigure(t, 'cart-copy')
  const step = it.getByRole('button', { name: 'Step', exact: true })
  for (let presses = 0; presses < 5; presses++) await step.click()
  await until(it, (frame) => frame.step === 9, 'five steps')
  const before = await frameOf(it)
  await it.getByRole('slider', { name: 'Position of the copy' }).press('Shift+ArrowRight')
  await until(it, (frame) => frame.step === 0, 'the start')
  const after = await frameOf(it)
  assert.deepEqual(after.truth, before.truth)
  assert.ok(Math.abs(after.error[0] + 0.5) < 1e-12, `${after.error}`)
  await step.click()
  await until(it, (frame) => frame.step === 1, 'a step')
  assert.ok(Math.abs((await frameOf(it)).error[0] + 0.5) < 1e-12, 'no gain takes it away')
})

test('a press anywhere in the cloud takes the error that is nearest', async (t) => {
  const { page, it } = await openFigure(t, 'error-cloud', { touch: true })
  const ring = it.getByRole('slider', { name: 'The error that is touched' })
  const place = async () => {
    const { x, y, width, height } = await ring.boundingBox()
    return [x + width / 2, y + height / 2]
  }
  const before = (await frameOf(it)).params.dot
  const [[x, y], plane] = [await place(), await it.locator('.live svg').first().boundingBox()]
  // Where the ring is, mirrored in the middle of the drawing.
  await page.touchscreen.tap(2 * plane.x + plane.width - x, 2 * plane.y + plane.height - y)
  await until(it, ({ params }) => params.dot !== before, 'another error')
  const [nowX, nowY] = await place()
  assert.ok(Math.hypot(nowX + x - 2 * plane.x - plane.width, nowY + y - 2 * plane.y - plane.height) < 40)
})
