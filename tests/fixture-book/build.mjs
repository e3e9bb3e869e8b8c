// A book of two sections for the tests of what a page does, built by the book's program with the scripts, styles and
// stills of the real one. Its text is here; its data (formulas, terms, works, questions) are the real book's, so that
// neither can lack what the other has.
import { execFileSync } from 'node:child_process'
import { mkdirSync, readdirSync, rmSync, symlinkSync } from 'node:fs'
import path from 'node:path'
import { root } from '../browser/places.mjs'

const own = import.meta.dirname
const DATA = ['constants.toml', 'glossary.toml', 'macros.toml', 'notation.toml', 'references.toml']
const QUIZZES = 'quizzes'

/** Builds it into `folder`. */
export function buildFixture(folder) {
  const book = `${folder}-root`
  rmSync(book, { recursive: true, force: true })
  mkdirSync(path.join(book, 'content'), { recursive: true })
  for (const name of ['crates', 'tests', 'web']) symlinkSync(path.join(root, name), path.join(book, name))
  for (const name of DATA) symlinkSync(path.join(root, 'content', name), path.join(book, 'content', name))
  for (const name of readdirSync(own).filter((it) => it !== 'build.mjs' && it !== QUIZZES))
    symlinkSync(path.join(own, name), path.join(book, 'content', name))
  // The real book's questions, and one of its own.
  mkdirSync(path.join(book, 'content', QUIZZES))
  for (const folder of [path.join(root, 'content', QUIZZES), path.join(own, QUIZZES)]) {
    for (const name of readdirSync(folder))
      symlinkSync(path.join(folder, name), path.join(book, 'content', QUIZZES, name))
  }
  const program = ['run', '--quiet', '--locked', '-p', 'book', '--']
  execFileSync('cargo', [...program, '--strict', '--root', book, '--out', folder], { cwd: root, stdio: 'inherit' })
}
