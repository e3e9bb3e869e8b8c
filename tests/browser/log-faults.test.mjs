// What is wrong with a log is shown where it stands, and a page without its script says so.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { dist, frameOf, open } from './harness.mjs'
import { MRCLAM, SMALL, file, openLog } from './own-log.mjs'

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
    ['X,1,2,3', 1, /'X' is no row's letter; L, G, D, O, V, S, T, VE, SE, TE, R, B, P or H was expected/],
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
    assert.match(await answer.locator('.log-wrong').innerText(), /** @type {RegExp} */ (words))
  }
  await choose(file('still.csv', 'L,7,3,4\nR,1,7,2\n# the end\n'))
  await answer
    .getByText('still.csv, line 2, character 1: the log has no motion; D, O, V, S, T, VE, SE or TE rows were expected.')
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
      [
        `The robot's motion is missing: ${roles.join(', ')}`,
        'a file of velocities, of odometry or of encoders was expected.',
      ].join('; '),
      { exact: true },
    )
    .waitFor()
  assert.match(await answer.innerText(), /Open the missing file together with these, or correct below/)
  assert.equal(await answer.locator('.log-line').count(), 0, 'no line is shown as wrong')
})

test('a fault and a question are said at their files at once, and of speeds no count is asked', async (t) => {
  const { page, choose, answer } = await openLog(t)
  const rows = Array.from({ length: 60 }, (_, i) => `${i / 10},1,${i === 50 ? 'abc' : 1}\n`).join('')
  const wheels = file('wheels.csv', `time_s,left_mps,right_mps\n${rows}`)
  await choose(file('compass.csv', 'time_s,heading_deg\n0,10\n1,12\n'), wheels)
  await answer.getByText('wheels.csv, line 52, character 5: right is ').waitFor()
  await answer.getByText('Besides, compass.csv asks something: see below.').waitFor()
  const sets = page.locator('.log-file')
  await sets.nth(0).getByText('In which unit is “heading_deg”?').waitFor()
  await sets.nth(1).getByText('Line 52, character 5: right is ').waitFor()
  await sets.nth(1).getByText('Encoders need the distance between the wheels.').waitFor()
  assert.equal(await page.locator('[data-key="1 base"]').count(), 1)
  assert.equal(await page.locator('[data-key="1 ticks"], [data-key="1 radius"], [data-key="1 counting"]').count(), 0)
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
