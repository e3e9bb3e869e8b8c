// Which tests a change can touch, for `scripts/test --changed`. Where only folders of figures and tests have changed,
// it is those tests, the tests that name one of the figures, and of those that go through all figures the ones of
// these figures. Whatever else has changed may touch any test; CI runs all of them at each push.
import { readFileSync, readdirSync } from 'node:fs'
import path from 'node:path'
import { FIGURES } from '../target/figures.js'

/** What holds every file to something, and takes no time. */
const OF_ALL_FILES = new Set(['lines', 'circles'])

/**
 * @param {string} folder of the tests
 * @param {string[]} changed files, from the project's root
 * @returns {{ whole: string[], parts: string[], pattern: string } | null} the names of files to run whole, and of files
 *   to run the tests of whose titles have the pattern; null for all tests
 */
export function touched(folder, changed) {
  const figures = new Set()
  const tests = new Set(OF_ALL_FILES)
  for (const file of changed) {
    const figure = /^web\/widgets\/([a-z-]+)\//.exec(file)?.[1]
    const test = /^tests\/(?:node|browser)\/([a-z-]+)\.test\.mjs$/.exec(file)
    if (figure) figures.add(figure)
    else if (test && path.basename(path.dirname(file)) === path.basename(folder)) tests.add(test[1])
    else if (!test) return null
  }
  const words = FIGURES.filter(({ name }) => figures.has(name)).flatMap(({ name, tag }) => [name, tag])
  const whole = []
  const parts = []
  for (const file of readdirSync(folder).filter((it) => it.endsWith('.test.mjs'))) {
    const name = file.replace('.test.mjs', '')
    const text = readFileSync(path.join(folder, file), 'utf8')
    const ofAll = /\b(WIDGETS|FIGURES|FIGURE_PAGES)\b/.test(text)
    if (tests.has(name) || (!ofAll && words.some((word) => text.includes(`'${word}'`)))) whole.push(name)
    else if (ofAll && words.length > 0) parts.push(name)
  }
  return { whole, parts, pattern: `\\b(${words.join('|')})\\b` }
}
