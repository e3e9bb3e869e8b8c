// A long run is computed in slices: the page goes on painting, a bar says how far it has come, and it can be given up.
// None of these tests asks how long anything takes: they ask what was painted, and how many steps one call of the lab
// was given.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { HEAP } from '../heap.mjs'
import { codeOf, frameOf, open, openFigure, root, stateOf, until } from './harness.mjs'

const estimate = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))
const probeAt = (step, params) => `figure/observability-probe/?fig-probe=${codeOf('observability-probe', step, params)}`

/** Notes at every animation frame what the bar of the figure `tag` says. */
const noteBar = (page, tag) =>
  page.addInitScript((name) => {
    globalThis.bars = []
    const look = () => {
      requestAnimationFrame(look)
      const box = document.querySelector(`${name} .live .progress:not([hidden])`)
      if (box) globalThis.bars.push(box.querySelector('progress').value)
    }
    look()
  }, tag)

/** The figure alive, whatever it still computes. */
async function alive(page, tag) {
  const element = page.locator(tag).first()
  await element.scrollIntoViewIfNeeded()
  await page.locator(`${tag}[data-state="live"]`).first().waitFor()
  return element
}

/**
 * Gives the probe's replay up once its bar has moved, in the animation frame that shows it: a look or a press from here
 * may come when the replay has ended. Before, it notes what the page shows meanwhile.
 */
const giveUp = (page) =>
  page.addInitScript(() => {
    const look = () => {
      const probe = document.querySelector('observability-probe')
      const box = probe?.querySelector('.live .progress:not([hidden])')
      const cancel = [...(box?.querySelectorAll('button') ?? [])].find((one) => one.textContent === 'Cancel')
      const forget = [...(probe?.querySelectorAll('.live label') ?? [])].find((one) =>
        one.textContent?.includes('forget the map'),
      )
      if (new Set(globalThis.bars).size < 4 || !cancel) return requestAnimationFrame(look)
      const { frame, state } = /** @type {any} */ (probe)
      globalThis.meanwhile = {
        words: box.textContent,
        step: frame.step,
        state: [state.step, state.params.forget],
        forget: forget?.querySelector('input')?.checked ?? null,
      }
      cancel.focus()
      cancel.click()
    }
    look()
  })

test('a link to step 100,000 of a crowded map leaves the page responsive, and can be given up', async (t) => {
  const page = await open(t, {
    at: probeAt(100_000, HEAP),
    prepare: async (it) => {
      await noteBar(it, 'observability-probe')
      await giveUp(it)
    },
  })
  const probe = await alive(page, 'observability-probe')
  await page.waitForFunction(() => globalThis.meanwhile)
  const { words, ...meanwhile } = await page.evaluate(() => globalThis.meanwhile)
  assert.match(words, /Computing step [\d,]+ of 100,000/)
  // The usual picture meanwhile, with the controls of the link.
  assert.deepEqual(meanwhile, { step: 240, state: [100_000, true], forget: true })
  const bars = await page.evaluate(() => globalThis.bars)
  assert.ok(
    bars.every((value, i) => i === 0 || value >= bars[i - 1]),
    'the bar only grows',
  )
  const frame = await until(probe, ({ params }) => !params.forget, 'the usual figure stays')
  assert.equal(frame.step, 240)
  assert.ok(!(await probe.locator('.live .progress').isVisible()))
  assert.ok(!(await probe.getByRole('checkbox', { name: 'forget the map' }).isChecked()))
  assert.ok(
    await page.evaluate(() => Boolean(document.activeElement?.closest('observability-probe .live'))),
    'the focus stays in the figure',
  )
  await probe.getByRole('button', { name: 'Step' }).click()
  await until(probe, ({ step }) => step === 241, 'it goes on from there')
})

test('a link to the last step of all opens in many short calls, to the bits of one', async (t) => {
  const page = await open(t, {
    at: probeAt(100_000, { count: 2 }),
    motion: 'no-preference',
    prepare: (it) => noteBar(it, 'observability-probe'),
  })
  const probe = await alive(page, 'observability-probe')
  await until(probe, ({ step }) => step === 100_000, 'it arrives')
  const whole = estimate.ObservabilityProbe.from({
    version: 1,
    lab: 'observability-probe',
    params: { count: 2 },
    step: 100_000,
  })
  assert.equal(await probe.evaluate((it) => it.figure.lab.digest()), whole.digest())
  assert.deepEqual(await stateOf(probe), whole.state())
  // The run ends here, in a reader's words.
  await probe.getByRole('button', { name: 'Play' }).click()
  await probe
    .locator('.live .figure-note')
    .getByText(/ends here, at step 100,000/)
    .waitFor()
  assert.ok(await probe.getByRole('button', { name: 'Play' }).isVisible(), 'it does not play')
  await probe.getByRole('button', { name: 'Step' }).click()
  assert.match(await probe.locator('.live .figure-note').innerText(), /ends here/)
  assert.equal((await frameOf(probe)).step, 100_000)
})

test('fast play reaches the last step, and stops there', async (t) => {
  const { it: hook } = await openFigure(t, 'odometry-hook', {
    query: `?fig-odometry=${codeOf('odometry-hook', 99_700, {})}`,
    motion: 'no-preference',
  })
  await hook.getByRole('combobox', { name: 'Speed' }).selectOption({ label: '10×' })
  await hook.getByRole('button', { name: 'Play', exact: true }).click()
  // Play stops at the end of each lap of 640 ticks.
  await until(hook, ({ step }) => step === 99_840, 'the end of a lap')
  await hook.getByRole('button', { name: 'Play', exact: true }).click()
  await until(hook, ({ step }) => step === 100_000, 'the last step')
  await hook.getByRole('button', { name: 'Play', exact: true }).waitFor()
  await hook
    .locator('.live .figure-note')
    .getByText(/ends here/)
    .waitFor()
})

test('a change during a long replay supersedes it; a key moves the knob on from where it was', async (t) => {
  const page = await open(t, { at: probeAt(60_000, { count: 3 }) })
  const probe = await alive(page, 'observability-probe')
  await until(probe, ({ step }) => step === 60_000, 'it arrives')
  // Each call of the lab from here on is noted.
  await probe.evaluate((it) => {
    const lab = Object.getPrototypeOf(it.figure.lab)
    const { run } = lab
    globalThis.calls = []
    lab.run = function noted(n) {
      globalThis.calls.push(n)
      return run.call(this, n)
    }
  })
  const seed = probe.getByRole('spinbutton', { name: 'Seed' })
  await seed.fill('5')
  await seed.press('Enter')
  const landmark = probe.locator('.live [aria-label*="Landmark 1"]').first()
  const before = (await frameOf(probe)).params.landmarks[0][0]
  for (let i = 0; i < 3; i++) await landmark.press('ArrowLeft')
  const { params } = await until(
    probe,
    (frame) => frame.params.seed === 5 && frame.params.landmarks[0][0] < before - 0.12,
    'both changes hold',
  )
  assert.ok(Math.abs(params.landmarks[0][0] - (before - 0.15)) < 1e-9, 'each press counts')
  const calls = await page.evaluate(() => globalThis.calls)
  t.diagnostic(`${calls.length} calls, the longest of ${Math.max(...calls)} steps`)
  assert.ok(calls.length > 20 && Math.max(...calls) < 20_000)
})
