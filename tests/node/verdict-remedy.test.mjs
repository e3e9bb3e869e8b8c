// What a press below the verdict sets is what the verdict's sentence says, and only where one setting mends it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { mendBefore } from '../../web/page/log-fit-words.js'
import { remedies, remedy } from '../../web/page/log-remedy.js'
import { unsettledWords } from '../../web/widgets/robot-log/unsettled.js'
import { named } from '../../web/widgets/robot-log/named.js'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const DEGREE = Math.PI / 180
const size = (value, sigma = 0.021, now = 0) => ({ now, value, sigma, end: false })
/** @type {any} */
const params = { gate: null }
/** @type {any} */
const frame = { params, truth: null }
/** @returns {any} */
const set = (given, truth = false) => remedy(suspect(given), params, truth)
/** The numbers that the second half of a sentence gives, without how well each is known. */
const asked = (given) =>
  (sentence(suspect(given), false).match(/: (?:set|let) .*$/) ?? [''])[0]
    .replaceAll('−', '-')
    .replace(/ ± [\d.]+/g, '')
    .match(/-?\d+(\.\d+)?/g)
    ?.map(Number)

test('a press sets the number that the sentence says, in the unit of the filter', () => {
  /** @type {[any, number][]} */
  const numbers = [
    [{ name: 'delayFix', sizes: [size(0.34567)] }, 1],
    [{ name: 'delaySpeed', sizes: [size(-0.34567)] }, 1],
    [{ fault: 'bias', name: 'offset', sizes: [size(0.81234, 0.0234)] }, 1],
    [{ fault: 'turned', name: 'bearingOffset', sizes: [size(0.034567, 0.0012)] }, DEGREE],
    [{ fault: 'turned', name: 'headingOffset', sizes: [size(-3.1, 0.012)] }, DEGREE],
    [{ fault: 'sigma', name: 'fixSigmaScale', claims: [0.1, 0.1, 0.1], sizes: [size(4.98765, 0.12, 1)] }, 1],
    [
      {
        fault: 'scale',
        name: 'scale',
        sizes: [size(0.034567, 0.0012)],
        times: { value: 1.0346, sigma: 0.0012, set: 1, unit: null },
      },
      0.01,
    ],
  ]
  for (const [given, unit] of numbers) {
    const { press, patch } = set(given)
    assert.equal(press, 'Set it so')
    assert.deepEqual(Object.keys(patch), [given.name])
    const [said] = asked(given)
    assert.ok(Math.abs(patch[given.name] / unit - said) < 1e-9 * Math.abs(said), `${given.name}: ${said}`)
  }
})

test('a start is set with its heading within half a turn, unless a truth has it', () => {
  const start = { fault: 'start', name: null, sizes: [size(3.21987, 0.12), size(-1.5, 0.1), size(4, 0.05)] }
  const { press, patch } = set(start)
  assert.equal(press, 'Set the start so')
  const [x, y, heading] = asked(start)
  assert.deepEqual(patch.start.slice(0, 2), [x, y])
  assert.ok(Math.abs(patch.start[2] - heading * DEGREE) < 1e-9)
  assert.ok(Math.abs(patch.start[2]) < Math.PI)
  assert.equal(set(start, true), null, 'the row of the truth is the one to mend')
})

test('delays that come together are set together, each its own', () => {
  const both = { with: 'delayHeading', sizes: [size(0.4), size(0.5, 0.021, 0.1)] }
  assert.deepEqual(set(both), { press: 'Set them so', patch: { delayFix: 0.4, delayHeading: 0.5 } })
  const three = { with: 'delayHeading', sizes: [size(0.4), size(0.4), size(0.4)] }
  assert.deepEqual(set(three).patch, { delayFix: 0.4, delayHeading: 0.4, delaySighting: 0.4 })
})

test('scale and offset of the ranges are set together', () => {
  const ruler = {
    fault: 'scale',
    name: 'scale',
    with: 'offset',
    sizes: [size(0.034567, 0.0012), size(0.71, 0.02)],
    times: { value: 1.0346, sigma: 0.0012, set: 1, unit: null },
  }
  const { patch } = set(ruler)
  const [scale, offset] = asked(ruler)
  assert.ok(Math.abs(patch.scale - scale / 100) < 1e-12)
  assert.equal(patch.offset, offset)
})

test('what the filter can learn, it learns, and outliers are gated at their sensor alone', () => {
  const bias = { fault: 'bias', name: 'turnBias', sizes: [size(0.01, 0.001)] }
  assert.deepEqual(set(bias).patch, { learnBias: true })
  const speed = { fault: 'scale', name: 'speedScale', times: { value: 1.1, sigma: 0.01, set: 1, unit: null } }
  assert.deepEqual(set({ ...speed, sizes: [size(-0.09, 0.01)] }).patch, { learnSpeed: true })
  const tails = suspect({ fault: 'tails', name: null, sensor: 'range', sizes: [size(0.1, 0.01)] })
  /** @type {any} */
  const gated = { gate: { fix: 0.95 } }
  assert.deepEqual(remedy(tails, gated, false)?.patch, { gate: { fix: 0.95, range: 0.999 } })
  const both = suspect({ ...tails, name: 'sigmaRange', sizes: [size(0.1, 0.01), size(0.12345, 0.0031, 0.6)] })
  assert.deepEqual(remedy(both, gated, false), {
    press: 'Switch the gate on, with that σ',
    patch: { gate: { fix: 0.95, range: 0.999 }, sigmaRange: 0.1235 },
  })
})

test('where landmarks or odometry are wrong the log is read as the sentence says, beside former corrections', () => {
  /** @type {any} */
  const log = {
    motion: 'odometry',
    names: [],
    landmarks: [
      { id: 3, x: 1, y: 2 },
      { id: 7, x: 4, y: 5 },
    ],
    corrections: { driven: [1.1, 1], landmarks: [[3, 1, 2]], ranges: [[7, 0.1]] },
  }
  const corrected = (given) => remedy(suspect({ name: null, ...given }), params, false, log)
  const elsewhere = { fault: 'displaced', landmarks: [7], sizes: [size(4.8123, 0.03, 4), size(4.5, 0.03, 5)] }
  assert.deepEqual(corrected(elsewhere), {
    press: 'Take it there',
    corrections: {
      driven: [1.1, 1],
      landmarks: [
        [3, 1, 2],
        [7, 4.812, 4.5],
      ],
      ranges: [[7, 0.1]],
    },
  })
  assert.match(sentence(suspect({ name: null, ...elsewhere }), false), /write 4\.812 ± 0\.030 m and 4\.500/)
  assert.deepEqual(corrected({ fault: 'exchanged', landmarks: [3, 7], sizes: [] })?.corrections?.landmarks, [
    [3, 4, 5],
    [7, 1, 2],
  ])
  const biased = { fault: 'landmark-bias', landmarks: [7], sizes: [size(0.3987, 0.021)] }
  assert.deepEqual(
    corrected(biased)?.corrections,
    { ...log.corrections, ranges: [[7, 0.499]] },
    'beside what was taken',
  )
  assert.deepEqual(corrected({ ...biased, landmarks: [3] })?.corrections?.ranges, [
    [7, 0.1],
    [3, 0.399],
  ])
  assert.equal(
    sentence(suspect({ name: null, ...biased }), false),
    'The ranges to landmark 7 alone read 0.399 ± 0.021 m too long, as behind a wall or by a delay in its radio: ' +
      'take them 0.399 m shorter.',
  )
  const short = suspect({ name: null, ...biased, sizes: [size(-0.3987, 0.021)] })
  assert.match(
    sentence(short, false),
    /read 0\.399 ± 0\.021 m too short, as by its radio: take them 0\.399 m longer\.$/,
  )
  const odometry = { fault: 'odometry', sizes: [size(-0.0301, 0.0021), size(0.0123, 0.0034)] }
  const { press, corrections } = corrected(odometry) ?? {}
  assert.equal(press, 'Take them so')
  const [along, about] = corrections?.driven ?? [0, 0]
  assert.ok(Math.abs(along - 1.1 * 0.9699) < 1e-9 && Math.abs(about - 1.0123) < 1e-9, `${along} ${about}`)
  assert.equal(corrected({ ...odometry, sizes: [{ ...size(9), end: true }, size(0)] }), null, 'another unit')
  assert.equal(remedy(suspect({ name: null, ...odometry }), params, false), null, 'of no log')
})

test('what is the reader’s to say has no press: a unit, a sign, names, what lies at the end of a search', () => {
  const times = { value: 3.6, sigma: 0.01, set: 1, unit: ['km/h', 'm/s'] }
  assert.equal(set({ fault: 'scale', name: 'speedScale', sizes: [size(-0.72)], times }), null)
  const most = { ...size(-0.9), end: true }
  assert.equal(set({ fault: 'scale', name: 'scale', sizes: [most], times: { ...times, unit: null } }), null)
  for (const fault of ['mirrored', 'exchanged', 'displaced', 'landmark-bias'])
    assert.equal(set({ fault, name: null, sizes: [] }), null)
})

test('two that the readings do not tell apart have a press each, and what is none has none', () => {
  const start = suspect({ fault: 'start', name: null, standing: 'maybe', sizes: [size(3), size(2), size(1)] })
  const rival = suspect({ standing: 'maybe', excess: 14 })
  const presses = (given, more) => remedies(judgement(given, more), frame).map(({ press }) => press)
  assert.deepEqual(presses([start, rival]), ['Either: set the start so', 'Or: set it so'])
  assert.deepEqual(presses([start, { ...rival, excess: 2 }]), ['Set the start so'])
  assert.deepEqual(presses([suspect({ standing: 'cleared' })]), [])
  assert.deepEqual(presses([suspect({}), rival], { other: true }), ['Set it so'], 'the likeliest may be tried')
  const of = (/** @type {string} */ fault) =>
    suspect({ fault, name: null, landmarks: [7], standing: 'maybe', sizes: [size(1), size(2)] })
  const both = judgement([of('landmark-bias'), of('displaced')])
  const names = (/** @type {any} */ corrections) =>
    named(both, /** @type {any} */ ({ corrections })).map(({ fault }) => fault)
  const NONE = { driven: [1, 1], landmarks: [], ranges: [] }
  assert.deepEqual(names(NONE), ['landmark-bias', 'displaced'])
  assert.deepEqual(names({ ...NONE, landmarks: [[7, 1, 1]] }), ['displaced'], 'what was mended is mended once more')
  assert.deepEqual(names({ ...NONE, ranges: [[7, 1]] }), ['landmark-bias'])
  assert.deepEqual(names({ ...NONE, ranges: [[3, 1]] }), ['landmark-bias', 'displaced'])
  assert.deepEqual(remedies(null, frame), [])
})

test('Fit says what the verdict names and it does not look for', () => {
  const start = suspect({ fault: 'start', name: null, sizes: [size(3), size(2), size(1)] })
  assert.match(mendBefore(judgement([start])), /names another start, which Fit does not look for: mend that before/)
  const bias = suspect({ fault: 'bias', name: 'turnBias', sizes: [size(0.01, 0.001)] })
  assert.match(mendBefore(judgement([bias])), /names a bias of the turn rate/)
  const tails = suspect({ fault: 'tails', name: 'sigmaRange', sensor: 'range', sizes: [] })
  assert.match(mendBefore(judgement([tails])), /names a share of outliers among the ranges, which Fit does not/)
  assert.equal(mendBefore(judgement([suspect({})])), '', 'a delay is among what it finds')
  assert.equal(mendBefore(judgement([{ ...start, standing: 'cleared' }])), '')
  assert.equal(mendBefore(null), '')
})

test('where one σ is wrong all are fitted together at one press', () => {
  /** @param {string} name @param {number} now @param {number} value @param {string} standing */
  const sigma = (name, now, value, standing) =>
    suspect({
      fault: 'sigma',
      name,
      sizes: [size(value, 0.01, now)],
      standing,
      excess: standing === 'cleared' ? -1 : 9,
    })
  const known = Object.entries({ sigmaDistance: 0.1, sigmaTurn: 0.05, sigmaFix: 1 })
  const usual = /** @type {any} */ (known.map(([name, value]) => ({ name, default: value })))
  const set = { gate: null, sigmaDistance: 0.1, sigmaTurn: 0.05, sigmaFix: 0.4 }
  /** @param {any[]} suspects @param {any} [params] @returns {[any[], string]} */
  const of = (suspects, params = set, more = {}) => {
    const verdict = judgement(suspects, more)
    const shown = /** @type {any} */ ({ params, truth: null, log: null, known: usual })
    return [remedies(verdict, shown), unsettledWords(verdict, params, usual)]
  }
  const [fix, turn, distance] = [
    sigma('sigmaFix', 0.4, 0.5, 'sure'),
    sigma('sigmaTurn', 0.05, 0.05, 'cleared'),
    sigma('sigmaDistance', 0.1, 0.2, 'maybe'),
  ]
  assert.deepEqual(of([fix, turn, distance]), [
    [{ press: 'Fit all three σ', fit: ['sigmaFix', 'sigmaTurn', 'sigmaDistance'] }],
    ' The two others are as uncertain: a fit finds all three together.',
  ])
  const told = { ...set, sigmaTurn: 0.03 }
  assert.deepEqual(of([fix, turn, distance], told), [
    [{ press: 'Fit all three σ', fit: ['sigmaFix', 'sigmaTurn', 'sigmaDistance'] }],
    ' Another σ is as uncertain: a fit finds all three together.',
  ])
  // The others were found beside what this one was.
  const alone = of([fix, turn, { ...distance, standing: 'cleared' }], { ...told, sigmaDistance: 0.2 })
  assert.deepEqual(alone, [
    [{ press: 'Fit all three σ', fit: ['sigmaFix', 'sigmaTurn', 'sigmaDistance'] }],
    ' A fit finds all three together.',
  ])
  const [presses, words] = of([sigma('sigmaTurn', 0.05, 0.1, 'sure')])
  assert.equal(presses[0].press, 'Set it so')
  assert.equal(words, ' That σ is the one with which the page begins, whatever the log is.')
  // So they are where one alone mends nothing.
  assert.equal(of([fix, turn, distance], set, { other: true })[0][0].press, 'Fit all three σ')
  assert.ok(of([fix, turn, distance], set, { ungated: true })[0][0].ungated, 'judged and fitted without the gate')
  const quiet = [fix, turn, distance].map((one) => ({ ...one, standing: 'cleared' }))
  const [gated, open] = [0.999, null].map((gate) => of(quiet, { ...set, gate })[1])
  assert.match(gated, /^ The σ of the motion are those with which the page begins, and behind a gate they may be wrong/)
  assert.deepEqual([open, of(quiet, { ...set, gate: { fix: 0.99, range: null }, sigmaTurn: 0.04 })[1]], ['', ''])
  // Readings that bring their own are none of the page's; another fault is mended first.
  const own = suspect({ fault: 'sigma', name: 'fixSigmaScale', claims: [1, 1, 1], sizes: [size(2, 0.1, 1)] })
  assert.deepEqual(of([own, turn])[0][0].fit, ['fixSigmaScale', 'sigmaTurn'])
  assert.deepEqual(of([suspect({}), turn, distance])[0][0].patch, { delayFix: 0.35 })
})

test('a delay beyond all that are tried is set once, and then it is a file’s clock', () => {
  const late = suspect({ fault: 'clock', name: 'delayFix', sizes: [{ now: 0, value: 3, sigma: 0.1, end: true }] })
  assert.deepEqual(remedy(late, params, false)?.patch, { delayFix: 3 })
  const early = suspect({ fault: 'clock', name: 'delaySpeed', sizes: [{ now: 0, value: -3, sigma: 0.1, end: true }] })
  assert.equal(remedy(early, { ...params, delayFix: 3 }, false), null)
  const told = suspect({ fault: 'clock', name: 'delayFix', sizes: [{ now: 3, value: 5.2, sigma: 0.1, end: false }] })
  assert.deepEqual(remedy(told, { ...params, delayFix: 3 }, false)?.patch, { delayFix: 5.2 })
})

test('what may be no fault has no press, and stands behind what is one', () => {
  const late = suspect({
    fault: 'clock',
    name: 'delayFix',
    standing: 'maybe',
    own: true,
    excess: 6,
    sizes: [size(0.04)],
  })
  assert.deepEqual(remedies(judgement([late]), frame), [])
  const noise = suspect({ fault: 'sigma', name: 'sigmaFix', standing: 'maybe', excess: 4, sizes: [size(0.3, 0.01, 1)] })
  const both = judgement([late, noise])
  assert.deepEqual(named(both), [noise])
  assert.deepEqual(
    remedies(both, frame).map(({ patch }) => patch),
    [{ sigmaFix: 0.3 }],
  )
  // What was held against the truth, and is not the first, mends nothing.
  assert.deepEqual(named(judgement([late, { ...noise, mended: { rmse: 1, nees: 2, outside: 0 } }])), [late])
})

test('turns of odometry that noise makes smaller may be no fault and have no press', () => {
  const sizes = [size(0.001, 0.004), size(-0.105, 0.018)]
  const turns = suspect({ fault: 'odometry', name: null, standing: 'maybe', own: true, sizes })
  assert.deepEqual(remedies(judgement([turns]), frame), [])
  const said = ranked(judgement([turns]), { rows: 1000, truth: false })
  assert.match(
    said,
    /^Perhaps: The robot .* less than odometry reads\. Noise in the turns that are read looks the same: it may be/,
  )
})
