// What a reader takes along from the page of a log: the settings, which the page reads again, and programs of others.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { until } from './harness.mjs'
import { drop, file, openLog } from './own-log.mjs'

/** Columns that a reader has to exchange by hand. */
const table = (row) => Array.from({ length: 30 }, (_, k) => `${k / 2},${row(k)}\n`).join('')
const FIXES = `stamp,east,north\n${table((k) => `${k / 4},${(k % 3) / 10}`)}`
const SPEEDS = `time,v,omega\n${table(() => '0.5,0')}`

/** What a button gives as a file: its name and its text. */
async function given(page, label) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: label, exact: true }).click(),
  ])
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') }
}
const settingsInput = (page) => page.locator('input[accept*=json]')
const said = (page, words) => page.locator('.log-note', { hasText: words }).waitFor()

test('settings and the reading of columns are taken along, and read again in a fresh page', async (t) => {
  const { page, it, choose, answer } = await openLog(t)
  await choose(file('speeds.csv', SPEEDS), file('fixes.csv', FIXES))
  const asked = 'Are x and y the true position'
  await page.locator('.log-ask', { hasText: asked }).waitFor()
  // Each answer builds the form anew: only then is the next choice made.
  const chosen = async (key, option) => {
    await page.evaluate(() => document.querySelector('.log-file').toggleAttribute('data-before', true))
    await page.locator(`[data-key="1 ${key}"]`).selectOption(option)
    await page.locator('.log-file[data-before]').waitFor({ state: 'detached' })
  }
  const read = () => page.locator('.log-file select').evaluateAll((all) => all.map(({ value }) => value))
  await chosen('read as', 'sensors')
  await answer.getByText('Files: speeds.csv, fixes.csv').waitFor()
  const guessed = await read()
  await chosen('x', { label: 'north' })
  await chosen('y', { label: 'east' })
  await it.evaluate((host) => host.figure.change({ sigmaFix: 0.25, gate: 0.99 }))
  await until(it, ({ params }) => params.sigmaFix === 0.25, 'the change')
  const corrected = await read()
  assert.notDeepEqual(corrected, guessed)
  const { name, text } = await given(page, 'Download the settings')
  assert.equal(name, 'settings.json')
  assert.equal(JSON.parse(text).settings.sigmaFix, 0.25)
  const python = await given(page, 'For filterpy')
  assert.ok(python.name === 'filter.py' && python.text.includes('SIGMA_FIX = 0.25'))
  const yaml = await given(page, 'For robot_localization')
  assert.ok(yaml.name === 'ekf.yaml' && yaml.text.includes('pose0_config'))

  const fresh = await openLog(t)
  await settingsInput(fresh.page).setInputFiles(file('settings.json', text))
  await said(fresh.page, 'settings.json: no open file is called speeds.csv')
  await fresh.choose(file('speeds.csv', SPEEDS), file('fixes.csv', FIXES))
  await said(fresh.page, 'The filter has the settings of settings.json.')
  const again = await fresh.page.locator('.log-file select').evaluateAll((all) => all.map(({ value }) => value))
  assert.deepEqual(again, corrected)
  const params = await fresh.it.evaluate((host) => host.figure.run.state().params)
  assert.deepEqual([params.sigmaFix, params.gate], [0.25, 0.99])

  // Dropped with the files, or behind them while their question is open, they are settings as well.
  const log = [
    ['speeds.csv', SPEEDS],
    ['fixes.csv', FIXES],
  ]
  const settings = ['settings.json', text]
  for (const drops of [[[...log, settings]], [log, [settings]], [[settings], log]]) {
    const other = await openLog(t)
    for (const [at, files] of drops.entries()) {
      await drop(other.page, files)
      if (at === 0 && drops.length > 1)
        await (files === log
          ? other.page.locator('.log-ask', { hasText: asked }).waitFor()
          : other.answer.getByText('settings.json: no open file is called speeds.csv').waitFor())
    }
    await other.answer.getByText('The filter has the settings of settings.json.').waitFor()
    assert.deepEqual(await other.page.locator('.log-file legend').allTextContents(), ['speeds.csv', 'fixes.csv'])
    const found = await other.page.locator('.log-file select').evaluateAll((all) => all.map(({ value }) => value))
    assert.deepEqual(found, corrected)
    await until(other.it, ({ params: now }) => now.sigmaFix === 0.25 && now.gate === 0.99, 'the settings')
  }
})

test('a file that is no settings, or holds one that is not known, changes nothing and says why', async (t) => {
  const { page, it } = await openLog(t)
  const before = await it.evaluate((host) => JSON.stringify(host.figure.run.state().params))
  for (const [text, words] of [
    ['x,y\n', 'mine.json: it is no JSON'],
    ['{"format":"robot-motion log settings","version":1,"settings":{"sigma":1},"files":[]}', 'has “sigma”'],
    ['{"format":"robot-motion log settings","version":1,"settings":{"sigmaFix":-1},"files":[]}', 'sigmaFix is -1'],
  ]) {
    await settingsInput(page).setInputFiles(file('mine.json', text))
    await said(page, words)
  }
  assert.equal(await it.evaluate((host) => JSON.stringify(host.figure.run.state().params)), before)
})
