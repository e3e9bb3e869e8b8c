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
    for (let i = 0; i < 8; i++)
      handle.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }))
    for (let i = 0; i < 12; i++)
      handle.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true, cancelable: true }))
  })
  await until(
    probe,
    ({ params }) => Math.abs(params.landmarks[0][0] - (start[0] - 12 * 0.05)) < 1e-9,
    'twelve steps from the wall',
  )

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

test('the mix of dials that no reading shows is found by keys, and a second landmark parts the curves', async (t) => {
  const { it: probe } = await openFigure(t, 'observability-probe')
  const strips = () => probe.locator('.live :is(.panel-ranges, .panel-bearings):not([hidden])').count()
  assert.equal(await strips(), 0, 'calm at first')
  await probe.getByRole('button', { name: 'Turn the world' }).click()
  await until(probe, ({ ghost }) => ghost?.rangeGap > 0.5, 'the ghost reads other ranges')
  assert.equal(await strips(), 2)
  assert.equal(await probe.locator('.live :is(.panel-nees, .panel-nis):not([hidden])').count(), 0)
  const dial = probe.getByRole('slider', { name: /on the spot/ })
  for (let degrees = 1; degrees <= 10; degrees++) {
    await dial.press('ArrowRight')
    await until(probe, ({ params }) => Math.abs(params.ghostTurn - (degrees * Math.PI) / 180) < 1e-9, `${degrees}°`)
  }
  const found = await frameOf(probe)
  assert.ok(found.ghost.rangeGap < 1e-9 && found.ghost.bearingGap < 1e-9 && found.ghost.moved > 0.5)
  assert.match(await probe.locator('.live .verdict').innerText(), /It reads what the robot reads/)
  const readout = (label) => probe.locator('.live .readout').filter({ hasText: label }).locator('dd').textContent()
  assert.equal(await readout('Mixed by hand'), await readout('Null vector'))
  await probe.getByRole('combobox', { name: 'Sensor' }).selectOption({ label: 'range only' })
  await until(probe, ({ ghost }) => ghost.bearingGap === null && ghost.rangeGap < 1e-9, 'ranges alone agree, too')
  assert.equal(await strips(), 1)
  await probe.getByRole('combobox', { name: 'Landmarks' }).selectOption({ label: 'two' })
  await until(probe, ({ ghost }) => ghost.rangeGap > 0.5, 'a second landmark shows the turn')
  await probe.getByRole('checkbox', { name: 'let a ghost drive along' }).uncheck()
  await until(probe, ({ ghost }) => ghost === null, 'gone')
  assert.equal(await strips(), 0)
})

test('dashes stay dashes after two laps: a closed track is drawn once', async (t) => {
  const { it } = await openFigure(t, 'observability-probe')
  await it.getByRole('button', { name: 'Turn the world' }).click()
  await until(it, ({ ghost }) => ghost, 'a ghost')
  const laps = () =>
    it.locator('.live .panel-map').evaluate((map) =>
      ['.mark.track.truth', '.mark.track.ghost'].map((track) => {
        const { width } = map.querySelector('.floor').getBBox()
        // The square has half the side of the room.
        return map.querySelector(track).getTotalLength() / (2 * width)
      }),
    )
  for (const share of await laps()) assert.ok(Math.abs(share - 1) < 0.01, `${share} laps are drawn`)
  await it.getByRole('button', { name: 'Step' }).click()
  await until(it, ({ step }) => step === 241, 'one step more')
  for (const share of await laps()) assert.ok(Math.abs(share - 1) < 0.01, `${share} laps are drawn`)
})

test('before the first step no direction is drawn along a path that is not there', async (t) => {
  const { it } = await openFigure(t, 'observability-probe')
  const names = () => it.locator('.live .panel-map text').filter({ hasText: /^path/ }).count()
  assert.equal(await names(), 1)
  await it.getByRole('button', { name: 'Reset' }).click()
  await until(it, ({ step }) => step === 0, 'the start')
  assert.equal(await names(), 0)
})
