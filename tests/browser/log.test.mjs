// The page where a reader opens a log of a robot of their own: whatever way a log comes, it is read here and goes
// nowhere; what is wrong with it is shown where it stands; a long replay is told of and can be given up.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { WORKER_POLICY } from '../../scripts/static-server.mjs'
import { PHONE, dist, figure, frameOf, open, root, stateOf, until } from './harness.mjs'

const SMALL = 'L,7,3,4\nO,0.5,0.1,0.02\nR,0.5,7,4.9\nO,1,0.1,0\nR,1,7,4.8\n'
const file = (name, text) => ({ name, mimeType: 'text/csv', buffer: Buffer.from(text) })
const MRCLAM = [
  file(
    'Robot1_Odometry.dat',
    '# Time [s]    forward velocity [m/s]    angular velocity[rad/s]\n1248272263.0 \t 0.10 \t 0.0\n1248272263.5 \t 0.10 \t 0.2\n1248272264.0 \t 0.00 \t 0.0\n',
  ),
  file(
    'Robot1_Measurement.dat',
    '# Time [s]    Subject #    range [m]    bearing [rad]\n1248272263.2 \t 63 \t 2.0 \t 0.1\n1248272263.4 \t 14 \t 1.0 \t 0.2\n',
  ),
  file('Barcodes.dat', '# Subject #    Barcode #\n 2   \t 14\n 6   \t 63\n'),
  file(
    'Landmark_Groundtruth.dat',
    '# Subject #    x [m]    y [m]    x std-dev [m]    y std-dev [m]\n6 \t 2.0 \t 0.5 \t 0.0001 \t 0.0002\n',
  ),
  file(
    'Robot1_Groundtruth.dat',
    '# Time [s]    x [m]    y [m]    orientation [rad]\n1248272262.9 \t 0.1 \t 0.2 \t 0.3\n1248272264.1 \t 0.2 \t 0.2 \t 0.4\n',
  ),
]

/** The page with its figure alive. */
async function openLog(t, wishes = {}) {
  const page = await open(t, { at: 'log/', ...wishes })
  const it = await figure(page, 'robot-log')
  // The script of the page has come: it gives the examples their addresses.
  await page.locator('.log-example a[href]').first().waitFor()
  return {
    page,
    it,
    choose: (...files) => page.locator('.log-drop input').setInputFiles(files),
    answer: page.locator('.log-answer'),
  }
}

/** Drops files on the page, as a hand would. */
function drop(page, files) {
  return page.evaluate((given) => {
    const data = new DataTransfer()
    for (const [name, text] of given) data.items.add(new File([text], name))
    document
      .querySelector('h1')
      .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
  }, files)
}

test('a log that is chosen, dropped or pasted is read on this machine, and nothing is asked for afterwards', async (t) => {
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
  await it.locator('.live').getByLabel('ranges correct the estimate').check()
  await until(it, ({ params, summary }) => params.sightings && summary.used === 2, 'the filter runs on it')
  await new Promise((resolve) => setTimeout(resolve, 500))
  assert.deepEqual(asked, [])
  const kept = await page.evaluate(() => JSON.stringify([{ ...localStorage }, { ...sessionStorage }, location.href]))
  assert.ok(!kept.includes('MARKER'), kept)
})

test('without its script the page has nothing to press in vain, and says so', async (t) => {
  const folder = path.join(dist, 'assets')
  const script = readdirSync(folder).find(
    (name) => name.startsWith('part-') && readFileSync(path.join(folder, name), 'utf8').includes('plaza1-copied.csv'),
  )
  const page = await open(t, {
    at: 'log/',
    expected: [/part-|Failed to load|ERR_FAILED/],
    prepare: (it) => it.route(`**/${script}`, (route) => route.abort()),
  })
  await page
    .locator('.log-intake', { hasText: 'A log is opened by scripts, which are off or could not be fetched.' })
    .waitFor()
  assert.equal(await page.locator('.log-intake :is(button, summary, a):visible').count(), 0)
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

test('a table is guessed, shown and corrected by keys', async (t) => {
  const { page, it, choose, answer } = await openLog(t, { viewport: PHONE })
  const rows = Array.from({ length: 40 }, (_, i) => `${i},${500},${i % 3}`).join('\n')
  await choose(file('wheels.csv', `stamp,forward speed,yaw rate\n${rows}\n`))
  await until(it, ({ rows }) => rows === 40, 'the table as guessed')
  const select = (name) => page.locator(`.log-file [data-key="0 ${name}"]`)
  assert.deepEqual(await Promise.all(['read as', 'time', 'v', 'ω'].map((name) => select(name).inputValue())), [
    'velocities',
    '0',
    '1',
    '2',
  ])
  assert.equal(await select('unit of length').inputValue(), 'mm', 'five hundred metres a second are too many')
  await select('unit of angle').focus()
  await page.keyboard.press('ArrowDown')
  await page.waitForFunction(() => document.querySelector('[data-key="0 unit of angle"]').value === 'deg')
  await until(it, ({ reckoning }) => Math.abs(reckoning[2]) < 1, 'degrees turn less than radians')
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), '0 unit of angle', 'the focus stays')
  await select('v').selectOption('–')
  await answer.getByText('no column has been chosen for v').waitFor()
  assert.equal((await frameOf(it)).rows, 40, 'the figure keeps what it showed')
})

test('a fault is shown with its file, line and character, and in pasted rows at the cursor', async (t) => {
  const { page, it, choose, answer } = await openLog(t)
  const { rows } = await frameOf(it)
  await choose(file('broken.csv', `${SMALL}R,2,7,x\n`))
  await answer.getByText('broken.csv, line 6, character 7').waitFor()
  assert.equal(await page.locator('.log-line').innerText(), 'R,2,7,x')
  assert.equal(await page.locator('.log-line mark').innerText(), 'x')
  await page.locator('.log-paste summary').click()
  await page.locator('.log-paste textarea').fill(`${SMALL}R,2,8,4\n`)
  await page.getByRole('button', { name: 'Read these rows' }).click()
  await answer.getByText('there is no landmark 8').waitFor()
  assert.equal(
    await page.evaluate(() =>
      document.activeElement.value.slice(document.activeElement.selectionStart, document.activeElement.selectionEnd),
    ),
    '8,4',
  )
  assert.equal((await frameOf(it)).rows, rows, 'the figure keeps what it showed')
})

test('each kind of fault is shown with its file, line and character', async (t) => {
  const { choose, answer } = await openLog(t)
  const faults = [
    ['X,1,2,3', 1, /'X' is no row's letter; L, G, O, V, R or B was expected/],
    ['O,1,2', 6, /has 3 fields; 4 were expected: O,t,distance,turn/],
    ['O,1,2,3,4', 9, /has 5 fields; 4 were expected/],
    ['O,1,nan,3', 5, /distance is 'nan'; a finite number/],
    ['O,1,1e999,3', 5, /finite number/],
    ['L,7,1,1', 3, /landmark 7 stands here for the second time/],
    ['R,1,8,2', 5, /there is no landmark 8; a landmark that is seen needs a row with its place\.$/m],
    ['R,1,7,-2', 7, /a range of at least 0/],
    ['V,1,2,3', 1, /O rows and V rows/],
    ['O,1e12,1,1', 3, /times within/],
    ['R,1,"7",2', 5, /is quoted/],
    ['O;1;1;0', 1, /';' was found between the fields/],
    ['R,1.5,7.0,2', 7, /whole number/],
    ['R,1,\u0001,2', 5, /control character/],
  ]
  for (const [i, [row, column, words]] of faults.entries()) {
    await choose(file(`fault-${i}.csv`, `${SMALL}${row}\n`))
    await answer.getByText(`fault-${i}.csv, line 6, character ${column}: `).waitFor()
    assert.match(await answer.locator('.log-wrong').innerText(), words)
  }
  await choose(file('still.csv', 'L,7,3,4\nR,1,7,2\n# the end\n'))
  await answer
    .getByText('still.csv, line 2, character 1: the log has no motion; O rows or V rows were expected.')
    .waitFor()
  const picture = {
    name: 'picture.png',
    mimeType: 'image/png',
    buffer: Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13]),
  }
  await choose(picture)
  await answer
    .getByText('picture.png, line 1, character 1: a control character or one outside UTF-8 was found')
    .waitFor()
  await choose(file('nothing.csv', ''))
  await answer.getByText('nothing.csv, line 1, character 1: the file is empty.').waitFor()
})

test('a file of motion that is missing is no fault of another file', async (t) => {
  const { choose, answer } = await openLog(t)
  await choose(...MRCLAM.slice(1))
  const roles = [
    'Robot1_Measurement.dat is read as sightings',
    'Barcodes.dat is read as barcodes',
    'Landmark_Groundtruth.dat is read as landmarks',
    'Robot1_Groundtruth.dat is read as truth',
  ]
  await answer
    .getByText(
      `The robot's motion is missing: ${roles.join(', ')}; a file of velocities or of odometry was expected.`,
      { exact: true },
    )
    .waitFor()
  assert.match(await answer.innerText(), /Open the missing file together with these, or correct below/)
  assert.equal(await answer.locator('.log-line').count(), 0, 'no line is shown as wrong')
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
  await it.locator('.live').getByLabel('ranges correct the estimate').check()
  await until(it, ({ summary }) => summary.used === 2, 'the filter')
  for (const [name, head, rows] of [
    ['track', /^time,x,y,theta/, 3],
    ['innovations', /^time,landmark,range/, 3],
  ]) {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: `Download the ${name}` }).click(),
    ])
    const text = readFileSync(await download.path(), 'utf8')
    assert.match(text, head)
    assert.equal(text.trim().split('\n').length, rows, text)
  }
  await it.getByRole('button', { name: 'Copy link' }).click()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  const state = JSON.parse(Buffer.from(new URL(link).searchParams.get('fig-own-log'), 'base64url').toString())
  assert.deepEqual([state[1], state[2], state[3].sightings], ['robot-log', 4, true])
  assert.equal(await it.getByRole('button', { name: 'Embed' }).count(), 0, 'another page has not this log')
})

test('the copy with the mistake shows which beacons are taken for one another', async (t) => {
  const { page, it } = await openLog(t, { at: 'log/?example=copied' })
  await until(it, ({ rows }) => rows === 13_186, 'the log')
  await page.locator('.log-answer').getByText('plaza1-copied.csv').waitFor()
  await it.locator('.live').getByRole('button', { name: 'Gate them' }).click()
  await until(it, ({ params }) => params.gate === 0.999, 'the gate')
  await it.locator('.live').getByLabel(/Scale/).fill('0.07')
  const { byLandmark } = await until(it, ({ params }) => params.scale === 0.07, 'the scale')
  const share = new Map(byLandmark.map(({ id, used, refused }) => [id, refused / (used + refused)]))
  assert.ok(share.get(1) > 0.9 && share.get(6) > 0.9 && share.get(0) < 0.01 && share.get(5) < 0.01)
  const table = await page.locator('.log-table', { hasText: 'By landmark' }).innerText()
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
  await it.locator('.live').getByLabel('ranges correct the estimate').check()
  const column = (title) => page.locator('.log-table', { hasText: title }).locator('tbody th').allInnerTexts()
  await page.waitForFunction(() => document.querySelector('.log-table.has-heads tbody tr:nth-child(2)'))
  assert.deepEqual(await column('By landmark'), ['7', '10'])
  for (const words of [...(await column('Settings')), ...(await column('Results'))])
    assert.ok(!/^(of|Its|Lag|[a-z])\b/.test(words) || /^σ/.test(words), words)
})

test('no rows in the box are asked for, and a fault in pasted rows is mended there', async (t) => {
  const { page, answer } = await openLog(t)
  await page.locator('.log-paste summary').click()
  await page.getByRole('button', { name: 'Read these rows' }).click()
  await answer.getByText('The box has no rows.').waitFor()
  await page.locator('.log-paste textarea').fill(`${SMALL}O,1,x,3\n`)
  await page.getByRole('button', { name: 'Read these rows' }).click()
  await answer.getByText('Mend the rows and read them again.').waitFor()
})

test('the report prints with the figure as it is', async (t) => {
  const { page, it, choose } = await openLog(t)
  await choose(file('mine.csv', SMALL))
  await until(it, ({ rows }) => rows === 4, 'the log')
  await page.evaluate(() => {
    document.documentElement.dataset.report = ''
  })
  await page.emulateMedia({ media: 'print' })
  for (const shown of ['h1', 'robot-log .live svg.panel-map', '.log-table >> nth=0', 'robot-log .live .verdict'])
    assert.ok(await page.locator(shown).first().isVisible(), shown)
  for (const hidden of [
    '.log-intake',
    '.log-actions',
    'robot-log .still',
    'robot-log .live .controls',
    'robot-log .live .tries',
    'robot-log .live .readouts',
    '#format',
  ])
    assert.ok(!(await page.locator(hidden).first().isVisible()), hidden)
})

test('the replay of two million rows is told of and given up, and the log stays', async (t) => {
  const { page, it } = await openLog(t)
  await it.locator('.live').getByRole('button', { name: 'Let the filter learn the scale' }).click()
  await until(it, ({ params }) => params.learn, 'the filter with most to do')
  await page.evaluate(() => {
    const rows = ['L,1,0,10\n']
    for (let i = 0; i < 999_999; i++) rows.push(`O,${i},0.1,0.01\nR,${i},1,10\n`)
    const data = new DataTransfer()
    data.items.add(new File(rows, 'long.csv'))
    document
      .querySelector('h1')
      .dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
  })
  // At each animation frame: the bar is there for a second or two.
  const words = await page.waitForFunction(() => {
    const box = document.querySelector('robot-log .progress:not([hidden])')
    const words = box?.querySelector('span').textContent
    box?.querySelector('button').click()
    return words
  }, undefined)
  assert.match(await words.jsonValue(), /Computing step [\d,]+ of 1,999,998/)
  await page.waitForFunction(() => document.querySelector('robot-log').settled)
  assert.equal((await frameOf(it)).rows, 13_186, 'the picture is the one before')
  await it.locator('.live').getByRole('button', { name: 'Reset' }).click()
  const { step, params } = await until(it, ({ rows }) => rows === 1_999_998, 'the long log from its start')
  assert.deepEqual([step, params.learn], [0, true])
})

test('a link to a log of another length shows the end of this one', async (t) => {
  const code = Buffer.from(JSON.stringify([1, 'robot-log', 1_500_000, { sightings: true, gate: 0.99 }])).toString(
    'base64url',
  )
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
  for (const width of [640, 768, 900, 1024]) {
    await page.setViewportSize({ width, height: 900 })
    await page.waitForFunction(() =>
      [...document.querySelectorAll('robot-log .live > .panel')].every(
        ({ clientWidth, viewBox }) => Math.abs(clientWidth - viewBox.baseVal.width) < 2,
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
