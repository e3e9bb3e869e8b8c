// While a system has a fault, what is shown is that of the system before: nobody may take it for the faulty one's.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, open } from './harness.mjs'

/** How a part is drawn, and what stands before and behind its own words. */
const drawn = (/** @type {import('playwright-core').Locator} */ part) =>
  part.evaluate((it) => ({
    opacity: getComputedStyle(it).opacity,
    before: getComputedStyle(it, '::before').content,
    after: getComputedStyle(it, '::after').content,
  }))

for (const theme of /** @type {const} */ (['light', 'dark'])) {
  test(`beside a faulty paste all numbers are said to be of the system before, in the ${theme} theme`, async (t) => {
    const page = await open(t, { at: 'system/', theme })
    const it = await figure(page, 'own-system')
    const [readouts, verdict, matrices, fault, pasteFault] = [
      '.readouts',
      '.verdict',
      '.own-grids',
      '.own-editor > .own-fault',
      '.own-paste-fault',
    ].map((part) => it.locator(`.live ${part}`))
    await it.getByRole('button', { name: 'Paste a system' }).click()
    const area = it.locator('.own-paste textarea')
    await area.fill('A = [0 1; -4 -0.4]\nC = [1 0]\nQ = eye(2)')
    await pasteFault.filter({ hasText: 'R, the noise of a reading, is missing.' }).waitFor()
    assert.match((await drawn(pasteFault)).after, /The matrices and the answers below are still of the system before/)
    assert.equal((await drawn(fault)).after, 'none')
    for (const part of [readouts, verdict]) {
      const { before, opacity } = await drawn(part)
      // What says so is not pale itself.
      assert.deepEqual([before, opacity], ['"Of the system before the fault: "', '1'])
    }
    assert.equal((await drawn(matrices)).opacity, '0.45')
    assert.equal((await drawn(it.locator('.live > svg').first())).opacity, '0.45')
    assert.equal((await drawn(readouts.locator('> *').first())).opacity, '0.45')
    // What is not understood stays, with its fault, when something else is changed meanwhile.
    await it.getByRole('checkbox', { name: 'Continuous time' }).press('Space')
    await it.locator('.own-time input[checked]').waitFor()
    assert.deepEqual(
      [await area.inputValue(), await pasteFault.textContent()],
      ['A = [0 1; -4 -0.4]\nC = [1 0]\nQ = eye(2)', 'R, the noise of a reading, is missing.'],
    )
    await area.fill('A = [0 1; -4 -0.4]\nC = [1 0]\nQ = eye(2)\nR = 1')
    await pasteFault.filter({ hasText: /^$/ }).waitFor({ state: 'attached' })
    assert.deepEqual(
      [(await drawn(readouts)).before, (await drawn(pasteFault)).after, (await drawn(matrices)).opacity],
      ['none', 'none', '1'],
    )
    // An entry that is typed stands in its matrix, which is therefore not pale.
    await it.getByRole('textbox', { name: 'F, row 1, column 2' }).fill('x')
    await fault.filter({ hasText: 'is not a number' }).waitFor()
    assert.match((await drawn(fault)).after, /^" The answers below are still of the system before/)
    assert.equal((await drawn(matrices)).opacity, '1')
  })
}
