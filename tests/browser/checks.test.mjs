// The page of the checks: all thirteen, one after another in the reader's browser, each with its own time.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import path from 'node:path'
import { PHONE, open, root } from './harness.mjs'

const core = createRequire(import.meta.url)(path.join(root, 'target/pkg/node/estimate_wasm.js'))

test('on a phone the values of the build and of the browser are on the screen', async (t) => {
  const page = await open(t, { at: 'check/', viewport: PHONE, touch: true })
  await page.getByRole('button', { name: 'Run the checks here' }).tap()
  await page
    .getByRole('status')
    .filter({ hasText: /^13 of 13/ })
    .waitFor()
  const beyond = await page
    .locator('[data-check] > *')
    .evaluateAll((all) =>
      all.filter((cell) => cell.getBoundingClientRect().right > innerWidth).map((cell) => cell.textContent),
    )
  assert.deepEqual(beyond, [])
})

test('the thirteen checks pass in the browser, each with its time and the values of the build', async (t) => {
  const page = await open(t, { at: 'check/' })
  // How many rows had their values when the browser had its turn.
  await page.evaluate(() => {
    globalThis.seen = []
    new MutationObserver(() => globalThis.seen.push(document.querySelectorAll('[data-passed]').length)).observe(
      document.querySelector('.checks'),
      { subtree: true, attributes: true, attributeFilter: ['data-passed'] },
    )
  })
  const button = page.getByRole('button', { name: 'Run the checks here' })
  const summary = page.getByRole('status')
  await button.click()
  await summary.filter({ hasText: /^13 of 13 checks pass in this browser; together they took [\d.]+\sms\.$/ }).waitFor()
  assert.deepEqual(
    await page.evaluate(() => globalThis.seen),
    Array.from({ length: 13 }, (_, i) => i + 1),
    'the browser has its turn after each',
  )

  const rows = await page.locator('[data-check]').evaluateAll((all) =>
    all.map((row) => ({
      id: Number(row.dataset.check),
      passed: row.dataset.passed,
      ...Object.fromEntries(
        ['title', 'expected', 'native', 'here', 'tolerance', 'time'].map((cell) => [
          cell,
          row.querySelector(`.check-${cell}`).textContent,
        ]),
      ),
      source: row.querySelector('a').href,
    })),
  )
  assert.deepEqual(
    rows.map(({ id }) => id),
    core.chapterChecks().map(({ id }) => id),
  )
  let whole = 0
  for (const { id, passed, native, here, expected, tolerance, time } of rows) {
    assert.equal(passed, 'true', `check ${id}`)
    assert.match(time, /^(<\s0\.1|\d+\.\d)\sms$/, `check ${id}`)
    whole += /^</.test(time) ? 0 : parseFloat(time)
    assert.equal(here, `✓ ${native}`, `check ${id}: here and at build`)
    assert.ok(expected.length > 0 && tolerance.length > 0)
  }
  const total = Number(/took ([\d.]+)\sms/.exec(await summary.textContent())[1])
  assert.ok(Math.abs(total - whole) <= 13 * 0.1 + 0.1, `the times add up to ${whole}, said is ${total}`)

  // The values printed are those of the module, to seven digits, but to no more than the tolerance.
  const read = (text) => text.replace('✓ ', '').replaceAll('−', '-').split(', ').map(Number)
  for (const { id, here } of rows) {
    const { actual, tolerance } = core.chapterCheck(id)
    read(here).forEach((value, i) =>
      assert.ok(
        Math.abs(value - actual[i]) <= 1e-6 * Math.abs(actual[i]) + Math.min(tolerance, 1e-6),
        `check ${id}: ${value} is ${actual[i]}`,
      ),
    )
  }

  // Each source is the test, at its line.
  for (const { id, source } of rows) {
    const [address, line] = source.split('#')
    const text = await (await page.request.get(address)).text()
    assert.ok(text.includes(`id="${line}"`), `check ${id}: ${line}`)
    const at = text
      .slice(text.indexOf(`id="${line}"`))
      .slice(0, 600)
      .replace(/<[^>]*>/g, '')
    assert.ok(at.includes(`fn check_${id}_`), `check ${id} is at ${line}: ${at.slice(0, 90)}`)
  }

  // Once more: the old values go, and they come again.
  await summary.evaluate((said) => {
    said.textContent = ''
  })
  await button.click()
  await summary.filter({ hasText: /^13 of 13/ }).waitFor()
  assert.equal(await page.locator('[data-passed="true"]').count(), 13)
})

test('a module that cannot be fetched is said, and the button works again', async (t) => {
  const page = await open(t, {
    at: 'check/',
    expected: [/\.wasm/, /failed to fetch|Failed to load|ERR_FAILED/i],
    prepare: (it) => it.route('**/*.wasm', (route) => route.abort()),
  })
  const button = page.getByRole('button', { name: 'Run the checks here' })
  await button.click()
  await page.getByRole('status').filter({ hasText: 'its module could not be fetched' }).waitFor()
  await page.unroute('**/*.wasm')
  await button.click()
  await page
    .getByRole('status')
    .filter({ hasText: /^13 of 13/ })
    .waitFor()
})
