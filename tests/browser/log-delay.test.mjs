// The delay of a log, found by hand: by keys on its slider, with the log-likelihood in sight.
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
