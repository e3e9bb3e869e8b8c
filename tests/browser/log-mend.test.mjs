// What the verdict names is set at a press below it, and undone at another; the focus and the page keep their place.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { frameOf, until } from './harness.mjs'
import { file, openLog } from './own-log.mjs'

/**
 * A circle among three landmarks; ranges have an error of about 0.2 m, or of another size.
 * @param {string} name @param {number} count of rows of motion @param {number[]} off how far beside its place the
 * second landmark is written @param {string[]} more rows @param {number} error the most that a range is off, m
 */
function circle(name, count, [right, up] = [0, 0], more = [], error = 0.3) {
  const places = [
    [0, 0],
    [20, 2],
    [8, 18],
  ]
  const rows = places.map(([x, y], i) => `L,${i + 1},${x + (i === 1 ? right : 0)},${y + (i === 1 ? up : 0)}`)
  for (let k = 0; k < count; k++) {
    const t = k / 10
    const [x, y] = [10 + 5 * Math.sin(0.2 * t), 12 - 5 * Math.cos(0.2 * t)]
    rows.push(`V,${t},1,0.2`)
    const [px, py] = places[k % 3]
    if (k % 2 === 0) rows.push(`R,${t},${(k % 3) + 1},${Math.hypot(px - x, py - y) + error * Math.sin(7.3 * k * k)}`)
  }
  return file(name, [...rows, ...more].join('\n'))
}

/** Whether a displaced landmark is named: seen from one side, ranges to it that are off look the same. */
const isNamed = ({ suspects }) =>
  suspects.slice(0, 2).some(({ fault, standing }) => fault === 'displaced' && standing !== 'cleared')

test('a landmark that stands elsewhere is taken there at a press, and where its file has it at another', async (t) => {
  const { page, it, choose, answer } = await openLog(t, { viewport: { width: 390, height: 844 } })
  await choose(circle('displaced.csv', 800, [1.2, -0.9], ['G,0,10,7,0']))
  const bar = page.locator('robot-log .live .log-mend')
  const take = bar.getByRole('button', { name: 'Take it there' })
  await take.waitFor()
  const report = () => page.evaluate(() => document.querySelector('.log-report')?.textContent ?? '')
  const before = await report()
  // By keys what the verdict proposes is next to the map.
  await page.getByRole('link', { name: 'See the map and the verdict' }).press('Enter')
  for (const _ of ['the time of the drive', 'a press']) await page.keyboard.press('Tab')
  assert.equal(await bar.evaluate((it) => it.contains(document.activeElement)), true, 'two steps from the link')
  await take.click()
  await answer.getByText('Landmark 2 is taken at (20').waitFor()
  const back = bar.getByRole('button', { name: 'Undo' })
  assert.equal(await bar.evaluate((one) => one === document.activeElement), true, 'the next key undoes nothing')
  const mended = await until(it, ({ judgement }) => judgement && !isNamed(judgement), 'the verdict')
  const named = mended.judgement.suspects.find(({ fault }) => fault === 'displaced')
  assert.equal(named.standing, 'cleared')
  await back.click()
  await until(it, ({ judgement }) => judgement && isNamed(judgement), 'the verdict as before')
  assert.equal(await answer.getByText('is taken at').count(), 0)
  assert.equal(await back.isVisible(), false)
  await take.click()
  const all = answer.getByRole('button', { name: 'Take it all back' })
  await all.waitFor()
  await page.waitForFunction((before) => document.querySelector('.log-report')?.textContent !== before, before)
  const [written] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download the log’s rows' }).click(),
  ])
  const rows = await readFile(await written.path(), 'utf8')
  assert.match(
    rows,
    /^# corrected: \{"driven":\[1,1\],"landmarks":\[\[2,20\.\d+,2\.?\d*\]\],"ranges":\[\]\}\nL,1,0,0\nL,2,20/,
    'it says so',
  )
  // The figure is far below the window where there are many files, and the report with it: neither stays behind.
  await page.evaluate(() => {
    const files = document.querySelector('.log-files')
    if (files instanceof HTMLElement) files.style.minBlockSize = '6000px'
    scrollTo(0, 0)
  })
  await all.click()
  await page.waitForFunction((before) => document.querySelector('.log-report')?.textContent === before, before)
  await until(it, ({ judgement }) => judgement && isNamed(judgement), 'the verdict as the file has it')
  assert.equal(await back.isVisible(), false, 'nothing is left to undo')
})

test('a start that the verdict names is set at a press, and undone at another', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 1440, height: 900 } })
  assert.equal(await page.locator('.log-mend').isVisible(), false, 'nothing is named of the log that the page brings')
  // Begun far from where the filter starts, its σ right, and so long that a verdict takes several frames.
  await choose(circle('circle.csv', 2000, [0, 0], [], 0.85))
  // The first ranges say where it began.
  const { params: opened } = await until(it, (frame) => frame.params.start && frame.judgement, 'the start of the log')
  assert.ok(Math.hypot(opened.start[0] - 10, opened.start[1] - 7) < 0.5, String(opened.start))
  await page.getByRole('button', { name: 'At the origin' }).click()
  const bar = page.locator('robot-log .live .log-mend')
  const press = bar.getByRole('button', { name: 'Set the start so' })
  await press.waitFor()
  assert.match(await page.locator('.log-strip').innerText(), /The verdict names another start, which Fit does not look/)
  await press.focus()
  // How far it moves while it is there and waits: the next verdict may come within a frame.
  const moved = await press.evaluateHandle((one) => {
    const y = () => one.getBoundingClientRect().y
    const first = y()
    return {
      far: new Promise((told) => {
        let far = 0
        requestAnimationFrame(function look() {
          if (!one.isConnected) return told(far)
          far = Math.max(far, Math.abs(y() - first))
          requestAnimationFrame(look)
        })
      }),
    }
  })
  await press.press('Enter')
  const back = bar.getByRole('button', { name: 'Undo' })
  assert.equal(await bar.evaluate((one) => one === document.activeElement), true, 'the next key undoes nothing')
  const far = await moved.evaluate(({ far }) => far)
  assert.ok(far < 0.5, `the press stays where it was while the next verdict comes: ${far}`)
  const { params } = await until(it, (frame) => frame.params.start && frame.judgement, 'the verdict from the start on')
  const [x, y] = params.start
  assert.ok(Math.hypot(x - 10, y - 7) < 0.5, `the robot started at 10 m, 7 m: ${x}, ${y}`)
  assert.equal(await press.count(), 0, 'the start is named no more')
  await back.press('Enter')
  await until(it, (frame) => frame.params.start === null && frame.judgement, 'the verdict as before')
  await press.waitFor()
  assert.equal(await back.isVisible(), false)
  assert.equal((await frameOf(it)).params.start, null)
})

test('σ with which the page begins are fitted together at one press, which is given up or undone as one', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 390, height: 844 } })
  await choose(circle('known.csv', 800, [0, 0], ['G,0,10,7,0']))
  const bar = page.locator('robot-log .live .log-mend')
  const press = bar.getByRole('button', { name: /^Fit (both|all \w+) σ$/ })
  await press.waitFor()
  const { params: before, judgement } = await frameOf(it)
  const wrong = judgement.suspects.filter(({ fault }) => fault === 'sigma').map(({ name }) => name)
  // Given up before the worker can have read its first word.
  await press.evaluate((one) => {
    one.click()
    const [, cancel] = [...(one.closest('.log-mend')?.querySelectorAll('button') ?? [])]
    if (cancel.textContent !== 'Cancel' || cancel !== document.activeElement) throw new Error('no Cancel in reach')
    cancel.click()
  })
  await bar.getByText('The fit was given up.').waitFor()
  assert.deepEqual((await frameOf(it)).params, before)
  assert.equal(await press.evaluate((one) => one === document.activeElement), true)
  await press.press('Enter')
  const { params, ...fitted } = await until(
    it,
    (frame) =>
      frame.params.sigmaRange !== frame.known.find(({ name }) => name === 'sigmaRange').default && frame.judgement,
    'the verdict on what was fitted',
  )
  assert.ok(wrong.length > 1 && wrong.every((name) => params[name] !== before[name]), wrong.join())
  assert.ok(Math.abs(params.sigmaRange - 0.21) < 0.03, `the errors swing between −0.3 and 0.3 m: ${params.sigmaRange}`)
  assert.ok(fitted.judgement.suspects.every(({ fault, standing }) => fault !== 'sigma' || standing === 'cleared'))
  const back = bar.getByRole('button', { name: 'Undo' })
  assert.equal(await bar.evaluate((one) => one === document.activeElement), true, 'the next key undoes nothing')
  await back.press('Enter')
  const undone = await until(
    it,
    (frame) => frame.params.sigmaRange === before.sigmaRange && frame.judgement,
    'as before',
  )
  assert.deepEqual(undone.params, before)
})

test('σ that are fitted beside outliers come with gates and a start of their own, and are undone as one', async (t) => {
  const { page, it, choose } = await openLog(t)
  // Straight on at 1 m/s; fixes of about 2 cm, of which each tenth is 3 m off, the first among them.
  const rows = Array.from({ length: 400 }, (_, k) => {
    const [time, out] = [k / 5, k % 10 === 0 ? 3 : 0]
    const [x, y] = [time + 0.03 * Math.sin(7.3 * k * k) + out, 0.03 * Math.cos(5.1 * k * k) - out]
    return `V,${time},1,0\nP,${time},${x},${y}`
  })
  await choose(file('outliers.csv', rows.join('\n')))
  const bar = page.locator('robot-log .live .log-mend')
  await bar
    .getByRole('button', { name: /Fit|gate/ })
    .first()
    .waitFor()
  const fit = bar.getByRole('button', { name: /^Fit/ })
  const before = (await until(it, ({ judgement }) => judgement, 'the verdict')).params
  await fit.click()
  await bar.getByText(/^9\.9 % of the readings are outliers: the gates are on/).waitFor()
  const { params } = await until(it, (frame) => frame.judgement && frame.params.gate === 0.999, 'the gate')
  assert.ok(Math.hypot(params.start[0], params.start[1]) < 0.1 && params.startSigma < 0.1, String(params.start))
  await bar.getByRole('button', { name: 'Undo' }).click()
  await until(
    it,
    (frame) => frame.judgement && JSON.stringify(frame.params) === JSON.stringify(before),
    'all as it was',
  )
  // The same press does the same once more: that start is still the page's own.
  await fit.click()
  const again = await until(it, (frame) => frame.judgement && frame.params.gate === 0.999, 'the gate once more')
  assert.deepEqual(again.params.start, params.start)
})

/** A robot that turns either way, whose turn rates read so many times what they are. @param {number} times */
function winding(times) {
  const places = [
    [0, 0],
    [20, 2],
    [8, 18],
  ]
  const rows = places.map(([x, y], i) => `L,${i + 1},${x},${y}`)
  let [x, y, theta] = [6, 6, 0.5]
  for (let k = 0; k < 1800; k++) {
    const [t, omega] = [k / 10, 0.35 * Math.cos(0.11 * (k / 10)) + 0.2]
    rows.push(`V,${t},0.8,${omega * times}`)
    const [px, py] = places[k % 3]
    if (k % 2 === 0) rows.push(`R,${t},${(k % 3) + 1},${Math.hypot(px - x, py - y) + 0.85 * Math.sin(7.3 * k * k)}`)
    x += 0.08 * Math.cos(theta)
    y += 0.08 * Math.sin(theta)
    theta += omega / 10
  }
  return file('winding.csv', rows.join('\n'))
}

test('turns that are taken otherwise at a press leave a start that the reader has set', async (t) => {
  const { page, it, choose, answer } = await openLog(t, { viewport: { width: 1440, height: 900 } })
  await choose(winding(1.3))
  await until(it, (frame) => frame.params.start && frame.judgement, 'the start of the log')
  await page.getByLabel('x, m', { exact: true }).fill('6.02')
  await page.getByLabel('x, m', { exact: true }).press('Enter')
  await until(it, (frame) => frame.params.start?.[0] === 6.02 && frame.judgement, 'the verdict with that start')
  await page
    .locator('.log-mend')
    .getByRole('button', { name: /[Tt]ake them so/ })
    .click()
  await answer.getByText(/Turn rates are taken 0\.7\d+ times as they are read/).waitFor()
  const { params } = await until(it, ({ judgement }) => judgement?.suspects[0].fault !== 'turn-scale', 'the verdict')
  assert.equal(params.start[0], 6.02)
})

test('turns of the wrong sign have no press: a link leads to the fields in which the files are read', async (t) => {
  const { page, it, choose } = await openLog(t, { viewport: { width: 390, height: 844 } })
  const tables = { L: ['landmark,x,y'], V: ['time_s,v_mps,omega_radps'], R: ['time_s,landmark,range_m'] }
  for (const row of winding(-1).buffer.toString().split('\n')) tables[row[0]].push(row.slice(2))
  const named = { L: 'landmarks.csv', V: 'wheels.csv', R: 'ranges.csv' }
  await choose(...Object.entries(tables).map(([letter, rows]) => file(named[letter], rows.join('\n'))))
  const { judgement } = await until(it, (frame) => frame.judgement, 'the verdict')
  // Three landmarks in a mirror look much as two that are exchanged, which has a press.
  assert.ok(judgement.suspects.slice(0, 2).some(({ fault }) => fault === 'mirrored'))
  const link = page.locator('.log-mend').getByRole('link', { name: 'See how the files are read' })
  await link.click()
  const field = page.locator('#log-files select').first()
  await page.waitForFunction(() => document.activeElement?.matches('#log-files select'))
  assert.ok((await field.boundingBox()).y >= 0, 'it is in sight')
})
