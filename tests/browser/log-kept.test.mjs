// What is kept when another log is opened, what the report says of start and withheld fixes, and what stays in sight.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { PHONE, until } from './harness.mjs'
import { enter, file, openLog, told } from './own-log.mjs'

const ROWS = Array.from({ length: 60 }, (_, i) => `V,${i},1,0\nP,${i},${i + 0.8 * Math.sin(7 * i)},${Math.cos(5 * i)}`)
const log = (name, rows = ROWS) => file(name, rows.join('\n'))
const rowOf = (page, name) =>
  page.locator('.log-tables tr', { has: page.locator('th', { hasText: new RegExp(`^${name}$`) }) }).locator('td')

test('another log begins with the usual settings, and the same one, mended, with those that it had', async (t) => {
  const { page, it, choose, answer } = await openLog(t)
  await choose(log('first.csv'))
  await until(it, ({ summary }) => summary.used === 60, 'the fixes')
  assert.equal(await answer.locator('.log-offer').count(), 0, 'nothing was set')
  await enter(told(page, 'positions'), 'σ, m', '2.5')
  await enter(told(page, 'positions'), 'delay, s', '0.4')
  await until(it, ({ params }) => params.delayFix === 0.4 && params.sigmaFix === 2.5, 'two settings')

  await choose(log('second.csv', ROWS.slice(0, 50)))
  await until(it, ({ params, summary }) => summary.used === 50 && params.sigmaFix === 1, 'the usual ones')
  const offer = answer.locator('.log-offer')
  assert.match(await offer.innerText(), /of the log before are not taken over: σ of positions; delay of positions\./)
  await offer.getByRole('button', { name: 'Take them over' }).click()
  await until(it, ({ params }) => params.delayFix === 0.4 && params.sigmaFix === 2.5, 'taken over')

  await choose(log('second.csv', ROWS.slice(0, 40)))
  await until(it, ({ params, summary }) => summary.used === 40 && params.sigmaFix === 2.5, 'the same, mended')
  assert.match(await offer.innerText(), /^Settings from before are kept: /)
  await offer.getByRole('button', { name: 'Begin with the usual ones' }).click()
  await until(it, ({ params }) => params.delayFix === 0 && params.sigmaFix === 1, 'the usual ones')
})

test('the report has the start and the withheld stretch, and its innovations those of all sensors', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(log('fixes.csv'))
  await until(it, ({ summary }) => summary.used === 60, 'the fixes')
  const after = told(page, 'withheld fixes, and the track afterwards')
  await enter(after, 'withhold from, s', '20')
  await enter(after, 'to, s', '40')
  await until(it, ({ summary }) => summary.withheld?.rows === 19, 'the fixes between')
  assert.equal(await rowOf(page, 'Withheld fixes').innerText(), 'from 20.0 s to 40.0 s')
  assert.match(await rowOf(page, 'Start').innerText(), /^−?\d+\.\d\d\d m, −?\d+\.\d\d\d m, −?\d+\.\d°$/)
  assert.equal(await rowOf(page, 'Fixes that were withheld').innerText(), '19')
  assert.match(await rowOf(page, 'The filter’s distance from them').innerText(), /m RMS, .* m at worst$/)
  const saved = async (name) => {
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: `Download the ${name}` }).click(),
    ])
    const chunks = []
    for await (const chunk of await file.createReadStream()) chunks.push(chunk)
    return [file.suggestedFilename(), ...Buffer.concat(chunks).toString().trim().split('\n')]
  }
  const [, head, ...rows] = await saved('innovations')
  assert.match(head, /^time,sensor,landmark,measured,expected,innovation,/)
  assert.equal(rows.length, 41)
  assert.ok(rows.every((row) => /^\d+,fix,,/.test(row)))
  const [name, ...written] = await saved('log’s rows')
  assert.equal(name, 'log.csv')
  assert.equal(written.length, await it.evaluate(({ frame }) => frame.log.rows), 'a line for each row')
})

const boxOf = (page, selector) => page.locator(selector).first().boundingBox()

test('on a phone map and log-likelihood stay in sight, one below the other, while a slider is turned', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: PHONE })
  await choose(log('fixes.csv'))
  await until(it, ({ summary }) => summary.used === 60, 'the fixes')
  await told(page, 'motion').scrollIntoViewIfNeeded()
  const [map, line] = [await boxOf(page, '.own-log .live > .panel-map'), await boxOf(page, '.log-tells p')]
  assert.ok(map.y > -1 && line.y >= map.y + map.height - 1, `${JSON.stringify(map)} ${JSON.stringify(line)}`)
  assert.ok(line.y + line.height < PHONE.height, 'both are in the window')
})

test('at 900 px the strip stands beside the panels and stays in sight', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 900, height: 1100 } })
  await choose(log('fixes.csv'))
  await until(it, ({ summary }) => summary.used === 60, 'the fixes')
  await page.locator('.own-log .live > .panel-innovations').scrollIntoViewIfNeeded()
  const [map, strip] = [await boxOf(page, '.own-log .live > .panel-map'), await boxOf(page, '.log-strip')]
  assert.ok(strip.x >= map.x + map.width, 'on the right')
  assert.ok(strip.y >= 0 && strip.y < 1100, 'in sight')
})

test('the report says how each file is read', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(
    file('wheels.csv', `t,v_left_mps,v_right_mps\n${Array.from({ length: 60 }, (_, i) => `${i},1,1.01`).join('\n')}`),
    file('gps.csv', `t,x,y\n${Array.from({ length: 60 }, (_, i) => `${i},${i},${Math.cos(5 * i)}`).join('\n')}`),
  )
  const base = page.getByLabel('distance between the wheels, m')
  await base.fill('0.5')
  await base.press('Tab')
  await until(it, ({ summary }) => summary.used === 60, 'the fixes')
  assert.match(await rowOf(page, 'wheels\\.csv').innerText(), /left from v_left_mps, m\/s; .* the wheels, m: 0\.5\.$/)
  assert.match(await rowOf(page, 'gps\\.csv').innerText(), /^sensors: .* x from x, m; y from y, m\.$/)
})
