// Runs the browser tests: one file more at a time than there are processors, since a test often waits for the page; and
// after them, one by one, those that keep the whole machine busy. Each file starts a browser of its own: that costs
// half a second of a processor, and files that ran in one browser would share its clipboard and its crashes.
//   node tests/browser/run.mjs [NAME …]   only the files of these names, e.g. quiz probe
// With the files that have changed in CHANGED, a line each, only what they can touch (tests/touched.mjs).
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import os from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { buildFixture } from '../fixture-book/build.mjs'
import { named } from '../named.mjs'
import { touched } from '../touched.mjs'
import { fixture, HANGS_MS } from './places.mjs'

const folder = path.dirname(fileURLToPath(import.meta.url))
/** It puts a whole machine's load on it. */
const ALONE = new Set(['firefox'])

const { all, asked } = named(folder, 'browser')
const some = process.env.CHANGED && !asked ? touched(folder, process.env.CHANGED.trim().split('\n')) : null
const whole = some?.whole ?? all

buildFixture(fixture)

const AT_ONCE = Math.min(4, os.availableParallelism() + 1)
const passed = [
  await run(
    whole.filter((name) => !ALONE.has(name)),
    AT_ONCE,
  ),
  await run(
    whole.filter((name) => ALONE.has(name)),
    1,
  ),
  some && (await run(some.parts, AT_ONCE, [`--test-name-pattern=${some.pattern}`])),
]
process.exitCode = passed.includes(false) ? 1 : 0

/**
 * Whether all tests of these files passed.
 * @param {string[]} names
 * @param {number} workers how many files at a time
 * @param {string[]} [options] of Node's
 */
async function run(names, workers, options = []) {
  if (names.length === 0) return true
  const tests = spawn(
    process.execPath,
    [
      '--test',
      `--test-concurrency=${workers}`,
      `--test-timeout=${5 * HANGS_MS}`,
      '--test-reporter=spec',
      ...options,
      ...names.map((name) => path.join(folder, `${name}.test.mjs`)),
    ],
    { stdio: 'inherit' },
  )
  const [status] = await once(tests, 'close')
  return status === 0
}
