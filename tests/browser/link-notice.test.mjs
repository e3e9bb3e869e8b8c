// A link's states are looked over when the page opens, wherever its figures are: what cannot be read is said at the top
// and stays said, what waits behind a question is said beside the question, and a copied link carries every figure as
// it is.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { codeOf, comeTo, figure, frameOf, open, openFigure, stateIn, tagOf, until } from './harness.mjs'

const LOOP = codeOf('loop-closure', 20, {})
const BENCH = (step) => codeOf('observer-bench', step, { sensor: 'velocity', mode: 'fixed', gain: 1, seed: 1 })
const notice = (page) => page.locator('main > .link-notice')

test('a link without a hash that cannot be read says so where the page opens, until it is dismissed', async (t) => {
  const page = await open(t, { at: 'kalman/?fig-bench=cut', prepare: ({ clock }) => clock.install() })
  await notice(page)
    .getByText(/Turn the gain.*could not be read/)
    .waitFor()
  assert.equal(await page.evaluate(() => scrollY), 0)
  assert.equal(await notice(page).locator('[role=status]').count(), 1)
  // The figure's own stays as well, longer than what is said in passing, until something is done.
  const bench = await figure(page, 'observer-bench')
  const note = bench.locator('.live .figure-note')
  await page.clock.fastForward(8500)
  assert.match(await note.innerText(), /could not be read/)
  assert.ok(await notice(page).isVisible())
  await bench.getByRole('button', { name: 'Step' }).click()
  assert.equal(await note.innerText(), '')
  await notice(page).getByRole('button', { name: 'Dismiss' }).click()
  assert.equal(await notice(page).count(), 0)
})

for (const [tag, id] of [
  ['observer-bench', 'fig-bench'],
  ['picture', 'fig-picture'],
]) {
  test(`the notice of the ${tag} can be dismissed, and the focus stays in the figure`, async (t) => {
    const { page, it: element } = await openFigure(t, tag, { query: `?${id}=cut` })
    await element.getByRole('button', { name: 'Dismiss' }).press('Enter')
    assert.equal(await element.locator('.live .figure-note').innerText(), '')
    assert.ok(await page.evaluate((name) => Boolean(document.activeElement?.closest(`${name} .live`)), tagOf(tag)))
  })
}

test('a link with a parameter out of bounds says so where the page opens', async (t) => {
  const page = await open(t, { at: `kalman/?fig-bench=${codeOf('observer-bench', 3, { gain: 1e9 })}` })
  await notice(page)
    .getByText(/Turn the gain.*could not be read/)
    .waitFor()
  assert.equal(await page.evaluate(() => scrollY), 0)
})

test('a link to a figure that is not there says so, in plain text', async (t) => {
  const page = await open(t, { at: 'kalman/?fig-%3Cimg%20src=x%3E=1&fig-nope=abc#fig-bench' })
  await notice(page).getByText('does not have: fig-nope').waitFor()
  assert.ok((await notice(page).innerText()).includes('fig-<img src'))
  assert.equal(await notice(page).locator('img').count(), 0)
  assert.ok(
    await notice(page).evaluate((it) => {
      const { top, bottom } = it.getBoundingClientRect()
      return top >= 0 && bottom <= innerHeight
    }),
    'it is on the screen, wherever the page opens',
  )
})

test('a link that can be read brings no notice', async (t) => {
  const page = await open(t, { at: `kalman/?fig-bench=${BENCH(20)}` })
  const bench = await figure(page, 'observer-bench')
  assert.equal((await frameOf(bench)).step, 20)
  assert.equal(await notice(page).count(), 0)
  assert.equal(await bench.locator('.live .figure-note').innerText(), '')
})

test('a figure whose state the link carries does not wait for its question', async (t) => {
  const page = await open(t, { at: `kalman/?fig-loop=${LOOP}` })
  // The script of the questions, which lock their figures, comes with the first of them.
  await comeTo(page, '#quiz-loop-shrinks', 'form#quiz-loop-shrinks input')
  const loop = page.locator('#fig-loop .widget')
  await loop.scrollIntoViewIfNeeded()
  await page.locator('#fig-loop .widget[data-state="live"]').waitFor()
  assert.equal((await frameOf(loop)).step, 20)
  assert.ok(!(await loop.evaluate((widget) => widget.inert)))
  assert.equal(await page.locator('#fig-loop .figure-locked').count(), 0)
})

test('a copied link carries the other figures of the address as they are, not as they were', async (t) => {
  const page = await open(t, { at: `kalman/?fig-bench=${BENCH(12)}` })
  const bench = await figure(page, 'observer-bench')
  await bench.getByRole('button', { name: 'Step' }).click()
  await until(bench, ({ step }) => step === 13, 'a step')
  const hook = await figure(page, 'odometry-hook')
  await hook.getByRole('button', { name: 'Copy link to this state' }).click()
  await hook.getByText('Link copied.').first().waitFor()
  const link = new URL(await page.evaluate(() => navigator.clipboard.readText()))
  const stepOf = (id) => stateIn(link, id).step
  assert.equal(stepOf('fig-bench'), 13)
  assert.equal(stepOf('fig-odometry'), (await frameOf(hook)).step)
  assert.deepEqual([...link.searchParams.keys()].sort(), ['fig-bench', 'fig-odometry'])
  assert.equal(link.hash, '#fig-odometry')
})
