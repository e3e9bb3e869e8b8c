// A figure shows a computation, never a recording: each is put into random states with its own controls (the Probe's
// landmarks at random places, a random seed), and its frame, to the last bit, and every readout on the page are
// compared with what a native run of the same state computes. Two runs of one commit visit the same states;
// PROBE_SEED=7 looks elsewhere, and PROBE_ROUNDS=20 at more of them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { frameOf, openFigure, root, settled, stateOf } from './harness.mjs'
import { held, plain } from '../../web/draw/words.js'
import { WIDGETS } from '../../web/widgets/index.js'
import { dice as seeded } from '../node/nonsense.mjs'

const SEED = Number(process.env.PROBE_SEED ?? 1)
/** How many states of a figure are compared: the Probe has the most handles, and a log takes the longest. */
const rounds = (name) => Number(process.env.PROBE_ROUNDS ?? { 'observability-probe': 6, 'robot-log': 2 }[name] ?? 3)

/** The frame that this machine's own code computes for a state, given as a copied link carries it. */
function native(link, id) {
  const text = Buffer.from(new URL(link).searchParams.get(id), 'base64url').toString()
  const frame = execFileSync('cargo', ['run', '--quiet', '--locked', '-p', 'labs', '--example', 'lab_frame'], {
    cwd: root,
    input: text,
    maxBuffer: 2 ** 26,
  })
  return { text, frame: JSON.parse(String(frame)) }
}

// Before any test, since cargo may have to compile it: no test's time is spent on that.
execFileSync('cargo', ['build', '--quiet', '--locked', '-p', 'labs', '--example', 'lab_frame'], { cwd: root })

/** JSON knows neither NaN nor infinity. */
function finite(value) {
  if (typeof value === 'number') return Number.isFinite(value) ? value : null
  if (Array.isArray(value)) return value.map(finite)
  if (value === null || typeof value !== 'object') return value
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, finite(inner)]))
}

/**
 * Moves everything a reader can move to a random place. What one move takes away, or brings, the next ones leave out,
 * or move.
 */
async function shuffle(page, element, dice) {
  const live = element.locator('.live')
  await live.evaluate((part) => {
    for (const fold of part.querySelectorAll('.controls details')) fold.open = true
  })
  for (const select of await live.locator('select').all()) {
    if ((await select.locator('xpath=ancestor::label').innerText()).startsWith('Speed') || (await select.isDisabled()))
      continue
    const open = await select
      .locator('option')
      .evaluateAll((all) => all.flatMap((option, i) => (option.disabled ? [] : [i])))
    await select.selectOption({ index: open[dice.below(open.length)] })
    await settled(element)
  }
  for (const box of await live.locator('input[type=checkbox]').all()) {
    const on = dice.uniform() < 0.5
    if (await box.isEnabled()) await box.setChecked(on)
    await settled(element)
  }
  for (const slider of await live.locator('input[type=range]:enabled').all()) {
    await slider.evaluate((input, share) => {
      input.value = String(Number(input.min) + share * (Number(input.max) - Number(input.min)))
      input.dispatchEvent(new Event('input', { bubbles: true }))
    }, dice.uniform())
  }
  const handles = live.locator('svg [role=slider]').locator('visible=true')
  for (let i = 0; i < (await handles.count()); i++) {
    const handle = handles.nth(i)
    await handle.scrollIntoViewIfNeeded()
    const grip = await handle.locator('.handle-dot').boundingBox()
    const panel = await handle.evaluate((it) => {
      const { left, top, width, height } = it.ownerSVGElement.getBoundingClientRect()
      return { left, top, width, height }
    })
    const middle = [grip.x + grip.width / 2, grip.y + grip.height / 2]
    const goal = [panel.left + dice.uniform() * panel.width, panel.top + dice.uniform() * panel.height]
    await page.mouse.move(...middle)
    await page.mouse.down()
    await page.mouse.move(...goal, { steps: 3 })
    await page.mouse.up()
    await settled(element)
  }
  const seed = live.getByRole('spinbutton', { name: 'Seed' })
  if (await seed.count()) {
    await seed.fill(String(dice.below(2 ** 32)))
    await seed.press('Tab')
  }
  const step = live.getByRole('button', { name: 'Step', exact: true })
  if (await step.count()) for (let presses = dice.below(12); presses > 0; presses--) await step.click()
  await settled(element)
}

for (const [tag, load] of Object.entries(WIDGETS)) {
  test(`${tag}: every readout is what a native run of the same state says`, async (t) => {
    const spec = await load()
    const { page, it: element } = await openFigure(t, tag)
    const start = await stateOf(element)
    const id = await element.evaluate((it) => it.figure.id)
    const dice = seeded(SEED)
    const most = rounds(tag)
    assert.ok(most >= 1, `${most} rounds compare nothing`)
    for (let round = 1; round <= most; round++) {
      await shuffle(page, element, dice)
      // What was said of the link of the round before may still stand there.
      await page.evaluate(() => navigator.clipboard.writeText(''))
      await element.getByRole('button', { name: 'Copy link to this state' }).click()
      await page.waitForFunction(async () => (await navigator.clipboard.readText()) !== '')
      const link = await page.evaluate(() => navigator.clipboard.readText())
      const run = native(link, id)
      const where = `PROBE_SEED=${SEED}, round ${round}, ${run.text}`

      assert.notDeepEqual(await stateOf(element), start, where)
      // What a reader looks at is the page's own, and no part of a run.
      const { looks, log, known, ...ran } = finite(await frameOf(element))
      assert.deepEqual(ran, run.frame, where)
      const shown = await element.locator('.live').evaluate((live) => ({
        readouts: [...live.querySelectorAll('.readout')].map((box) => [
          (box.querySelector('dt .in-choset') ?? box.querySelector('dt')).textContent,
          box.querySelector('dd').textContent,
        ]),
        verdict: [...live.querySelector('.verdict').childNodes]
          .map((part) => (/in-(?!choset)/.test(part.className) ? '' : part.textContent))
          .join(''),
        panels: Object.fromEntries(
          [...live.querySelectorAll('.panel')].map((svg) => [
            /panel-(\S+)/.exec(svg.getAttribute('class'))[1],
            svg.getAttribute('aria-label'),
          ]),
        ),
      }))
      const said = spec
        .readouts(run.frame)
        .map(({ label, value, unit }) => [
          plain(label),
          unit && value !== '–' ? `${value}${unit === '°' ? '' : ' '}${unit}` : value,
        ])
      assert.ok(said.length >= 3, `${tag} has readouts`)
      assert.deepEqual(shown.readouts, said, where)
      assert.equal(shown.verdict, held(plain(/** @type {any} */ (spec).verdict(run.frame))), where)
      assert.deepEqual(shown.panels, spec.describe(run.frame), where)
    }
  })
}

test("the comparison sees a difference in the last bit, in a zero's sign and in a missing number", () => {
  const frame = {
    P: [
      [0.1, 0],
      [0, NaN],
    ],
  }
  assert.deepEqual(finite(frame), {
    P: [
      [0.1, 0],
      [0, null],
    ],
  })
  for (const other of [
    {
      P: [
        [0.1 + 2 ** -56, 0],
        [0, null],
      ],
    },
    {
      P: [
        [0.1, -0],
        [0, null],
      ],
    },
    { P: [[0.1, 0], [0]] },
  ]) {
    assert.notDeepEqual(finite(frame), other)
  }
})
