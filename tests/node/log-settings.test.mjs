// The settings of a log as a file: what is written is read again, and what is not known is refused by name.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { NotOpen, nextChange } from '../../web/page/log-saved-files.js'
import { isSameLog, isSettings, readSettings, settingsText, startsElsewhere } from '../../web/page/log-settings.js'
import { NONE, markOf, sameCorrections, written } from '../../web/page/log-corrections.js'
import { applyChange } from '../../web/widgets/robot-log/change.js'

const { LogFiles, LogTable, RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')
const known = RobotLog.parameters()

const WHEELS = `time,left,right\n${Array.from({ length: 20 }, (_, k) => `${k / 10},${12 * k},${13 * k}\n`).join('')}`
const FIXES = `stamp;east;north\n${Array.from({ length: 20 }, (_, k) => `${k / 10};${k / 20};0.5\n`).join('')}`

/** @param {[string, string][]} named */
function opened(...named) {
  const files = new LogFiles()
  for (const [name, text] of named) files.add(name, text)
  return files
}
/** Reads open files as settings say. @param {any} files @param {any} settings */
function follow(files, settings) {
  let count = 0
  for (let change = nextChange(settings.files, files.files()); change; count += 1) {
    assert.ok(count < 100, JSON.stringify(change))
    applyChange(files, change)
    change = nextChange(settings.files, files.files())
  }
  return count
}
const bare = (files) => files.files().map(({ name: _, ...one }) => one)

/** Files that are read as nobody would guess. */
function corrected() {
  const files = opened(['wheels.csv', WHEELS], ['fixes.csv', FIXES])
  files.setRole(0, 'encoders')
  const number = Object.entries({ ticks: 512, radius: 0.05, base: 0.3 })
  for (const [name, value] of number) files.setWheel(0, name, value)
  files.setCounting(0, 'total')
  files.setRole(1, 'sensors')
  files.setColumn(1, 'x', 2)
  files.setUnit(1, 'x', 'mm')
  files.setColumn(1, 'y', 1)
  return files
}
const PARAMS = {
  sigmaDistance: 0.25,
  gate: { fix: 0.95 },
  start: [1, 2, 0.5],
  learnBias: true,
  withheld: Float64Array.of(3, 5),
}

test('what is written is read again: settings, columns, units and wheels', () => {
  const files = corrected()
  const settings = readSettings(settingsText(PARAMS, files.files()), known)
  const { params, missing } = settings
  assert.deepEqual({ ...params, withheld: params.withheld }, { ...usual(), ...PARAMS, withheld: [3, 5] })
  assert.equal(missing.length, known.length - 5)
  const again = opened(['wheels.csv', WHEELS], ['fixes.csv', FIXES])
  assert.ok(follow(again, settings) > 3)
  assert.deepEqual(again.files(), files.files())
  assert.equal(follow(again, settings), 0)
  // The core takes what was read.
  RobotLog.from(RobotLog.parse('V,0,1,0\nP,1,1,0\n'), { version: 1, lab: 'robot-log', params, step: 0 })
})
const usual = () => Object.fromEntries(known.map(({ name, default: value }) => [name, value]))

test('what is read otherwise than the files have it is written and read again, or refused', async () => {
  const text = 'L,3,1,2\nO,0,1,0\nO,1,1,0.1\nR,1,3,2\n'
  const files = opened(['log.csv', text])
  const of = () => files.read().contents()
  const none = JSON.parse(settingsText({}, files.files(), of()))
  assert.ok(!('corrections' in none), 'nothing is corrected')
  /** @type {import('estimate-wasm').LogCorrections} */
  const corrections = { driven: [0.97, 1.01], landmarks: [[3, 1.5, 2]], ranges: [[3, 0.4]], swerve: 0.04 }
  applyChange(files, { corrections })
  const contents = of()
  assert.deepEqual(contents.landmarks, [{ id: 3, x: 1.5, y: 2 }])
  assert.ok(contents.notes.includes('Landmark 3 is taken at (1.50, 2.00) m, and not at (1.00, 2.00) m.'))
  assert.ok(contents.notes.includes('On each metre 2.292° more to the left is turned than is read.'))
  const settings = readSettings(settingsText({}, files.files(), contents), known)
  assert.deepEqual(settings.corrections, corrections)
  // Rows that the page has written say that they have them already, and are rows as before.
  const rows = await written(new Blob([text]), contents.corrections).text()
  assert.deepEqual(await markOf(new Blob([rows])), corrections)
  assert.equal(opened(['b_log.csv', rows]).read().contents().steps, contents.steps)
  for (const other of [text, '# corrected: {}\n', '# corrected: [\n', ''])
    assert.equal(await markOf(new Blob([other])), null)
  assert.equal(await written(text, NONE).text(), text)
  assert.ok(sameCorrections(settings.corrections, contents.corrections))
  assert.deepEqual(readSettings(JSON.stringify(none), known).corrections, NONE)
  for (const wrong of [
    {},
    { ...corrections, driven: [0, 1] },
    { ...corrections, landmarks: [[0.5, 1, 1]] },
    { ...corrections, ranges: [[3]] },
    { ...corrections, ranges: [[-1, 0.4]] },
    { ...corrections, swerve: '0' },
    { ...corrections, x: 1 },
  ])
    assert.throws(() => readSettings(JSON.stringify({ ...none, corrections: wrong }), known), /corrections are not/)
  assert.throws(() => files.correct([0, 1], []), /driven: has a factor/)
  assert.throws(() => files.correct([1], []), /driven/)
  assert.throws(() => files.correct([1, 1], [[1, 2]]), /landmarks/)
})

test('whose rows are read, of several tags, is written and read again', () => {
  /** @type {[string, string]} */
  const table = ['ranges.csv', 't,tag,anchor,range\n0,T7,6,2\n1,T9,6,3\n2,T7,6,2.5\n']
  const files = opened(table)
  const asked = () => readSettings(settingsText({}, files.files()), known).files[0]
  assert.ok(!('only' in asked()), 'not said yet')
  for (const only of ['T7', null]) {
    files.setOnly(0, only)
    const again = opened(table)
    assert.equal(follow(again, readSettings(settingsText({}, files.files()), known)), 1)
    assert.deepEqual(again.files(), files.files())
  }
  files.setOnly(0, 'T7')
  const settings = readSettings(settingsText({}, files.files()), known)
  const other = opened(['ranges.csv', 't,tag,anchor,range\n0,T8,6,2\n1,T9,6,3\n'])
  assert.throws(() => follow(other, settings), /ranges\.csv has no rows of T7\./)
})

test('a table that is read once more is read so again, of another recording too', () => {
  const rows = Array.from({ length: 9 }, (_, k) => `${k / 10},1,0,${k / 10},0,${9 - k / 10},5\n`).join('')
  const table = `t,v,omega,x,y,d1,d2\n${rows}`
  const files = opened(['monday.csv', table], ['anchors.csv', 'id,x,y\n1,9,0\n2,0,5\n'])
  files.setRole(2, 'truth')
  files.setUnit(3, 'v', 'km/h')
  const named = files.files().map(({ name, role, again }) => [name, role, again])
  assert.deepEqual(named, [
    ['monday.csv', 'ranges', null],
    ['anchors.csv', 'landmarks', null],
    ['monday.csv, its positions', 'truth', 0],
    ['monday.csv, its motion', 'velocities', 0],
  ])
  const settings = readSettings(settingsText({}, files.files()), known)
  const tuesday = opened(['anchors.csv', 'id,x,y\n1,9,0\n2,0,5\n'], ['tuesday.csv', table])
  follow(tuesday, settings)
  assert.deepEqual(
    tuesday.files().map(({ name, role }) => [name, role]),
    [named[1], ...[0, 2, 3].map((i) => named[i])].map(([name, role]) => [
      String(name).replace('monday', 'tuesday'),
      role,
    ]),
  )
  assert.equal(tuesday.files()[3].values.find(({ name }) => name === 'v').unit, 'km/h')
  const other = {
    ...settings,
    files: [{ ...settings.files[0], role: 'unused', values: {} }, ...settings.files.slice(1)],
  }
  assert.throws(
    () => follow(opened(['monday.csv', table], ['anchors.csv', 'id,x,y\n1,9,0\n']), other),
    /have no monday/,
  )
  const spoilt = settingsText({}, files.files()).replace('"again": 0', '"again": 7')
  assert.throws(() => readSettings(spoilt, known), /files\[2\]\.again is 7/)
})

test('another recording with the same columns is read so too, wherever a column stands', () => {
  const files = corrected()
  const settings = readSettings(settingsText({}, files.files()), known)
  const again = opened(['later-fixes.csv', FIXES], ['later-wheels.csv', WHEELS])
  follow(again, settings)
  assert.deepEqual(bare(again), bare(files).reverse())
  const moved = opened(['wheels.csv', WHEELS.replace('time,left', 'left,time')], ['fixes.csv', FIXES])
  follow(moved, settings)
  assert.deepEqual(
    moved
      .files()[0]
      .values.slice(0, 2)
      .map(({ column }) => column),
    [1, 0],
  )
})

test('of another log the settings say nothing of where this one begins', () => {
  const log = (/** @type {number} */ x) => {
    const rows = Array.from({ length: 9 }, (_, k) => `V,${k},1,0\nP,${k},${x + k},0\n`).join('')
    return opened(['fixes.csv', rows]).read().contents()
  }
  const [monday, tuesday] = [log(5), { ...log(80), steps: 99 }]
  const settings = readSettings(settingsText({ start: [5, 0, 0], startSigma: 0.1 }, [], monday), known)
  assert.equal(startsElsewhere(settings, monday), null)
  assert.deepEqual(startsElsewhere(settings, tuesday)?.patch.start, tuesday.opening.start)
  assert.ok(Math.abs(tuesday.opening.start[0] - 80) < 0.1)
  assert.match(startsElsewhere(settings, tuesday)?.words ?? '', /start is this log’s own/)
  assert.deepEqual(startsElsewhere(settings, { ...tuesday, opening: null })?.patch, {})
  assert.equal(startsElsewhere(settings, { ...tuesday, truth: true }), null)
  // Of the same length and with as many readings it is another one all the same, as it begins elsewhere.
  assert.deepEqual(startsElsewhere(settings, log(80))?.patch.start, tuesday.opening.start)
  const [x, y, theta] = monday.opening.start
  const rounded = { ...monday, opening: { ...monday.opening, start: [x + 1e-5, y, theta] } }
  assert.equal(startsElsewhere(settings, rounded), null)
})

test('a log in the book’s own format needs no columns', () => {
  const files = opened(['mine.csv', 'V,0,1,0\nP,1,1,0\n'])
  assert.deepEqual(readSettings(settingsText(PARAMS, files.files()), known).files, [])
})

test('what is not known or does not fit is refused by its name', () => {
  const contents = opened(['fixes.csv', 'V,0,1,0\nP,1,1,0\nP,2,2,0\n']).read().contents()
  const written = JSON.parse(settingsText(PARAMS, corrected().files(), contents))
  const of = (change) => {
    const copy = structuredClone(written)
    change(copy)
    return () => readSettings(JSON.stringify(copy), known)
  }
  for (const [change, said] of /** @type {[(it: any) => unknown, RegExp][]} */ ([
    [(it) => (it.format = 'other'), /^format is not/],
    [(it) => (it.version = 2), /^version is 2; this page reads 1/],
    [(it) => delete it.settings, /^settings is no object/],
    [(it) => (it.more = 1), /the file has “more”/],
    [(it) => (it.settings.sigma = 1), /settings has “sigma”, which is not known/],
    [(it) => (it.settings.sigmaTurn = -1), /settings\.sigmaTurn is -1; it is a number between 0 and 10/],
    [(it) => (it.settings.sigmaTurn = '1'), /settings\.sigmaTurn is "1"/],
    [(it) => (it.settings.fixes = 1), /settings\.fixes is 1; it is true or false/],
    [(it) => (it.settings.gate = 2), /settings\.gate is 2; it is a probability/],
    [(it) => (it.settings.gate = { sonar: 0.9 }), /settings\.gate/],
    [(it) => (it.settings.start = [1, 2]), /settings\.start is \[1,2\]/],
    [(it) => (it.settings.every = -1), /settings\.every/],
    [(it) => (it.files = {}), /files is no list/],
    [(it) => (it.log.start = [1, '2', 0]), /log\.start is \[1,"2",0\]/],
    [(it) => delete it.files[1].role, /files\[1\] has no role/],
    [(it) => (it.files[0].header = [1]), /files\[0\]\.header/],
    [(it) => (it.files[1].values.x.column = 1), /files\[1\]\.values\.x: column 1 is not called "north"/],
    [(it) => (it.files[0].wheels.size = 1), /files\[0\]\.wheels has “size”/],
  ]))
    assert.throws(of(change), (/** @type {any} */ error) => said.test(error.message), String(said))
  assert.throws(() => readSettings('{', known), /no JSON/)
  const { files } = readSettings(JSON.stringify(written), known)
  assert.throws(() => nextChange(files, opened(['wheels.csv', WHEELS]).files()), /no open file is called fixes\.csv/)
  assert.throws(() => nextChange(files, []), NotOpen)
  const unit = of((it) => (it.files[1].values.x.unit = 'furlong'))()
  assert.throws(() => follow(opened(['wheels.csv', WHEELS], ['fixes.csv', FIXES]), unit), /x is not read in furlong/)
})

test('where the origin of a truth lies is written and read again', () => {
  /** @type {[string, string][]} */
  const tables = [
    ['gps.csv', 'time,speed,yaw_rate,latitude,longitude\n0,1,0,50,8\n1,1,0,50.0001,8\n'],
    ['truth.csv', 'time,true_x,true_y\n0,400,800\n1,400,811\n'],
  ]
  const files = opened(...tables)
  assert.equal(files.files()[1].frame.said, null)
  assert.ok(!('frame' in readSettings(settingsText({}, files.files()), known).files[1]), 'not said yet')
  files.setFrame(1, 'moved')
  const settings = readSettings(settingsText({}, files.files()), known)
  const again = opened(...tables)
  assert.equal(follow(again, settings), 1)
  assert.deepEqual(again.files(), files.files())
  const spoilt = settingsText({}, files.files()).replace('"moved"', '"turned"')
  assert.throws(() => readSettings(spoilt, known), /files\[1\]\.frame is "turned"/)
})

test('the settings of a log are of use to the rows that the page has written of it, and to no others', () => {
  const table = opened(['drive.csv', 'time,v,omega,gps_x,gps_y\n0,1,0,0,0\n1,1,0,,\n2,1,0,2,0\n'])
  table.setRole(0, 'sensors')
  const log = table.read()
  const saved = readSettings(settingsText({}, table.files(), log.contents()), known)
  const text = (it) => {
    const rows = new LogTable(it, {}, 'log')
    return rows.next(100)
  }
  const rows = opened(['log.csv', text(log)])
  assert.equal(isSameLog(saved, rows.files(), rows.read().contents()), true)
  assert.equal(isSameLog(saved, table.files(), log.contents()), false, 'its table is read by its columns')
  const other = opened(['other.csv', 'V,0,1,0\nP,1,1,0\n'])
  const asked = () => isSameLog(saved, other.files(), other.read().contents())
  assert.throws(asked, /it is of a log from drive\.csv\. other\.csv is in the book’s own format and has 2 rows of .* 5/)
  const bare = readSettings(settingsText({}, table.files()), known)
  const unknown = () => isSameLog(bare, rows.files(), rows.read().contents())
  assert.throws(unknown, /do not say what that log held\./)
  assert.throws(unknown, NotOpen, 'they wait for the log that they are of')
  const own = readSettings(settingsText({}, rows.files(), rows.read().contents()), known)
  assert.equal(isSameLog(own, other.files(), other.read().contents()), false, 'no columns, no question')
})

test('a file of settings is known by its first words among other files', async () => {
  const written = settingsText({}, corrected().files())
  for (const [text, is] of [
    [written, true],
    [JSON.stringify(JSON.parse(written)), true],
    [`${written.slice(0, 120)}`, true],
    ['', false],
    ['{"format":"another"}', false],
    ['t,v\n0,1\n', false],
  ])
    assert.equal(await isSettings(new Blob([String(text)])), is, String(text).slice(0, 40))
})
