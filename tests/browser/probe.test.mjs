// The Observability Probe: a landmark dragged with mouse and keys, and what the rank panel makes of it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { frameOf, openFigure, until } from './harness.mjs'

const ranks = async (probe) => {
  const { frozen, alongPath } = await frameOf(probe)
  const text = await probe.locator('.live').innerText()
  // What is printed is what the frame holds.
  assert.ok(text.includes(`${frozen.rank} of 3`) && text.includes(`${alongPath.rank} of 3`))
  return [frozen.rank, alongPath.rank]
}

test('a landmark moves by mouse and by keys, and the rank panel follows the geometry', async (t) => {
  const { page, it: probe } = await openFigure(t, 'observability-probe')
  assert.deepEqual(await ranks(probe), [2, 2])

  const landmark = probe.locator('.live [aria-label*="Landmark 1"]').first()
  const at = async () => (await frameOf(probe)).params.landmarks[0]
  const start = await at()
  await landmark.focus()
  await page.keyboard.press('ArrowLeft')
  await until(probe, ({ params }) => params.landmarks[0][0] < 6, 'the key moved it')
  const keyed = await at()
  assert.ok(keyed[0] < start[0] && keyed[1] === start[1])
  // Each press counts, however many come before the next frame.
  await landmark.evaluate((handle) => {
    for (let i = 0; i < 8; i++) handle.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }))
    for (let i = 0; i < 12; i++) handle.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true, cancelable: true }))
  })
  await until(probe, ({ params }) => Math.abs(params.landmarks[0][0] - (start[0] - 12 * 0.05)) < 1e-9, 'twelve steps from the wall')

  await landmark.scrollIntoViewIfNeeded()
  const box = await landmark.boundingBox()
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x - 60, y + 20, { steps: 5 })
  await page.mouse.up()
  await until(probe, ({ params }) => params.landmarks[0][0] < 5.1, 'the mouse moved it')
  const dragged = await at()
  assert.ok(dragged[0] < start[0] - 0.9 && dragged[1] < keyed[1])

  await probe.getByRole('combobox', { name: 'Landmarks' }).selectOption({ label: 'two' })
  await until(probe, ({ params }) => params.count === 2, 'two are shown')
  assert.deepEqual(await ranks(probe), [3, 3])
  await probe.getByRole('button', { name: 'Put the last landmark in line' }).click()
  await until(probe, ({ frozen }) => frozen.rank === 2, 'they are in line')
  // A crossing is momentary: along the path the rank stays.
  assert.deepEqual(await ranks(probe), [2, 3])
})
