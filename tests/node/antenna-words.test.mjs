// An antenna that does not stand where the robot's pose is: what is said of it, what the press sets, and what comes
// of a start that the fixes have told.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { mendBefore } from '../../web/page/log-fit-words.js'
import { remedy } from '../../web/page/log-remedy.js'
import { startBelow } from '../../web/widgets/robot-log/antenna.js'
import { ranked, sentence } from '../../web/widgets/robot-log/verdict.js'
import { judgement, suspect } from './verdicts.mjs'

const size = (/** @type {number} */ value, /** @type {number} */ sigma) => ({ now: 0, value, sigma, end: false })
const antenna = (/** @type {any[]} */ ...sizes) =>
  suspect({ fault: 'antenna', name: null, with: sizes[2] ? 'delayFix' : null, sizes })
const params = /** @type {any} */ ({ start: [10, 20, Math.PI / 2], antennaAhead: 0, antennaLeft: 0 })

test('it is said where the antenna stands, and set there', () => {
  const one = antenna(size(0.5234, 0.0123), size(-0.0312, 0.0141))
  assert.equal(
    sentence(one, false),
    'The antenna whose positions these are stands 0.523 ± 0.012 m ahead of the point about which the robot turns, ' +
      'and 0.031 ± 0.014 m to its right: set its place so.',
  )
  assert.match(sentence(antenna(size(-1.2, 0.1), size(0.4, 0.1)), false), / behind the point .* to its left: set/)
  const { press, patch } = /** @type {any} */ (remedy(one, params, false))
  assert.deepEqual([press, patch.antennaAhead, patch.antennaLeft], ['Set its place so', 0.523, -0.031])
  assert.match(mendBefore(judgement([one])), /^The verdict names another place of the antenna, which Fit does not look/)
})

test('what the model may have as its own is said, and a delay is set with the place', () => {
  const [ahead, left] = [size(0.5234, 0.0123), size(0.0312, 0.0141)]
  const said = (/** @type {any[]} */ ...sizes) =>
    ranked(judgement([antenna(...sizes)], { pace: 0.8, ownDelay: 0.1 }), { rows: 1000, truth: false })
  assert.match(
    said(ahead, left),
    / Up to 0\.08 m of it ahead may be the motion model’s own, the way of a step\. The log-l/,
  )
  const late = { ...size(0.35, 0.02), now: 0.1, value: 0.45 }
  assert.match(said(ahead, left, late), / to its left, and these come 0\.350 ± 0\.020 s late: .* delay to 0\.450 s\./)
  const { patch } = /** @type {any} */ (remedy(antenna(ahead, left, late), params, true))
  assert.deepEqual(patch, { antennaAhead: 0.523, antennaLeft: 0.031, delayFix: 0.45 })
  const speed = { ...antenna(ahead, left, { ...size(0.2, 0.002) }), with: 'delaySpeed' }
  assert.match(sentence(speed, false), / to its left, and the speed comes 0\.2000 ± 0\.0020 s late: .* to 0\.2000 s\.$/)
  const { patch: both } = /** @type {any} */ (remedy(speed, params, true))
  assert.deepEqual(both, { antennaAhead: 0.523, antennaLeft: 0.031, delaySpeed: 0.2 })
})

test('a start that was taken from fixes goes below the antenna, and a true one stays', () => {
  const one = antenna(size(0.5, 0.01), size(0.2, 0.01))
  const { patch } = /** @type {any} */ (remedy(one, params, false))
  const [x, y, theta] = patch.start
  assert.ok(Math.abs(x - 10.2) < 1e-12 && Math.abs(y - 19.5) < 1e-12 && theta === Math.PI / 2, `${patch.start}`)
  assert.equal('start' in /** @type {any} */ (remedy(one, params, true)).patch, false)
  assert.equal('start' in /** @type {any} */ (remedy(one, { ...params, start: null }, false)).patch, false)
  // What is set already is no change.
  const set = { ...params, antennaAhead: 0.5, antennaLeft: 0.2 }
  assert.deepEqual(startBelow(set, { antennaAhead: 0.5 }), params.start)
  assert.ok(Math.abs(startBelow(set, { antennaAhead: 0 })[1] - 20.5) < 1e-12)
})
