// The questions of the built chapter: each has one right answer that the page takes, a reason for every choice, and
// nothing that tells the right one before. How a question behaves is tested in a browser, on a few of them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { judge, keyOf, unmet } from '../../web/page/answer.js'
import { handlesOf } from '../../web/widgets/late-readings/handles.js'
import { estimate, widget } from './claims.mjs'

const { parseHTML } = createRequire(new URL('../../web/package.json', import.meta.url))('linkedom')
/** The chapter, and the page of its exercises. */
const pages = ['kalman', 'kalman/exercises'].map(
  (at) => parseHTML(readFileSync(new URL(`../../dist/${at}/index.html`, import.meta.url), 'utf8')).document,
)
const all = (selector, of) => [...of.querySelectorAll(selector)]
const onPages = (selector) => pages.flatMap((page) => all(selector, page))
/** @type {{ it: any, id: string, kind: string, key: any }[]} */
const questions = onPages('.quiz').map((it) => ({ it, id: it.dataset.quiz, kind: it.dataset.kind, key: keyOf(it) }))
const words = (element) => element?.textContent.trim() ?? ''

test('every choice of every question has a reason of its own, and one is right', () => {
  const choices = questions.filter(({ kind }) => kind === 'choice')
  assert.ok(choices.length >= 3)
  for (const { it, id, key } of choices) {
    const reasons = all('.quiz-reasons > li', it)
    assert.equal(reasons.length, all('.quiz-choice', it).length, id)
    assert.deepEqual(
      reasons.flatMap((li, i) => (li.querySelector('.quiz-mark.is-right') ? [i] : [])),
      [key.right],
      id,
    )
    assert.equal(new Set(reasons.map((li) => words(li.querySelector('.quiz-reason')))).size, reasons.length, id)
    for (const li of reasons) assert.ok(words(li.querySelector('.quiz-reason')).length > 30, `${id}: ${words(li)}`)
  }
})

test('the natural slips of three questions are known, and are told apart from what is nearly right', () => {
  for (const [id, slip, tells] of /** @type {[string, string, RegExp][]} */ ([
    ['third-step', '1.75', /counts twice/],
    ['third-step', '1.76', /counts twice/],
    ['gate-ratio', '5.8', /left out the half/],
    ['wheel-sigma', '0.108', /own noise out/],
    ['wheel-sigma', '0.107', /own noise out/],
  ])) {
    const { it, key } = questions.find((question) => question.id === id)
    const { right, near } = /** @type {any} */ (judge(key, slip))
    assert.ok(!right && near >= 0, `${id}: ${slip}`)
    assert.match(words(all('.quiz-reasons > li .quiz-reason', it)[near]), tells, `${id}: ${slip}`)
  }
})

test('every exercise is checked, and every right answer is taken', () => {
  const exercises = onPages('.exercise')
  assert.ok(exercises.length >= 15)
  for (const exercise of exercises) assert.ok(exercise.querySelector('.quiz'), `${exercise.id} is checked`)
  for (const { id, kind, key } of questions) {
    if (kind === 'choice') assert.ok(Number.isInteger(key.right), id)
    else if (kind === 'state') assert.ok(key.conditions.length > 0, id)
    else {
      const told = (values) => /** @type {any} */ (judge(key, values.join(' ')))
      const verdict = { right: true, near: -1, nearly: false, close: false }
      assert.deepEqual(told(key.values), verdict, id)
      // A mistake worth recognising is no right answer, and is recognised as itself.
      for (const [near, values] of key.near.entries())
        assert.deepEqual(told(values), { ...verdict, right: false, near }, `${id}, ${values}`)
      // Two digits of either are as good as all of them.
      for (const digits of [2, 3, 4]) {
        const rounded = (values) => values.map((value) => value.toPrecision(digits))
        if (
          !key.bounds &&
          !key.near.some((values) => judge({ ...key, values, near: [] }, rounded(key.values).join(' '))?.right)
        )
          assert.ok(told(rounded(key.values)).right, `${id}, ${rounded(key.values)}`)
        for (const values of key.near) assert.ok(!told(rounded(values)).right, `${id}, ${rounded(values)}`)
      }
    }
  }
})

test('nothing in the options tells the right one', () => {
  for (const { it, id } of questions) {
    const options = all('.quiz-choice', it)
    assert.equal(
      new Set(options.map((option) => option.getAttributeNames().join())).size,
      Math.min(1, options.length),
      id,
    )
    assert.equal(
      all('.quiz-choice :is([data-number], .number, a), [data-right], [data-value], [data-tolerance]', it).length,
      0,
      id,
    )
    assert.doesNotMatch(it.dataset.key, /right|value|least/, id)
  }
})

test('the gap that ends with half a metre is had by the figure’s own controls, and is judged right', async () => {
  const { key } = questions.find(({ id }) => id === 'late-gap-state')
  const spec = await widget('late-readings')
  let params = {}
  const frame = () => {
    const lab = estimate[spec.lab].from({ version: 1, lab: 'late-readings', step: 0, params })
    const now = lab.frame()
    lab.free()
    return now
  }
  const set = (name, value) => {
    /** @type {any} */
    const control = spec.controls.find((one) => one.name === name)
    params = { ...params, ...(control.set?.(value, frame().params) ?? { [name]: value }) }
    return control
  }
  assert.deepEqual(unmet(key, frame()), [0, 1], 'as it opens')
  assert.ok(set('way', 'go-back').options.some(({ value }) => value === 'go-back'))
  assert.deepEqual(unmet(key, frame()), [1], 'without a gap')
  assert.equal(set('gap', true).get(frame().params), true)
  assert.deepEqual(unmet(key, frame()), [1], 'the gap is too long')
  // Its end is brought nearer, a key at a time.
  const limits = Object.fromEntries(estimate[spec.lab].parameters().map((one) => [one.name, one]))
  const scale = Object.assign((value) => value, { invert: (pixel) => pixel })
  /** @type {any} */
  const plane = { x: scale, y: scale, box: { left: 0, top: 0, right: 20, bottom: 20 } }
  const rows = { measured: 80, came: 44, height: 400 }
  let presses = 0
  while (unmet(key, frame()).length > 0 && presses++ < 100)
    params = { ...params, ...handlesOf(frame(), limits, plane, rows)['gap-to'].nudge(-1, 0) }
  assert.deepEqual(unmet(key, frame()), [], JSON.stringify(params))
  assert.ok(presses > 0 && frame().gap.to > frame().gap.from)
  set('gap', false)
  assert.deepEqual(unmet(key, frame()), [1], 'the gap is closed')
})
