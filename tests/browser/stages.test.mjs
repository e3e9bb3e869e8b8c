// A figure that opens small in the text grows with it; on a phone the picture stays beside what moves it; and the
// pictures at the heads are in the reader's hand.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { codeOf, comeTo, DESKTOP, figure, open, openFigure, PHONE, quiet, unlock } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

/** The parts of a figure that are there, by name. */
const there = (page, figure) =>
  page
    .locator(`${figure} .live`)
    .evaluate((live) =>
      [
        ...['disc', 'gain', 'variance', 'error'].map((name) => `.panel-${name}`),
        '.readouts',
        '.figure-tools',
        '[aria-label="Run"] + .control',
      ].filter((part) => live.querySelector(part)?.checkVisibility()),
    )

test('the Bench opens with its ellipse and its knob, and its words and buttons bring the rest', async (t) => {
  const page = await open(t)
  await comeTo(page, '#fig-bench', '#fig-bench .widget[data-state=live]')
  assert.deepEqual(await there(page, '#fig-bench'), [])
  assert.ok(await page.locator('#fig-bench').getByRole('slider', { name: /Gain/ }).isVisible(), 'the knob is there')
  // Words of the text.
  await page.getByRole('link', { name: 'Watch the dots on the disc.' }).press('Enter')
  await page.locator('#fig-bench .live .panel-disc').waitFor()
  assert.deepEqual(await there(page, '#fig-bench'), ['.panel-disc'])
  // The button below the figure.
  await page.locator('#fig-bench').getByRole('button', { name: 'Show the whole bench' }).click()
  await page.locator('#fig-bench .live .panel-error').waitFor()
  assert.equal((await there(page, '#fig-bench')).length, 7, 'all of it is there')
  assert.equal(await page.locator('#fig-bench .grow-list :visible').count(), 0, 'nothing is left to show')
  // What has come is as large as it is drawn.
  await quiet(page)
  for (const name of ['disc', 'gain']) {
    const [width, drawn] = await page
      .locator(`#fig-bench .live .panel-${name}`)
      .evaluate((svg) => [svg.getBoundingClientRect().width, svg.viewBox.baseVal.width])
    assert.ok(Math.abs(width - drawn) < 1, `${name} is ${width} px wide and drawn for ${drawn}`)
  }
  // Words never make a figure smaller.
  await page.getByRole('link', { name: 'Watch the dots on the disc.' }).press('Enter')
  assert.equal((await there(page, '#fig-bench')).length, 7)
})

for (const [id, later] of [
  ['fig-picture', 'axis'],
  ['fig-probe', 'trace'],
])
  test(`${id} opens small too, and its buttons bring the rest`, async (t) => {
    const page = await open(t)
    await unlock(page, id)
    await comeTo(page, `#${id}`, `#${id} .widget[data-state=live]`)
    const [panel, tools] = [`.panel-${later}`, '.figure-tools'].map((part) => page.locator(`#${id} .live ${part}`))
    assert.ok(!(await panel.isVisible()) && !(await tools.isVisible()), 'it is small')
    const grow = page.locator(`#${id} .grow-list button`).filter({ visible: true }).first()
    await grow.click()
    await panel.waitFor()
    assert.ok(!(await tools.isVisible()))
    await grow.click()
    await tools.waitFor()
    assert.equal(await page.locator(`#${id} .grow-list :visible`).count(), 0, 'nothing is left to show')
  })

test('a link to a state opens the whole figure, and so does its own page', async (t) => {
  const state = codeOf('observer-bench', 3)
  const page = await open(t, { at: `kalman/?fig-bench=${state}#fig-bench` })
  await comeTo(page, '#fig-bench', '#fig-bench .widget[data-state=live]')
  assert.equal((await there(page, '#fig-bench')).length, 7)
  const { page: own } = await openFigure(t, 'observer-bench')
  assert.equal((await there(own, 'figure')).length, 7)
})

test('on a phone the ellipse stays in sight while the knob is turned, and one button has the rest', async (t) => {
  const { page } = await openFigure(t, 'observer-bench', { viewport: PHONE, touch: true })
  assert.deepEqual(
    (await there(page, 'figure')).filter((part) => !part.startsWith('.panel')),
    [],
  )
  const knob = page.getByRole('slider', { name: /Gain/ })
  await knob.evaluate((it) =>
    scrollBy({ top: it.getBoundingClientRect().bottom - innerHeight + 60, behavior: 'instant' }),
  )
  await quiet(page)
  const [picture, hand] = await Promise.all([page.locator('.live .panel-phase').boundingBox(), knob.boundingBox()])
  assert.ok(picture.y >= -1 && picture.y + picture.height < hand.y, 'the ellipse is above the knob')
  assert.ok(hand.y + hand.height <= PHONE.height, 'and the knob on the same screen')
  await page.getByRole('button', { name: /More: plots/ }).click()
  assert.equal((await there(page, 'figure')).length, 7)
})

test('on a phone held across, each figure’s picture stays in sight beside its last slider', async (t) => {
  const across = { width: PHONE.height, height: PHONE.width }
  let beside = 0
  for (const name of Object.keys(WIDGETS)) {
    const { page } = await openFigure(t, name, { viewport: across, touch: true })
    const pin = page.locator('.live > [data-pin]')
    const sliders = page.locator('.live .controls > :not(details) input[type=range]').filter({ visible: true })
    if ((await pin.count()) === 0 || (await sliders.count()) === 0) continue
    await sliders.last().evaluate((it) => it.scrollIntoView({ block: 'end', behavior: 'instant' }))
    await quiet(page)
    const [picture, hand] = await Promise.all([pin.boundingBox(), sliders.last().boundingBox()])
    assert.ok(picture.x + picture.width <= hand.x, `${name}: beside one another`)
    assert.ok(picture.y >= -1 && picture.y + picture.height <= across.height, `${name}: from ${picture.y} px`)
    beside += 1
    await page.close()
  }
  assert.ok(beside > 5, `${beside} figures`)
})

test('on a phone what is said stays in sight by the hand, and covers neither picture nor hand', async (t) => {
  for (const viewport of [PHONE, { width: 360, height: 640 }])
    for (const name of Object.keys(WIDGETS)) {
      if (!(await WIDGETS[name]()).layout.along) continue
      const { page } = await openFigure(t, name, { viewport, touch: true })
      const hand = page.locator('.live .params > *').filter({ visible: true }).first()
      await hand.evaluate((it) => it.scrollIntoView({ block: 'center', behavior: 'instant' }))
      await quiet(page)
      const box = await hand.boundingBox()
      const said = await page.locator('.live .verdict').boundingBox()
      assert.ok(said.y + said.height <= viewport.height + 1, `${name}: said down to ${said.y + said.height} px`)
      assert.ok(said.y >= box.y + Math.min(box.height, 60), `${name}: from ${said.y} px, the hand is at ${box.y}`)
      const pin = page.locator('.live[data-pinned] > [data-pin]')
      if (await pin.count()) {
        const picture = await pin.boundingBox()
        assert.ok(picture.y + picture.height < said.y, `${name}: the picture ends at ${picture.y + picture.height} px`)
      }
      assert.deepEqual(await page.evaluate(covered), [], `${name}: the sentence covers the picture`)
      await page.close()
    }
})

/** Where, as the page is scrolled down, the sentence lies on the panel that stays in sight, and not below it. */
function covered() {
  const [pin, said] = ['[data-pin]', '.verdict'].map((part) => document.querySelector(`.live > ${part}`))
  const found = []
  document.body.style.paddingBottom = '100vh'
  for (let y = 0; pin && y < document.documentElement.scrollHeight; y += 40) {
    scrollTo({ top: y, behavior: 'instant' })
    const [picture, words] = [pin, said].map((part) => part.getBoundingClientRect())
    const top = Math.max(picture.top, words.top, 0)
    const bottom = Math.min(picture.bottom, words.bottom, innerHeight)
    const at = document.elementFromPoint(picture.left + picture.width / 2, (top + bottom) / 2)
    if (bottom - top > 1 && said.contains(at)) found.push(y)
  }
  return found
}

test('on a phone the Bench’s variances come between the ellipse and the knob that moves them', async (t) => {
  for (const viewport of [PHONE, { width: 360, height: 640 }]) {
    const page = await open(t, { viewport, touch: true })
    await comeTo(page, '#fig-bench', '#fig-bench .widget[data-state=live]')
    await page.getByRole('link', { name: 'Watch the variances.' }).tap()
    await page.locator('#fig-bench .live .panel-variance').waitFor()
    await quiet(page)
    const [pin, variance, knob] = await Promise.all(
      ['.panel-phase', '.panel-variance', '.params input[type=range]'].map((part) =>
        page.locator(`#fig-bench .live ${part}`).first().boundingBox(),
      ),
    )
    assert.ok(variance.y >= pin.y + pin.height - 1, `the variances from ${variance.y} px, below the ellipse`)
    assert.ok(knob.y >= variance.y + variance.height - 1, `the knob at ${knob.y} px, below the variances`)
    assert.ok(knob.y + knob.height <= viewport.height + 1, `the knob down to ${knob.y + knob.height} px`)
    await page.context().close()
  }
})

test('what is being computed is told in a line of its own, over no picture', async (t) => {
  let told = 0
  for (const viewport of [DESKTOP, PHONE])
    for (const name of Object.keys(WIDGETS)) {
      const spec = await WIDGETS[name]()
      if (!spec.slow) continue
      const { page, it } = await openFigure(t, name, { viewport })
      await quiet(page)
      const { height } = await it.boundingBox()
      await it.locator('.live .progress').evaluate((box) => {
        box.hidden = false
      })
      const bar = await it.locator('.live .progress').boundingBox()
      assert.equal((await it.boundingBox()).height, height, `${name}: nothing moves`)
      const words = await it.locator('.live .verdict').evaluate((said) => {
        const range = document.createRange()
        range.selectNodeContents(said)
        return range.getBoundingClientRect().bottom
      })
      assert.ok(bar.y >= words - 1, `${name}: from ${bar.y} px, the words end at ${words}`)
      for (const panel of await it.locator('.live > .panel:not([data-pin])').filter({ visible: true }).all()) {
        const { x, y, width, height: tall } = await panel.boundingBox()
        const apart = y >= bar.y + bar.height || y + tall <= bar.y || x >= bar.x + bar.width || x + width <= bar.x
        assert.ok(apart || viewport === PHONE, `${name}: over ${await panel.getAttribute('class')}`)
      }
      told += 1
      await page.close()
    }
  assert.ok(told > 2, `${told} figures`)
})

for (const name of ['odometry-hook', 'picture', 'observability-probe', 'tune', 'loop-closure', 'bug-museum'])
  test(`on a phone the ${name} is at most two screens high, and what opens the rest stays in place`, async (t) => {
    const { page } = await openFigure(t, name, { viewport: PHONE, touch: true })
    await quiet(page)
    const { height } = await page.locator('.widget').boundingBox()
    assert.ok(height <= 2 * PHONE.height, `${height} px`)
    const more = page.locator('.live .further, .live .more > summary').filter({ visible: true }).first()
    await more.evaluate((it) => it.scrollIntoView({ block: 'center', behavior: 'instant' }))
    await quiet(page)
    const { y } = await more.boundingBox()
    await more.tap()
    await quiet(page)
    assert.ok(Math.abs((await more.boundingBox()).y - y) < 2, `it was pressed at ${y} px`)
  })

test('the line at the head of the chapter is moved by keys and by hand, and the touching point slides', async (t) => {
  const page = await open(t)
  const line = page.getByRole('slider', { name: 'The line of the reading' })
  await line.waitFor()
  await page
    .locator('.vignette > .full')
    .evaluate((point) => Promise.all(point.getAnimations().map((it) => it.finished)))
  const point = () => page.locator('.vignette > .full').boundingBox()
  const at = [await point()]
  const before = await line.getAttribute('aria-valuetext')
  for (let i = 0; i < 6; i += 1) await line.press('ArrowDown')
  at.push(await point())
  assert.notEqual(await line.getAttribute('aria-valuetext'), before)
  const ring = await page.locator('.vignette .handle-ring').boundingBox()
  const middle = [ring.x + ring.width / 2, ring.y + ring.height / 2]
  await page.mouse.move(...middle)
  await page.mouse.down()
  await page.mouse.move(middle[0], middle[1] - 40, { steps: 4 })
  await page.mouse.up()
  at.push(await point())
  const [first, keys, hand] = at.map(({ x, y }) => [x, y])
  assert.ok(keys[1] > first[1] && hand[1] < keys[1] - 30, 'it goes with the line')
  // It slides along one straight line.
  const slope = (/** @type {number[]} */ [x1, y1], /** @type {number[]} */ [x2, y2]) => (x2 - x1) / (y2 - y1)
  assert.ok(Math.abs(slope(first, keys) - slope(keys, hand)) < 0.03, `${slope(first, keys)} and ${slope(keys, hand)}`)
  assert.ok(Math.abs(slope(first, keys)) > 0.1, 'not straight down')
})

test('the cover has a lap whose end is the handle, and every place of it has its track', async (t) => {
  const page = await open(t, { at: '' })
  const end = page.getByRole('slider', { name: 'The wheel’s error' })
  await end.waitFor()
  const shown = () => page.locator('.lap:not([hidden])').evaluateAll((all) => all.map((it) => it.dataset.words))
  assert.equal((await shown()).length, 1)
  await end.press('Home')
  assert.deepEqual(await shown(), ['a wheel 0.00 % smaller than believed: 0.0 m off after a lap'])
  await end.press('End')
  const [worst] = await shown()
  assert.match(worst, /^a wheel 1\.00 % smaller than believed: [3-6]\.\d m off after a lap$/)
  assert.equal(await end.getAttribute('aria-valuetext'), worst)
})

for (const [size, viewport] of Object.entries({ desktop: DESKTOP, phone: PHONE }))
  test(`words bring what they speak of into sight, from behind More too, ${size}`, async (t) => {
    const page = await open(t, { viewport, touch: viewport === PHONE })
    for (const [words, name, place] of [
      ['[href="#fig-bench"][data-shows="mode"]', 'observer-bench', '[data-control="mode"]'],
      ['[href="#fig-picture"][data-shows="readouts"]', 'picture', '.readouts'],
    ]) {
      const part = (await figure(page, name)).locator(`.live ${place}`)
      await page.locator(`a.grow${words}`).first().click()
      await page.waitForFunction(
        (found) => {
          const { top, bottom } = found.getBoundingClientRect()
          return found.checkVisibility() && top >= 0 && bottom <= innerHeight + 1
        },
        await part.elementHandle(),
      )
    }
  })
