// Exercises: each has an answer that the page checks, a vector counts up to sign and length where it should, the page
// recognises a figure's state, and what the reader has answered stands at the chapter's end and in a file.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { codeOf, comeTo, EXERCISES, figure, open, root } from './harness.mjs'

const keyOf = (form) =>
  form.evaluate(({ dataset }) =>
    JSON.parse(new TextDecoder().decode(Uint8Array.from(dataset.key.match(/../g), (byte) => parseInt(byte, 16)))),
  )

/** A question on the screen, with the controls that it gets there. */
const check = async (page, id) => {
  const form = page.locator(`#quiz-${id}`)
  await comeTo(page, `#quiz-${id}`, `form#quiz-${id}`)
  return {
    form,
    verdict: form.locator('.quiz-verdict'),
    again: form.getByRole('button', { name: 'Try again' }),
    commit: form.locator('[type=submit]'),
    input: form.getByRole('textbox'),
  }
}
/** The chapter's end, filled. */
const end = async (page) => {
  const box = page.locator('[data-score]')
  await comeTo(page, '[data-score]', '[data-score] h2')
  return box
}
/** Answers a question rightly or wrongly. */
const answer = async (page, id, right) => {
  const it = await check(page, id)
  const key = await keyOf(it.form)
  if (key.values) await it.input.fill(key.values.map((value) => (right ? value : value + 7)).join(' '))
  else
    await it.form
      .locator('input')
      .nth(right ? key.right : key.right === 0 ? 1 : 0)
      .check()
  await it.commit.click()
  // A wrong number has a second try.
  if (key.values && !right) await it.commit.click()
  assert.equal(await it.form.getAttribute('data-answered'), right ? 'right' : 'wrong', id)
  return it
}

test('a vector is right up to sign and length, in the ways people write vectors', async (t) => {
  const page = await open(t, { at: EXERCISES })
  const it = await check(page, 'unseen-direction')
  const judged = async (text) => {
    await it.input.fill(text)
    await it.input.press('Enter')
    if ((await it.verdict.innerText()).startsWith('Not yet')) await it.input.press('Enter')
    const answered = await it.form.getAttribute('data-answered')
    const said = await it.verdict.innerText()
    if (answered) await it.again.click()
    return answered ?? said
  }
  for (const text of [
    '1, 2, -1',
    '[1 2 −1]',
    '(-0.5; -1; 0.5)',
    '-0,5; -1; 0,5',
    '1e3,2e3,-1e3',
    '1/2 1 -1/2',
    '1e300 2e300 -1e300',
    '0.4082, 0.8165, -0.4082',
  ])
    assert.equal(await judged(text), 'right', text)
  for (const text of ['1, 2, 1', '1 0 -1', '0, 0, 1', '1, 2, -1.1']) assert.equal(await judged(text), 'wrong', text)
  for (const text of ['1, 2', '1 2 -1 0', 'a b c', '0 0 0', '1, 2, NaN', ',,'])
    assert.equal(await judged(text), 'That is not 3 numbers, or all are zero.', text)
  assert.equal(await judged(' '), 'Type 3 numbers first.')
  // A wrong vector worth recognising is recognised, whatever its length.
  await it.input.fill('-2 0 2')
  await it.commit.click()
  await it.commit.click()
  assert.match(await it.form.locator('.is-yours').innerText(), /second row/)
  assert.match(await it.form.locator('.quiz-value').innerText(), /Right is.*\[1, 2, −1\].*up to sign and length/)
})

test('the page recognises the collinear trap in the figure, and names what is missing', async (t) => {
  const page = await open(t, { at: EXERCISES })
  const it = await check(page, 'collinear-state')
  await it.commit.click()
  await it.verdict.filter({ hasText: 'does not run yet' }).waitFor()
  await it.form.getByRole('button', { name: 'Look at the figure' }).press('Enter')
  const probe = await figure(page, 'observability-probe')
  const watch = page.locator('#fig-probe .quiz-watch')
  await watch.filter({ hasText: 'tells you when' }).waitFor()
  const inView = () =>
    watch.evaluate((bar) => {
      const { top, bottom } = bar.getBoundingClientRect()
      return top >= 0 && bottom <= innerHeight && bar.querySelector('a').offsetHeight >= 24
    })
  assert.ok(await inView(), 'the way back is on the screen')
  await probe.locator('.live .figure-tools').scrollIntoViewIfNeeded()
  assert.ok(await inView(), 'below the figure too')
  // So is the browser's own way back.
  const inSight = (id) =>
    page.waitForFunction((name) => {
      const { top, bottom } = document.getElementById(name).getBoundingClientRect()
      return top < innerHeight && bottom > 0
    }, id)
  await page.goBack()
  await inSight('quiz-collinear-state')
  await page.goForward()
  await watch.getByRole('link', { name: 'Back to the exercise' }).click()
  await it.commit.click()
  await it.verdict.filter({ hasText: 'Show two landmarks.' }).waitFor()
  assert.equal(await it.form.getAttribute('data-answered'), null)
  await probe.scrollIntoViewIfNeeded()
  await probe.evaluate((host) => host.figure.change({ count: 2, sensor: 'range' }))
  await page.waitForFunction(() => {
    const host = document.querySelector('#fig-probe .widget')
    return host.settled && host.frame.params.count === 2
  })
  assert.equal(await it.form.getAttribute('data-answered'), null, 'two landmarks alone are no trap')
  await probe.getByRole('button', { name: 'Put the last landmark in line' }).click()
  await watch.filter({ hasText: 'This is the state' }).waitFor()
  assert.equal(await it.form.getAttribute('data-answered'), 'right')
  await page.reload()
  await check(page, 'collinear-state')
  await page.locator('#quiz-collinear-state[data-answered="right"]').waitFor()
  assert.ok(!(await page.locator('#quiz-collinear-state .quiz-todo').isVisible()), 'nothing is missing any more')
})

test('the page recognises the fastest knob, reached by keys', async (t) => {
  const page = await open(t, { at: EXERCISES })
  const it = await check(page, 'fastest-state')
  const { conditions } = await keyOf(it.form)
  const { most } = conditions.find(({ path }) => path === 'spectralRadius')
  const bench = await figure(page, 'observer-bench')
  await bench.evaluate((host) => host.figure.change({ sensor: 'position', mode: 'fixed', gain: 1 }))
  await page.waitForFunction(() => {
    const host = document.querySelector('#fig-bench .widget')
    return host.settled && host.frame.params.sensor === 'position'
  })
  await it.form.scrollIntoViewIfNeeded()
  await it.commit.click()
  assert.deepEqual(await it.form.locator('.quiz-missing li').allInnerTexts(), [
    'Turn the knob to where the two eigenvalues meet.',
  ])
  await figure(page, 'observer-bench')
  const slider = bench.getByRole('slider', { name: /gain/i })
  await slider.focus()
  for (let i = 0; i < 7; i++) await page.keyboard.press('ArrowRight')
  assert.equal(await slider.inputValue(), '1.07')
  await page.waitForFunction((wanted) => {
    const host = document.querySelector('#fig-bench .widget')
    return host.settled && host.frame.spectralRadius <= wanted
  }, most)
  await it.form.scrollIntoViewIfNeeded()
  await it.commit.focus()
  await page.keyboard.press('Enter')
  await it.verdict.filter({ hasText: 'Right.' }).waitFor()
})

test('the chapter ends with what is answered, gives it out as a file, and forgets it', async (t) => {
  const page = await open(t)
  const box = await end(page)
  const words = box.locator('.score-words')
  const count = await page.locator('.exercise-elsewhere').count()
  assert.match(
    await words.innerText(),
    new RegExp(
      String.raw`Predictions: 0 of \d+ answered, 0 right at once, 0 right after more tries\.\s+` +
        `Exercises: 0 of ${count} answered`,
    ),
  )
  const all = await box.locator('.score-open a').count()
  await answer(page, 'loop-shrinks', true)
  const chapter = page.url()
  await page.goto(`${chapter}exercises/`)
  const lamp = await answer(page, 'lamp-row', false)
  await lamp.again.click()
  await answer(page, 'lamp-row', true)
  await answer(page, 'founded', false)
  await answer(page, 'unseen-rank', true)
  await (await check(page, 'constant')).form.getByRole('button', { name: 'Skip, show me' }).click()

  // On their own page the exercises' progress stands too, and leads to the rest.
  const part = await end(page)
  assert.match(await part.locator('.score-words').innerText(), /^Exercises: 2 of \d+ answered/)
  await part.getByRole('link', { name: /All your answers/ }).click()
  await page.waitForURL((url) => !url.pathname.endsWith('/exercises/'))
  await end(page)
  assert.equal(await page.locator('#ex-lamp').getAttribute('data-all-answered'), '')
  assert.equal(await page.locator('#ex-unseen').getAttribute('data-all-answered'), null)
  assert.match(
    await words.innerText(),
    new RegExp(
      String.raw`Predictions: 1 of \d+ answered, 1 right at once, 0 right after more tries\.\s+` +
        String.raw`Exercises: 2 of ${count} answered, 0 right at once, 1 right after more tries\.`,
    ),
  )
  const left = await box.locator('.score-open a').evaluateAll((links) => links.map((link) => link.getAttribute('href')))
  assert.equal(left.length, all - 3)
  assert.ok(
    left.includes('../kalman/exercises/#ex-unseen') &&
      left.includes('../kalman/exercises/#ex-constant') &&
      !left.includes('../kalman/exercises/#ex-lamp') &&
      !left.includes('#quiz-loop-shrinks'),
  )
  const here = left.filter((address) => address.startsWith('#'))
  assert.ok(await page.evaluate((addresses) => addresses.every((address) => document.querySelector(address)), here))

  const waits = page.waitForEvent('download')
  await box.getByRole('button', { name: 'Save my answers as a file' }).click()
  const file = await waits
  assert.equal(file.suggestedFilename(), 'kalman-answers.json')
  const saved = JSON.parse(readFileSync(await file.path(), 'utf8'))
  assert.equal(saved.chapter.slug, 'kalman')
  assert.ok(!Number.isNaN(Date.parse(saved.date)))
  const of = (id) => {
    const { grade, answered, right, tries, shown } = saved.exercises.find((it) => it.id === id)
    return { grade, answered, right, tries, shown }
  }
  assert.deepEqual(of('ex-lamp'), { grade: 2, answered: true, right: true, tries: 3, shown: false })
  assert.deepEqual(of('ex-found'), { grade: 1, answered: true, right: false, tries: 2, shown: false })
  assert.deepEqual(of('ex-constant'), { grade: 1, answered: false, right: false, tries: 0, shown: true })
  assert.deepEqual(of('ex-unseen'), { grade: 2, answered: false, right: false, tries: 1, shown: false })
  // A teacher reads on the page for teachers what the file holds.
  const told = readFileSync(path.join(root, 'content/pages/teaching.md'), 'utf8')
  const fields = [saved, saved.chapter, saved.exercises[0], saved.exercises[0].checks[0], saved.predictions[0]].flatMap(
    Object.keys,
  )
  assert.deepEqual(
    fields.filter((field) => !told.includes(`\`${field}\``)),
    [],
  )

  await box.getByRole('button', { name: 'Forget my answers to the questions' }).click()
  await words.filter({ hasText: `Exercises: 0 of ${count} answered` }).waitFor()
  assert.deepEqual(await page.evaluate(() => Object.keys(localStorage).filter((key) => /^(quiz|tries):/.test(key))), [])
})

test('where the browser keeps nothing, answers last until the page is closed, and the page says so', async (t) => {
  const page = await open(t, {
    at: EXERCISES,
    prepare: (it) =>
      it.addInitScript(() => {
        const refuse = () => {
          throw new DOMException('refused', 'SecurityError')
        }
        Object.defineProperty(window, 'localStorage', { get: refuse })
      }),
  })
  await answer(page, 'lamp-row', true)
  const box = await end(page)
  const count = await page.locator('.exercise, .exercise-elsewhere').count()
  assert.ok((await box.innerText()).includes(`Exercises: 1 of ${count} answered, 1 right at once`))
  assert.match(await box.innerText(), /your answers last until you close the page/)
})

test('without scripts the chapter ends without an empty box', async (t) => {
  const page = await open(t, { scripts: false })
  assert.equal(await page.locator('[data-score]').evaluate((box) => box.getBoundingClientRect().height), 0)
})

test('an old address of an exercise, a question or an answer leads to its page, state and all', async (t) => {
  const page = await open(t, { at: 'kalman/#ex-ghost' })
  const there = async (id) => {
    await page.waitForURL((url) => url.pathname.endsWith('/kalman/exercises/') && url.hash === `#${id}`)
    await page.locator(`.exercise #${id}, .exercise#${id}`).waitFor()
  }
  await there('ex-ghost')
  const state = codeOf('observability-probe', 3)
  const chapter = page.url().replace(/exercises\/.*/, '')
  await page.goto(`${chapter}?fig-probe=${state}#quiz-ghost-state`)
  await there('quiz-ghost-state')
  assert.equal(new URL(page.url()).searchParams.get('fig-probe'), state)
  await page.goto(chapter)
  await page.evaluate(() => {
    location.hash = '#ex-gate'
  })
  await there('ex-gate')
})

test('an old address of a section that has a page of its own leads there, and without scripts by a link', async (t) => {
  const page = await open(t, { at: 'kalman/#thirteen-checks' })
  await page.waitForURL((url) => url.pathname.endsWith('/kalman/rust/') && url.hash === '#thirteen-checks')
  await page.locator('h2#thirteen-checks').waitFor()
  assert.equal(await page.locator('[data-score]').count(), 0, 'a page without questions has no place for a score')
  const plain = await open(t, { at: 'kalman/#rust-kf', scripts: false })
  const line = plain.locator('#rust-kf')
  assert.ok(await line.evaluate((it) => it.matches('li:target')))
  await line.getByRole('link').click()
  await plain.locator('h2#rust-kf').waitFor()
})

test('without scripts an old address of an exercise leads to its line in the list, and that to it', async (t) => {
  const page = await open(t, { at: 'kalman/#ex-ghost', scripts: false })
  const line = page.locator('#ex-ghost')
  assert.ok(await line.evaluate((it) => it.matches('li:target')))
  await line.getByRole('link').click()
  await page.locator('.exercise#ex-ghost').waitFor()
})
