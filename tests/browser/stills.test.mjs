// Stills first: without scripts every figure is a picture with words, in the place and of the height of the figure that
// comes to life when it is near.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { PNG } from 'pngjs'
import { FIGURE_PAGES, open, openFigure, quiet } from './harness.mjs'
import { differenceOf } from './snapshots.mjs'
import { judge, stills } from './stills.mjs'

test('with scripts off every figure is a still with words, and the page is whole', async (t) => {
  const page = await open(t, { scripts: false })
  judge(await stills(page))
  assert.equal(
    await page.locator('button:visible, input:visible, select:visible').count(),
    0,
    'nothing to press that would not answer',
  )
  const pictures = await page
    .locator('figure.figure-widget .still')
    .evaluateAll((all) => all.map((still) => still.innerHTML))
  assert.equal(new Set(pictures).size, pictures.length, 'each figure shows its own state')
  assert.ok((await page.locator('main p').count()) > 30)
})

test('drawings that are files follow theme and notation, and a search in the page finds their words', async (t) => {
  const page = await open(t, {
    expected: [/\.wasm|Failed to load|ERR_FAILED/i],
    prepare: (it) => it.route('**/*.wasm', (route) => route.abort()),
  })
  // It opens small; the plot comes with its last stage.
  await page.locator('#fig-bench .widget').evaluate((widget) => {
    widget.dataset.stage = '3'
  })
  const gain = page.locator('#fig-bench .still > .panel-gain')
  await gain.scrollIntoViewIfNeeded()
  await page.locator('#fig-bench .figure-failure').waitFor()
  const shot = async () => {
    await page.waitForFunction(() =>
      [...document.querySelectorAll('#fig-bench .still > img')].every(
        (image) => image.complete && image.naturalWidth > 0,
      ),
    )
    await quiet(page)
    return PNG.sync.read(await gain.screenshot())
  }
  /** The brightness of most of its pixels, and of its ink. */
  const tones = ({ data }) => {
    const all = Array.from(
      { length: data.length / 4 },
      (_, i) => (data[4 * i] + data[4 * i + 1] + data[4 * i + 2]) / 3,
    ).sort((a, b) => a - b)
    const paper = all[all.length >> 1]
    return {
      paper,
      ink: Math.abs(all[0] - paper) > Math.abs(all[all.length - 1] - paper) ? all[0] : all[all.length - 1],
    }
  }
  const light = await shot()
  const day = tones(light)
  assert.ok(day.paper > 200 && day.ink < 150, JSON.stringify(day))
  await page.locator('[data-set-theme="dark"]').click()
  const dark = await shot()
  const night = tones(dark)
  assert.ok(night.paper < 50 && night.ink > 130, JSON.stringify(night))
  await page.locator('[data-set-notation="thrun"]').click()
  await page.waitForFunction(() => document.documentElement.dataset.letters === 'thrun')
  assert.ok(differenceOf(await shot(), dark).part > 0.005, 'R(k) became K')
  await page.locator('[data-set-notation="choset"]').click()
  await page.waitForFunction(() => document.documentElement.dataset.letters === 'choset')
  assert.equal(differenceOf(await shot(), dark).part, 0)
  const found = await page.evaluate(
    () => (
      getSelection()?.removeAllRanges(),
      find('gain K and its knob g,') ? getSelection()?.anchorNode?.parentElement?.closest('figure')?.id : null
    ),
  )
  assert.equal(found, 'fig-bench')
})

/** How high a figure is, and which of its panels lie over one another. */
const laid = (page, part) =>
  page.locator('.widget').evaluate((widget, of) => {
    const boxes = [...widget.querySelectorAll(`${of} > .panel`)].map((panel) => [
      panel.getAttribute('class'),
      panel.getBoundingClientRect(),
    ])
    const over = boxes.flatMap(([name, a], i) =>
      boxes
        .slice(i + 1)
        .filter(([, b]) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1)
        .map(([other]) => `${name} and ${other}`),
    )
    return { height: widget.getBoundingClientRect().height, over }
  }, part)

for (const width of [320, 390, 768, 1280]) {
  test(`at ${width} px a still has the places and the height of the figure that comes to life`, {}, async (t) => {
    for (const at of FIGURE_PAGES) {
      /** @type {any} */
      let release
      const released = new Promise((resolve) => {
        release = resolve
      })
      const page = await open(t, {
        at,
        viewport: { width, height: 900 },
        prepare: (it) =>
          it.route('**/*.wasm', async (route) => {
            await released
            await route.continue()
          }),
      })
      await page.evaluate(() => document.fonts.ready)
      const still = await laid(page, '.still')
      release()
      await page.locator('.widget[data-state="live"]').waitFor()
      const live = await laid(page, '.live')
      assert.deepEqual([still.over, live.over], [[], []], at)
      // A sentence may be a line longer in the one than in the other.
      assert.ok(
        Math.abs(still.height - live.height) <= 30,
        `${at}: the still is ${still.height} px high, the figure ${live.height}`,
      )
    }
  })
}

test('a figure in a frame that is folded away keeps its drawing, and goes on where it was', async (t) => {
  const { page, it } = await openFigure(t, 'observer-bench')
  const sizes = () =>
    it.evaluate((widget) => [...widget.querySelectorAll('.live .panel')].map((panel) => panel.getAttribute('viewBox')))
  const before = await sizes()
  for (const width of ['1px', '90px']) {
    await page.locator('main').evaluate((main, to) => {
      main.style.width = to
    }, width)
    await it.getByRole('button', { name: 'Step' }).evaluate((button) => button.click())
    await quiet(page)
    assert.deepEqual(await sizes(), before, width)
    const negative = await it.evaluate(
      (widget) =>
        [...widget.querySelectorAll('.live svg [width], .live svg [height]')].filter(
          (part) => Number(part.getAttribute('width') ?? 0) < 0 || Number(part.getAttribute('height') ?? 0) < 0,
        ).length,
    )
    assert.equal(negative, 0, width)
  }
  await page.locator('main').evaluate((main) => {
    main.style.width = ''
  })
  await quiet(page)
  assert.deepEqual(await sizes(), before)
})

test('a figure works while it is near the screen, and the module is fetched once, when it is needed', async (t) => {
  const fetched = []
  const page = await open(t, {
    motion: 'no-preference',
    prepare: async (it) =>
      it.on('request', (request) => {
        if (request.url().endsWith('.wasm')) fetched.push(request.url())
      }),
  })
  // Before anyone scrolls, with the page at rest.
  await page.waitForLoadState('networkidle')
  assert.deepEqual(
    await page
      .locator('.widget')
      .evaluateAll((all) => all.filter((it) => it.getBoundingClientRect().top < innerHeight + 900).length),
    0,
    'no figure is near',
  )
  assert.deepEqual(fetched, [])
  const bench = page.locator('observer-bench').first()
  await bench.scrollIntoViewIfNeeded()
  await page.locator('observer-bench[data-state="live"]').first().waitFor()
  await bench.getByRole('button', { name: 'Play' }).click()
  const step = () => bench.evaluate((it) => it.frame.step)
  const start = await step()
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, start)
  // A hidden tab: here the document only says so, and frames would go on.
  const hide = (hidden) =>
    page.evaluate((it) => {
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => it })
      document.dispatchEvent(new Event('visibilitychange'))
    }, hidden)
  await hide(true)
  await quiet(page)
  const hidden = await step()
  await quiet(page, 90)
  assert.equal(await step(), hidden, 'it rests while the tab is hidden')
  await hide(false)
  await page.waitForFunction((n) => document.querySelector('observer-bench').frame.step > n, hidden)
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight))
  await quiet(page)
  const left = await step()
  await quiet(page, 90)
  assert.ok((await step()) - left <= 1, 'it rests while it is out of sight')
  assert.equal(new Set(fetched).size, 1)
  assert.equal(fetched.length, 1)
})
