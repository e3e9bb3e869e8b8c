// The figures late in the chapter: their module is fetched when one of them comes near; "Tune me" fills its map beside
// the page and keeps the truth sealed; "Close the loop" tells a right filter from a mutilated one.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { comeTo, EXERCISES, figure, frameOf, open, openFigure, root, settled } from './harness.mjs'

test('the module with the labs of late figures is fetched when one of them comes near, and not before', async (t) => {
  const late = readFileSync(path.join(root, 'target/pkg/late/estimate_wasm_bg.wasm')).length
  const sizes = []
  const page = await open(t, {
    prepare: async (it) =>
      it.on('response', async (response) => {
        if (response.url().endsWith('.wasm')) sizes.push((await response.body()).length)
      }),
  })
  await figure(page, 'odometry-hook')
  assert.ok(sizes.length === 1 && !sizes.includes(late), `${sizes}`)
  await comeTo(page, 'lab-tune', 'lab-tune[data-state="live"]')
  await settled(page.locator('lab-tune'))
  assert.ok(sizes.includes(late))
})

test('Tune me: the map fills, the ring is dragged, Fit finds the top, the truth is sealed at first', async (t) => {
  const { page, it } = await openFigure(t, 'tune')
  await settled(it)
  const map = () =>
    it.evaluate((host) => {
      const { rows, size, values, top } = host.figure.beside.value
      return { rows, size, highest: Math.max(...values), top }
    })
  const { rows, size, highest, top } = await map()
  assert.equal(rows, size)
  assert.ok(highest < top && highest > top - 1)
  assert.ok(await it.locator('.live .panel-map .likely').first().getAttribute('d'))
  const closed = it.locator('.live .panel-map .contour')
  assert.equal(await closed.count(), 0, 'a line about the likeliest noise would give it away')

  const ring = it.getByRole('slider', { name: 'The filter’s noise' })
  const { x, y, width, height } = await ring.locator('.handle-dot').boundingBox()
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  await page.mouse.move(x - 60, y + 40, { steps: 4 })
  await page.mouse.up()
  await settled(it)
  const dragged = await frameOf(it)
  assert.ok(dragged.params.logQ < -0.2 && dragged.params.logW < -0.2)
  await ring.press('ArrowUp')
  await ring.press('Shift+ArrowRight')
  await settled(it)
  const { params } = await frameOf(it)
  assert.ok(
    Math.abs(params.logW - dragged.params.logW - 0.02) < 1e-9 &&
      Math.abs(params.logQ - dragged.params.logQ - 0.2) < 1e-9,
  )

  assert.equal(await it.locator('.live .readout').filter({ hasText: 'Mean NEES' }).locator('dd').innerText(), 'sealed')
  await it.getByRole('button', { name: 'Fit the noise' }).click()
  await settled(it)
  const fitted = await frameOf(it)
  assert.ok(fitted.fit.lacking < 0.1 && fitted.verdict === null)
  assert.ok(await closed.getAttribute('d'))
  const [box, likeliest] = [it.getByLabel('commit: open the truth'), it.getByLabel('show the likeliest')]
  await likeliest.uncheck()
  await settled(it)
  const from = await box.evaluate(
    (input) => input.getBoundingClientRect().top - input.closest('.live').getBoundingClientRect().top,
  )
  await box.check()
  await settled(it)
  assert.match(await it.locator('.live .verdict').innerText(), /The true q is/)
  assert.deepEqual(
    [await likeliest.isChecked(), await likeliest.isDisabled()],
    [true, true],
    'it is drawn with the truth',
  )
  assert.equal(
    await box.evaluate(
      (input) => input.getBoundingClientRect().top - input.closest('.live').getBoundingClientRect().top,
    ),
    from,
    'the box stays under the pointer',
  )

  await it.getByRole('button', { name: 'Another log' }).click()
  await settled(it)
  const next = await frameOf(it)
  assert.deepEqual([next.params.seed, next.fit, next.verdict], [params.seed + 1, null, null])
  assert.notEqual((await map()).top, top)
})

test('Close the loop: every ellipse shrinks as it closes, dropped cross-covariances show in the NEES', async (t) => {
  const { it } = await openFigure(t, 'loop-closure')
  await it.getByRole('button', { name: 'Stop just before the loop closes' }).click()
  await settled(it)
  const before = await frameOf(it)
  await it.getByRole('button', { name: 'Step', exact: true }).click()
  await settled(it)
  const after = await frameOf(it)
  assert.equal(after.closure.step, before.step + 1)
  const size = ({ ellipse }) => ellipse.semiMajor
  const far = before.map.landmarks.filter((landmark, i) => size(after.map.landmarks[i]) < size(landmark))
  assert.ok(far.length >= before.map.landmarks.length - 2, `${far.length} of ${before.map.landmarks.length}`)
  await it.getByRole('button', { name: 'Drop the cross-covariances' }).click()
  await settled(it)
  const apart = await frameOf(it)
  assert.ok(apart.meanNees > 10 * after.meanNees)
  assert.match(await it.locator('.live .verdict').innerText(), /claims far more than it knows/)
})

test('Close the loop: both thresholds are dragged on their axis, and where they cross there are ghosts', async (t) => {
  const { page, it } = await openFigure(t, 'loop-closure')
  await it.getByRole('button', { name: 'As at first' }).click()
  await settled(it)
  assert.equal((await frameOf(it)).map.spurious, 0)
  const dot = it.locator('.live .panel-thresholds [role=slider][aria-label="Threshold for founding"] .handle-dot')
  await dot.scrollIntoViewIfNeeded()
  const { x, y, width, height } = await dot.boundingBox()
  const gate = await it.locator('.live .panel-thresholds [role=slider][aria-label="Gate"] .handle-dot').boundingBox()
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  await page.mouse.move(gate.x - 12, y + height / 2, { steps: 5 })
  await page.mouse.up()
  await settled(it)
  const frame = await frameOf(it)
  assert.ok(
    frame.params.found < frame.params.gate && frame.thresholds.gate === frame.params.found,
    'the gate ends where founding begins',
  )
  assert.ok(frame.map.spurious > 0)
  assert.equal(await it.locator('.live .panel-map .ghost').count(), frame.map.spurious)
  const before = frame.params.found
  await it.locator('.live .panel-thresholds [role=slider][aria-label="Threshold for founding"]').press('ArrowRight')
  await settled(it)
  assert.ok((await frameOf(it)).params.found > before)
})

for (const [id, tag, wrong, right, todo] of [
  ['tune-in-band', 'lab-tune', { logQ: -2, logW: -1 }, { logW: 0.3 }, 'Bring the mean NIS into its band.'],
  ['loop-ghost', 'loop-closure', { correlated: false, seed: 1, step: 128 }, { seed: 2 }, 'There is no ghost yet.'],
]) {
  test(`the page recognises the state that ${id} asks for, and names what is missing`, async (t) => {
    const page = await open(t, { at: EXERCISES })
    await comeTo(page, tag, `${tag}[data-state="live"]`)
    const it = page.locator(tag)
    await it.evaluate((host, change) => host.figure.change(change), wrong)
    await settled(it)
    await comeTo(page, `#quiz-${id}`, `form#quiz-${id}`)
    const form = page.locator(`#quiz-${id}`)
    await form.locator('[type=submit]').click()
    await form.locator('.quiz-verdict').filter({ hasText: todo }).waitFor()
    assert.equal(await form.getAttribute('data-answered'), null)
    await comeTo(page, tag, `${tag}[data-state="live"]`)
    await it.evaluate((host, change) => host.figure.change(change), right)
    await settled(it)
    await comeTo(page, `#quiz-${id}`, `form#quiz-${id}`)
    await form.locator('[type=submit]').click()
    await page.locator(`#quiz-${id}[data-answered="right"]`).waitFor()
  })
}
