// The page where a reader opens a log of a robot of their own: whatever way a log comes, it is read here and goes
// nowhere; what is wrong with it is shown where it stands; a long replay is told of and can be given up.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { WORKER_POLICY } from '../../scripts/static-server.mjs'
import { holdReplays } from './held-replays.mjs'
import { codeOf, frameOf, PHONE, quiet, root, stateIn, stateOf, until } from './harness.mjs'
import { MRCLAM, SMALL, drop, enter, file, openLog, told } from './own-log.mjs'

test('a log that is chosen, dropped or pasted is read here, and nothing is asked for afterwards', async (t) => {
  const { page, it, choose, answer } = await openLog(t)
  await page.waitForLoadState('networkidle')
  assert.equal(page.workers().length, 1)
  const script = await page.request.get(page.workers()[0].url())
  assert.equal(script.headers()['content-security-policy'], WORKER_POLICY, 'the worker is bound by its own policy')
  const asked = []
  page.context().on('request', (request) => {
    if (!request.url().startsWith('blob:')) asked.push(request.url())
  })
  const marked = (n) => `# MARKER-${n}-5f1c\n${SMALL}O,${n},0.1,0\n`
  await choose(file('mine.csv', marked(2)))
  await until(it, ({ rows }) => rows === 5, 'the chosen log')
  assert.match(await answer.innerText(), /Files: mine\.csv\. Rows: 6\. .*Landmarks: 1\. True track: not known/)
  await drop(page, [['dropped.csv', `${marked(3)}O,4,0.1,0\n`]])
  await until(it, ({ rows }) => rows === 6, 'the dropped log')
  await page.locator('.log-paste summary').click()
  await page.locator('.log-paste textarea').fill(`${marked(5)}O,6,0.1,0\nO,7,0.1,0\n`)
  await page.getByRole('button', { name: 'Read these rows' }).click()
  await until(it, ({ rows }) => rows === 7, 'the pasted log')
  await told(page, 'ranges').getByLabel('used', { exact: true }).check()
  await until(it, ({ params, summary }) => params.sightings && summary.used === 2, 'the filter runs on it')
  await quiet(page)
  assert.deepEqual(asked, [])
  const kept = await page.evaluate(() => JSON.stringify([{ ...localStorage }, { ...sessionStorage }, location.href]))
  assert.ok(!kept.includes('MARKER'), kept)
})

test('the worker may ask for nothing elsewhere', async (t) => {
  const { page } = await openLog(t, { expected: [/Content Security Policy|violates|foreign request|failed/] })
  const refused = await page.workers()[0].evaluate(() =>
    fetch('http://127.0.0.2:9/').then(
      () => 'sent',
      (error) => error.name,
    ),
  )
  assert.equal(refused, 'TypeError')
})

test('the five files of MRCLAM dropped together are one log', async (t) => {
  const { page, it, answer } = await openLog(t)
  await drop(
    page,
    MRCLAM.map(({ name, buffer }) => [name, buffer.toString()]),
  )
  const { landmarks, bearings, truth } = await until(it, ({ rows }) => rows === 4, 'the log of the five files')
  assert.deepEqual([landmarks, bearings, truth !== null], [[{ id: 6, x: 2, y: 0.5 }], true, true])
  assert.match(await answer.innerText(), /1 reading left out: another robot was seen/)
  assert.deepEqual(
    await page.locator('.log-file legend').allInnerTexts(),
    MRCLAM.map(({ name }) => name),
  )
  const roles = await page
    .locator('.log-file select[data-key$="read as"]')
    .evaluateAll((all) => all.map((select) => select.value))
  assert.deepEqual(roles, ['velocities', 'sightings', 'barcodes', 'landmarks', 'truth'])
})

test('a table is guessed, shown with three values and what follows, and corrected by keys', async (t) => {
  const { page, it, choose, answer } = await openLog(t, { viewport: PHONE })
  const rows = Array.from({ length: 40 }, (_, i) => `${i},${500},${i % 3}`).join('\n')
  await choose(file('wheels.csv', `stamp,forward speed,yaw rate\n${rows}\n`))
  await answer.getByText('wheels.csv asks: In which unit is “forward speed”?').waitFor()
  const select = (name) => page.locator(`.log-file [data-key="0 ${name}"]`)
  assert.deepEqual(await Promise.all(['read as', 'time', 'v', 'ω'].map((name) => select(name).inputValue())), [
    'velocities',
    '0',
    '1',
    '2',
  ])
  assert.equal(await select('unit of v').inputValue(), '', 'nobody knows in what they are')
  await select('unit of v').selectOption('mm/s')
  await until(it, ({ rows }) => rows === 40, 'the table with its unit')
  assert.match(
    await page.locator('.log-follows').innerText(),
    /^So: 1 Hz, 0 to 39 s, v 0.5 … 0.5 m\/s, 19.5 m of way, turned 6.\d+ turns\.$/,
  )
  assert.deepEqual(await page.locator('.log-samples').allInnerTexts(), ['0 · 20 · 39', '500 · 500 · 500', '0 · 2 · 0'])
  await select('unit of ω').focus()
  await page.keyboard.press('ArrowDown')
  await page.waitForFunction(() => document.querySelector('[data-key="0 unit of ω"]').value === 'deg/s')
  await until(it, ({ reckoning }) => Math.abs(reckoning[2]) < 1, 'degrees turn less than radians')
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), '0 unit of ω', 'the focus stays')
  await select('v').selectOption('–')
  await answer.getByText('no column has been chosen for v').waitFor()
  assert.equal((await frameOf(it)).rows, 40, 'the figure keeps what it showed')
})

test('the page says from the start whose log its figure shows', async (t) => {
  const { answer, choose } = await openLog(t, { viewport: PHONE })
  await answer
    .getByText('The figure shows the mower’s log until you open another. Files: plaza1.csv. Rows: 15,123.')
    .waitFor()
  await choose(file('diary.txt', 'Dear diary,\ntoday it drove.\n'), file('wheels.csv', 'time,v,omega\n0,1,0\n1,1,0\n'))
  await answer.getByText('diary.txt is not used.').waitFor()
})

test('files are chosen with the keyboard, and an example is at hand', async (t) => {
  const { page, it } = await openLog(t)
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    page.getByRole('button', { name: 'Choose files' }).press('Enter'),
  ])
  await chooser.setFiles([file('by-keys.csv', SMALL)])
  await until(it, ({ rows }) => rows === 4, 'the log')
  await page.getByRole('button', { name: 'A small example' }).press('Enter')
  await until(it, ({ landmarks, bearings }) => landmarks.length === 3 && bearings, 'the example')
  const link = page.getByRole('link', { name: 'A small example: download' })
  const [download] = await Promise.all([page.waitForEvent('download'), link.click()])
  assert.equal(
    readFileSync(await download.path(), 'utf8'),
    readFileSync(path.join(root, 'content/logs/example.csv'), 'utf8'),
  )
})

test('track and innovations come as CSV, and a link carries the settings and not the log', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('mine.csv', SMALL))
  await until(it, ({ rows }) => rows === 4, 'the log')
  await told(page, 'ranges').getByLabel('used', { exact: true }).check()
  await until(it, ({ summary }) => summary.used === 2, 'the filter')
  for (const [name, head, rows] of [
    ['filter’s track', /^time,x,y,theta/, 3],
    ['innovations', /^time,sensor,landmark,measured/, 3],
  ]) {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: `Download the ${name}` }).click(),
    ])
    const text = readFileSync(await download.path(), 'utf8')
    assert.match(text, /** @type {RegExp} */ (head))
    assert.equal(text.trim().split('\n').length, rows, text)
  }
  await it.getByRole('button', { name: 'Copy link' }).click()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  const { lab, step, params } = stateIn(link, 'fig-own-log')
  assert.deepEqual([lab, step, params.sightings], ['robot-log', 4, true])
  assert.equal(await it.getByRole('button', { name: 'Embed' }).count(), 0, 'another page has not this log')
})

test('the copy with the mistake shows which beacons are taken for one another', async (t) => {
  const { page, it } = await openLog(t, { at: 'log/?example=copied' })
  await until(it, ({ rows }) => rows === 13_186, 'the log')
  await page.locator('.log-answer').getByText('plaza1-copied.csv').waitFor()
  await told(page, 'ranges').getByLabel('gate').selectOption('99.9 %')
  await until(it, ({ params }) => params.sightings && params.gate?.range === 0.999, 'the gate')
  await enter(told(page, 'ranges'), 'scale ε', '0.07')
  const { byLandmark } = await until(it, ({ params }) => params.scale === 0.07, 'the scale')
  const share = new Map(byLandmark.map(({ id, used, refused }) => [id, refused / (used + refused)]))
  assert.ok(share.get(1) > 0.9 && share.get(6) > 0.9 && share.get(0) < 0.01 && share.get(5) < 0.01)
  const table = await page.locator('.log-report .log-table', { hasText: 'Each sensor' }).innerText()
  assert.match(table, /Refused/)
})

test('the report has a heading and a place in the contents, and its lines stand by themselves', async (t) => {
  const { page, choose, it } = await openLog(t)
  await page.getByRole('heading', { name: /^Report/, level: 2 }).waitFor()
  assert.deepEqual((await page.locator('.toc li').allInnerTexts()).slice(0, 3), [
    'Open a log',
    'Report',
    'This book’s format',
  ])
  await choose(file('mine.csv', `L,10,0,5\n${SMALL}R,1,10,5\n`))
  await until(it, ({ rows }) => rows === 5, 'the log')
  await told(page, 'ranges').getByLabel('used', { exact: true }).check()
  const column = (title) =>
    page.locator('.log-report .log-table', { hasText: title }).locator('tbody th').allInnerTexts()
  await page.waitForFunction(() => document.querySelector('.log-report .has-heads tbody tr:nth-child(3)'))
  assert.deepEqual(await column('Each sensor'), ['Ranges', 'Landmark 7', 'Landmark 10'])
  for (const words of [...(await column('Settings')), ...(await column('Results'))])
    assert.ok(!/^(of|Its|Lag|[a-z])\b/.test(words) || /^σ/.test(words), words)
})

test('the report prints with the figure as it is', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('mine.csv', SMALL))
  await until(it, ({ rows }) => rows === 4, 'the log')
  await page.evaluate(() => {
    document.documentElement.dataset.report = ''
  })
  await page.emulateMedia({ media: 'print' })
  for (const shown of [
    'h1',
    'robot-log .live svg.panel-map',
    '.log-report .log-table >> nth=0',
    'robot-log .live .verdict',
  ])
    assert.ok(await page.locator(shown).first().isVisible(), shown)
  for (const hidden of [
    '.log-intake',
    '.log-actions',
    'robot-log .still',
    'robot-log .live .controls',
    'robot-log .live .log-tells',
    'robot-log .live .readouts',
    '#format',
  ])
    assert.ok(!(await page.locator(hidden).first().isVisible()), hidden)
})

test('the replay of two million rows is told of and given up, and the log stays', async (t) => {
  const { page, it } = await openLog(t)
  for (const label of ['used', 'learn the scale ε'])
    await told(page, 'ranges').getByLabel(label, { exact: true }).check()
  await until(it, ({ params }) => params.learn, 'the filter with most to do')
  await page.evaluate(holdReplays)
  await page.evaluate(() => {
    const rows = ['L,1,0,10\n']
    for (let i = 0; i < 999_999; i++) rows.push(`O,${i},0.1,0.01\nR,${i},1,10\n`)
    const data = new DataTransfer()
    data.items.add(new File(rows, 'long.csv'))
    document
      .querySelector('h1')
      .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
  })
  const bar = page.locator('robot-log .progress')
  await bar.waitFor()
  assert.match(await bar.locator('span').textContent(), /Computing step [\d,]+ of 1,999,998/)
  await bar.getByRole('button').click()
  await page.waitForFunction(() => document.querySelector('robot-log').settled)
  await page.evaluate(holdReplays)
  assert.equal((await frameOf(it)).rows, 13_186, 'the picture is the one before')
  await it.locator('.live').getByRole('button', { name: 'Reset' }).click()
  const { step, params } = await until(it, ({ rows }) => rows === 1_999_998, 'the long log from its start')
  assert.deepEqual([step, params.learn], [0, true])
})

test('a link to a log of another length shows the end of this one', async (t) => {
  const code = codeOf('robot-log', 1_500_000, { sightings: true, gate: 0.99 })
  const { it } = await openLog(t, { at: `log/?fig-own-log=${code}` })
  const { step, params } = await stateOf(it)
  assert.deepEqual([step, params.gate, params.sightings], [13_186, 0.99, true])
})

for (const width of [390, 900, 1280]) {
  test(`the letters of the printed report have one size in every panel, from a window of ${width} px`, async (t) => {
    const { page } = await openLog(t, {
      viewport: { width, height: 900 },
      touch: width < 500,
      prepare: (it) =>
        it.addInitScript(() => {
          globalThis.print = () => {
            globalThis.printed = true
          }
        }),
    })
    await page.getByRole('button', { name: 'Print the report' }).click()
    await page.waitForFunction(() => globalThis.printed)
    await page.emulateMedia({ media: 'print' })
    const { scales, right } = await page.evaluate(() => {
      const panels = [...document.querySelectorAll('robot-log .live > .panel')].filter((it) => it.checkVisibility())
      return {
        scales: panels.map((it) => it.getScreenCTM().a),
        right:
          Math.max(...panels.map((it) => it.getBoundingClientRect().right)) -
          document.querySelector('.own-log').getBoundingClientRect().left,
      }
    })
    assert.ok(scales.length >= 6, `${scales.length} panels`)
    assert.ok(Math.max(...scales) / Math.min(...scales) < 1.02, scales.join(', '))
    // As wide as a sheet of A4 between its margins.
    assert.ok(right <= 688, `${right} px wide`)
  })
}

test('on the page no title of a plot reaches out of its panel', async (t) => {
  const { page } = await openLog(t)
  await page.getByRole('button', { name: 'More panels' }).click()
  for (const width of [640, 768, 900, 1024]) {
    await page.setViewportSize({ width, height: 900 })
    await page.waitForFunction(() =>
      [...document.querySelectorAll('robot-log .live > .panel')].every(
        ({ clientWidth, viewBox }) => clientWidth === 0 || Math.abs(clientWidth - viewBox.baseVal.width) < 2,
      ),
    )
    const cut = await page
      .locator('robot-log .live .plot-title')
      .evaluateAll((all) =>
        all
          .filter(
            (title) => title.getBoundingClientRect().right > title.closest('.panel').getBoundingClientRect().right + 2,
          )
          .map((title) => title.textContent),
      )
    assert.deepEqual(cut, [], `${width} px`)
  }
})
