// ./scripts/serve --watch: a change of a source is built, and the open pages are told; the build is a stand-in here.
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { HANGS_MS } from '../browser/places.mjs'
import { Rebuilder } from '../../scripts/rebuild.mjs'
import { serve } from '../../scripts/static-server.mjs'

let home, site, events
const stop = new AbortController()
before(async () => {
  home = mkdtempSync(path.join(tmpdir(), 'watch-'))
  for (const folder of ['content', 'scripts', 'dist', 'web/node_modules'])
    mkdirSync(path.join(home, folder), { recursive: true })
  writeFileSync(path.join(home, 'content/a.md'), 'one')
  writeFileSync(path.join(home, 'dist/index.html'), '<!doctype html><head></head><p>page')
  // It fails where the text says so.
  writeFileSync(
    path.join(home, 'scripts/build'),
    '#!/bin/sh\nif grep -q wrong content/a.md; then echo "a.md:1: wrong" >&2; exit 1; fi\n',
    { mode: 0o755 },
  )
  const rebuilder = new Rebuilder(home)
  site = await serve({ folder: path.join(home, 'dist'), live: rebuilder })
  rebuilder.watch(stop.signal)
  const response = await fetch(`${site.url}.live/events`)
  events = /** @type {any} */ (response.body).pipeThrough(new TextDecoderStream()).getReader()
  assert.match(String((await events.read()).value), /^: open/)
})
after(async () => {
  stop.abort()
  await site.close()
  rmSync(home, { recursive: true })
})

/** The next event that the pages are told. */
const told = async () => {
  const { value } = await events.read()
  const [, name, data] = value.match(/^event: (\w+)\ndata: (.*)\n/)
  return { name, data: JSON.parse(data) }
}

test('a page is sent with the script that waits for a build, and the worker keeps nothing', async () => {
  assert.match(await (await fetch(site.url)).text(), /<script src="\/\.live\/reload\.js" defer><\/script><\/head>/)
  assert.match(String((await fetch(`${site.url}.live/reload.js`)).headers.get('content-type')), /^text\/javascript/)
  assert.match(await (await fetch(`${site.url}sw.js`)).text(), /unregister/)
})

test('a change is built and told, a fault with its words, and the repair too', { timeout: HANGS_MS }, async () => {
  writeFileSync(path.join(home, 'content/a.md'), 'two words')
  assert.deepEqual(await told(), { name: 'built', data: '' })
  writeFileSync(path.join(home, 'content/a.md'), 'wrong')
  assert.deepEqual(await told(), { name: 'failed', data: 'a.md:1: wrong' })
  writeFileSync(path.join(home, 'web/node_modules/no-source.js'), 'x')
  rmSync(path.join(home, 'content/a.md'))
  writeFileSync(path.join(home, 'content/b.md'), 'three')
  writeFileSync(path.join(home, 'content/a.md'), 'right again')
  assert.deepEqual(await told(), { name: 'built', data: '' })
})
