// The tests of a folder, and those of them that are asked for by name.
import { readdirSync } from 'node:fs'

/**
 * The names of a folder's tests: all, or those that the program's words ask for. A name that no test has ends the
 * program.
 * @param {string} folder
 * @param {string} kind what such a test is called
 */
export function named(folder, kind) {
  const all = readdirSync(folder)
    .filter((file) => file.endsWith('.test.mjs'))
    .map((file) => file.replace('.test.mjs', ''))
  const wanted = process.argv.slice(2)
  const unknown = wanted.find((name) => !all.includes(name))
  if (unknown) {
    console.error(`✗ There is no ${kind} test '${unknown}'. There are: ${all.join(', ')}`)
    process.exit(2)
  }
  return { all: wanted.length > 0 ? wanted : all, asked: wanted.length > 0 }
}
