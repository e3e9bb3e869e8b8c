// The delay of a log, found by hand: by keys on its slider, with the log-likelihood in sight; and by Fit.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { PHONE, root, until } from './harness.mjs'
import { enter, file, openLog, told } from './own-log.mjs'

const CAR = readFileSync(path.join(root, 'content/logs/car.csv'), 'utf8')
/** What the page shows, a number. */
const likelihood = async (page) => {
  const words = await page.locator('.log-likelihood').innerText()
  return Number(/Log-likelihood (−[\d,.]+) of/.exec(words)[1].replace('−', '-').replaceAll(',', ''))
}

for (const viewport of [{ width: 1440, height: 900 }, { width: 900, height: 700 }, PHONE]) {
  test(`at ${viewport.width} px the car’s speed is found half a second late by keys`, async (t) => {
    const { page, it, choose } = await openLog(t, { viewport })
    await choose(file('car.csv', CAR))
    await until(it, ({ summary }) => summary.used > 2000, 'the car')
    await enter(told(page, 'motion'), 'delay of the speed, s', '0.3')
    const slider = told(page, 'motion').getByLabel('delay of the speed, s, slider')
    await slider.focus()
    // On a phone its words stand above the slider, and come after the focus: it stays where the hand is.
    const { y: before } = await slider.boundingBox()
    await until(it, ({ judgement, judging }) => judgement && !judging, 'the verdict')
    const { y: after } = await slider.boundingBox()
    assert.ok(Math.abs(after - before) < 2, `the slider went from ${before} to ${after} px`)
    const seen = []
    for (const delay of [0.3, 0.4, 0.5, 0.6, 0.7, 0.8]) {
      // A hundredth a press.
      if (delay > 0.3) for (let press = 0; press < 10; press++) await slider.press('ArrowRight')
      await until(it, ({ params }) => Math.abs(params.delaySpeed - delay) < 1e-9, `${delay} s`)
      seen.push([delay, await likelihood(page)])
      const [line, hand] = await Promise.all([page.locator('.log-likelihood'), slider].map((one) => one.boundingBox()))
      for (const { y, height } of [line, hand]) assert.ok(y >= 0 && y + height <= viewport.height, `${delay} s: ${y}`)
      assert.ok(line.y + line.height <= hand.y, 'the line does not cover the slider')
    }
    const [best] = seen.reduce((one, other) => (other[1] > one[1] ? other : one))
    assert.ok(best === 0.5 || best === 0.6, JSON.stringify(seen))
  })
}

/** The same drive with one turn rate and one fix in ten, and every other speed: it is fitted in a third of the time. */
function thinned() {
  const [seen, every] = [
    { S: 0, T: 0, P: 0 },
    { S: 2, T: 10, P: 10 },
  ]
  const kept = CAR.split('\n').filter(([kind]) => !(kind in seen) || seen[kind]++ % every[kind] === 0)
  return kept.join('\n')
}

test('Fit tells how far it is, is given up, and finds the speed half a second later than the positions', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('car.csv', CAR))
  await until(it, ({ summary }) => summary.used > 2000, 'the car')
  const row = told(page, 'fit')
  const press = (name) => row.getByRole('button', { name, exact: true }).click()
  await press('Fit')
  await row.locator('progress[value]').waitFor()
  await press('Cancel')
  await row.getByText('The fit was given up.').waitFor()
  assert.equal(await row.locator('progress').isVisible(), false)

  await choose(file('thin.csv', thinned()))
  await until(it, ({ summary }) => summary.used > 200 && summary.used < 210, 'the car with a fix a second')
  await press('Fit')
  await row.locator('li').first().waitFor()
  const words = await row.innerText()
  const delay = (of) => Number(new RegExp(`delay of the ${of}, s: (\\d\\.\\d+) ±`).exec(words)?.[1])
  assert.ok(Math.abs(delay('speed') - delay('positions') - 0.58) < 0.15, words)
  await press('Take what the log tells')
  const { params } = await until(it, ({ params }) => params.delaySpeed > 0, 'what is taken')
  assert.ok(Math.abs(params.delaySpeed - delay('speed')) < 0.01 && params.delayTurn === 0)
})
