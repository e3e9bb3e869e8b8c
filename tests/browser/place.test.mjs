// The reader's place: after a reload, a way back, a link, a text fragment or a hit of the search the same line is where
// it was or belongs, though parts of the chapter are laid out only when the reader comes near them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { DESKTOP, open, PHONE, quiet, stage } from './harness.mjs'

/** The height of a line of text, pixels: nobody loses the place by less. */
const LINE = 29
const SIZES = { desktop: { viewport: DESKTOP }, phone: { viewport: PHONE, touch: true } }

/** Waits until nothing has moved for some frames. */
const settle = (page) =>
  page.evaluate(async () => {
    await document.fonts.ready
    let [still, last] = [0, NaN]
    for (let i = 0; i < 400 && still < 30; i++) {
      await new Promise((resolve) => requestAnimationFrame(resolve))
      const now = scrollY + document.documentElement.scrollHeight / 1e6
      still = now === last && document.readyState === 'complete' ? still + 1 : 0
      last = now
    }
  })
/**
 * The first paragraph that begins on the screen, and where. Where a figure fills the screen it is the last one above:
 * what stands below moves when the figure comes alive and grows.
 */
const mark = (page) =>
  page.evaluate(() => {
    const all = [...document.querySelectorAll('.chapter > section p')]
      .filter((it) => it.checkVisibility() && it.textContent.trim().length > 40 && !it.closest('.widget'))
      .map((it) => ({ text: it.textContent.trim().slice(0, 60), top: it.getBoundingClientRect().top }))
    return all.find(({ top }) => top > 30 && top < innerHeight) ?? all.filter(({ top }) => top <= 30).at(-1) ?? null
  })
const topOf = (page, text) =>
  page.evaluate(
    (words) =>
      [...document.querySelectorAll('.chapter p')]
        .find((p) => p.textContent.trim().startsWith(words))
        ?.getBoundingClientRect().top,
    text,
  )
/** Scrolls as a reader does, from where the page is, to the middle of a part. */
const readTo = async (page, part, share = 0.5) => {
  await page.evaluate(
    async ([name, at]) => {
      const section = document.querySelector(`[data-part="${name}"]`)
      for (let i = 0; i < 3; i++) {
        const { top, height } = section.getBoundingClientRect()
        scrollTo({ top: scrollY + top + height * at, behavior: 'instant' })
        for (let frame = 0; frame < 8; frame++) await new Promise((resolve) => requestAnimationFrame(resolve))
      }
    },
    [part, share],
  )
  await settle(page)
  await quiet(page)
}
const near = (now, then, what) =>
  assert.ok(Math.abs(now - then) < LINE, `${what}: ${now} px from the top, ${then} before`)

for (const [size, how] of Object.entries(SIZES)) {
  test(`a reload leaves the reader where the reader was, ${size}`, async (t) => {
    const page = await open(t, how)
    for (const part of ['knob', 'schedule', 'ekf', 'ellipse', 'exercises']) {
      await readTo(page, part)
      const before = await mark(page)
      assert.ok(before, part)
      await page.reload()
      await settle(page)
      near(await topOf(page, before.text), before.top, part)
    }
  })

  test(`derivations unfolded above the place stay unfolded, and the place with them, ${size}`, {}, async (t) => {
    const page = await open(t, how)
    const all = page.locator('details.derivation')
    const ids = await all.evaluateAll((blocks) => blocks.slice(0, 4).map((block) => block.id))
    for (const id of ids) {
      await page.locator(`#${id}`).scrollIntoViewIfNeeded()
      await page.locator(`#${id} > summary`).click()
    }
    // Inside one of them.
    await page
      .locator(`#${ids[2]} .step`)
      .last()
      .evaluate((step) => scrollTo({ top: scrollY + step.getBoundingClientRect().top - 60, behavior: 'instant' }))
    await settle(page)
    await quiet(page)
    const before = await mark(page)
    await page.reload()
    await settle(page)
    near(await topOf(page, before.text), before.top, ids[2])
    assert.deepEqual(
      await page.locator('details.derivation[open]').evaluateAll((blocks) => blocks.map((block) => block.id)),
      ids,
    )
  })

  test(`the way back from another page, or place of this one, leads to the line that was left, ${size}`, async (t) => {
    const page = await open(t, how)
    const { site } = await stage()
    await readTo(page, 'algorithms')
    const before = await mark(page)
    await page.goto(`${site.url}hosting/`)
    await page.goBack()
    await settle(page)
    near(await topOf(page, before.text), before.top, 'back from another page')
    // By a link within the page, and back.
    await page.evaluate(() => document.querySelector('.toc a[href="#hand-steps"]').click())
    await settle(page)
    near(
      await page.locator('#hand-steps').evaluate((it) => it.getBoundingClientRect().top),
      24,
      'the link of the contents',
    )
    await page.goBack()
    await settle(page)
    near(await topOf(page, before.text), before.top, 'back within the page')
    await page.goForward()
    await settle(page)
    near(await page.locator('#hand-steps').evaluate((it) => it.getBoundingClientRect().top), 24, 'and forward again')
  })

  test(`an address leads to its heading, its figure or its words, ${size}`, async (t) => {
    for (const id of ['hand-steps', 'ellipse', 'fig-probe', 'exercises', 'bibliography']) {
      const page = await open(t, { ...how, at: `kalman/#${id}` })
      await settle(page)
      const { top, bottom, height, end } = await page.evaluate((name) => {
        const { top, bottom } = document.getElementById(name).getBoundingClientRect()
        return {
          top,
          bottom,
          height: innerHeight,
          end: Math.abs(scrollY + innerHeight - document.documentElement.scrollHeight) < 2,
        }
      }, id)
      if (end) assert.ok(top >= 0 && bottom <= height, `${id} is on the last screen`)
      else near(top, 24, id)
    }
    const page = await open(t, how)
    await readTo(page, 'slam', 0.4)
    const { text } = await mark(page)
    const words = text.split(' ').slice(0, 5).join(' ')
    const other = await open(t, { ...how, at: `kalman/#:~:text=${encodeURIComponent(words).replace(/-/g, '%2D')}` })
    await settle(other)
    const { height } = how.viewport
    const top = await topOf(other, text)
    assert.ok(top > -LINE && top < height - LINE, `“${words}” is at ${top} of ${height} px`)
  })

  test(`a hit of the search leads to its heading, ${size}`, async (t) => {
    const page = await open(t, how)
    await page.locator('[data-open-search]').first().click()
    const dialog = page.getByRole('dialog', { name: 'Search' })
    await dialog.getByRole('searchbox').fill('associate')
    const hit = dialog.locator('.search-results a').first()
    await hit.waitFor()
    const id = await hit.evaluate((link) => decodeURIComponent(link.hash.slice(1)))
    await hit.click()
    await settle(page)
    near(await page.evaluate((name) => document.getElementById(name).getBoundingClientRect().top, id), 24, id)
  })
}

test('a reload leads to the place that was left, and not to the one that the address names', async (t) => {
  const page = await open(t, { at: 'kalman/#ellipse' })
  await settle(page)
  await readTo(page, 'hand-steps')
  const before = await mark(page)
  await page.reload()
  await settle(page)
  near(await topOf(page, before.text), before.top, 'hand-steps')
  // A script that scrolls after that is left alone.
  await page.reload()
  await quiet(page)
  await page.evaluate(() => document.querySelector('[data-part="ekf"]').scrollIntoView({ behavior: 'instant' }))
  await settle(page)
  near(await page.locator('[data-part="ekf"]').evaluate((it) => it.getBoundingClientRect().top), 24, 'ekf')
})

test('a link within the page leads there as often as it is pressed', async (t) => {
  const page = await open(t)
  const link = page.locator('main a[href="#schedule"]').first()
  const target = page.locator('#schedule')
  for (const time of ['first', 'second', 'third']) {
    await link.scrollIntoViewIfNeeded()
    await settle(page)
    await link.click()
    await settle(page)
    near(await target.evaluate((it) => it.getBoundingClientRect().top), 24, `the ${time} time`)
    await page.evaluate(() => document.querySelector('#intuition').scrollIntoView({ behavior: 'instant' }))
    await settle(page)
  }
})

test('words far below the screen are found in the page', async (t) => {
  const page = await open(t)
  const words = await page.evaluate(() =>
    [...document.querySelectorAll('[data-part="slam"] p')]
      .find((p) => !p.querySelector('.formula, .number') && p.textContent.length > 80)
      .textContent.trim()
      .split(/\s+/)
      .slice(0, 4)
      .join(' '),
  )
  assert.ok(await page.evaluate((some) => find(some), words), `“${words}”`)
  await settle(page)
  assert.ok((await page.evaluate(() => scrollY)) > 2000)
})

test('a part that is not laid out has nearly its real height, and holds no form control', async (t) => {
  for (const how of Object.values(SIZES)) {
    const page = await open(t, how)
    await settle(page)
    const seen = await page.evaluate(() =>
      [...document.querySelectorAll('.chapter > section')].map((part) => {
        const far = part.getBoundingClientRect().top > 5 * innerHeight
        const controls = part.querySelectorAll('button, input, select, textarea').length
        const guess = part.getBoundingClientRect().height
        part.style.contentVisibility = 'visible'
        return { name: part.dataset.part, far, controls, guess, real: part.getBoundingClientRect().height }
      }),
    )
    assert.ok(seen.filter(({ far }) => far).length > 10)
    assert.deepEqual(
      seen.filter(({ far, controls }) => far && controls > 0),
      [],
    )
    const wrong = seen.filter(({ guess, real }) => Math.abs(guess - real) > Math.max(200, 0.15 * real))
    assert.deepEqual(wrong, [], 'run ./scripts/heights and build again')
  }
})

test('a figure that comes alive while it is read stays where it is, and is as high as its still', async (t) => {
  /** @type {any} */
  let answer
  const asked = new Promise((resolve) => {
    answer = resolve
  })
  const page = await open(t, {
    ...SIZES.phone,
    prepare: (it) =>
      it.route('**/*.wasm', async (route) => {
        await asked
        await route.continue()
      }),
  })
  const probe = page.locator('#fig-probe')
  const box = () => probe.evaluate((it) => it.getBoundingClientRect().toJSON())
  for (let i = 0; i < 5; i++) {
    await probe.evaluate((it) =>
      scrollBy({ top: it.getBoundingClientRect().top + it.getBoundingClientRect().height * 0.6, behavior: 'instant' }),
    )
    await quiet(page, 20, true)
  }
  const before = await box()
  assert.ok(before.top < 0 && before.bottom > 100, 'its end is on the screen')
  answer()
  await probe.locator('[data-state=live]').waitFor()
  await quiet(page)
  const now = await box()
  near(now.height, before.height, 'its height')
  near(now.top, before.top, 'its upper edge')
})

for (const [size, how] of Object.entries(SIZES)) {
  test(`a text is not moved by a figure above it that comes alive, ${size}`, async (t) => {
    /** @type {any} */
    let answer
    const asked = new Promise((resolve) => {
      answer = resolve
    })
    const page = await open(t, {
      ...how,
      prepare: (it) =>
        it.route('**/*.wasm', async (route) => {
          await asked
          await route.continue()
        }),
    })
    const bench = page.locator('#fig-bench')
    const top = () => bench.evaluate((it) => it.closest('section').nextElementSibling.getBoundingClientRect().top)
    for (let i = 0; i < 5; i++) {
      await bench.evaluate((it) =>
        scrollBy({ top: it.querySelector('.widget').getBoundingClientRect().bottom + 40, behavior: 'instant' }),
      )
      await quiet(page, 20, true)
    }
    const before = await top()
    answer()
    await bench.locator('[data-state=live]').waitFor()
    await quiet(page)
    near(await top(), before, 'the next part')
  })
}
