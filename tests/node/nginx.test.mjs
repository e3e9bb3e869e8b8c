// The nginx example of the page on hosting, read from that page and run in nginx itself over a small site. Skipped
// where there is no nginx, which .ci/run installs (NGINX names one that is not in the usual places).
import { after, before, test } from 'node:test'
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { once } from 'node:events'
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:net'
import { get } from 'node:http'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { fileURLToPath } from 'node:url'
import { HANGS_MS } from '../browser/places.mjs'
import { WORKER_POLICY } from '../../scripts/static-server.mjs'

const root = fileURLToPath(new URL('../..', import.meta.url))
const nginx = [process.env.NGINX, '/usr/sbin/nginx', '/usr/local/bin/nginx', '/opt/homebrew/bin/nginx'].find(
  (program) => program && existsSync(program),
)
/** Which ending is of which type, as Debian's package says it. */
const types = ['/etc/nginx/mime.types', '/usr/local/etc/nginx/mime.types', '/opt/homebrew/etc/nginx/mime.types'].find(
  existsSync,
)
const skip = nginx && types ? false : 'no nginx here; Debian: apt-get install nginx-light'

const LONG = 'The quick brown fox jumps over the lazy dog. '.repeat(100)
const FILES = {
  'index.html': LONG,
  '404.html': `lost ${LONG}`,
  'sw.js': LONG,
  'search.json': LONG,
  'kalman/index.html': LONG,
  'figure/bench/index.html': LONG,
  'assets/page-A1B2C3D4.js': LONG,
  'assets/robot-log-worker-A1B2C3D4.js': LONG,
  'assets/site-A1B2C3D4.css': LONG,
  'assets/module-A1B2C3D4.wasm': LONG,
  'assets/icon-A1B2C3D4.svg': LONG,
  'assets/manifest-A1B2C3D4.webmanifest': LONG,
  'assets/text-A1B2C3D4.woff2': LONG,
}

let home, port
/** @type {import('node:child_process').ChildProcess | undefined} */
let server
before(async () => {
  if (skip) return
  home = mkdtempSync(path.join(tmpdir(), 'nginx-'))
  for (const [name, text] of Object.entries(FILES)) {
    const file = path.join(home, 'site/robot-motion', name)
    mkdirSync(path.dirname(file), { recursive: true })
    writeFileSync(file, text)
  }
  const page = readFileSync(path.join(root, 'content/pages/hosting.md'), 'utf8')
  const [, example] =
    page.match(/^```nginx\n([\s\S]*?)^```$/m) ?? assert.fail('the page on hosting has no nginx example')
  const free = createServer().listen(0, '127.0.0.1')
  await once(free, 'listening')
  port = /** @type {import('node:net').AddressInfo} */ (free.address()).port
  free.close()
  const folders = ['client_body', 'proxy', 'fastcgi', 'uwsgi', 'scgi']
    .map((name) => `${name}_temp_path ${home}/${name};`)
    .join(' ')
  writeFileSync(
    path.join(home, 'nginx.conf'),
    `
    daemon off; master_process off; pid ${home}/pid; error_log ${home}/errors;
    events {}
    http {
      include ${types}; default_type application/octet-stream; access_log off; ${folders}
      server { listen 127.0.0.1:${port}; root ${home}/site; absolute_redirect off;
        ${example}
      }
    }`,
  )
  server = spawn(String(nginx), ['-p', home, '-c', path.join(home, 'nginx.conf'), '-e', path.join(home, 'errors')], {
    stdio: 'inherit',
  })
  for (const end = Date.now() + HANGS_MS; ; ) {
    const up = await ask('').then(
      () => true,
      () => false,
    )
    if (up) break
    const errors = path.join(home, 'errors')
    const said = existsSync(errors) ? readFileSync(errors, 'utf8') : ''
    assert.ok(Date.now() < end && server?.exitCode === null, `nginx does not answer: ${said}`)
    await new Promise((resolve) => setTimeout(resolve, 100))
  }
})
after(async () => {
  if (server && server.exitCode === null) {
    server.kill('SIGTERM')
    await once(server, 'close')
  }
  if (home) rmSync(home, { recursive: true })
})

/** @returns {Promise<{ status: number, headers: import('node:http').IncomingHttpHeaders, text: string }>} */
function ask(at, headers = { 'accept-encoding': 'gzip' }) {
  return new Promise((resolve, reject) => {
    get({ host: '127.0.0.1', port, path: `/robot-motion/${at}`, headers, agent: false }, (response) => {
      let text = ''
      response.on('data', (part) => {
        text += part
      })
      response.on('end', () => resolve({ status: response.statusCode ?? 0, headers: response.headers, text }))
    }).on('error', reject)
  })
}

test("types, also those that Debian's list lacks", { skip }, async () => {
  const wanted = {
    '': /^text\/html/,
    'kalman/': /^text\/html/,
    'search.json': /^application\/json/,
    'assets/page-A1B2C3D4.js': /^(text|application)\/javascript/,
    'assets/site-A1B2C3D4.css': /^text\/css/,
    'assets/module-A1B2C3D4.wasm': /^application\/wasm$/,
    'assets/icon-A1B2C3D4.svg': /^image\/svg\+xml/,
    'assets/manifest-A1B2C3D4.webmanifest': /^application\/manifest\+json/,
    'assets/text-A1B2C3D4.woff2': /^font\/woff2/,
  }
  for (const [at, type] of Object.entries(wanted)) assert.match((await ask(at)).headers['content-type'] ?? '', type, at)
})

test('everything but the fonts is compressed for who takes it, and caches are told', { skip }, async () => {
  for (const at of Object.keys(FILES).filter((name) => name !== '404.html')) {
    const { headers } = await ask(at)
    assert.equal(headers['content-encoding'], at.endsWith('.woff2') ? undefined : 'gzip', at)
    if (!at.endsWith('.woff2')) assert.match(headers.vary ?? '', /Accept-Encoding/, at)
    assert.equal((await ask(at, { 'accept-encoding': 'identity' })).headers['content-encoding'], undefined, at)
  }
})

test('what carries a hash is kept for ever, the rest is asked for again', { skip }, async () => {
  for (const at of Object.keys(FILES).filter((name) => name !== '404.html')) {
    const { 'cache-control': cache } = (await ask(at)).headers
    assert.equal(cache, at.startsWith('assets/') ? 'public, max-age=31536000, immutable' : 'no-cache', at)
  }
})

test('figures may be embedded by anybody, pages by their own site', { skip }, async () => {
  for (const at of ['', 'kalman/']) {
    const { headers } = await ask(at)
    assert.equal(headers['content-security-policy'], "frame-ancestors 'self'", at)
    assert.equal(headers['access-control-allow-origin'], undefined, at)
  }
  for (const at of [
    'figure/bench/',
    'assets/page-A1B2C3D4.js',
    'assets/module-A1B2C3D4.wasm',
    'assets/text-A1B2C3D4.woff2',
  ]) {
    const { headers } = await ask(at)
    assert.equal(headers['content-security-policy'], undefined, at)
    assert.equal(headers['access-control-allow-origin'], '*', at)
  }
})

test('workers come with the policy of workers', { skip }, async () => {
  for (const at of ['sw.js', 'assets/robot-log-worker-A1B2C3D4.js'])
    assert.equal((await ask(at)).headers['content-security-policy'], WORKER_POLICY, at)
})

test("an address that leads nowhere is answered by the book's page for it, with its status", { skip }, async () => {
  for (const at of ['none', 'kalman/none/at/all', 'assets/none.js']) {
    const { status, text } = await ask(at, { 'accept-encoding': 'identity' })
    assert.equal(status, 404, at)
    assert.match(text, /^lost/, at)
  }
})
