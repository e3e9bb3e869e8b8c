// Each figure in a frame of somebody else's page, from another origin and under `sandbox="allow-scripts"` alone: it
// comes to life, answers to mouse and keys, tells its height, takes the theme, and says nothing in the console.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { LAST_STEP } from '../../web/figure/state-in-url.js'
import { HEAP } from '../heap.mjs'
import { around, changes, lively, stateOf } from './embedding.mjs'
import { codeOf, pageOf, quiet, stage, stateIn, tagOf } from './harness.mjs'
import { WIDGETS } from '../../web/widgets/index.js'

/** What the pages with figures call themselves. */
const NAMES = { 'kalman/': /chapter 15/, 'kalman/filter/': /chapter 15/, 'system/': /Your own system/ }

for (const name of Object.keys(WIDGETS)) {
  test(`the ${name} lives in a sandboxed frame of another origin`, async (t) => {
    const { site } = await stage()
    const { page, frame, inner } = await around(t, { src: `${site.url}figure/${name}/?theme=dark` })
    const it = await lively(frame, name)
    assert.equal(await inner().evaluate(() => self.origin), 'null', 'it has no origin of its own')
    assert.equal(await frame.locator('[inert], [data-locked], .figure-locked').count(), 0, 'no question locks it')

    // Its height: the frame gets it, and then nothing in it scrolls.
    await page.waitForFunction(() =>
      messages.some(({ data, ours }) => ours && data.type === 'robot-motion:height' && data.height > 300),
    )
    await inner().waitForFunction(() => document.documentElement.scrollHeight <= innerHeight + 1)
    assert.ok(
      (await page.evaluate(() => messages)).every(
        ({ ours, data }) => ours && data.type === 'robot-motion:height' && Number.isInteger(data.height),
      ),
    )

    // By mouse and by keys.
    const slider = it.locator('.live input[type=range]:enabled:visible').first()
    if (await slider.count()) {
      await slider.scrollIntoViewIfNeeded()
      const { x, y, width, height } = await slider.boundingBox()
      await changes(it, () => page.mouse.click(x + 0.31 * width, y + height / 2), 'a click on a slider')
      await changes(it, () => slider.press('ArrowRight'), 'an arrow on a slider')
    }
    const handle = it.locator('.live svg [role=slider]:visible').first()
    if (await handle.count()) {
      await handle.scrollIntoViewIfNeeded()
      const grip = await handle.locator('.handle-dot').boundingBox()
      await page.mouse.move(grip.x + 3, grip.y + 3)
      await page.mouse.down()
      // Inwards: a handle may stand at its end.
      const panel = await handle.locator('xpath=ancestor::*[contains(@class, "panel")][1]').boundingBox()
      const inwards = grip.x > panel.x + panel.width / 2 ? -1 : 1
      await changes(
        it,
        async () => {
          await page.mouse.move(grip.x - 40 * inwards, grip.y - 25, { steps: 4 })
          await page.mouse.move(grip.x + 40 * inwards, grip.y + 25, { steps: 8 })
        },
        'a handle that is dragged',
      )
      await page.mouse.up()
      await changes(it, () => handle.press('ArrowLeft'), 'an arrow on a handle')
    }
    const step = it.getByRole('button', { name: 'Step', exact: true })
    if (await step.count()) await changes(it, () => step.click(), 'Step')

    // Its faces are there: the figure is written in the book's own letters.
    assert.ok(
      await inner().evaluate(
        async () => (await document.fonts.ready, [...document.fonts].some(({ status }) => status === 'loaded')),
      ),
    )

    // The theme of its address, and then the one it is told.
    const theme = () => inner().evaluate(() => document.documentElement.dataset.theme ?? 'auto')
    assert.equal(await theme(), 'dark')
    for (const wanted of ['light', 'auto', 'dark']) {
      await page.evaluate(
        (value) =>
          document.querySelector('iframe').contentWindow.postMessage({ type: 'robot-motion:theme', theme: value }, '*'),
        wanted,
      )
      await inner().waitForFunction((value) => (document.documentElement.dataset.theme ?? 'auto') === value, wanted)
    }
    // Nothing else is believed.
    const before = await stateOf(it)
    for (const data of [
      { type: 'robot-motion:theme', theme: 'pink' },
      { type: 'robot-motion:state', step: 3 },
      'light',
      null,
      7,
      { type: 'robot-motion:theme' },
    ]) {
      await page.evaluate((value) => document.querySelector('iframe').contentWindow.postMessage(value, '*'), data)
    }
    // Nor a message of another window.
    await inner().evaluate(() => postMessage({ type: 'robot-motion:theme', theme: 'light' }, '*'))
    await quiet(page)
    assert.equal(await theme(), 'dark')
    assert.equal(await stateOf(it), before)
  })

  test(`the ${name} fits a frame of 320 px`, async (t) => {
    const { site } = await stage()
    const { frame, inner } = await around(t, { src: `${site.url}figure/${name}/`, width: 320 })
    await lively(frame, name)
    assert.equal(await inner().evaluate(() => innerWidth), 320)
    assert.ok(await inner().evaluate(() => document.documentElement.scrollWidth <= 320), 'nothing scrolls sideways')
  })

  test(`the markup that the ${name} offers shows the same state on another page`, async (t) => {
    const { browser, site } = await stage()
    const context = await browser.newContext({
      viewport: { width: 1000, height: 900 },
      reducedMotion: 'reduce',
      permissions: ['clipboard-read', 'clipboard-write'],
      serviceWorkers: 'block',
    })
    t.after(() => context.close())
    const own = await context.newPage()
    await own.goto(`${site.url}figure/${name}/`)
    const it = await lively(own, name)
    await it.evaluate((host) => host.querySelectorAll('.live .controls details').forEach((fold) => (fold.open = true)))
    // A figure without a slider has a handle, or a box to write in.
    const knob = it.locator('.live :is(input[type=range]:enabled, svg [role=slider])').locator('visible=true').last()
    const write = async () => {
      await it.locator('.live textarea:not([readonly])').fill('x = F x')
      await own.keyboard.press('Tab')
    }
    await changes(it, async () => ((await knob.count()) ? knob.press('Shift+ArrowLeft') : write()), 'a knob or a text')
    const there = await stateOf(it)
    await it.getByRole('button', { name: 'Embed' }).click()
    const box = it.locator('.copy-box textarea')
    const markup = await box.inputValue()
    assert.ok(
      await box.evaluate((area) => area === document.activeElement && area.selectionEnd === area.value.length),
      'it is selected',
    )
    await it.getByText('Markup copied.').first().waitFor()
    assert.equal(await own.evaluate(() => navigator.clipboard.readText()), markup)
    await box.press('Escape')
    assert.equal(await it.locator('.copy-box').count(), 0)
    assert.ok(
      await own.evaluate((tag) => Boolean(document.activeElement?.closest(`${tag} .live`)), tagOf(name)),
      'the focus stays in the figure',
    )
    assert.match(markup, /^<iframe [^<>]*><\/iframe>$/)

    const { page, frame, inner } = await around(t, { markup })
    const shown = await lively(frame, name)
    assert.equal(await stateOf(shown), there)
    const { title, sandbox } = await page.evaluate(() => {
      const { title, sandbox } = document.querySelector('iframe')
      return { title, sandbox: String(sandbox) }
    })
    assert.ok(title.length > 5 && sandbox.includes('allow-scripts') && !sandbox.includes('allow-same-origin'))
    assert.equal(await inner().evaluate(() => self.origin), 'null')
    // The way back to its place in the chapter.
    const place = pageOf(name)
    const id = await shown.evaluate((host) => host.dataset.figure)
    const way = frame.locator('.figure-source').getByRole('link')
    assert.match(await way.textContent(), NAMES[place])
    assert.equal(await way.evaluate(({ href }) => href), `${site.url}${place}#${id}`)
    const [opened] = await Promise.all([page.context().waitForEvent('page'), way.click()])
    await opened.waitForLoadState('domcontentloaded')
    assert.ok(opened.url().startsWith(`${site.url}${place}`) && opened.url().endsWith(`#${id}`))
    await opened.close()
  })
}

test('in a frame a link is shown where the clipboard is closed, and there is nothing to download', async (t) => {
  const { site } = await stage()
  const { frame } = await around(t, {
    src: `${site.url}figure/observer-bench/?fig-limit=${codeOf('observer-bench', 20, { gain: 2.5 })}`,
  })
  const bench = await lively(frame, 'observer-bench')
  assert.deepEqual(
    [JSON.parse(await stateOf(bench)).step, JSON.parse(await stateOf(bench)).params.gain],
    [20, 2.5],
    'a state under the other name of the figure',
  )
  assert.equal(await bench.getByRole('button', { name: /Download/ }).count(), 0)
  await bench.getByRole('button', { name: 'Copy link to this state' }).click()
  const link = new URL(await bench.locator('.copy-box textarea').inputValue())
  assert.equal(link.pathname, `${new URL(site.url).pathname}figure/observer-bench/`)
  assert.equal(stateIn(link, 'fig-limit').step, 20)
})

test('a long run in a frame is computed in slices, without a worker', async (t) => {
  const { site } = await stage()
  const state = codeOf('observability-probe', LAST_STEP, HEAP)
  const { frame } = await around(t, { src: `${site.url}figure/observability-probe/?fig-probe=${state}` })
  const probe = await lively(frame, 'observability-probe')
  await probe
    .getByText(/Computing step [\d,]+ of 100,000/)
    .first()
    .waitFor()
  // By a key: while the frame is still finding its height, a pointer may have to come again, and the run end meanwhile.
  await probe.getByRole('button', { name: 'Cancel' }).press('Enter')
  assert.equal(JSON.parse(await stateOf(probe)).step, 240)
})

test('in a frame the likelihood’s map is filled in slices, without a worker, and the loop is driven', async (t) => {
  const { site } = await stage()
  const { page, frame } = await around(t, { src: `${site.url}figure/tune/` })
  const tune = await lively(frame, 'tune')
  await tune.evaluate(async (host) => {
    while (host.figure.beside.value?.rows !== host.figure.beside.value?.size || !host.figure.beside.value)
      await new Promise((resolve) => requestAnimationFrame(resolve))
  })
  assert.ok(await tune.locator('.live .panel-map .likely').first().getAttribute('d'))
  assert.equal(page.workers().length, 0)

  const other = await around(t, {
    src: `${site.url}figure/loop-closure/?fig-loop=${codeOf('loop-closure', 112, {})}`,
  })
  const loop = await lively(other.frame, 'loop-closure')
  assert.equal(JSON.parse(await stateOf(loop)).step, 112)
  await loop.getByRole('button', { name: 'Step', exact: true }).click()
  await loop
    .locator('.live .verdict')
    .filter({ hasText: /landmarks’ mean σ shrank from/ })
    .waitFor()
  assert.equal(other.page.workers().length, 0)
})

test("a figure's own page takes a theme of its address, and is whole without scripts", async (t) => {
  const { browser, site } = await stage()
  for (const [theme, paper] of [
    ['light', 'rgb(255, 253, 248)'],
    ['dark', 'rgb(20, 22, 26)'],
  ]) {
    const context = await browser.newContext({
      colorScheme: theme === 'light' ? 'dark' : 'light',
      serviceWorkers: 'block',
    })
    t.after(() => context.close())
    const page = await context.newPage()
    await page.goto(`${site.url}figure/observer-bench/?theme=${theme}`)
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), paper)
  }
  const context = await browser.newContext({ javaScriptEnabled: false })
  t.after(() => context.close())
  const page = await context.newPage()
  await page.goto(`${site.url}figure/observer-bench/`)
  assert.ok(await page.locator('.still svg').first().isVisible())
  assert.equal(await page.locator('button:visible, input:visible, select:visible').count(), 0)
  assert.ok(await page.getByRole('link', { name: /chapter 15/ }).isVisible())
})
