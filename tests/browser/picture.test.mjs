// The Picture: prediction, axes, reading and noise under mouse and keys; what the text says of the two feet holds
// wherever they are put.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { apart, close, handle, holds, noise, pull, unitOf } from './picture.mjs'
import { dragSlider, frameOf, openFigure, until } from './harness.mjs'

const picture = (t) => openFigure(t, 'picture')

test('the prediction moves by mouse and by keys, and both feet stay on the line', async (t) => {
  const { page, it } = await picture(t)
  const mean = handle(it, 'Prediction')
  const unit = await unitOf(it)
  const start = (await holds(it)).params.mean
  assert.deepEqual(start, [4, 4])
  await pull(page, mean, -70, 45)
  await until(
    it,
    ({ params }) =>
      close(params.mean[0], start[0] - 70 / unit, 0.02) && close(params.mean[1], start[1] - 45 / unit, 0.02),
    'it follows the mouse',
  )
  const dragged = (await holds(it)).params.mean
  for (const [key, dx, dy] of [
    ['ArrowRight', 0.05, 0],
    ['ArrowUp', 0, 0.05],
    ['ArrowLeft', -0.05, 0],
    ['ArrowDown', 0, -0.05],
    ['Shift+ArrowUp', 0, 0.5],
    ['PageDown', 0, -0.5],
  ]) {
    const { mean: before } = (await frameOf(it)).params
    await mean.press(key)
    await until(it, ({ params }) => close(params.mean[0], before[0] + dx) && close(params.mean[1], before[1] + dy), key)
  }
  const keyed = (await holds(it)).params.mean
  assert.ok(apart(dragged, keyed) < 1e-9, 'there and back')
  await mean.press('End')
  const {
    params: { mean: right },
  } = await until(it, ({ params }) => params.mean[0] > keyed[0] + 1, 'End')
  assert.ok(
    close(right[1], keyed[1]) && close(Number(await mean.getAttribute('aria-valuenow')), right[0], 1e-6),
    'to the right edge, no higher',
  )
  await mean.press('Home')
  await until(it, ({ params }) => params.mean[0] < keyed[0] - 1, 'Home')
  await mean.press('End')
  await until(it, ({ params }) => close(params.mean[0], right[0]), 'End again')
  assert.equal(
    await mean.getAttribute('aria-valuetext'),
    `at ${right[0].toFixed(2)} metres, ${right[1].toFixed(2)} metres a second`,
  )
})

test('the axes of the covariance turn and stretch, by mouse and by keys', async (t) => {
  const { page, it } = await picture(t)
  const [first, second] = [handle(it, 'First axis of the ellipse'), handle(it, 'Second axis of the ellipse')]
  const unit = await unitOf(it)
  const { params: before } = await frameOf(it)
  await pull(page, first, 30, 50)
  const end = [
    before.semiMajor * Math.cos(before.angle) + 30 / unit,
    before.semiMajor * Math.sin(before.angle) - 50 / unit,
  ]
  await until(
    it,
    ({ params }) =>
      close(params.semiMajor, Math.hypot(...end), 0.03) && close(params.angle, Math.atan2(end[1], end[0]), 0.03),
    'the end of the axis follows the mouse',
  )
  // P has the axes that are drawn.
  const { params, P } = await holds(it)
  const [c, s] = [Math.cos(params.angle), Math.sin(params.angle)]
  assert.ok(
    close(P[0][0], (params.semiMajor * c) ** 2 + (params.semiMinor * s) ** 2) &&
      close(P[0][1], (params.semiMajor ** 2 - params.semiMinor ** 2) * c * s),
  )

  await first.press('ArrowRight')
  await until(it, (frame) => close(frame.params.angle, params.angle + Math.PI / 180), 'an arrow turns it by a degree')
  await first.press('ArrowDown')
  await until(it, (frame) => close(frame.params.semiMajor, params.semiMajor - 0.05), 'and stretches it')
  await first.press('End')
  await until(it, (frame) => frame.params.semiMajor === 3, 'End')
  await first.press('Home')
  await until(it, (frame) => frame.params.semiMajor === 0.15, 'Home')
  await holds(it)

  // The second axis stands across: what counts is how far the mouse goes along it.
  const now = (await frameOf(it)).params
  const across = [-Math.sin(now.angle), Math.cos(now.angle)]
  await pull(page, second, 40 * across[0], -40 * across[1])
  await until(
    it,
    (frame) =>
      close(frame.params.semiMinor, now.semiMinor + 40 / unit, 0.03) &&
      frame.params.semiMajor === now.semiMajor &&
      frame.params.angle === now.angle,
    'the second axis follows the mouse',
  )
  const { semiMinor } = (await holds(it)).params
  await second.press('ArrowUp')
  await until(it, (frame) => close(frame.params.semiMinor, semiMinor + 0.05), 'an arrow')
  await second.press('Home')
  await until(it, (frame) => frame.params.semiMinor === 0.15, 'Home')
  await holds(it)
})

test('the reading moves its line, by mouse and by keys, and never loses its handle', async (t) => {
  const { page, it } = await picture(t)
  const reading = handle(it, 'Reading')
  const unit = await unitOf(it)
  const start = (await frameOf(it)).params.reading
  const line = () =>
    it
      .locator('.live .mark.line.measurement:not(.dashed)')
      .evaluate((mark) => ['x1', 'y1', 'x2', 'y2'].map((name) => Number(mark.getAttribute(name))))
  const before = await line()
  await pull(page, reading, 0, -60)
  await until(it, ({ params }) => close(params.reading, start + 60 / unit, 0.02), 'it follows the mouse')
  const after = await line()
  assert.ok(close(after[1], before[1] - 60, 1) && close(after[3], before[3] - 60, 1), 'the line went along')
  const {
    params: { reading: dragged },
  } = await holds(it)
  await reading.press('ArrowUp')
  await until(it, ({ params }) => close(params.reading, dragged + 0.05), 'an arrow')
  await reading.press('Shift+ArrowDown')
  await until(it, ({ params }) => close(params.reading, dragged - 0.45), 'ten of them')
  await holds(it)

  // However far the line goes, the axes follow: it and its handle stay in sight, and the keys bring it back.
  await reading.focus()
  const press = async (key, wanted) => {
    await page.keyboard.press(key)
    return until(it, ({ params }) => close(params.reading, wanted), `${key} makes it ${wanted}`)
  }
  let far = await frameOf(it)
  while (far.params.reading < 8) far = await press('PageUp', Math.min(8, far.params.reading + 0.5))
  const [, y1] = await line()
  const { top, height } = await it
    .locator('.live .panel-plane')
    .evaluate((svg) => ({ top: 0, height: svg.viewBox.baseVal.height }))
  assert.ok(y1 > top && y1 < height, `the line is at ${y1} of ${height}`)
  assert.ok(await reading.evaluate((grip) => grip === document.activeElement), 'the handle has the focus still')
  assert.ok(close(far.mahalanobisFoot.residual, 0) && close(far.euclideanFoot.residual, 0))
  for (let value = 7.5; value >= 4; value -= 0.5) await press('PageDown', value)
  await holds(it)
})

test('as W goes to 0 the two lines become one, by mouse and by keys', async (t) => {
  const { page, it } = await picture(t)
  const slider = noise(it)
  const lines = () =>
    it
      .locator('.live')
      .evaluate((live) =>
        ['.mark.line.measurement:not(.dashed)', '.mark.line.dashed.measurement'].map((mark) =>
          ['x1', 'y1', 'x2', 'y2'].map((name) => Number(live.querySelector(mark).getAttribute(name))),
        ),
      )
  const gap = async () => {
    const [omega, star] = await lines()
    return Math.max(...omega.map((value, i) => Math.abs(value - star[i])))
  }
  const between = ({ params, mostLikelyOutput, expectedOutput }) =>
    Math.abs(mostLikelyOutput - params.reading) + Math.abs(mostLikelyOutput - expectedOutput)

  const start = await holds(it)
  assert.ok((await gap()) > 5, 'with noise they are two')
  assert.ok(
    close(between(start), Math.abs(start.params.reading - start.expectedOutput)),
    'the most likely output lies between reading and prediction',
  )
  await dragSlider(page, slider, 3.5)
  const loud = await until(it, ({ params }) => params.noise > 3, 'W grows')
  assert.ok(
    Math.abs(loud.mostLikelyOutput - loud.expectedOutput) < Math.abs(start.mostLikelyOutput - start.expectedOutput),
    'a noisy sensor is believed less',
  )
  await holds(it)

  await dragSlider(page, slider, 0)
  const perfect = await until(it, ({ params }) => params.noise === 0, 'W is 0')
  const meet = async (frame) => {
    assert.ok(close(frame.mostLikelyOutput, frame.params.reading, 1e-12))
    assert.ok(apart(frame.update.at, frame.mahalanobisFoot.at) < 1e-12, 'the update is the purple foot')
    assert.equal(await gap(), 0)
    assert.match(await it.locator('.live .verdict').innerText(), /Ω and Ω\* are one line/)
    await holds(it)
  }
  await meet(perfect)

  await slider.press('End')
  await until(it, ({ params }) => params.noise === 4, 'End')
  await slider.press('ArrowLeft')
  await until(it, ({ params }) => close(params.noise, 3.95), 'an arrow')
  await slider.press('Home')
  await meet(await until(it, ({ params }) => params.noise === 0, 'Home'))
})

test('where P is a multiple of I the two feet meet, and nowhere else', async (t) => {
  const { it } = await picture(t)
  const feet = () =>
    it.locator('.live').evaluate((live) =>
      ['truth', 'posterior'].map((kin) => {
        const foot = live.querySelector(`.mark.foot.${kin}`)
        return [Number(foot.getAttribute('cx')), Number(foot.getAttribute('cy'))]
      }),
    )
  const start = await frameOf(it)
  assert.ok(apart(start.euclideanFoot.at, start.mahalanobisFoot.at) > 0.1)
  assert.ok(apart(...(await feet())) > 5)
  await it.getByRole('button', { name: 'Make it a circle' }).click()
  const round = await until(it, ({ params }) => params.semiMajor === params.semiMinor, 'a circle')
  assert.ok(close(round.P[0][1], 0, 1e-12) && close(round.P[0][0], round.P[1][1], 1e-12), 'P is a multiple of I')
  assert.ok(apart(round.euclideanFoot.at, round.mahalanobisFoot.at) < 1e-12)
  assert.ok(apart(...(await feet())) <= 0.1)
  assert.match(await it.locator('.live .verdict').innerText(), /both metrics agree/)
  await holds(it)
  // A turned sensor changes nothing about that.
  await it.getByRole('slider', { name: /Turn of the sensor/ }).press('Home')
  const turned = await until(it, ({ params }) => close(params.tilt, -Math.PI / 2), 'the position is measured')
  assert.ok(apart(turned.euclideanFoot.at, turned.mahalanobisFoot.at) < 1e-12)
  await it.getByRole('button', { name: 'As in step 1' }).click()
  const back = await until(it, ({ params }) => params.semiMajor !== params.semiMinor, 'as it was')
  assert.deepEqual(back, start)
})

test('a guess is dropped before the answer shows, stays on the line, and is judged when it shows', async (t) => {
  const { page, it } = await picture(t)
  const answer = () => it.locator('.live :is(.mark.foot.posterior, .mark.outline.posterior)').count()
  assert.ok((await answer()) > 0)
  await it.getByRole('button', { name: 'Drop a guess first' }).click()
  await until(it, ({ params }) => params.sealed && params.guess === 1, 'sealed')
  assert.equal(await answer(), 0, 'nothing gives it away')
  for (const label of [/^Update/, /^Gain|gain/])
    assert.equal(
      await it.locator('.live .readout-strip .readout').filter({ hasText: label }).first().locator('dd').textContent(),
      '–',
    )
  const guess = handle(it, 'Your guess')
  await pull(page, guess, -110, 40)
  const dropped = await until(it, ({ params }) => params.guess < -0.3, 'it follows the mouse')
  assert.ok(close(dropped.guess.at[1], dropped.params.reading), 'and stays on the line')
  await guess.press('ArrowRight')
  await until(it, ({ params }) => close(params.guess, dropped.params.guess + 0.05), 'an arrow')
  assert.match(await it.locator('.live .verdict').innerText(), /then choose “Show the answer”/)
  await it.getByRole('button', { name: 'Show the answer' }).click()
  const shown = await until(it, ({ params }) => !params.sealed, 'the answer')
  assert.ok((await answer()) > 0 && shown.guess.density <= 1)
  assert.match(await it.locator('.live .verdict').innerText(), /(as|than) your guess\./)
})

test('an ellipse grows from nothing, says what it holds, and touches the line where the purple foot is', async (t) => {
  const { it } = await picture(t)
  const slider = it.getByRole('slider', { name: /Grow an ellipse/ })
  await slider.press('ArrowRight')
  await until(it, ({ params }) => close(params.radius, 0.05), 'it begins')
  while (!/touches Ω\./.test(await it.locator('.live .verdict').innerText())) {
    const { radius } = (await frameOf(it)).params
    assert.ok(radius < 2, 'it comes to the line')
    await slider.press('ArrowRight')
    await until(it, ({ params }) => close(params.radius, radius + 0.05), 'it grows')
  }
  const { params, mahalanobisFoot, inside } = await frameOf(it)
  assert.ok(Math.abs(params.radius - mahalanobisFoot.distance) < 0.026)
  assert.equal(
    await it.locator('.live .readout').filter({ hasText: 'Inside' }).locator('dd').textContent(),
    `${Math.round(100 * inside)} %`,
  )
})
