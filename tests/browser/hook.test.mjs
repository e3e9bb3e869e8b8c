// The odometry figure with the wheel's bias as a state: what is learned, by the reader's own hand.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { frameOf, openFigure, until } from './harness.mjs'

test('the plot of the wheel comes with the switch, and the bias is learned with fixes and not without', async (t) => {
  const { page, it } = await openFigure(t, 'odometry-hook')
  const plot = it.locator('.live .panel-wheel:not([hidden])')
  assert.equal(await plot.count(), 0, 'calm at first')
  assert.equal(await it.locator('.live .readout').filter({ hasText: 'Learned bias' }).isVisible(), false)
  await it.getByRole('button', { name: 'Learn the wheel' }).click()
  const learned = await until(it, ({ step, wheel }) => step === 640 && wheel, 'a lap')
  assert.ok(
    Math.abs(learned.wheel.epsilon - learned.wheel.truth) < 3 * learned.wheel.sigma && learned.wheel.sigma < 0.0013,
    JSON.stringify(learned.wheel),
  )
  assert.equal(await plot.count(), 1)
  assert.ok((await plot.locator('.mark.curve').count()) >= 4)
  // The size of the heading's error, as its plot has it.
  assert.match(
    await it.locator('.live .readout').filter({ hasText: 'Heading error' }).locator('dd').textContent(),
    /^[\d.]+°$/,
  )
  assert.equal(
    await it.locator('.live .verdict i').filter({ hasText: 'σ' }).count(),
    3,
    'a σ of the status is the σ of the labels',
  )
  // The dot below the plot goes back in the drive, by keys.
  const cursor = plot.getByRole('slider', { name: 'Tick shown on the map' })
  await cursor.press('Home')
  await until(it, ({ step, wheel }) => step === 0 && wheel.epsilon === 0, 'Home')
  await cursor.press('End')
  await until(it, ({ step }) => step === 640, 'End')
  await it.getByRole('checkbox', { name: 'landmark fixes' }).uncheck()
  const blind = await until(it, ({ params }) => !params.fixes, 'without fixes')
  assert.deepEqual([blind.wheel.epsilon, blind.wheel.rank], [0, 0])
  const box = it.getByRole('checkbox', { name: /learn the wheel/ })
  // By the pointer itself: a click of the driver's may scroll the page first.
  await box.scrollIntoViewIfNeeded()
  const { x, y, width, height } = await box.boundingBox()
  await page.mouse.click(x + width / 2, y + height / 2)
  await until(it, ({ wheel }) => wheel === null, 'as it was')
  assert.equal(await plot.count(), 0)
  assert.ok(Math.abs((await box.boundingBox()).y - y) < 4, 'the box stays under the pointer')
  assert.equal(await it.locator('.live .panel-wheel [role=slider]').count(), 0, 'no handle is left in what is hidden')
  assert.equal((await frameOf(it)).params.learn, false)
})

test('a change at a tick of before draws the curves as far as the robot had come', async (t) => {
  const { it } = await openFigure(t, 'odometry-hook')
  await it.getByRole('button', { name: 'Show the whole lap' }).click()
  await until(it, ({ step }) => step === 640, 'a lap')
  await it.locator('.live .panel-heading').getByRole('slider', { name: 'Tick shown on the map' }).press('Home')
  await until(it, ({ step }) => step === 0, 'back at the start')
  const end = it.locator('.live .panel-heading .mark.end').first()
  const [across, up] = [await end.getAttribute('cx'), await end.getAttribute('cy')]
  await it.getByRole('checkbox', { name: 'landmark fixes' }).check()
  await until(it, ({ params, step }) => params.fixes && step === 0, 'with fixes, at the same tick')
  assert.equal(await end.getAttribute('cx'), across)
  assert.notEqual(await end.getAttribute('cy'), up)
})
