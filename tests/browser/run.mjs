// Runs the browser tests: one file more at a time than there are processors, since a test often waits for the page; and
// after them, one by one, those that keep the whole machine busy. Each file starts a browser of its own: that costs
// half a second of a processor, and files that ran in one browser would share its clipboard and its crashes.
//   node tests/browser/run.mjs [NAME …]   only the files of these names, e.g. quiz probe
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { readdirSync } from 'node:fs'
import os from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { buildFixture } from '../fixture-book/build.mjs'
import { fixture, HANGS_MS } from './places.mjs'

const folder = path.dirname(fileURLToPath(import.meta.url))
/** They put a whole machine's load on it. */
const ALONE = new Set(['lighthouse', 'firefox'])

const all = readdirSync(folder)
  .filter((file) => file.endsWith('.test.mjs'))
  .map((file) => file.replace('.test.mjs', ''))
const wanted = process.argv.slice(2)
for (const name of wanted) {
  if (all.includes(name)) continue
  console.error(`✗ There is no browser test '${name}'. There are: ${all.join(', ')}`)
  process.exit(2)
}
const names = wanted.length > 0 ? wanted : all

buildFixture(fixture)

const beside = await run(
  names.filter((name) => !ALONE.has(name)),
  Math.min(4, os.availableParallelism() + 1),
)
const alone = await run(
  names.filter((name) => ALONE.has(name)),
  1,
)
process.exitCode = beside && alone ? 0 : 1

/** Whether all tests of these files passed. @param {string[]} some @param {number} workers how many files at a time */
async function run(some, workers) {
  if (some.length === 0) return true
  const files = some.map((name) => path.join(folder, `${name}.test.mjs`))
  const tests = spawn(
    process.execPath,
    ['--test', `--test-concurrency=${workers}`, `--test-timeout=${5 * HANGS_MS}`, '--test-reporter=spec', ...files],
    {
      stdio: 'inherit',
    },
  )
  const [status] = await once(tests, 'close')
  return status === 0
}
