// The first view is light: at most 400 kB over the wire, the module at most 60 kB of them.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { firstView, kindOf } from './first-view.mjs'

test('the first view of the chapter is at most 400 kB, the module 60 kB', async (t) => {
  const sizes = await firstView()
  const all = sizes.reduce((sum, [, bytes]) => sum + bytes, 0)
  const module = sizes.filter(([name]) => kindOf(name) === 'module').reduce((sum, [, bytes]) => sum + bytes, 0)
  const table = sizes.sort((a, b) => b[1] - a[1]).map(([name, bytes]) => `${(bytes / 1000).toFixed(1)} kB ${name}`)
  t.diagnostic(`${(all / 1000).toFixed(1)} kB in ${sizes.length} files, the module ${(module / 1000).toFixed(1)} kB`)
  assert.ok(all <= 400_000, table.join('\n'))
  assert.ok(module > 0 && module <= 60_000, table.join('\n'))
})
