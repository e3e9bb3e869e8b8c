// The list of decisions has each of them once, by its number and under its own title.
//   UPDATE_DECISIONS=1 node --test tests/node/decisions.test.mjs   writes the list anew
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync, readdirSync, writeFileSync } from 'node:fs'
import path from 'node:path'

const folder = path.join(import.meta.dirname, '../../docs/decisions')
const list = path.join(folder, 'README.md')
const read = (/** @type {string} */ file) => readFileSync(path.join(folder, file), 'utf8')
const files = readdirSync(folder)
  .filter((file) => /^\d{4}-.*\.md$/.test(file))
  .sort()
const titleOf = (/** @type {string} */ file) => /^# (.+)$/m.exec(read(file))?.[1] ?? ''

test('a decision opens with a title, which has no number, and no two have one number', () => {
  for (const file of files) assert.match(read(file), /^# (?!\d{4} )\S/, file)
  assert.equal(new Set(files.map((file) => file.slice(0, 4))).size, files.length)
})

test('the list of decisions is that of their files', () => {
  const rows = files.map((file) => `| [${file.slice(0, 4)}](${file}) | ${titleOf(file)} |`)
  const text = readFileSync(list, 'utf8')
  const written = `${text.slice(0, text.indexOf('|---|---|\n') + '|---|---|\n'.length)}${rows.join('\n')}\n`
  if (process.env.UPDATE_DECISIONS) writeFileSync(list, written)
  assert.equal(readFileSync(list, 'utf8'), written)
})
