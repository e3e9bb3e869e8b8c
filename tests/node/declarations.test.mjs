// What an editor shows of the module: the declarations that are built with it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'

const declarations = readFileSync(new URL('../../target/pkg/node/estimate_wasm.d.ts', import.meta.url), 'utf8')

test('the documentation is text, without the quotes of a macro', () => {
  assert.ok(!/(?<!\w)r" /.test(declarations))
  assert.match(declarations, /\* The rail robot of §8\.2\.6 under an observer/)
})

test('each matrix of a system, a step or a sensor has words of its own, which an editor shows', () => {
  const lines = declarations.split('\n')
  const members = lines.flatMap((line, i) => (/^\s+[ABFGHQVW]\??: /.test(line) ? [[line.trim(), lines[i - 1]]] : []))
  for (const letter of 'FGHVW')
    assert.ok(members.filter(([member]) => member.startsWith(letter)).length >= 2, `${letter} is declared`)
  // Those of a letter's record are one line, and have no place for words.
  assert.deepEqual(
    members.filter(([, before]) => !before.trim().endsWith('*/')).map(([member]) => member),
    [],
  )
})
