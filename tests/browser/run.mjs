// Runs the browser tests: several files at a time in one Chromium, and after them, one by one, those whose verdict depends on
// how busy the machine is. A test file also runs by itself: node --test tests/browser/quiz.test.mjs
//   node tests/browser/run.mjs [NAME …]   only the files of these names, e.g. quiz probe
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { readdirSync } from 'node:fs'
import os from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'
import { CHROMIUM_FLAGS, chromiumPath } from './places.mjs'

const folder = path.dirname(fileURLToPath(import.meta.url))
/** They count what a figure or a page does within a time, or start a browser of their own and load it fully. */
const ALONE = new Set(['bench', 'layout', 'lighthouse', 'firefox'])

const all = readdirSync(folder).filter((file) => file.endsWith('.test.mjs')).map((file) => file.replace('.test.mjs', ''))
const wanted = process.argv.slice(2)
for (const name of wanted) {
  if (all.includes(name)) continue
  console.error(`✗ There is no browser test '${name}'. There are: ${all.join(', ')}`)
  process.exit(2)
}
const names = wanted.length > 0 ? wanted : all

const browser = await chromium.launchServer({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
let failed = false
try {
  const workers = Math.max(1, Math.min(4, os.availableParallelism()))
  await run(names.filter((name) => !ALONE.has(name)), workers)
  await run(names.filter((name) => ALONE.has(name)), 1)
} finally {
  await browser.close()
}
process.exitCode = failed ? 1 : 0

/** @param {string[]} some @param {number} workers how many files at a time */
async function run(some, workers) {
  if (some.length === 0) return
  const files = some.map((name) => path.join(folder, `${name}.test.mjs`))
  const tests = spawn(process.execPath, ['--test', `--test-concurrency=${workers}`, '--test-reporter=spec', ...files], {
    stdio: 'inherit',
    env: { ...process.env, BROWSER_ENDPOINT: browser.wsEndpoint() },
  })
  const [status] = await once(tests, 'close')
  failed ||= status !== 0
}
