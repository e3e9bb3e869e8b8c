// What Q and R of a paste mean where their sizes do not tell: as the page's letters have it, or as a button says.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { openFigure, until } from './harness.mjs'

test('a paste of Thrun’s letters is read as the page is, and a button turns Q and R round', async (t) => {
  const { page, it } = await openFigure(t, 'own-system')
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const area = it.locator('.own-paste textarea')
  await area.fill('A=[1 1;0 1]; C=[1 0;0 1]; R=[4 0;0 9]; Q=[0.1 0;0 0.2]')
  await until(it, ({ params }) => params.v[0][0] === 0.1 && params.w[1][1] === 9, 'Q is of the motion')
  await it.getByText('Q as the noise of a step and R as the noise of a reading, as is common').waitFor()
  await it.getByRole('button', { name: 'Take R as the noise of the motion' }).click()
  await until(it, ({ params }) => params.v[0][0] === 4 && params.w[1][1] === 0.2, 'R is of the motion')
  await it.getByRole('button', { name: 'Take Q as the noise of the motion' }).waitFor()
  await it.getByRole('button', { name: 'Close' }).click()
  await page.evaluate(() => document.documentElement.setAttribute('data-notation', 'thrun'))
  await it.getByRole('button', { name: 'Paste a system' }).click()
  await area.fill('A=[1 1;0 1]; C=[1 0;0 1]; R=[5 0;0 9]; Q=[0.1 0;0 0.2]')
  await it.getByText('R as the noise of a step and Q as the noise of a reading, as in Thrun’s letters').waitFor()
  await until(it, ({ params }) => params.v[0][0] === 5, 'R is of the motion')
  await area.fill('A=[1 1;0 1]; C=[1 0]; R=[5 0;0 9]; Q=0.1')
  await it.getByRole('button', { name: /as the noise of the motion/ }).waitFor({ state: 'hidden' })
})

test('a script that computes F from A is taken, and it is said what is a variable of it', async (t) => {
  const { it } = await openFigure(t, 'own-system')
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const area = it.locator('.own-paste textarea')
  await area.fill('A = [0 1; -4 -0.4]; B = [0; 1]; T = 0.1\nF = expm(A*T)\nH = [1 0]; Q = 0.01*eye(2); R = 1; R *= 5')
  await it
    .getByText(/Taken as variables of the formulas alone: A\. B as what an input does in one step: write G = …/)
    .waitFor()
  await until(
    it,
    ({ params }) => params.w[0][0] === 5 && !params.continuous && params.f[1][0] < -0.38,
    'F is of a step',
  )
  await area.fill('Phi = [1 0.1; 0 1]; H = [1 0]; Q = eye(2); R = 1')
  await it.getByText('Phi, Q, R read as F, V, W.').waitFor()
  const readout = it.locator('.live .readout').filter({ hasText: 'Inputs reach all' })
  await readout.filter({ hasText: 'there are none' }).waitFor()
})

test('an F that looks like rates is asked about beside the matrices, and a button ticks Continuous time', async (t) => {
  const { page, it } = await openFigure(t, 'own-system')
  const button = it.getByRole('button', { name: 'Take F as continuous in time' })
  const box = it.getByRole('checkbox', { name: 'Continuous time' })
  await button.waitFor({ state: 'hidden' })
  await it.getByRole('button', { name: 'Paste a system' }).click()
  const area = it.locator('.own-paste textarea')
  await area.fill('F = [0 1 0; 0 -10 5; 0 -1 -20]\nH = [1 0 0]\nQ = diag([0 0.5 0.2])\nR = 0.0001\nT = 0.005')
  await it.locator('.live .own-asks').getByText('Is F of a differential equation?').waitFor()
  await it.locator('.live .verdict').filter({ hasText: 'looks like one of a differential equation' }).waitFor()
  await button.click()
  const { F, params } = await until(it, ({ params }) => params.continuous, 'F is of rates')
  assert.ok(params.period === 0.005 && F[0][0] === 1 && Math.abs(F[1][1] - Math.exp(-0.05)) < 1e-3, String(F))
  await button.waitFor({ state: 'hidden' })
  assert.ok(await box.evaluate((one) => one === document.activeElement && one.checked))
  await box.uncheck()
  await button.waitFor()
  // Where no length of a step is given, it has the usual one.
  await area.fill('F = [0 1; -4 -0.4]\nH = [1 0]\nV = [0 0; 0 1]\nW = 1')
  await until(it, ({ params: now }) => now.states === 2 && now.period === 0, 'a spring')
  await button.focus()
  await page.keyboard.press('Enter')
  await until(it, ({ params: now }) => now.continuous && now.period === 0.1, 'each tenth of a second')
})
