// Runs the tests of the module and of the scripts through Node.
//   node tests/node/run.mjs [NAME …]   only the files of these names, e.g. lines tries
// With the files that have changed in CHANGED, a line each, only what they can touch (tests/touched.mjs).
import { spawnSync } from 'node:child_process'
import path from 'node:path'
import { named } from '../named.mjs'
import { touched } from '../touched.mjs'

const folder = import.meta.dirname
const { all, asked } = named(folder, 'Node')
const some = process.env.CHANGED && !asked ? touched(folder, process.env.CHANGED.trim().split('\n')) : null
const passed = [run(some?.whole ?? all), some && run(some.parts, [`--test-name-pattern=${some.pattern}`])]
process.exitCode = passed.includes(false) ? 1 : 0

/** Whether all tests of these files passed. @param {string[]} names @param {string[]} [options] of Node's */
function run(names, options = []) {
  if (names.length === 0) return true
  const files = names.map((name) => path.join(folder, `${name}.test.mjs`))
  const words = ['--test', '--test-reporter=spec', ...options, ...files]
  return spawnSync(process.execPath, words, { stdio: 'inherit' }).status === 0
}
