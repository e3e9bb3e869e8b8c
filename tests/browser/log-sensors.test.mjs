// The sensors of a reader's own log: their rows, the start, what is withheld, the smoothed track.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { until } from './harness.mjs'
import { enter, file, openLog, told } from './own-log.mjs'

const GNSS = ['time,lat,lon,speed,yaw_rate']
for (let i = 0; i < 60; i++)
  GNSS.push(`${i},${(48 + 1e-5 * i).toFixed(6)},11.000000,${(1.112).toFixed(3)},${i % 2 ? 0.01 : -0.01}`)

test('a receiver is a sensor: the filter starts at its first fix, and its row has σ, delay and gate', async (t) => {
  const { page, it, choose, answer } = await openLog(t)
  await choose(file('gnss.csv', GNSS.join('\n')))
  await answer.getByText('The filter starts where the first fixes say.').waitFor()
  await answer.getByText(/east and north of the first fix, 48\.00000° N, 11\.00000° E/).waitFor()
  const { params, summary } = await until(it, (frame) => frame.params.start && frame.summary.used === 60, 'the fixes')
  assert.ok(Math.abs(params.start[2] - Math.PI / 2) < 0.05, 'the way leads north')
  assert.equal(summary.rmse, null, 'no truth')
  const row = told(page, 'positions')
  assert.match(await row.locator('.log-says').innerText(), /^60 used, none refused, NIS /)
  await enter(row, 'σ, m', '2,5')
  await until(it, ({ params }) => params.sigmaFix === 2.5, 'σ with a comma')
  await enter(row, 'delay, s', '0.5')
  await until(it, ({ params }) => params.delayFix === 0.5, 'the delay')
  await row.getByLabel('gate').selectOption('99.0 %')
  await until(it, ({ params }) => params.gate?.fix === 0.99 && params.gate.range === null, 'a gate of its own')
  await enter(row, 'least gap in time, s', '10')
  await until(it, ({ params, summary }) => params.every?.fix === 10 && summary.sensors.fix.used === 6, 'six of sixty')
  await row.getByLabel('used', { exact: true }).uncheck()
  await until(it, ({ params, summary }) => params.fixes === false && summary.used === 0, 'dead reckoning')
  await it.locator('.live').getByText('Dead reckoning: odometry alone, no reading is used.').waitFor()
})

test('the start is typed and dragged, fixes are withheld, and the track is smoothed', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('gnss.csv', GNSS.join('\n')))
  await until(it, (frame) => frame.params.start && frame.summary.used === 60, 'the fixes')
  const start = told(page, 'start')
  await enter(start, 'x, m', '−3')
  await until(it, ({ params }) => params.start?.[0] === -3, 'a start beside it')
  await it.locator('.live').getByRole('button', { name: 'Reset' }).click()
  const handle = it.locator('.live [role=slider][aria-label="Start of the filter"]')
  await handle.focus()
  await page.keyboard.press('ArrowRight')
  await until(it, ({ params }) => Math.abs(params.start?.[0] + 2.9) < 1e-9, 'a tenth of a metre by a key')
  await start.getByRole('button', { name: 'From the first fixes' }).click()
  await until(it, ({ params }) => Math.abs(params.start?.[0]) < 0.1, 'the first fixes again')
  await it.locator('.live [role=slider][aria-label="Time of the drive"]').focus()
  await page.keyboard.press('End')
  const after = told(page, 'withheld fixes, and the track afterwards')
  await enter(after, 'withhold from, s', '20')
  await after.getByText('Say also until when.').waitFor()
  assert.equal((await until(it, () => true, 'as it was')).params.withheld, null, 'one end withholds nothing')
  await enter(after, 'to, s', '40')
  await until(it, ({ summary }) => summary.withheld?.rows === 19, 'the fixes between')
  await after.getByRole('button', { name: 'Smooth the track' }).click()
  const { smoothed, summary } = await until(it, (frame) => frame.smoothed, 'the smoothed track')
  assert.ok(smoothed.x.length > 10 && summary.withheld.rmsSmoothed > 0)
  assert.match(await after.locator('.log-says').innerText(), /from the 19 withheld fixes.*The smoothed track is/)
  // Another log knows nothing of it.
  await choose(file('wheels.csv', 'time,v,omega\n0,1,0\n1,1,0\n'))
  const { params } = await until(it, ({ rows }) => rows === 2, 'another log')
  assert.deepEqual([params.start, params.withheld, params.startSigma], [null, null, 0.2])
})
