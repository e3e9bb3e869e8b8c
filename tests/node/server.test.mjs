// The static server of ./scripts/serve: right types, its own folder only, from a sub-path, and whole under odd
// requests.
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { mkdtempSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { request } from 'node:http'
import { connect } from 'node:net'
import { spawnSync } from 'node:child_process'
import { once } from 'node:events'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { HANGS_MS } from '../browser/places.mjs'
import { WORKER_POLICY, serve } from '../../scripts/static-server.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))

let home, site
before(async () => {
  home = mkdtempSync(path.join(tmpdir(), 'static-'))
  mkdirSync(path.join(home, 'site/kalman'), { recursive: true })
  writeFileSync(path.join(home, 'secret.txt'), 'secret')
  writeFileSync(path.join(home, 'site/index.html'), '<p>cover'.repeat(100))
  writeFileSync(path.join(home, 'site/kalman/index.html'), '<p>chapter')
  writeFileSync(path.join(home, 'site/module.wasm'), Buffer.from([0, 97, 115, 109]))
  for (const name of ['page-A1B2C3D4.js', 'robot-log-worker-A1B2C3D4.js', 'sw.js'])
    writeFileSync(path.join(home, 'site', name), 'export {}')
  symlinkSync(path.join(home, 'secret.txt'), path.join(home, 'site/link.txt'))
  site = await serve({ folder: path.join(home, 'site'), base: '/sub/path/' })
})
after(async () => {
  await site.close()
  rmSync(home, { recursive: true })
})

/** A request whose path is sent as it stands: fetch would tidy the dots away. */
function get(at, headers = {}, method = 'GET') {
  const { hostname, port } = new URL(site.url)
  return new Promise((resolve, reject) => {
    request({ hostname, port, path: at, headers, method }, (response) => {
      const parts = []
      response.on('data', (part) => parts.push(part))
      response.on('end', () =>
        resolve({ status: response.statusCode, headers: response.headers, body: Buffer.concat(parts) }),
      )
    })
      .on('error', reject)
      .end()
  })
}

test('pages, folders and types', async () => {
  assert.equal((await get('/sub/path/')).headers['content-type'], 'text/html; charset=utf-8')
  assert.equal((await get('/sub/path/kalman/')).body.toString(), '<p>chapter')
  assert.equal((await get('/sub/path/module.wasm')).headers['content-type'], 'application/wasm')
  const folder = await get('/sub/path/kalman?a=1')
  assert.deepEqual([folder.status, folder.headers.location], [308, '/sub/path/kalman/?a=1'])
  assert.equal((await get('/sub/path')).headers.location, '/sub/path/')
})

test('workers come with the policy of workers, and scripts of a page without', async () => {
  const policy = async (name) => (await get(`/sub/path/${name}`)).headers['content-security-policy']
  assert.deepEqual(await Promise.all(['sw.js', 'robot-log-worker-A1B2C3D4.js', 'page-A1B2C3D4.js'].map(policy)), [
    WORKER_POLICY,
    WORKER_POLICY,
    undefined,
  ])
})

test('nothing outside the folder', async () => {
  for (const at of [
    '/sub/path/../secret.txt',
    '/sub/path/../../secret.txt',
    '/sub/path/%2e%2e/secret.txt',
    '/sub/path/..%2fsecret.txt',
    '/sub/path/kalman/..%2f..%2f..%2fsecret.txt',
    '/sub/path/link.txt',
    '/secret.txt',
    '/',
    '/sub/',
    '/sub/path/none',
    '/sub/path/%00',
    '/sub/path/%zz',
    '/sub/path/module.wasm/x',
  ]) {
    const { status, body } = await get(at)
    assert.equal(status, 404, at)
    assert.ok(!body.toString().includes('secret'), at)
  }
  assert.equal((await get('/sub/path/', {}, 'POST')).status, 405)
})

test('compressed where the reader takes it, cached where the name carries a hash', async () => {
  const zipped = await get('/sub/path/', { 'accept-encoding': 'gzip' })
  assert.equal(zipped.headers['content-encoding'], 'gzip')
  assert.ok(zipped.body.length < 200)
  assert.match((await get('/sub/path/page-A1B2C3D4.js')).headers['cache-control'], /immutable/)
  const page = await get('/sub/path/')
  assert.equal(page.headers['cache-control'], 'no-cache')
  assert.equal((await get('/sub/path/', { 'if-none-match': page.headers.etag })).status, 304)
})

/** The first line of the answer to a request line that no client library would send. */
async function raw(line) {
  const { hostname, port } = new URL(site.url)
  const socket = connect(Number(port), hostname)
  socket.write(`${line}\r\nHost: ${hostname}\r\nConnection: close\r\n\r\n`)
  let text = ''
  socket.on('data', (part) => {
    text += part
  })
  await once(socket, 'close')
  return text.split('\r\n')[0]
}

test('an address that cannot be read is a bad request', async () => {
  assert.match(await raw('GET http://[ HTTP/1.1'), / 400 /)
  assert.match(await raw('GET http://a:b/ HTTP/1.1'), / 400 /)
  // A proxy's form of the same page.
  assert.match(await raw('GET http://127.0.0.1/sub/path/ HTTP/1.1'), / 200 /)
})

test('a redirect never leads to another host', async () => {
  const other = await serve({ folder: path.join(home, 'site') })
  const { hostname, port } = new URL(other.url)
  try {
    for (const at of ['/.//kalman', '//kalman', '/..//kalman', '/x/..//kalman']) {
      const response = await new Promise((resolve, reject) =>
        request({ hostname, port, path: at }, resolve).on('error', reject).end(),
      )
      response.resume()
      const { location } = response.headers
      assert.ok(
        location === undefined || new URL(location, other.url).host === `${hostname}:${port}`,
        `${at} leads to ${location}`,
      )
    }
  } finally {
    await other.close()
  }
})

test('gzip is sent to whom it was not refused', async () => {
  const coding = async (accepted) =>
    (await get('/sub/path/', { 'accept-encoding': accepted })).headers['content-encoding']
  assert.equal(await coding('gzip;q=0'), undefined)
  assert.equal(await coding('br, gzip; q=0.0'), undefined)
  assert.equal(await coding('x-gzip-like'), undefined)
  assert.equal(await coding('gzip;q=0.5, br'), 'gzip')
  assert.equal(await coding('*'), 'gzip')
  assert.equal(await coding('*, gzip;q=0'), undefined)
})

test('any page may fetch what a figure on it needs', async () => {
  for (const at of ['/sub/path/', '/sub/path/module.wasm', '/sub/path/page-A1B2C3D4.js']) {
    assert.equal((await get(at)).headers['access-control-allow-origin'], '*', at)
  }
})

test('a port that is none is refused before anything is built', () => {
  for (const port of ['abc', '-1', '65536', '80.5', '', '1e3']) {
    const { status, stderr } = spawnSync('bash', ['scripts/serve', `--port=${port}`], {
      cwd: root,
      encoding: 'utf8',
      timeout: HANGS_MS,
    })
    assert.equal(status, 1, port)
    assert.match(stderr, /whole number from 0 to 65535/, port)
    assert.doesNotMatch(stderr, /1\/4|The module/, port)
  }
})
