// A log whose motion is not read for a while: the verdict's presses keep the longest stretch without such a gap.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { areCorrections, isCorrected, plain, sameCorrections } from '../../web/page/log-corrections.js'
import { mendBefore } from '../../web/page/log-fit-words.js'
import { readSettings, settingsText } from '../../web/page/log-settings.js'
import { remedies } from '../../web/page/log-remedy.js'
import { ranked } from '../../web/widgets/robot-log/verdict.js'
import { applyChange } from '../../web/widgets/robot-log/change.js'
import { judgement, suspect } from './verdicts.mjs'

const { LogFiles, LogVerdict, RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** @type {import('estimate-wasm').LogCorrections} */
const NONE = { driven: [1, 1], landmarks: [], ranges: [], kept: null }
const gap = (longest, between, count = 1) => ({ what: 'turn rate', count, longest, between })
/** What is pressed beside a fault, by words and by what is read then. */
const presses = (gaps, /** @type {any} */ { kept = null, standing = 'sure' } = {}) => {
  const frame = { params: {}, truth: null, log: { corrections: { ...NONE, kept } } }
  const found = remedies(judgement([suspect({ standing })], { gaps }), /** @type {any} */ (frame))
  return found.map(({ press, corrections }) => [press, corrections?.kept])
}

test('where much of the motion is not read, the one press is to cut the log, and no fault is told', () => {
  const early = gap([120, 240], [0, 120])
  const said = ranked(judgement([suspect({})], { gaps: [early] }), { rows: 100, truth: false })
  assert.match(said, /^No turn rate from 120\.0 to 240\.0 s .* first\. The readings do not fit what is held, and what/)
  assert.doesNotMatch(said, /positions/)
  assert.match(mendBefore(judgement([suspect({})], { gaps: [early] })), /cut the log there before/)
  assert.deepEqual(presses([early]), [['Cut the log: keep 0.0 to 120.0 s', [0, 120]]])
  // A part of a part, in seconds since the first row of the files.
  assert.deepEqual(presses([early], { kept: [30, 270] }), [['Cut the log: keep 0.0 to 120.0 s', [30, 150]]])
  assert.deepEqual(presses([gap([3, 5], [5, 240]), early])[0][1], [0, 120], 'at the longest')
})

test('beside a short gap a fault has its press as well, and where there is no fault nothing is cut', () => {
  const short = gap([80, 82], [82, 240], 3)
  assert.deepEqual(presses([short]), [
    ['Cut the log: keep 82.0 to 240.0 s', [82, 240]],
    ['Set it so', undefined],
  ])
  assert.deepEqual(presses([short], { standing: 'cleared' }), [])
  assert.deepEqual(presses([]), [['Set it so', undefined]])
})

test('the part that is read is kept among what is corrected', () => {
  /** @type {typeof NONE} */
  const part = { ...NONE, kept: [0, 120] }
  assert.ok(isCorrected({ corrections: part }) && !isCorrected({ corrections: NONE }))
  assert.deepEqual(plain(part).kept, [0, 120])
  assert.ok(!('kept' in plain(NONE)), 'files of before have none')
  assert.ok(!sameCorrections(part, { ...NONE, kept: [0, 119] }))
  assert.ok(areCorrections(plain(part)) && areCorrections(plain(NONE)))
  for (const kept of [[5, 5], [5], ['0', 5], 7]) assert.ok(!areCorrections({ ...plain(NONE), kept }), String(kept))
})

test('a log whose gyro ends half-way is cut there, and files of settings say so', () => {
  const files = new LogFiles()
  const rows = (/** @type {number} */ n, /** @type {(t: number) => unknown[]} */ of) =>
    Array.from({ length: n }, (_, k) => `${[k / 10, ...of(k / 10)].join()}\n`).join('')
  files.add('gyro.csv', `time_s,yaw_rate\n${rows(600, (t) => [0.2 * Math.sin(t / 5)])}`)
  files.add('speed.csv', `time_s,speed\n${rows(1200, () => [1])}`)
  const along = (/** @type {number} */ t) => [t + 0.1 * Math.sin(97 * t), 5 * Math.sin(t / 9)]
  files.add('gnss.csv', `time_s,gnss_x,gnss_y\n${rows(1200, along)}`)
  const judged = () => {
    const log = files.read()
    const { opening } = log.contents()
    const usual = Object.fromEntries(RobotLog.parameters().map((/** @type {any} */ one) => [one.name, one.default]))
    const verdict = new LogVerdict(log, { ...usual, ...opening })
    while (verdict.step());
    return { contents: log.contents(), found: verdict.found() }
  }
  const { contents, found } = judged()
  assert.deepEqual(
    found.gaps.map(({ what, count }) => [what, count]),
    [['turn rate', 1]],
  )
  const [cut, ...others] = remedies(found, /** @type {any} */ ({ params: {}, truth: null, log: contents }))
  assert.deepEqual([cut.press, others.length], ['Cut the log: keep 0.0 to 59.9 s', 0])
  applyChange(files, cut)
  const part = judged()
  assert.deepEqual(part.found.gaps, [])
  assert.deepEqual([contents.rows, part.contents.rows, part.contents.steps], [3000, 1800, 1800])
  assert.ok(part.contents.notes.includes('The log is read from 0.0 to 59.9 s after its first row.'))
  assert.equal(part.contents.span[1] - part.contents.span[0], 59.9)
  const { corrections } = readSettings(settingsText({}, files.files(), part.contents), RobotLog.parameters())
  assert.ok(sameCorrections(corrections, part.contents.corrections) && isCorrected({ corrections }))
  applyChange(files, { corrections: NONE })
  assert.deepEqual(judged().contents, contents)
  assert.throws(() => files.correct([1, 1], [], [], [5, 5]), /kept: ends before it begins/)
})
