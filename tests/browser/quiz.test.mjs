// Predict first: no explanation before an answer, a reason for each answer, and a tolerance for numbers.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { comeTo, open } from './fixture.mjs'
import { kept, keyOf, quiz, shown } from './quiz.mjs'

test('a choice is committed to before anything is explained, and a wrong one says why', async (t) => {
  const page = await open(t)
  // The script comes with the first question, and a figure that is in sight then keeps its height.
  await comeTo(page, '#quiz-third-step', 'form#quiz-third-step input')
  await page.locator('#fig-picture .figure-locked').waitFor({ state: 'attached' })
  const it = await quiz(page, 'which-foot')
  assert.ok(!(await shown(it)))
  assert.ok(!(await it.form.locator('.quiz-why').isVisible()))
  await it.commit.click()
  await it.verdict.filter({ hasText: 'Choose an answer first.' }).waitFor()
  assert.ok(!(await shown(it)), 'nothing chosen, nothing explained')
  assert.deepEqual(await kept(page), {})

  // The figure that would give it away waits too.
  const picture = page.locator('#fig-picture .widget')
  assert.ok(await picture.evaluate((widget) => widget.inert))
  const veil = page.locator('#fig-picture .figure-locked')
  assert.match(await veil.innerText(), /First answer “Which foot\?”, then try it here/)
  assert.equal(await veil.getByRole('link', { name: 'Which foot?' }).getAttribute('href'), '#quiz-which-foot')
  const [over, under] = [await veil.boundingBox(), await picture.boundingBox()]
  for (const side of ['x', 'y', 'width', 'height'])
    assert.ok(Math.abs(over[side] - under[side]) < 1, `the veil lies on the figure and no more: ${side}`)

  await it.form.getByRole('radio', { name: /Straight down/ }).check()
  assert.ok(!(await shown(it)), 'chosen is not committed')
  await it.commit.click()
  await it.verdict.filter({ hasText: 'Not this time' }).waitFor()
  assert.ok(await shown(it))
  assert.equal(await it.form.getAttribute('data-answered'), 'wrong')
  const mine = it.form.locator('.is-yours')
  assert.equal(await mine.count(), 1)
  assert.ok(await mine.isVisible())
  assert.match(await mine.innerText(), /Straight down.*nearest point for a ruler/s)
  assert.ok(!(await picture.evaluate((widget) => widget.inert)), 'the figure is free')
  assert.ok((await picture.boundingBox()).height > 500, 'all of it is there')
  const others = it.form.locator('.quiz-others')
  assert.ok(!(await others.evaluate((block) => block.open)))
  assert.match(
    await others.locator('summary').evaluate((summary) => getComputedStyle(summary, '::before').content),
    /\u25b8/,
    'what opens has the mark of what opens',
  )
  assert.ok(await it.form.getByRole('radio').first().isDisabled(), 'an answer given stands')
  assert.ok(!(await it.commit.isVisible()))
  assert.ok(
    await it.form.evaluate(
      (form) =>
        form.querySelector('.quiz-answer').getBoundingClientRect().bottom <=
        form.querySelector('[data-quiz-reset]').getBoundingClientRect().top,
    ),
    'another try comes behind the reasons',
  )
  assert.ok(
    await it.verdict.evaluate((verdict) => document.activeElement === verdict),
    'the focus is at what was said, not lost with the button',
  )
})

test('whatever is chosen, its own reason comes first', async (t) => {
  const page = await open(t)
  const forms = await page
    .locator('.quiz[data-kind=choice]')
    .evaluateAll((all) =>
      all.map((form) => ({ id: form.dataset.quiz, choices: form.querySelectorAll('.quiz-choice').length })),
    )
  assert.ok(forms.length >= 1)
  for (const { id, choices } of forms) {
    const it = await quiz(page, id)
    const reasons = new Set()
    let right = 0
    for (let i = 0; i < choices; i++) {
      await it.form.locator('input').nth(i).check()
      await it.commit.click()
      const answered = await it.form.getAttribute('data-answered')
      if (answered === 'right') right++
      assert.equal(await it.verdict.innerText(), answered === 'right' ? 'Right.' : 'Not this time. Here is why.')
      const reason = await it.form.locator('.is-yours .quiz-reason').innerText()
      assert.ok(
        await it.form
          .locator('details.quiz-answer > .details-body > .quiz-reasons > li')
          .evaluateAll((all) => all.length === 1 && all[0].classList.contains('is-yours')),
        'the own reason first',
      )
      assert.ok(!(await it.form.locator('.quiz-others').evaluate((block) => block.open)), 'the others are folded')
      const marks = await it.form
        .locator('.quiz-choice')
        .evaluateAll((all) => all.map((label) => label.querySelector('.quiz-mark').getAttribute('aria-label')))
      assert.equal(marks.filter((mark) => mark === 'right').length, 1)
      assert.equal(marks[i], answered)
      assert.ok(reason.length > 30, `${id}, choice ${i}`)
      reasons.add(reason)
      await it.again.click()
    }
    assert.equal(right, 1, id)
    assert.equal(reasons.size, choices, id)
  }
})

test('a number is right within its tolerance, in the ways people write numbers', async (t) => {
  const page = await open(t)
  const it = await quiz(page, 'third-step')
  const {
    values: [value],
    tolerance,
    near: [[mistaken]],
  } = await keyOf(it.form)
  assert.ok(value > 0 && tolerance > 0)
  const judged = async (text) => {
    await it.input.fill(text)
    await it.input.press('Enter')
    const answered = await it.form.getAttribute('data-answered')
    const said = await it.verdict.innerText()
    if (answered) await it.again.click()
    return [answered, said]
  }
  const [RIGHT, WRONG, AGAIN, CLOSE, NEARLY, NONE] = [
    ['right', 'Right.'],
    ['wrong', 'Not this time. Here is the answer.'],
    [null, 'Not yet: try once more.'],
    [null, 'Close, but that is not it: try once more.'],
    [null, 'Nearly: give it with a digit more.'],
    [null, 'That is not a number.'],
  ]
  for (const text of [
    String(value),
    String(value + 0.9 * tolerance),
    String(value - 0.9 * tolerance),
    String(value).replace('.', ','),
    `${value * 8}/8`,
    ` ${value.toFixed(4)} `,
    value.toExponential(),
  ]) {
    assert.deepEqual(await judged(text), RIGHT, text)
  }
  // Any wrong number may be mended once; the second one ends the question.
  for (const [text, said] of [
    [String(-value), AGAIN],
    [`−${value}`, AGAIN],
    ['0', AGAIN],
    [String(value + 1.1 * tolerance), CLOSE],
  ]) {
    assert.deepEqual(await judged(text), said, String(text))
    assert.ok(!(await shown(it)))
    assert.deepEqual(await judged(String(value - 1.1 * tolerance)), WRONG, 'the second try')
  }
  // What is right in too few digits to tell is asked for more, once, and that is no wrong number.
  assert.deepEqual(await judged(value.toPrecision(1)), NEARLY)
  assert.deepEqual(await judged('0'), AGAIN)
  assert.deepEqual(await judged(value.toPrecision(1)), WRONG)
  // What is no number costs nothing, before the first wrong one and after it.
  const tries = () => page.evaluate(() => Object.entries(localStorage).filter(([key]) => /^(quiz|tries):/.test(key)))
  for (const wrong of [AGAIN, WRONG]) {
    const before = await tries()
    for (const text of ['much', '1/0', '1..2', '1/2/3', 'NaN', 'Infinity', '0x10', '<b>1</b>'])
      assert.deepEqual(await judged(text), NONE, text)
    assert.deepEqual(await judged('  '), [null, 'Type a number first.'])
    assert.deepEqual(await tries(), before)
    assert.deepEqual(await judged('0'), wrong)
  }

  // A wrong answer worth recognising is recognised.
  const near = it.form.locator('[data-choice="0"]')
  await it.input.fill(String(mistaken))
  await it.commit.click()
  // Its reader may mend it once; the answer is not shown yet.
  assert.match(await it.verdict.innerText(), /^Not yet: try once more\..*predicted variance/s)
  assert.equal(await it.form.getAttribute('data-answered'), null)
  assert.ok(!(await shown(it)))
  assert.deepEqual(await judged(String(value)), RIGHT, 'the second try')
  await it.input.fill(String(mistaken))
  await it.commit.click()
  await it.input.fill(String(mistaken))
  await it.commit.click()
  assert.ok(await near.evaluate((item) => item.classList.contains('is-yours')))
  assert.match(await it.form.locator('.is-yours').innerText(), /predicted variance/)
  assert.ok(await it.form.locator('.is-yours').isVisible())
})

test('a number of thousands of digits is no answer, and stops nothing', async (t) => {
  const page = await open(t)
  const it = await quiz(page, 'third-step')
  await it.input.pressSequentially('7'.repeat(60))
  assert.equal((await it.input.inputValue()).length, 40, 'the field takes no more')
  // A script or an old field may hold more; trying every way to split 60,000 digits took nine seconds.
  await it.input.evaluate((input) => {
    input.removeAttribute('maxlength')
    input.value = `${'7'.repeat(60_000)}x`
  })
  await it.commit.click()
  await it.verdict.filter({ hasText: 'That is not a number.' }).waitFor()
})

test('Tab leads into a question that is still far below the screen', async (t) => {
  const page = await open(t)
  const id = await page.evaluate(() => {
    const form = [...document.querySelectorAll('.quiz')].find(
      (it) => it.getBoundingClientRect().top > 3 * innerHeight && !it.querySelector('input'),
    )
    const links = [...document.querySelectorAll('main a[href], main summary')].filter(
      (link) =>
        link.compareDocumentPosition(form) & Node.DOCUMENT_POSITION_FOLLOWING &&
        !link.closest('details:not([open]) > :not(summary), .end-matter'),
    )
    links.at(-1).focus({ preventScroll: true })
    return form.id
  })
  await page.locator(`#${id} input`).first().waitFor({ state: 'attached' })
  await page.keyboard.press('Tab')
  assert.ok(await page.evaluate((name) => document.activeElement?.closest('form')?.id === name, id))
})

test('a reader who skips is shown the answer and the figure, and may still try', async (t) => {
  const page = await open(t)
  const it = await quiz(page, 'which-foot')
  await it.form.getByRole('button', { name: 'Skip, show me' }).press('Enter')
  await it.verdict.filter({ hasText: 'Here is the answer.' }).waitFor()
  assert.ok(!(await shown(it)), 'the reasons stay folded: the figure is the answer')
  assert.equal(await it.form.getAttribute('data-answered'), 'shown')
  const picture = page.locator('#fig-picture .widget')
  assert.ok(!(await picture.evaluate((widget) => widget.inert)))
  const way = it.form.locator('.quiz-way a')
  assert.equal(await way.getAttribute('href'), '#fig-picture')
  await page.reload()
  await quiz(page, 'which-foot')
  await page.locator('#quiz-which-foot[data-answered="shown"]').waitFor()
  await it.again.click()
  assert.ok(await picture.evaluate((widget) => widget.inert))
  // The veil skips too.
  await page.locator('#fig-picture .figure-locked').getByRole('button', { name: 'Skip, show me' }).click()
  await page.locator('#quiz-which-foot[data-answered="shown"]').waitFor()
  assert.ok(!(await picture.evaluate((widget) => widget.inert)))
})

test('no figure waits without scripts, nor on paper', async (t) => {
  const silent = await open(t, { scripts: false })
  assert.equal(await silent.locator('.widget[inert], .figure-locked').count(), 0)
  assert.equal(await silent.locator('.quiz-actions:visible').count(), 0)
  const page = await open(t)
  await comeTo(page, '#fig-picture', '#fig-picture .widget[inert]')
  await page.emulateMedia({ media: 'print' })
  assert.equal(await page.locator('.figure-locked:visible').count(), 0)
  assert.equal(await page.locator('#fig-picture .still').evaluate((still) => getComputedStyle(still).filter), 'none')
})
