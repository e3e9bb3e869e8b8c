// A file of code or content is one noun, and has at most 300 lines, of at most 120 columns where it is code; each
// figure of the list has its file.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { FIGURES } from '../../target/figures.js'

const script = fileURLToPath(new URL('../../scripts/lines', import.meta.url))
const lines = (/** @type {string} */ one) => spawnSync(process.execPath, [one, '--check'], { encoding: 'utf8' })

test('no file of content, code, styles, scripts or tests has more than 300 lines, or a line too wide', () => {
  const { status, stdout } = lines(script)
  assert.equal(status, 0, stdout)
})

test('the parts that scripts/lines prints sum to all code, of Rust and of JavaScript', () => {
  const blocks = lines(script).stdout.split('\n\n')
  const [crates, parts, rooms] = blocks.map((block) => block.split('\n').map((row) => Number(/\d+$/.exec(row))))
  for (const { name } of FIGURES) assert.match(blocks[1], new RegExp(`^${name} +[1-9]\\d+$`, 'm'))
  assert.ok(crates.length > 5 && parts.length > 5 && rooms.length === 5)
  const together = rooms.pop()
  assert.equal(
    rooms.reduce((sum, count) => sum + count, 0),
    together,
  )
  assert.equal(
    parts.reduce((sum, count) => sum + count, 0),
    Number(/^labs +(\d+)$/m.exec(blocks[0])?.[1]),
  )
  assert.equal(
    crates.slice(0, -1).reduce((sum, count) => sum + count, 0),
    crates.at(-1),
  )
})

test('301 lines, 121 columns and a figure without its file are faults; comments are no code', (t) => {
  const root = mkdtempSync(path.join(tmpdir(), 'lines '))
  t.after(() => rmSync(root, { recursive: true }))
  for (const folder of [
    '.ci',
    '.github',
    'content',
    'crates/a/src',
    'crates/labs/src',
    'docs',
    'scripts',
    'tests',
    'web/node_modules',
  ])
    mkdirSync(path.join(root, folder), { recursive: true })
  cpSync(script, path.join(root, 'scripts/lines'))
  writeFileSync(path.join(root, 'content/short.md'), 'line\n'.repeat(300))
  writeFileSync(path.join(root, 'content/long.md'), 'line\n'.repeat(301))
  writeFileSync(path.join(root, 'web/node_modules/long.js'), 'line\n'.repeat(301))
  writeFileSync(path.join(root, 'web/wide.js'), `'${'é'.repeat(118)}'\n'${'é'.repeat(119)}'\n`)
  writeFileSync(path.join(root, '.github/wide.yml'), 'e'.repeat(121))
  writeFileSync(path.join(root, 'crates/labs/src/figures.rs'), '            swinging_door::SwingingDoor in "late";\n')
  writeFileSync(path.join(root, 'web/wide.md'), 'é'.repeat(121))
  writeFileSync(path.join(root, 'web/code.js'), '/**\n * words\n */\n\n// words\n/* words */\ncode()\n')
  const { status, stdout } = lines(path.join(root, 'scripts/lines'))
  assert.equal(status, 1)
  assert.match(stdout, /^content\/long\.md: 301 lines, over 300$/m)
  assert.match(stdout, /^web\/wide\.js:2: 121 columns, over 120$/m)
  assert.doesNotMatch(stdout, /short|node_modules|wide\.js:1|wide\.md/)
  assert.match(stdout, /^JavaScript, web +3$/m)
  assert.match(stdout, /^\.github\/wide\.yml:1: 121 columns, over 120$/m)
  assert.match(stdout, /^crates\/labs\/src\/figures\.rs: there is no swinging_door\.rs$/m)
})
