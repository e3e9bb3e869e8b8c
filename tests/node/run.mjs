// Runs the tests of the module and of the scripts through Node.
//   node tests/node/run.mjs
// With the files that have changed in CHANGED, a line each, only what they can touch (tests/touched.mjs).
import { spawnSync } from 'node:child_process'
import { readdirSync } from 'node:fs'
import path from 'node:path'
import { touched } from '../touched.mjs'

const folder = import.meta.dirname
const all = readdirSync(folder)
  .filter((file) => file.endsWith('.test.mjs'))
  .map((file) => file.replace('.test.mjs', ''))
const some = process.env.CHANGED ? touched(folder, process.env.CHANGED.trim().split('\n')) : null
const passed = [run(some?.whole ?? all), some && run(some.parts, [`--test-name-pattern=${some.pattern}`])]
process.exitCode = passed.includes(false) ? 1 : 0

/** Whether all tests of these files passed. @param {string[]} names @param {string[]} [options] of Node's */
function run(names, options = []) {
  if (names.length === 0) return true
  const files = names.map((name) => path.join(folder, `${name}.test.mjs`))
  const words = ['--test', '--test-reporter=spec', ...options, ...files]
  return spawnSync(process.execPath, words, { stdio: 'inherit' }).status === 0
}
