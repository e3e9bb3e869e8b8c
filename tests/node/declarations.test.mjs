// What an editor shows of the module: the declarations that are built with it.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'

const declarations = readFileSync(new URL('../../target/pkg/node/estimate_wasm.d.ts', import.meta.url), 'utf8')

test('the documentation is text, without the quotes of a macro', () => {
  assert.ok(!/(?<!\w)r" /.test(declarations))
  assert.match(declarations, /\* The rail robot of §8\.2\.6 under an observer/)
})
