// A link carries a figure's state to the last digit; a mangled one falls back, and says so.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { WIDGETS } from '../../web/widgets/index.js'
import { SITE, hashes, kept, lost } from '../node/kept-links.mjs'
import {
  comeTo,
  dragSlider,
  figure,
  frameOf,
  open,
  openFigure,
  quiet,
  stage,
  stateOf,
  tagOf,
  unlock,
  until,
} from './harness.mjs'

const copied = async (page, bench) => {
  await bench.getByRole('button', { name: 'Copy link to this state' }).click()
  await bench.getByText('Link copied.').first().waitFor()
  return page.evaluate(() => navigator.clipboard.readText())
}

test('a copied link opens the same state, to the same digits', async (t) => {
  const page = await open(t)
  const bench = await figure(page, 'observer-bench')
  await bench.getByRole('combobox', { name: 'Sensor' }).selectOption('position')
  await dragSlider(page, bench.getByRole('slider', { name: /gain/i }), 2.37)
  await bench.getByRole('button', { name: 'Step' }).click()
  await until(bench, ({ step }) => step === 13, 'a step')
  const link = await copied(page, bench)
  const there = { frame: await frameOf(bench), state: await stateOf(bench) }

  const { site } = await stage()
  const other = await open(t, { at: link.slice(site.url.length) })
  const restored = await figure(other, 'observer-bench')
  assert.deepEqual(await stateOf(restored), there.state)
  assert.deepEqual(await frameOf(restored), there.frame)
})

for (const [what, mangle] of /** @type {[string, (text: string) => string][]} */ ([
  ['cut short', (text) => text.slice(0, -7)],
  ['no base64 at all', () => '%3Cscript%3Ealert(1)%3C/script%3E'],
  ['of another version', () => btoa(JSON.stringify([99, 'observer-bench', 3, {}])).replace(/=+$/, '')],
  ['of another lab', () => btoa(JSON.stringify([1, 'odometry-hook', 3, {}])).replace(/=+$/, '')],
  ['out of bounds', () => btoa(JSON.stringify([1, 'observer-bench', 3, { gain: 1e9 }])).replace(/=+$/, '')],
  [
    'of the wrong kind',
    () => btoa(JSON.stringify([1, 'observer-bench', 3, { gain: '1', sensor: 7, seed: -1 }])).replace(/=+$/, ''),
  ],
  ['far too long', () => 'A'.repeat(9_000)],
  ['with a step beyond all', () => btoa(JSON.stringify([1, 'observer-bench', 1e15, {}])).replace(/=+$/, '')],
])) {
  test(`a link ${what} gives the usual figure and a notice`, async (t) => {
    const good = btoa(
      JSON.stringify([1, 'observer-bench', 3, { sensor: 'velocity', mode: 'fixed', gain: 1, seed: 1 }]),
    ).replace(/=+$/, '')
    const { it: bench } = await openFigure(t, 'observer-bench', { query: `?fig-bench=${mangle(good)}` })
    assert.equal((await frameOf(bench)).step, 12)
    await bench
      .getByText(/could not be read/)
      .first()
      .waitFor()
  })
}

test('the figure and its series can be taken along', async (t) => {
  const { page, it: bench } = await openFigure(t, 'observer-bench')
  const take = async (name) => {
    const [download] = await Promise.all([page.waitForEvent('download'), bench.getByRole('button', { name }).click()])
    return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') }
  }
  const csv = await take('Download CSV')
  const { series } = await frameOf(bench)
  const [head, ...rows] = csv.text.trim().split(/\r?\n/)
  assert.deepEqual(head.split(','), Object.keys(series))
  assert.equal(rows.length, series.step.length)
  assert.equal(Number(rows.at(-1).split(',')[head.split(',').indexOf('p11')]), series.p11.at(-1))
  const svg = await take('Download SVG')
  assert.match(svg.text, /^(<\?xml[^>]*>\s*)?<svg[^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/)
  assert.doesNotMatch(svg.text, /var\(--/, 'the colours are in the file')
})

for (const tag of Object.keys(WIDGETS)) {
  test(`state, picture and series of the ${tag} can be taken along`, async (t) => {
    const { page, it: widget } = await openFigure(t, tag)
    const [id, before] = [await widget.getAttribute('data-figure'), await stateOf(widget)]
    const step = widget.getByRole('button', { name: 'Step' })
    if (await step.count()) await step.click()
    // Off its usual place. A figure without a slider has a handle, or a box to write in.
    await widget.evaluate((host) => host.querySelectorAll('.live .controls details').forEach((it) => (it.open = true)))
    const knobs = widget.locator('.live :is(input[type=range]:enabled, svg [role=slider])').locator('visible=true')
    if (await knobs.count()) await knobs.last().press('Shift+ArrowLeft')
    else {
      await widget.locator('.live textarea:not([readonly])').fill('x = F x')
      await page.keyboard.press('Tab')
    }
    await page.waitForFunction(
      ([name, was]) =>
        JSON.stringify(document.querySelector(name).state) !== was && document.querySelector(name).settled,
      [tagOf(tag), JSON.stringify(before)],
    )
    await quiet(page)
    const there = { frame: await frameOf(widget), state: await stateOf(widget) }
    assert.notDeepEqual(there.state, before)
    const link = await copied(page, widget)

    const take = async (name) => {
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        widget.getByRole('button', { name }).click(),
      ])
      assert.equal(download.suggestedFilename().replace(/\.\w+$/, ''), id)
      return readFileSync(await download.path(), 'utf8')
    }
    const [head, ...rows] = (await take('Download CSV')).trim().split(/\r?\n/)
    const columns = head.split(',')
    assert.ok(
      columns.length > 1 && rows.length > 0 && rows.every((row) => row.split(',').length === columns.length),
      head,
    )
    for (const [name, values] of Object.entries(there.frame.series ?? {})) {
      const at = columns.indexOf(name)
      if (at < 0 || !Array.isArray(values) || typeof values.at(-1) !== 'number') continue
      assert.equal(rows.length, values.length)
      assert.equal(Number(rows.at(-1).split(',')[at]), values.at(-1), name)
    }
    const svg = await take('Download SVG')
    assert.match(svg, /^(<\?xml[^>]*>\s*)?<svg[^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/)
    assert.doesNotMatch(svg, /var\(--/, 'the colours are in the file')
    assert.ok((svg.match(/<(path|line|circle)/g) ?? []).length > 5, 'marks')

    const { site } = await stage()
    const other = await open(t, { at: link.slice(site.url.length) })
    await unlock(other, id)
    const restored = await figure(other, tag)
    assert.deepEqual(await stateOf(restored), there.state)
    assert.deepEqual(await frameOf(restored), there.frame)
  })
}

// Figures of one page in one address, as a reader's address comes to hold them; tests/node/kept-links.test.mjs opens
// every link.
for (const { version, links } of kept()) {
  for (const page of new Set(links.map(({ address }) => address.split('?')[0]))) {
    test(`the page ${page} opens links of ${version}`, async (t) => {
      const there = links.filter(({ address }) => address.split('?')[0] === page)
      const last = there.filter(({ figure: id }, i) => there.findLastIndex((link) => link.figure === id) === i)
      const query = new URLSearchParams(last.flatMap(({ address }) => [...new URL(address, SITE).searchParams]))
      const opened = await open(t, { at: `${page}?${query}` })
      for (const { figure: id, state, frame } of last) {
        const widget = tagOf(state.lab)
        const element = opened.locator(`#${id} ${widget}`)
        await comeTo(opened, `#${id}`, `#${id} ${widget}[data-state=live]`)
        const there = ([where, step]) => {
          const it = document.querySelector(where)
          return it.settled && it.state.step === step
        }
        await opened.waitForFunction(there, [`#${id} ${widget}`, state.step]).catch((error) => {
          throw new Error(`${id}: ${error.message}`)
        })
        assert.equal(await element.getByText(/could not be read/).count(), 0, id)
        assert.deepEqual(lost(state.params, (await stateOf(element)).params), [], id)
        assert.deepEqual(lost(frame, hashes(await frameOf(element))), [], id)
      }
    })
  }
}

test('a link to a derivation opens it, and once more where it was closed again', async (t) => {
  const page = await open(t)
  const block = page.locator('#der-bias')
  for (const time of ['first', 'second']) {
    await page.locator('main a[href="#der-bias"]').first().click()
    await page.locator('#der-bias[open]').waitFor()
    assert.ok(await block.locator('.derivation-body').isVisible(), `the ${time} time`)
    await block.evaluate((it) => it.removeAttribute('open'))
  }
})
