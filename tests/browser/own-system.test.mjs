// The page of a system of one's own: what is typed, pasted and dragged becomes a system, and what cannot be one is
// named.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, frameOf, open, openFigure, PHONE, quiet, until } from './harness.mjs'

const TAG = 'own-system'
const cell = (it, matrix, row, column) => it.getByRole('textbox', { name: `${matrix}, row ${row}, column ${column}` })
const fault = (it) => it.locator('.live .own-editor > .own-fault')
const pasteFault = (it) => it.locator('.live .own-paste-fault')

test('a number that is typed changes the system at once, and a covariance stays symmetric', async (t) => {
  const { it } = await openFigure(t, TAG)
  await cell(it, 'F', 1, 2).fill('1/4')
  assert.equal((await until(it, ({ params }) => params.f[0][1] === 0.25, 'the fraction is taken')).params.f[0][1], 0.25)
  await cell(it, 'V', 1, 2).fill('0.001')
  const { params } = await until(it, ({ params }) => params.v[0][1] === 0.001, 'the entry is taken')
  assert.equal(params.v[1][0], 0.001)
  assert.equal(await cell(it, 'V', 2, 1).inputValue(), '0.001')
  assert.equal(await fault(it).textContent(), '')
})

test('each fault is named while it is typed, and the figure keeps the last system', async (t) => {
  const { it } = await openFigure(t, TAG)
  const before = (await frameOf(it)).params
  for (const [matrix, row, column, text, words] of [
    ['F', 1, 2, 'x', /^F, row 1, column 2: “x” is not a number\.$/],
    ['H', 1, 1, '', /^H, row 1, column 1: a number is missing\.$/],
    ['W', 1, 1, '-1', /^W .*negative eigenvalue/],
    ['V', 1, 2, '7', /^V .*negative eigenvalue/],
    ['F', 1, 1, '1e400', /is not a number/],
  ]) {
    const box = cell(it, matrix, row, column)
    const good = await box.inputValue()
    await box.fill(text)
    await assert.doesNotReject(fault(it).filter({ hasText: words }).waitFor(), `${matrix} ${text}`)
    assert.equal(await box.inputValue(), text, 'what was typed stays')
    await box.fill(good)
    await fault(it).filter({ hasText: /^$/ }).waitFor({ state: 'attached' })
  }
  assert.deepEqual((await frameOf(it)).params, before)
})

test('a system that is pasted is taken, its faults are named, and a preset replaces it', async (t) => {
  const { it } = await openFigure(t, TAG)
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const area = it.locator('.own-paste textarea')
  assert.match(await area.inputValue(), /^F = \[1 0\.5; 0 1\]\n/)
  await area.fill('F = [1 0; 0 0.5]\nH = [1 0]\nV = [1 0; 0 1]')
  await pasteFault(it).filter({ hasText: 'W, the noise of a reading, is missing.' }).waitFor()
  await area.fill('F = [1 0; 0 0.5]\nH = [1 0]\nV = [1 0; 0 1]\nW = 2')
  const frame = await until(it, ({ params }) => params.w[0][0] === 2, 'the system is taken')
  assert.deepEqual([frame.params.inputs, frame.observable, frame.detectable], [0, 'no', 'yes'])
  await it.locator('.verdict').filter({ hasText: 'x₂ is never seen' }).waitFor()
  await area.fill('A = [0 1; -4 -0.4]\nC = [1 0]\nQ = [0 0; 0 1]\nR = 1\nT = 0.05')
  await it.locator('.own-paste', { hasText: 'Taken as what one step does: tick “Continuous time” if' }).waitFor()
  await area.fill('F = [1e20 0.1; 0 1]\nH = [1 0]\nV = [0 0; 0 1]\nW = 2')
  await it
    .locator('.verdict')
    .filter({ hasText: /^Badly scaled: .* through which x₂ is read .*undecided/ })
    .waitFor()
  assert.equal(await it.locator('.verdict').filter({ hasText: /never/ }).count(), 0)
  await it.getByRole('combobox', { name: 'Preset' }).selectOption('Bias plus sensor')
  await it.locator('.verdict').filter({ hasText: 'value − bias is never seen' }).waitFor()
  await it.getByLabel('Name of x2').fill('offset')
  await it.locator('.verdict').filter({ hasText: 'value − offset is never seen' }).waitFor()
})

test('the box of a paste closes by its button and by Escape, and the focus goes back', async (t) => {
  const { page, it } = await openFigure(t, TAG)
  const paste = it.getByRole('button', { name: 'Paste a system' })
  for (const close of [
    () => page.keyboard.press('Escape'),
    () => it.getByRole('button', { name: 'Close' }).press('Enter'),
  ]) {
    await paste.press('Enter')
    await it.locator('.own-paste textarea').waitFor()
    await close()
    await it.locator('.own-paste').waitFor({ state: 'detached' })
    assert.ok(await paste.evaluate((button) => button === document.activeElement))
  }
})

test('an eigenvalue that is dragged takes its conjugate along, and by hand one goes on from its gain', async (t) => {
  const { page, it } = await openFigure(t, TAG)
  await it.getByRole('combobox', { name: 'Gain' }).selectOption('by placement')
  const handle = it.getByRole('slider', { name: /^Eigenvalue 1/ })
  await handle.waitFor()
  await handle.scrollIntoViewIfNeeded()
  const box = await handle.locator('.handle-dot').boundingBox()
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
  await page.mouse.down()
  await page.mouse.move(box.x + box.width / 2 - 20, box.y - 50, { steps: 4 })
  await page.mouse.up()
  const { eigenvalues, params, K } = await until(
    it,
    ({ params }) => params.poles[0][1] > 0.1,
    'the pole leaves the real line',
  )
  const [re, im] = params.poles[0]
  assert.deepEqual(
    eigenvalues.map((l) => [l.re, l.im].map((x) => Math.round(100 * x) / 100)),
    [
      [re, im],
      [re, -im],
    ],
  )
  await it.getByRole('combobox', { name: 'Gain' }).selectOption('by hand')
  const byHand = await until(it, ({ params }) => params.gain === 'hand', 'by hand')
  assert.deepEqual(byHand.K, K)
  assert.equal(
    await it.locator('.control-range:visible').filter({ hasText: /^K/ }).count(),
    2,
    'a slider for each entry',
  )
  // A box shows the digits that fit, and all of them to whoever types there.
  assert.ok(Math.abs(Number(await cell(it, 'K', 1, 1).inputValue()) - K[0][0]) < 1e-3)
  await cell(it, 'K', 1, 1).focus()
  assert.equal(await cell(it, 'K', 1, 1).inputValue(), String(K[0][0]))
  await cell(it, 'K', 2, 1).fill('0.25')
  assert.equal((await until(it, ({ params }) => params.k[1][0] === 0.25, 'an entry')).params.k[0][0], K[0][0])
})

test('the tolerance is dragged, and a verdict that it does not decide says so', async (t) => {
  const { it } = await openFigure(t, TAG)
  await cell(it, 'F', 2, 1).fill('0')
  await cell(it, 'F', 1, 2).fill('0.00001')
  await until(it, ({ params, rank }) => params.f[0][1] === 1e-5 && rank.rank === 2, 'a weak coupling')
  assert.equal(await it.locator('.live .panel-ranks').isVisible(), false, 'behind the fold')
  await it.locator('.live .own-more summary').click()
  const level = it.getByRole('slider', { name: 'Tolerance of the rank' })
  await level.focus()
  await level.press('End')
  const frame = await until(it, ({ params }) => params.logTolerance === -1, 'at the end')
  assert.equal(frame.rank.rank, 1)
})

test('a system in any book’s letters and of continuous time is taken, and its times are in seconds', async (t) => {
  const { it } = await openFigure(t, TAG)
  await it.getByRole('button', { name: 'Paste a system' }).click()
  await it
    .locator('.own-paste textarea')
    .fill(
      'T = 0.05; A = [0 1; -1 -0.1]; B = [0; 1]; C = [1 0]\n' +
        'Q = diag([0 0.1]); R = 0.01; P0 = diag([4 9]); c2d(sys, T)',
    )
  const { params, F, P } = await until(it, ({ params }) => params.continuous, 'continuous time')
  assert.deepEqual([params.period, params.spread.slice(0, 2), params.f[1][0], F[0][0] < 1], [0.05, [4, 9], -1, true])
  assert.ok(P[0][0] < 4)
  await it.getByText(/read as F, G, H, V, W\. Q as the noise of a second and .* Taken as continuous in time/).waitFor()
  assert.equal(await it.getByRole('textbox', { name: 'Length of a step, s' }).inputValue(), '0.05')
  await it.locator('.live .readout').filter({ hasText: 'Slowest time constant' }).filter({ hasText: / s$/ }).waitFor()
  await it.getByRole('textbox', { name: 'Length of a step, s' }).fill('-1')
  await fault(it).filter({ hasText: 'The length of a step is out of bounds' }).waitFor()
  await it.getByRole('textbox', { name: 'Length of a step, s' }).fill('0.1')
  await until(it, (frame) => frame.params.period === 0.1 && frame.F[0][0] < F[0][0], 'a longer step')
})

test('a run is as long as the slowest error, and the limit is that of the recursion', async (t) => {
  const { it } = await openFigure(t, TAG)
  await it.getByRole('combobox', { name: 'Preset' }).selectOption('Height, speed and bias, 0.01 s')
  const frame = await until(it, ({ step, runLength }) => step === runLength && step > 5000, 'a long run')
  assert.ok(frame.series.step.length > 200 && frame.series.step[0] === 0)
  assert.ok(frame.doubled.converged && frame.settled === null)
  const { near } = frame
  assert.ok(near > 5000 && near < frame.doubled.steps, `${near} steps to within 1 %`)
  await it
    .locator('.verdict')
    .filter({ hasText: /settles in (\d{4}|\d\.?\d*\s×\s10⁴)\ssteps, [\d.]+\ss\./ })
    .waitFor()
})

test('each state has a variance at the start', async (t) => {
  const { it } = await openFigure(t, TAG)
  await it.getByRole('textbox', { name: 'Variance at the start of state 2' }).fill('-1')
  await fault(it).filter({ hasText: 'The variance of the start is out of bounds' }).waitFor()
  await it.getByRole('textbox', { name: 'Variance at the start of state 2' }).fill('25')
  await until(it, ({ params }) => params.spread[1] === 25, 'the variance is taken')
})

test('a link holds the system, its names and the step', async (t) => {
  const { page, it } = await openFigure(t, TAG)
  await it.getByRole('combobox', { name: 'Preset' }).selectOption('DC motor, 0.05 s')
  await until(it, ({ params }) => params.states === 3, 'three states')
  await it.getByRole('button', { name: 'Copy link to this state' }).click()
  await it.getByText('Link copied.').first().waitFor()
  const before = await frameOf(it)
  await page.goto(await page.evaluate(() => navigator.clipboard.readText()))
  const again = await figure(page, TAG)
  await until(again, ({ params }) => params.states === 3, 'the state is back')
  assert.deepEqual(await frameOf(again), before)
  assert.equal(await again.getByLabel('Name of x2').inputValue(), 'speed')
})

test('each program can be copied', async (t) => {
  const { page, it } = await openFigure(t, TAG)
  for (const [language, sign] of [
    ['Rust', 'use estimate::dynamic'],
    ['JavaScript', "require('robot-motion')"],
    ['numpy', 'import numpy as np'],
  ]) {
    await it.getByRole('button', { name: `Copy as ${language}` }).click()
    await it.getByText(`The system in ${language}, copied`).waitFor()
    const text = await page.evaluate(() => navigator.clipboard.readText())
    assert.ok(text.includes(sign), text.slice(0, 80))
    assert.equal(await it.locator('.own-paste textarea').inputValue(), text)
  }
})

test('whoever copies while an entry is wrong learns that the copy is of the system before', async (t) => {
  const { it } = await openFigure(t, TAG)
  await cell(it, 'F', 1, 1).fill('abc')
  assert.deepEqual(
    await it
      .locator('.own-matrix input[aria-invalid]')
      .evaluateAll((all) => all.map((one) => one.getAttribute('aria-label'))),
    ['F, row 1, column 1'],
  )
  assert.equal(await it.locator('.own-matrix[data-wrong]').count(), 0, 'the other entries are not marked')
  await it.getByRole('button', { name: 'Copy as numpy' }).click()
  await it.getByText('The last system without a fault, in numpy, copied').waitFor()
  assert.equal(await cell(it, 'F', 1, 1).inputValue(), 'abc')
  await it.getByRole('button', { name: 'Copy link to this state' }).click()
  await it.getByText('Link copied. It holds the last state without a fault.').first().waitFor()
  await it.getByRole('button', { name: 'Embed' }).click()
  await it.getByText('Markup copied. It holds the last state without a fault.').first().waitFor()
  await cell(it, 'F', 1, 1).fill('1')
  await it.getByRole('button', { name: 'Copy link to this state' }).click()
  await it.getByText('Link copied.', { exact: true }).first().waitFor()
})

test('a change of the system from elsewhere takes the place of what could not be read', async (t) => {
  const { it } = await openFigure(t, TAG)
  await cell(it, 'F', 1, 1).fill('abc')
  await fault(it).filter({ hasText: 'is not a number' }).waitFor()
  await it.getByRole('button', { name: 'Add a bias to a sensor' }).click()
  await it.locator('.verdict').filter({ hasText: 'value − bias is never seen' }).waitFor()
  assert.deepEqual([await fault(it).textContent(), await cell(it, 'F', 1, 1).inputValue()], ['', '1'])
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const area = it.locator('.own-paste textarea')
  await area.fill('F = [1 2; 3]')
  await pasteFault(it).filter({ hasText: 'F: row 2 has 1 number, row 1 has 2.' }).waitFor()
  await it.getByRole('button', { name: 'Read the velocity alone' }).click()
  await pasteFault(it).filter({ hasText: /^$/ }).waitFor({ state: 'attached' })
  assert.match(await area.inputValue(), /^F = \[1 0\.5; 0 1\]\n.*\nH = \[0 1\]/)
})

test('the state in the plots is chosen by its name', async (t) => {
  const { it } = await openFigure(t, TAG)
  const choice = it.getByRole('combobox', { name: 'State in the plots' })
  await choice.selectOption('velocity')
  assert.equal((await until(it, ({ params }) => params.shown === 2, 'the velocity')).params.states, 2)
  await it.getByLabel('Name of x2').fill('')
  await choice.locator('option', { hasText: 'x₂' }).waitFor({ state: 'attached' })
  assert.deepEqual(await choice.locator('option:not([hidden])').allTextContents(), ['position', 'x₂'])
})

for (const width of [320, 390, 1280]) {
  test(`four states and four readings fit a page ${width} px wide`, async (t) => {
    const page = await open(t, { at: 'system/', viewport: { ...PHONE, width } })
    const it = await figure(page, TAG)
    for (const [name, count] of [
      ['States', '4'],
      ['Inputs', '4'],
      ['Readings', '4'],
    ])
      await it.getByRole('combobox', { name, exact: true }).selectOption(count)
    await until(it, ({ params }) => params.readings === 4 && params.states === 4, 'four of each')
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width)
    const cells = await it
      .locator('.own-matrix:not([hidden]) input:visible')
      .evaluateAll((all) =>
        all.map((one) => one.getBoundingClientRect()).map(({ width, height, right }) => ({ width, height, right })),
      )
    assert.equal(cells.length, 16 * 5 + 4)
    for (const one of cells) assert.ok(one.height >= 44 && one.width >= 44 && one.right <= width, JSON.stringify(one))
  })
}

test('what is pressed stays under the finger on a phone, though the matrices above it grow', async (t) => {
  const { it } = await openFigure(t, TAG, { viewport: PHONE, touch: true })
  for (const [phrase, states] of [
    ['Place the eigenvalues yourself', 3],
    ['Read the velocity alone', 2],
    ['Place the eigenvalues yourself', 3],
  ]) {
    const button = it.locator('.live .tries').getByRole('button', { name: phrase })
    await button.scrollIntoViewIfNeeded()
    const top = () => button.evaluate((pressed) => pressed.getBoundingClientRect().top)
    const before = await top()
    await button.tap()
    await until(it, ({ params }) => params.states === states, phrase)
    await quiet(it.page())
    assert.ok(Math.abs((await top()) - before) < 2, `${phrase}: ${before} px from the top, ${await top()} afterwards`)
  }
})
