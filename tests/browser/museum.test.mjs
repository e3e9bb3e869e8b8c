// The museum of bugs in the page: what the lot hides is named nowhere, three names in a row unlock pairs, and a count
// over seeds shows how far it has come and can be stopped.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { frameOf, openFigure, until } from './harness.mjs'
import { BUGS } from '../../web/widgets/bug-museum/words.js'

/** What the lot has drawn, asked of a lab beside the figure's. */
const drawn = (it) =>
  it.evaluate((host) => {
    const { lab } = host.figure
    const beside = lab.constructor.from({
      ...lab.state(),
      step: 0,
      params: { ...lab.state().params, committed: true, many: false },
    })
    const { answer } = beside.frame()
    beside.free()
    return answer
  })

test('three hidden bugs named in a row unlock two at once, and nothing on the page names a hidden one', async (t) => {
  const { it } = await openFigure(t, 'bug-museum')
  const press = (name) => it.getByRole('button', { name }).click()
  const two = it.getByRole('button', { name: /^Hide two/ })
  const [seeds, bugs] = [new Set(), new Set()]
  // The first card of a deck: the next twelve are other bugs.
  await it.evaluate((host) => host.figure.change({ lot: 13 * 7 }))
  for (let round = 1; round <= 3; round += 1) {
    assert.ok(await two.isDisabled(), `round ${round}`)
    await press('Hide a bug')
    await until(
      it,
      ({ params, driven, steps }) => params.lot !== 0 && !params.committed && driven === steps,
      'a bug is hidden',
    )
    const { bug } = await drawn(it)
    const {
      params: { seed },
    } = await frameOf(it)
    assert.ok(!seeds.has(seed) && !bugs.has(bug), `another run and another bug than before: ${seed}, ${bug}`)
    seeds.add(seed)
    bugs.add(bug)
    const shown = await it.locator('.live').evaluate((live) =>
      [...live.querySelectorAll('select')]
        .map(({ selectedOptions: [{ textContent }] }) => textContent)
        .concat(
          [...live.querySelectorAll('.verdict, .readout, svg text')].map(({ textContent }) => textContent),
          [...live.querySelectorAll('[aria-label]')].map((part) => part.getAttribute('aria-label')),
        )
        .join('\n'),
    )
    assert.ok(!shown.includes(BUGS[bug].name), shown)
    await it.getByRole('combobox', { name: 'It is' }).selectOption({ label: BUGS[bug].name })
    await until(it, ({ params }) => params.guess === bug, 'a name is chosen')
    await press('Name it')
    const { answer, params } = await until(it, (frame) => frame.answer !== null, 'the answer')
    assert.deepEqual([answer.right, answer.bug, params.named], [true, bug, round])
    assert.match(await it.locator('.live .verdict').innerText(), /^Right: it was “/)
  }
  await two.click()
  await until(it, ({ params }) => params.pair && !params.committed, 'two are hidden')
  assert.match(await it.locator('.live .verdict').innerText(), /^Two bugs are hidden/)
  // Whoever gives up begins anew.
  await press('Hide a bug')
  await until(it, ({ params }) => !params.pair && params.named === 0, 'the count is 0')
})

test('a count over seeds can be stopped on its way, and says what it has', async (t) => {
  const { it, page } = await openFigure(t, 'bug-museum')
  await it.getByRole('checkbox', { name: 'count over seeds' }).check()
  const { seeds, figures } = await until(it, (frame) => frame.seeds === 500, 'all seeds')
  assert.ok(
    figures.every(({ beyond: [below, above] }) => below + above <= 1) && figures[7].beyond[1] > 0.9,
    `refused readings give the bug away, of ${seeds}`,
  )
  assert.ok(
    figures.every(({ counts, runs }) => runs.length === 500 && counts.reduce((sum, count) => sum + count) === 500),
    'each run is in a bar',
  )
  assert.equal(await it.locator('.live path.bars').count(), figures.length)
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    it.getByRole('button', { name: 'Download CSV' }).click(),
  ])
  const [names, first] = (await readFile(await download.path(), 'utf8'))
    .split('\n')
    .filter((line) => !line.startsWith('#'))
    .map((line) => line.trim().split(','))
  assert.equal(Number(first[names.indexOf('run_nees')]), figures[3].runs[0])
  // Another bug: the count begins anew, and is stopped.
  const stopped = await it.evaluate(async (host) => {
    host.figure.change({ bug: 'late' })
    for (let i = 0; i < 200 && !host.figure.run.progress; i += 1)
      await new Promise((resolve) => requestAnimationFrame(resolve))
    const { progress } = host.figure.run
    host.figure.run.cancel()
    host.figure.ask()
    return progress
  })
  assert.ok(stopped.step < 500 && stopped.of === 500, JSON.stringify(stopped))
  await until(
    it,
    ({ params, seeds: now }) => params.bug === 'unwrapped-innovation' && now === 500,
    'the count before stays',
  )
})

test('the figures of a run stand beside the switch that changes them', async (t) => {
  for (const viewport of [
    { width: 1280, height: 900 },
    { width: 900, height: 1100 },
    { width: 390, height: 844 },
  ]) {
    const { it } = await openFigure(t, 'bug-museum', { viewport })
    const [figures, bug] = [
      await it.locator('.live .panel-figures').boundingBox(),
      await it.getByRole('combobox', { name: 'Bug' }).boundingBox(),
    ]
    const reach = bug.y + bug.height - figures.y
    assert.ok(reach < viewport.height - 60, `at ${viewport.width} px the two take ${reach} px of ${viewport.height}`)
  }
})

test('what names a hidden bug is there while there is one, in the place of the switches', async (t) => {
  const { it } = await openFigure(t, 'bug-museum')
  const [bug, guess, back] = [
    it.getByRole('combobox', { name: 'Bug' }),
    it.getByRole('combobox', { name: 'It is' }),
    it.getByRole('button', { name: 'Back to the switches' }),
  ]
  const kept = ['Another run', 'Hide a bug', 'Hide two'].map((name) => it.getByRole('button', { name }))
  const places = () => Promise.all(kept.map(async (button) => JSON.stringify(await button.boundingBox())))
  const before = await places()
  assert.deepEqual([await bug.count(), await guess.count(), await back.count()], [1, 0, 0])
  await it.getByRole('button', { name: 'Hide a bug' }).click()
  await guess.waitFor()
  assert.deepEqual(
    [await bug.count(), await it.getByRole('combobox', { name: 'and' }).isDisabled()],
    [0, true],
    'one bug has one name',
  )
  assert.deepEqual(await places(), before, 'no other button comes under the pointer')
  await back.press('Enter')
  await bug.waitFor()
  assert.ok(
    await bug.evaluate((select) => select === document.activeElement),
    'the button that had the focus is gone, and the first switch has it',
  )
})
