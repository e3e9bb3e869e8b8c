// The σ that readings bring: what is said of it, which control a log has for it, and what goes with its factor.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { createRequire } from 'node:module'
import { sentence as fitted } from '../../web/page/log-fit-words.js'
import {
  acts,
  numbersOf as numbersToTell,
  openingOf,
  ownFactor,
  ownSigma,
  settingWords,
  settingsOf,
} from '../../web/page/log-numbers.js'

const { RobotLog } = createRequire(import.meta.url)('../../target/pkg/node/estimate_wasm.js')

/** A robot among landmarks, each of whose fixes brings 0.1 m. */
const camera = RobotLog.parse('L,1,9,0\nV,0,1,0\nP,0,0,0,0.1\nB,0.5,1,8.5,0\nP,1,1,0,0.1\nP,2,2,0,0.1')
function frameOf() {
  const lab = new RobotLog(camera, {})
  lab.runAll()
  const frame = lab.frame()
  lab.free()
  return frame
}

test('a σ that readings bring along is said in place of the setting that they do not take', () => {
  const contents = camera.contents()
  assert.equal(ownSigma(contents, 'sigmaFix'), 'each brings its own: 0.1 m')
  assert.equal(ownSigma(contents, 'sigmaHeading') + ownSigma(contents, 'sigmaTurn') + ownSigma(null, 'sigmaFix'), '')
  const value = (of) => settingsOf(frameOf(), of).find(([words]) => words === 'Positions: σ, m')?.[1]
  assert.equal(value(contents), 'each brings its own: 0.1 m')
  const some = RobotLog.parse('V,0,1,0\nP,0,0,0,0.25\nP,1,1,0,0.5\nP,2,2,0\nH,2,0,0.01').contents()
  assert.equal(value(some), '1; 2 of 3 bring their own: 0.25 to 0.5 m')
  assert.equal(ownSigma(some, 'sigmaHeading'), 'each brings its own: 0.01 rad')
})

test('the control of a σ that no reading takes gives its place to the factor on their own', () => {
  const [each, some] = [camera.contents(), RobotLog.parse('V,0,1,0\nP,0,0,0,0.25\nP,1,1,0,0.5\nP,2,2,0').contents()]
  const none = RobotLog.parse('V,0,1,0\nP,0,0,0\nP,1,1,0').contents()
  const shown = (of) => ['sigmaFix', 'fixSigmaScale'].map((name) => acts(of, name))
  assert.deepEqual(
    [shown(each), shown(some), shown(none)],
    [
      [false, true],
      [true, true],
      [true, false],
    ],
  )
  assert.ok(acts(none, 'sigmaTurn') && acts(none, 'delayFix'))
  const listed = numbersToTell(each).map(({ words }) => words)
  assert.ok(listed.includes('positions: factor on own σ') && !listed.includes('positions: σ, m'))
  assert.equal(settingWords('fixSigmaScale'), 'factor on own σ of positions')
  const factor = (of) => settingsOf(frameOf(), of).find(([words]) => words === 'Positions: factor on own σ')?.[1]
  assert.deepEqual([factor(each), factor(none), factor(null)], ['1', undefined, undefined])
  assert.match(
    ownFactor(each, 'fixSigmaScale'),
    /^σ: each brings its own: 0\.1 m\. The filter takes it times this factor\./,
  )
  assert.match(ownFactor(some, 'fixSigmaScale'), /^σ: 2 of 3 bring .* this factor\. The others have the σ above\.$/)
  assert.equal(ownFactor(each, 'sigmaFix') + ownFactor(each, 'delayFix'), '')
})

test('the σ of a start at the first fix goes with the factor where each fix brings its own', () => {
  const log = (rows) => RobotLog.parse(`V,0,1,0\n${rows}`).contents()
  const each = log('P,0,0,0,0.25\nP,9,9,0,0.25')
  assert.equal(openingOf(each, 1)?.startSigma, 0.25)
  assert.equal(openingOf(each, 4)?.startSigma, 1)
  assert.match(ownFactor(each, 'fixSigmaScale'), / With it goes the σ of a start at the first fix\.$/)
  const some = log('P,0,0,0,0.25\nP,9,9,0')
  assert.equal(openingOf(some, 4)?.startSigma, 0.25, 'a factor that is not the first fix’s for sure')
  const known = log('G,0,0,0,0\nP,0,0,0,0.25')
  assert.deepEqual([openingOf(known, 4), known.opening], [null, null], 'the truth says where it starts')
  assert.doesNotMatch(ownFactor(known, 'fixSigmaScale'), /start/)
})

test('a fit says the factor relative to itself, as it does a σ', () => {
  const found = fitted(
    { name: 'fixSigmaScale', value: 5.0123, sigma: 0.0236, relative: true, flat: null, most: null },
    { pace: 1, period: 0.1, ownDelay: 0.05 },
  )
  assert.equal(found, 'factor on the positions’ own σ: 5.01 ± 2.4 %')
})
