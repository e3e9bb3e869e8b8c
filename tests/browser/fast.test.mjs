// What the first view weighs over the wire, held under its goals: 90 kB for the module and 340 kB in all. The module
// is held close above where it is: it may only become lighter.
import { test } from 'node:test'
import assert from 'node:assert/strict'
import { firstView, kindOf } from './tools/first-view.mjs'
import { open } from './harness.mjs'
import { readItAll } from './tools/letters.mjs'

const BOUND = { module: 64_000, rest: 276_200, all: 340_000 }

test('the first view of the chapter and its module weigh no more than they did', async (t) => {
  const sizes = await firstView()
  const all = sizes.reduce((sum, [, bytes]) => sum + bytes, 0)
  const module = sizes.filter(([name]) => kindOf(name) === 'module').reduce((sum, [, bytes]) => sum + bytes, 0)
  const table = sizes.sort((a, b) => b[1] - a[1]).map(([name, bytes]) => `${(bytes / 1000).toFixed(1)} kB ${name}`)
  t.diagnostic(`${(all / 1000).toFixed(1)} kB in ${sizes.length} files, the module ${(module / 1000).toFixed(1)} kB`)
  assert.ok(all <= BOUND.all && all - module <= BOUND.rest, table.join('\n'))
  assert.ok(module > 0 && module <= BOUND.module, table.join('\n'))
})

test('the first parts of the faces hold all letters of the chapter, in all notations, figures alive', async (t) => {
  const more = new Set()
  const page = await open(t, {
    prepare: async (it) =>
      it.on('request', (request) => {
        if (/-more-\w+\.woff2$/.test(request.url())) more.add(request.url().split('/').pop())
      }),
  })
  await readItAll(page)
  assert.deepEqual([...more], [], 'run ./scripts/letters and build again')
})
