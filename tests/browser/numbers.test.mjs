// A computed number says what computes it and which check watches over it, and is its entry's value.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { open, quiet } from './harness.mjs'
import { listening, popover, rest } from './popover.mjs'

/** The list of the chapter's numbers, by id. */
const entries = (page) =>
  page.evaluate(async () => {
    const list = new DOMParser().parseFromString(await (await fetch('numbers/')).text(), 'text/html')
    return Object.fromEntries(
      [...list.querySelectorAll('.number-entry')].map((entry) => [
        entry.id.replace('number-', ''),
        {
          value: entry.querySelector('.number-value')?.textContent,
          source: Boolean(entry.querySelector('.number-source')),
          check: Boolean(entry.querySelector('.number-check')),
        },
      ]),
    )
  })

test('a number whose list cannot be fetched says so, and is explained once the list is there', async (t) => {
  const page = await open(t, {
    expected: [/numbers\/|Failed to load|ERR_FAILED/],
    prepare: async (it) => {
      await it.clock.install()
      await it.route('**/kalman/numbers/', (route) => route.abort())
    },
  })
  await listening(page)
  const number = page.locator('main p a.number').first()
  await number.focus()
  await popover(page).getByText('could not be fetched').waitFor()
  // The page that scrolled to it moved under the mouse: what has the focus keeps its explanation.
  await number.locator('xpath=ancestor::p').hover({ position: { x: 1, y: 1 } })
  await page.clock.fastForward(1000)
  assert.ok(await popover(page).isVisible())
  await page.keyboard.press('Escape')
  await page.unroute('**/kalman/numbers/')
  await number.evaluate((it) => it.blur())
  await number.focus()
  await popover(page).locator('.number-source').waitFor()
})

test('a number shows what computes it and which check pins it, hovered, focused, and inside a formula', async (t) => {
  const page = await open(t)
  await listening(page)
  const says = async (id) => {
    await popover(page).waitFor({ state: 'visible' })
    const [name, source, check] = await popover(page).evaluate((box) => [
      box.querySelector('dt code').textContent,
      box.querySelector('.number-source').href,
      box.querySelector('.number-check')?.href,
    ])
    assert.equal(name, id)
    assert.match(source, /\/source\/crates\/[a-z-]+\/src\/.*\.rs\.html#L\d+$/)
    return check
  }
  // In the text, by mouse.
  const pinned = page.locator('main p a.number').filter({ visible: true })
  const ids = await pinned.evaluateAll((all) => all.map((number) => number.hash.replace('#number-', '')))
  const listed = await entries(page)
  const at = ids.findIndex((id) => listed[id].check)
  assert.ok(at >= 0, 'there is a number in the text that a check pins')
  await pinned.nth(at).scrollIntoViewIfNeeded()
  await quiet(page)
  await pinned.nth(at).hover()
  assert.match(await says(ids[at]), /\/check\/(index\.html)?#check-\d+$/)
  // The mouse can go into it and follow the link to the check.
  await popover(page).locator('.number-check').hover()
  await quiet(page)
  assert.ok(await popover(page).isVisible())
  await rest(page)
  await popover(page).waitFor({ state: 'hidden' })
  // By the keys.
  await pinned.nth(at).focus()
  await says(ids[at])
  await page.keyboard.press('Escape')
  // Digits inside a formula.
  const digits = page.locator('main .katex [data-number]:not(math *)').locator('visible=true').first()
  await digits.scrollIntoViewIfNeeded()
  await quiet(page)
  await digits.hover()
  await says(await digits.getAttribute('data-number'))
  await rest(page)
  await popover(page).waitFor({ state: 'hidden' })
  // And for the keys the mark beside the formula.
  const mark = page.locator('main p a.formula-numbers').first()
  await mark.focus()
  assert.ok(
    await mark.evaluate((it) => it.getBoundingClientRect().width > 5 && getComputedStyle(it).opacity === '1'),
    'what has the focus is to be seen',
  )
  await says((await mark.getAttribute('data-numbers')).split(' ')[0])
  // Enter goes to the list of all numbers.
  await page.keyboard.press('Enter')
  await page.waitForURL(/\/numbers\/#number-/)
  assert.ok(
    await page.evaluate(() => document.getElementById(decodeURIComponent(location.hash.slice(1))).checkVisibility()),
    'the entry is to be seen',
  )
})

test("every number printed is its entry's value, rounded", async (t) => {
  const page = await open(t)
  const listed = await entries(page)
  const printed = await page.evaluate(() =>
    [...document.querySelectorAll('main :is([data-number], a.number)')].map((number) => ({
      id: number.dataset.number ?? number.hash.replace('#number-', ''),
      text: number.textContent,
    })),
  )
  const all = printed.map(({ id, text }) => ({ id, text, ...listed[id] }))
  assert.ok(all.length > 150, `${all.length} numbers`)
  let read = 0
  for (const { id, text, value, source } of all) {
    assert.ok(value && source, `${id} has an entry`)
    const plain = text.replace(/[\s\u200b\u202f]/g, '').replace(/[−]/g, '-')
    const [, digits, percent] = /^(-?\d+(?:\.\d+)?)(%?)$/.exec(plain) ?? []
    // Powers of ten are written in two lines of text; the book's own tests read those.
    if (digits === undefined) continue
    read++
    const half = 0.5000001 * 10 ** -(digits.split('.')[1]?.length ?? 0)
    const exact = Number(value.replace('−', '-')) * (percent ? 100 : 1)
    assert.ok(Math.abs(Number(digits) - exact) <= half, `${id} is ${value}, printed ${text}`)
  }
  assert.ok(read > 0.8 * all.length, `${read} of ${all.length} could be read`)
})
