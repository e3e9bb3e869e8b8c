// The notation switch: formulas, words, labels and readouts speak Thrun's letters, and go on doing so after a reload.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { figure, open } from './harness.mjs'

const button = (page, name) => page.getByRole('group', { name: 'Notation' }).getByRole('button', { name, exact: true })
const said = (page) => page.locator('.site-tools [role=status]')
/** What the reader sees of a formula, a label or a readout. */
const seen = async (page) => {
  // A part of the text that is far from the screen shows no words.
  await page.locator('observer-bench').first().scrollIntoViewIfNeeded()
  await page.waitForFunction(() => document.querySelector('observer-bench .live dt').innerText.trim())
  return page.evaluate(see)
}
const see = () => {
  const text = (element) => element.innerText.replace(/\s+/g, ' ').trim()
  const all = (selector) => [...document.querySelectorAll(selector)].map(text)
  return {
    formulas: [...document.querySelectorAll('[data-other]')].map((formula) =>
      [...formula.children]
        .filter((reading) => getComputedStyle(reading).display !== 'none')
        .map((reading) => (/in-\w+/.exec(reading.className) ?? ['in-choset'])[0]),
    ),
    bench: {
      labels: all('observer-bench .control-name'),
      readouts: all('observer-bench .live .readout:not([hidden]) dt'),
      drawn: [...document.querySelectorAll('observer-bench .live svg text')]
        .filter((it) => it.checkVisibility())
        .map((it) =>
          it.innerHTML.includes('in-thrun')
            ? [...it.children]
                .filter((part) => getComputedStyle(part).display !== 'none')
                .map((part) => part.textContent)
                .join('')
            : it.textContent,
        ),
    },
    pressed: all('[data-set-notation][aria-pressed="true"]'),
  }
}
const ask = async (page) => {
  await figure(page, 'observer-bench')
  // What is folded away is read too.
  await page.evaluate(() =>
    document.querySelectorAll('details').forEach((block) => {
      block.open = true
    }),
  )
  return seen(page)
}
const letters = (page, notation) =>
  page.waitForFunction((it) => document.documentElement.dataset.letters === it, notation)

test('the switch turns formulas, labels and readouts to other letters, and back', async (t) => {
  const fetched = []
  const page = await open(t, {
    prepare: async (it) =>
      it.on('request', (request) => {
        if (/(thrun|common)\.json$/.test(request.url())) fetched.push(request.url().split('/').pop())
      }),
  })
  const choset = await ask(page)
  assert.deepEqual(choset.pressed, ['Choset'])
  assert.ok(choset.formulas.length > 100)
  assert.ok(choset.formulas.every((shown) => shown.length === 1 && shown[0] === 'in-choset'))
  assert.ok(
    choset.bench.readouts.includes('P11') && choset.bench.readouts.some((label) => label.startsWith('Gain K')),
    choset.bench.readouts.join('; '),
  )
  assert.deepEqual(fetched, [], 'not fetched before it is asked for')

  await button(page, 'Thrun').click()
  await letters(page, 'thrun')
  const thrun = await seen(page)
  assert.deepEqual(thrun.pressed, ['Thrun'])
  assert.equal(thrun.formulas.length, choset.formulas.length)
  assert.ok(
    thrun.formulas.every((shown) => shown.length === 1 && shown[0] === 'in-thrun'),
    'every formula shows one reading',
  )
  assert.ok(
    thrun.bench.readouts.includes('Σ11') && thrun.bench.readouts.some((label) => label.startsWith('Gain L')),
    thrun.bench.readouts.join('; '),
  )
  assert.ok(
    thrun.bench.labels.some((label) => label.includes('K∞')) &&
      choset.bench.labels.some((label) => label.includes('R∞')),
  )
  assert.notDeepEqual(thrun.bench.drawn, choset.bench.drawn, 'the words drawn change as well')

  await button(page, 'Choset').click()
  assert.deepEqual(await seen(page), choset)
  await button(page, 'Common').click()
  await letters(page, 'common')
  const common = await seen(page)
  assert.deepEqual(common.pressed, ['Common'])
  assert.equal(common.formulas.length, choset.formulas.length)
  assert.ok(
    common.formulas.every((shown) => shown.length === 1 && shown[0] === 'in-common'),
    'every formula shows one reading',
  )
  assert.ok(
    common.bench.readouts.includes('P11') && common.bench.readouts.some((label) => label.startsWith('Gain L')),
    common.bench.readouts.join('; '),
  )
  assert.ok(
    common.bench.readouts.some((label) => label.includes('ỹ')),
    common.bench.readouts.join('; '),
  )

  await button(page, 'Thrun').click()
  assert.deepEqual(await seen(page), thrun)
  assert.deepEqual(fetched, ['thrun.json', 'common.json'], 'each fetched once')
})

test('what a formula says in the other letters is another formula, and nothing is left over', async (t) => {
  const page = await open(t)
  await button(page, 'Thrun').click()
  await letters(page, 'thrun')
  await button(page, 'Common').click()
  await letters(page, 'common')
  const all = await page.evaluate(() =>
    [...document.querySelectorAll('[data-other]')].map((formula) =>
      [...formula.children].map((reading) => reading.querySelector('math')?.textContent ?? reading.textContent),
    ),
  )
  assert.ok(
    all.every((readings) => readings.length === 3),
    'three readings each',
  )
  const same = all.filter(([choset, thrun, common]) => choset === thrun && choset === common)
  assert.deepEqual(same, [], 'what does not differ is there once')
  assert.ok(all.every((readings) => readings.every((reading) => reading.length > 0)))
})

test('the letters are remembered after a reload and on the next page', async (t) => {
  const page = await open(t)
  await button(page, 'Thrun').click()
  await letters(page, 'thrun')
  await page.reload()
  await letters(page, 'thrun')
  const again = await ask(page)
  assert.deepEqual(again.pressed, ['Thrun'])
  assert.ok(again.formulas.every((shown) => shown.length === 1 && shown[0] === 'in-thrun'))
  assert.ok(again.bench.readouts.includes('Σ11'))
  await page.goto(new URL('../log/', page.url()).href)
  assert.equal(await page.evaluate(() => document.documentElement.dataset.notation), 'thrun')
  assert.equal(await button(page, 'Thrun').getAttribute('aria-pressed'), 'true')
})

test('the keys work the switch', async (t) => {
  const page = await open(t)
  await button(page, 'Choset').focus()
  await page.keyboard.press('Tab')
  await page.keyboard.press('Enter')
  await letters(page, 'thrun')
  assert.equal(await button(page, 'Thrun').getAttribute('aria-pressed'), 'true')
  assert.equal(await button(page, 'Choset').getAttribute('aria-pressed'), 'false')
})

test("where the other letters cannot be fetched the page stays with Choset's", async (t) => {
  const page = await open(t, {
    expected: [/thrun\.json/, /ERR_FAILED/],
    prepare: (it) => it.route('**/thrun.json', (route) => route.abort()),
  })
  await button(page, 'Thrun').click()
  await page.waitForFunction(() => document.documentElement.dataset.notation === 'choset')
  assert.equal(await button(page, 'Choset').getAttribute('aria-pressed'), 'true')
  assert.ok((await ask(page)).formulas.every((shown) => shown.length === 1 && shown[0] === 'in-choset'))
  await said(page).filter({ hasText: 'could not be fetched' }).waitFor()
  // When they can be had, the next press has them.
  await page.unroute('**/thrun.json')
  await button(page, 'Thrun').click()
  await letters(page, 'thrun')
  assert.equal(await said(page).textContent(), '')
})

test("letters of another build than the page's are not put in: their numbers name other formulas", async (t) => {
  // As after a deploy with one formula more, in a tab opened before it.
  const page = await open(t, {
    prepare: (it) =>
      it.route('**/thrun.json', async (route) => {
        const response = await route.fetch()
        const { version, readings } = await response.json()
        assert.match(version, /^[0-9a-f]{16}$/)
        await route.fulfill({
          response,
          json: {
            version: version.replace(/^./, (digit) => (digit === '0' ? '1' : '0')),
            readings: ['<span>x</span>', ...readings],
          },
        })
      }),
  })
  await button(page, 'Thrun').click()
  await said(page).filter({ hasText: 'reload this page' }).waitFor()
  assert.equal(await button(page, 'Choset').getAttribute('aria-pressed'), 'true')
  assert.equal(await page.locator('[data-other] > .in-thrun').count(), 0)
  assert.ok((await ask(page)).formulas.every((shown) => shown.length === 1 && shown[0] === 'in-choset'))
  // The page of that build has them.
  await page.unroute('**/thrun.json')
  await page.reload()
  await button(page, 'Thrun').click()
  await letters(page, 'thrun')
})
