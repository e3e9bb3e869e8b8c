// The Picture under a test's mouse: its handles, its scale, and what holds of its two feet in every state.
import assert from 'node:assert/strict'
import { frameOf } from './harness.mjs'

export const close = (a, b, tolerance = 1e-9) => Math.abs(a - b) <= tolerance
export const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1])
export const handle = (picture, label) => picture.getByRole('slider', { name: label, exact: true })
export const noise = (picture) => picture.getByRole('slider', { name: /Sensor noise/ })

/** Pixels of one unit, by the drawing's own margins and reach. */
export const unitOf = (it) =>
  it.locator('.live .panel-plane').evaluate((svg) => {
    const { width, height } = svg.viewBox.baseVal
    return Math.min((width - 58) / 2, (height - 72) / 2) / 3
  })

/** Drags a handle by so many pixels. */
export async function pull(page, grip, dx, dy) {
  await grip.scrollIntoViewIfNeeded()
  const box = await grip.locator('.handle-dot').boundingBox()
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
  await page.mouse.move(x, y)
  await page.mouse.down()
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 3 })
  await page.mouse.move(x + dx, y + dy, { steps: 3 })
  await page.mouse.up()
}

/** Both feet are on the line, each at a right angle in its own metric, and the page says so. */
export async function holds(it) {
  const frame = await frameOf(it)
  const { euclideanFoot: gray, mahalanobisFoot: purple, update } = frame
  for (const [name, value] of Object.entries({
    'gray residual': gray.residual,
    'purple residual': purple.residual,
    'update residual': update.residual,
    'gray by the ruler': gray.euclidean,
    'purple by P': purple.mahalanobis,
    'update by P': update.mahalanobis,
  }))
    assert.ok(close(value, 0), `${name} is ${value} at ${JSON.stringify(frame.params)}`)
  assert.ok(purple.distance <= gray.distance + 1e-12, 'no point of the line is nearer in the metric of P')
  assert.deepEqual(
    update.at.map((value, i) => close(value, frame.posterior.x[i])),
    [true, true],
    "the update is the filter's",
  )
  const readout = (label) => it.locator('.live .readout').filter({ hasText: label }).locator('dd').textContent()
  assert.equal(await readout('of both'), '0.000, 0.000')
  assert.equal(await readout(/^Gray.*ruler/s), '0.000')
  assert.equal(await readout(/^Purple.*metric/s), '0.000')
  return frame
}
