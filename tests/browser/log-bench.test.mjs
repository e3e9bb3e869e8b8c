// The workbench in a browser: evidence and controls on one screen, A behind B, a touch and a drag on a panel, the map.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { PHONE, root, until } from './harness.mjs'
import { file, openLog, told } from './own-log.mjs'

const CAR = readFileSync(path.join(root, 'content/logs/car.csv'), 'utf8')
/** Along a line past two landmarks, with bearings and no truth. */
const CAMERA = ['L,1,10,5', 'L,2,20,-4']
for (let i = 0; i < 200; i++) {
  const [px, py] = i % 2 ? [20, -4] : [10, 5]
  CAMERA.push(
    `V,${i / 10},1,0\nB,${i / 10},${1 + (i % 2)},${Math.hypot(px - i / 10, py)},${Math.atan2(py, px - i / 10)}`,
  )
}

/** Which of these are whole in the window, once the figure's title is at its top. */
const seen = (page, names) =>
  page.evaluate((all) => {
    const figure = document.querySelector('.own-log .figure-widget')
    scrollBy(0, figure.getBoundingClientRect().top - 48)
    return all.filter((name) => {
      const { top, bottom, width } = document.querySelector(`robot-log .live ${name}`).getBoundingClientRect()
      return width > 0 && top >= 0 && bottom <= innerHeight
    })
  }, names)

test('evidence and sliders are on one screen; on a phone map, verdict and innovations are', async (t) => {
  const evidence = ['.panel-map', '.verdict', '.panel-innovations']
  const wide = [...evidence, '.panel-nis', '.log-likelihood', '.log-number']
  for (const [viewport, names] of /** @type {[typeof PHONE, string[]][]} */ ([
    [{ width: 1440, height: 900 }, wide],
    [{ width: 1000, height: 800 }, wide],
    [PHONE, evidence],
  ])) {
    const { page, it, choose } = await openLog(t, { viewport })
    await choose(file('car.csv', CAR))
    await until(it, ({ rows, summary }) => rows > 14_000 && summary.used > 2000, 'the car')
    assert.deepEqual(await seen(page, names), names, `${viewport.width} px`)
    const shown = await page
      .locator('robot-log .live > .panel')
      .evaluateAll((all) => all.filter((panel) => panel.checkVisibility()).map((panel) => panel.classList[1]))
    assert.deepEqual(
      shown,
      ['panel-map', 'panel-innovations', 'panel-nis'],
      'three panels, and no error without a truth',
    )
    assert.equal(await it.locator('.live').getByText('there is no truth').count(), 0)
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width)
  }
})

test('the strip scrolls under a pointer right after a press in it, and the page stays', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 1440, height: 900 } })
  await choose(file('camera.csv', CAMERA.join('\n')))
  await until(it, ({ rows }) => rows > 300, 'the log')
  const [strip, moved] = await page.locator('robot-log .live .log-strip').evaluate(async (box) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve))
    // What has room below it and above: the strip, and the page.
    box.scrollIntoView({ block: 'center' })
    box.querySelector('button').click()
    const { scrollY: before } = window
    await frame()
    box.scrollTop += 150
    for (let frames = 0; frames < 4; frames++) await frame()
    return [box.scrollTop, scrollY - before]
  })
  assert.ok(strip >= 150, `the strip: ${strip} px`)
  assert.equal(moved, 0)
})

test('the strip fades at its lower edge for as long as it goes on there', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 1440, height: 900 } })
  await choose(file('car.csv', CAR))
  await until(it, ({ summary }) => summary.used > 2000, 'the car')
  const strip = page.locator('robot-log .live .log-strip')
  const faded = () => strip.evaluate((box) => getComputedStyle(box).maskImage !== 'none')
  await page.locator('robot-log .live .log-strip[data-more]').waitFor()
  assert.ok(await faded())
  await strip.evaluate((box) => box.scrollTo(0, box.scrollHeight))
  await page.locator('robot-log .live .log-strip:not([data-more])').waitFor()
  assert.ok(!(await faded()))
})

test('A stays pale behind B, the likelihood is held against it, and the report has both', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('car.csv', CAR))
  await until(it, ({ summary }) => summary.used > 2000, 'the car')
  await page.getByRole('button', { name: 'Keep this as A' }).click()
  await page.locator('robot-log .live .panel-map .pale').waitFor({ state: 'attached' })
  const slider = told(page, 'motion').getByLabel('delay of the speed, s, slider')
  await slider.fill('0.5')
  await until(it, ({ params }) => params.delaySpeed === 0.5, 'the delay')
  await page
    .locator('.log-likelihood', { hasText: /\+[\d,]+\.\d against the last setting; \+[\d,]+\.\d against A\./ })
    .waitFor()
  for (const name of ['map', 'innovations', 'nis'])
    assert.ok((await page.locator(`robot-log .live .panel-${name} .pale > *`).count()) > 0, name)
  const row = page
    .locator('.log-report .log-table', { hasText: 'Settings' })
    .locator('tr', { hasText: 'delay of the speed' })
  assert.deepEqual(await row.locator('td').allInnerTexts(), ['0', '0.5'])
  const sensors = page.locator('.log-report .log-table', { hasText: 'Each sensor and landmark' })
  assert.deepEqual(await sensors.locator('tbody th').allInnerTexts(), ['Positions, A', 'Positions, B'])
  const [a, b] = await sensors.locator('tbody td:nth-of-type(4)').allInnerTexts()
  assert.ok(Number(b) < Number(a), `NIS falls from ${a} to ${b}`)
  await page.getByRole('button', { name: 'Back to A' }).click()
  await until(it, ({ params }) => params.delaySpeed === 0, 'as A was')
  await page.getByRole('button', { name: 'Drop A' }).click()
  await page.waitForFunction(() => !document.querySelector('robot-log .live .pale'))
})

test('a reading that is touched has its place on the map, and panels show one stretch of time', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('camera.csv', CAMERA.join('\n')))
  await until(it, ({ rows, summary }) => rows === 400 && summary.used === 200, 'the camera')
  await page.getByRole('button', { name: 'More panels' }).click()
  const panel = page.locator('robot-log .live .panel-innovations')
  await panel.scrollIntoViewIfNeeded()
  const { x, y, width, height } = await panel.boundingBox()
  await page.mouse.click(x + width / 2, y + height / 2)
  await page.locator('robot-log .live .panel-map .mark.hollow.measurement').waitFor({ state: 'attached' })
  await page.locator('.log-touched', { hasText: /^At [\d.]+ s, ranges of [12]: .* σ, used\.$/ }).waitFor()
  const reading = it.locator('.live [role=slider][aria-label="Reading"]').first()
  const before = await page.locator('.log-touched').innerText()
  await reading.press('ArrowRight')
  await page.waitForFunction((old) => document.querySelector('.log-touched').innerText !== old, before)
  await page.mouse.move(x + width * 0.4, y + height / 3)
  await page.mouse.down()
  await page.mouse.move(x + width * 0.6, y + height / 3, { steps: 5 })
  await page.mouse.up()
  await page.getByRole('button', { name: 'Whole log' }).waitFor()
  const ends = () =>
    page.evaluate(() =>
      ['innovations', 'nis', 'bearings'].map((name) => {
        const ticks = document.querySelectorAll(`robot-log .live .panel-${name} .axes .tick[text-anchor=middle]`)
        return [...ticks].map(({ textContent }) => textContent).join(' ')
      }),
    )
  await page.waitForFunction(() => document.querySelector('robot-log').settled)
  const [innovations, nis, bearings] = await ends()
  assert.ok(innovations.length > 0 && innovations === nis && nis === bearings, await ends())
  assert.match(innovations, /^0\.1/)
  // That stretch can be read alone, and the whole log again.
  await page.getByRole('button', { name: 'Read this part alone' }).click()
  await page
    .locator('.log-answer')
    .getByText(/^The log is read from \d+\.\d to \d+\.\d s after its/)
    .waitFor()
  await until(it, ({ rows }) => rows > 40 && rows < 200, 'a part of the camera')
  assert.equal(await page.getByRole('button', { name: 'Whole log' }).isVisible(), false)
  await page.locator('.log-mend').getByRole('button', { name: 'Undo' }).click()
  await until(it, ({ rows }) => rows === 400, 'the camera as it was')
  // A drag from one corner of a panel to the other, and beyond, selects none of its letters.
  for (const name of ['map', 'innovations', 'bearings']) {
    const box = await page.locator(`robot-log .live .panel-${name}`).boundingBox()
    await page.mouse.move(box.x + 2, box.y + 2)
    await page.mouse.down()
    await page.mouse.move(box.x + box.width - 2, box.y + box.height + 20, { steps: 8 })
    assert.equal(await page.evaluate(() => String(getSelection())), '', name)
    await page.mouse.up()
  }
})

test('the map of the likelihood is drawn, and its point moves both numbers', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('camera.csv', CAMERA.join('\n')))
  await until(it, ({ rows, summary }) => rows === 400 && summary.used === 200, 'the camera')
  await page.getByRole('button', { name: 'More panels' }).click()
  const map = page.locator('.log-likely')
  await map.getByLabel('across').selectOption('ranges with bearings: offset of the bearings, °')
  await map.getByLabel('upwards').selectOption('ranges with bearings: σ of a bearing, rad')
  await map.getByRole('button', { name: 'Draw the map' }).click()
  // The log has no noise, so that no σ is too small for it, and the page draws no line.
  await map.getByText('the likelihood is still high at its edge').waitFor()
  assert.ok((await map.locator('path.likely').count()) >= 3)
  await map.locator('[role=slider]').focus()
  await page.keyboard.press('ArrowRight')
  await until(it, ({ params }) => Math.abs(params.bearingOffset - (0.1 * Math.PI) / 180) < 1e-6, 'a tenth of a degree')
  await page.keyboard.press('ArrowDown')
  await until(it, ({ params }) => params.sigmaBearing < 0.05, 'a smaller σ')
})
