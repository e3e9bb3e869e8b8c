// The output axis of the Picture: two opinions under mouse and keys, and the scale that they are read on.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { close, handle, holds, pull } from './picture.mjs'
import { frameOf, openFigure, quiet, until } from './harness.mjs'

const picture = (t) => openFigure(t, 'picture')

test('on the output axis both opinions are dragged and pressed, and y* stays their balance', async (t) => {
  const { page, it } = await picture(t)
  /** The weights 1/variance balance about y*, and the page says what part is taken over. */
  const balanced = async () => {
    const frame = await holds(it)
    const {
      params: { reading, noise },
      expectedOutput,
      expectedVariance,
      mostLikelyOutput,
      share,
    } = frame
    assert.ok(close((mostLikelyOutput - expectedOutput) * noise, (reading - mostLikelyOutput) * expectedVariance, 1e-9))
    assert.equal(
      await it.locator('.live .readout').filter({ hasText: 'taken over' }).locator('dd').textContent(),
      share.toFixed(3),
    )
    return frame
  }
  const start = await balanced()
  await pull(page, handle(it, 'Expected output'), -40, 0)
  const moved = await until(
    it,
    ({ expectedOutput }) => expectedOutput < start.expectedOutput - 0.3,
    'the prediction follows',
  )
  assert.deepEqual(
    [moved.params.mean[0], moved.params.semiMajor, moved.params.reading],
    [start.params.mean[0], start.params.semiMajor, start.params.reading],
    'it moves along H alone',
  )
  await pull(page, handle(it, 'Output that is read'), 60, 0)
  const read = await until(it, ({ params }) => params.reading > start.params.reading + 0.3, 'the reading follows')
  assert.deepEqual(read.params.mean, moved.params.mean)
  await balanced()
  const [wide, blur] = [
    handle(it, 'Standard deviation of the expected output'),
    handle(it, 'Standard deviation of the reading'),
  ]
  await wide.press('ArrowRight')
  const wider = await until(
    it,
    ({ expectedVariance }) => close(Math.sqrt(expectedVariance), Math.sqrt(read.expectedVariance) + 0.05, 1e-6),
    'an arrow widens the bell',
  )
  assert.ok(
    close(wider.params.semiMajor / wider.params.semiMinor, read.params.semiMajor / read.params.semiMinor),
    'the ellipse keeps its shape',
  )
  await blur.press('End')
  await until(it, ({ params }) => params.noise === 4, 'End')
  await balanced()
  await blur.press('Home')
  await until(it, ({ params }) => params.noise === 0, 'Home')
  await balanced()
})

test('while a bell is dragged the axis keeps its scale: an even drag moves it evenly, to the edge', async (t) => {
  const { page, it } = await picture(t)
  const ticks = () => it.locator('.live .panel-axis .tick').allTextContents()
  const places = await ticks()
  for (const [label, read, side] of /** @type {[string, (frame: any) => number, number][]} */ ([
    ['Expected output', ({ expectedOutput }) => expectedOutput, 1],
    ['Output that is read', ({ params }) => params.reading, -1],
  ])) {
    const grip = handle(it, label)
    await grip.scrollIntoViewIfNeeded()
    const box = await grip.locator('.handle-dot').boundingBox()
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
    const values = [read(await frameOf(it))]
    await page.mouse.move(x, y)
    await page.mouse.down()
    for (let i = 1; i <= 12; i++) {
      await page.mouse.move(x + side * 40 * i, y)
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))))
      values.push(read(await until(it, () => true, 'settled')))
      assert.deepEqual(await ticks(), places, `${label} at ${values.at(-1)}`)
    }
    const stride = values[1] - values[0]
    const end = values.at(-1)
    for (const [i, value] of values.entries())
      assert.ok(close(value, values[0] + stride * i, 0.02) || close(value, end), `${label}: ${values}`)
    assert.ok(Math.abs(end - 3.7) < 4.6 && close(end, values.at(-2)), `it stops at the edge: ${values}`)
    await page.mouse.up()
    // Once it is let go, the bell comes into view as a whole; the phrase brings the first view back.
    const domain = async () => JSON.stringify(await ticks())
    await quiet(page)
    assert.notEqual(await domain(), JSON.stringify(places), 'a new scale')
    await it.getByRole('button', { name: 'As in step 1' }).click()
    await quiet(page)
    assert.equal(await domain(), JSON.stringify(places), 'the scale of the first view')
  }
})
