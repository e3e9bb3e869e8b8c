// A phrase to try gives what it gives from a fresh figure, whatever phrase was pressed before it. In the Picture it
// sets only what it speaks of.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { WIDGETS } from '../../web/widgets/index.js'
import { estimate, widget } from './claims.mjs'

/** Figures that are not held to it, and why. */
const APART = {
  'error-cloud': 'each speaks of the cloud that the reader has: of its mirror image, its variances, one of its dots',
  picture: 'a phrase sets only what it speaks of, and is held to that below',
  'two-carts': 'it has no phrases',
}
/** Phrases that build on the state by their own words: what is counted, fitted or driven is what the reader has. */
const RELATIVE = {
  'observability-probe': ['farther'],
  'odometry-hook': ['lap'],
  'bug-museum': ['seeds'],
  tune: ['fit', 'next'],
}
/**
 * What a phrase, or one phrase of a figure, may leave as it was: marks that are shown beside what it sets, and what its
 * run does not read.
 */
const BESIDE = {
  'observer-bench filter': ['gain'],
  tune: ['fit', 'committed', 'seed'],
  'own-system': ['poles'],
  'observability-probe': ['landmarks', 'ghostAround', 'ghostShift', 'ghostTurn'],
}
/**
 * What a phrase does not speak of, so that the reader's own stays: which noise is drawn, what is marked, the sensor of
 * the Bench, the gain of the copy.
 */
const KEPT = {
  'cart-copy': ['gain'],
  'observer-bench': ['sensor'],
  tune: ['seed', 'length'],
  'own-system': ['shown'],
  'late-readings': ['seed'],
  'bug-museum': ['seed'],
}
/** Phrases that only drive on: those after them leave the robot there. */
const DRIVES = { 'observability-probe': ['farther'] }
/** Figures whose words are about what a phrase leaves as it was: which log is drawn. */
const OWN_WORDS = ['tune']
/** A value that a parameter without limits of its own may have. */
const OTHER = {
  'observability-probe': { stop: 20 },
  'late-readings': { gap: [3, 6], ownDelay: 2 },
  'robot-log': { gate: 0.9 },
}

/** The log that a figure opens with, read once. @type {Map<string, any>} */
const logs = new Map()
function logOf({ log, lab }) {
  const text = () => readFileSync(new URL(`../../${log}`, import.meta.url), 'utf8')
  if (!logs.has(log)) logs.set(log, estimate[lab].parse(text()))
  return logs.get(log)
}

/** Another value than the usual one. */
function other({ name, words, step, least, greatest, default: value }, own = {}) {
  if (name in own) return own[name]
  if (words) return words.find((word) => word !== value)
  if (typeof value === 'boolean') return !value
  return value === greatest ? least : Math.min(greatest, value + Math.max(step, (greatest - least) / 4))
}

test('what is held apart is a figure, and one without phrases has none', async () => {
  for (const tag of Object.keys({ ...APART, ...RELATIVE, ...BESIDE, ...KEPT, ...DRIVES, ...OTHER }))
    assert.ok(tag.split(' ')[0] in WIDGETS, tag)
  assert.deepEqual((await WIDGETS['two-carts']()).tries ?? [], [])
})

for (const tag of Object.keys(WIDGETS).filter((name) => !(name in APART))) {
  test(`each phrase of the ${tag} gives the same after every other`, async () => {
    const spec = await widget(tag)
    const open = ({ params, step }) => {
      const state = { version: 1, lab: spec.name, step, params }
      return spec.log ? estimate[spec.lab].from(logOf(spec), state) : estimate[spec.lab].from(state)
    }
    const phrases = spec.tries.filter(({ name }) => !RELATIVE[tag]?.includes(name))
    const usual = Object.fromEntries(estimate[spec.lab].parameters().map(({ name, default: value }) => [name, value]))
    const first = { params: { ...usual, ...spec.start.params }, step: spec.start.step }
    const pressed = ({ params, step }, { change }) => {
      const lab = open({ params, step })
      const { step: to = step, ...changed } = change(lab.frame(), lab)
      lab.free()
      return { params: { ...params, ...changed }, step: to }
    }
    const seen = ({ params, step }, { name: phrase }) => {
      const beside = [...(BESIDE[tag] ?? []), ...(BESIDE[`${tag} ${phrase}`] ?? [])]
      const kept = Object.entries(params).filter(([name]) => !beside.includes(name))
      return { step, params: Object.fromEntries(kept) }
    }
    const said = ({ params, step }) => {
      const lab = open({ params, step })
      const words = spec.verdict(lab.frame())
      lab.free()
      return words
    }
    // What a reader may have set before: each switch, slider and choice at another value, one at a time.
    const declared = estimate[spec.lab].parameters()
    const there = open(first)
    const frame = there.frame()
    there.free()
    const set = spec.controls.flatMap((/** @type {any} */ { name, shown }) => {
      const parameter = declared.find((one) => one.name === name)
      return parameter && (shown?.(frame) ?? true) && !KEPT[tag]?.includes(name)
        ? [[name, other(parameter, OTHER[tag])]]
        : []
    })
    assert.ok(phrases.length >= 2)
    for (const phrase of phrases) {
      const fresh = pressed(first, phrase)
      const before = [
        ...spec.tries
          .filter(({ name }) => !DRIVES[tag]?.includes(name))
          .map((one) => [`“${one.label}”`, pressed(first, one)]),
        ...set.map(([name, value]) => [name, { ...first, params: { ...first.params, [name]: value } }]),
      ]
      for (const [what, state] of before) {
        const after = pressed(state, phrase)
        assert.deepEqual(seen(after, phrase), seen(fresh, phrase), `“${phrase.label}” after ${what}`)
        if (!OWN_WORDS.includes(tag)) assert.equal(said(after), said(fresh), `“${phrase.label}” after ${what}`)
      }
    }
  })
}

test('the figure that learns the wheel opens in a state that every phrase changes', async () => {
  const spec = await widget('odometry-hook')
  const lab = estimate.OdometryHook.from({
    version: 1,
    lab: spec.name,
    step: spec.start.step,
    params: { fixes: true, learn: true },
  })
  // The whole lap is that of the wheel that the reader has set, with its fixes and what is learned of it.
  assert.deepEqual(spec.tries[0].change(lab.frame(), lab), { step: spec.still })
  const set = Object.fromEntries(spec.tries.map(({ name, change }) => [name, change(lab.frame(), lab)]))
  // The whole lap is that of the wheel as it is set, with its fixes and with what is learned of it.
  assert.deepEqual(set.lap, { step: spec.still })
  // What the phrases call usual is what the lab has at first.
  const { fixes, ...usual } = set.fixes
  assert.ok(fixes)
  for (const { name, default: value } of estimate.OdometryHook.parameters())
    assert.ok([undefined, value].includes(usual[name]), name)
  for (const { label, change } of spec.tries) {
    const { step, ...changed } = change(lab.frame(), lab)
    const { params, step: now } = lab.frame()
    assert.ok(step !== now || Object.entries(changed).some(([name, value]) => params[name] !== value), label)
  }
  lab.free()
})

/** What each phrase speaks of, of the frame that it leads to. */
const SPEAKS_OF = {
  guess: ({ params: { sealed, guess, radius, semiMajor, semiMinor } }) => ({
    sealed,
    guess,
    radius,
    round: Math.abs(semiMajor - semiMinor) < 1e-9,
  }),
  show: ({ params: { sealed } }) => ({ sealed }),
  perfect: ({ params: { sealed, guess, radius, noise } }) => ({ sealed, guess, radius, noise }),
  equal: ({ params: { sealed, guess, radius }, mostLikelyVariance, expectedVariance }) => ({
    sealed,
    guess,
    radius,
    half: (mostLikelyVariance / expectedVariance).toFixed(9),
  }),
  round: ({ params: { sealed, guess, radius }, euclideanFoot, mahalanobisFoot }) => ({
    sealed,
    guess,
    radius,
    apart: Math.hypot(...euclideanFoot.at.map((value, i) => value - mahalanobisFoot.at[i])) < 1e-9,
  }),
  position: ({ params: { sealed, guess, radius }, H }) => ({ sealed, guess, radius, H }),
  again: (frame) => frame,
}

test('a phrase of the Picture shows the same after any other', async () => {
  const spec = await widget('picture')
  assert.deepEqual(
    spec.tries.map(({ name }) => name),
    Object.keys(SPEAKS_OF),
  )
  const open = (params) => estimate.Picture.from({ version: 1, lab: spec.name, step: 0, params })
  const after = (params, phrase) => {
    const lab = open(params)
    const changed = { ...lab.frame().params, ...phrase.change(lab.frame(), lab) }
    lab.free()
    return changed
  }
  const frameAt = (params) => open(params).frame()
  for (const phrase of spec.tries) {
    const fresh = SPEAKS_OF[phrase.name](frameAt(after({}, phrase)))
    const before = [
      ...spec.tries.map((other) => [other.name, after({}, other)]),
      ['a state of a reader', { radius: 2, guess: 0.4, sealed: true, noise: 3, semiMajor: 1, semiMinor: 2 }],
    ]
    for (const [name, params] of before) {
      const frame = frameAt(after(params, phrase))
      assert.deepEqual(SPEAKS_OF[phrase.name](frame), fresh, `“${phrase.label}” after ${name}`)
      assert.equal(
        spec.verdict(frame).startsWith('The answer is hidden'),
        phrase.name === 'guess',
        `“${phrase.label}” after ${name}`,
      )
    }
  }
})
