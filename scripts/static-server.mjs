// A small static server for dist/, on this machine only: the types a browser needs, gzip, and nothing outside the folder.
// The browser tests use it too, from a sub-path. As a program: node scripts/static-server.mjs FOLDER [PORT]
import { createServer } from 'node:http'
import { readFile, realpath, stat } from 'node:fs/promises'
import { createHash } from 'node:crypto'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { gzipSync } from 'node:zlib'

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.ico': 'image/x-icon',
  '.woff2': 'font/woff2',
  '.wasm': 'application/wasm',
  '.txt': 'text/plain; charset=utf-8',
  '.xml': 'application/xml; charset=utf-8',
}
const PACKED = new Set(['.html', '.css', '.js', '.mjs', '.json', '.webmanifest', '.svg', '.wasm', '.txt', '.xml'])

/**
 * Serves `folder` under `base` on loopback.
 * @param {{ folder: string, base?: string, port?: number, host?: string }} options port 0: any free one
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve({ folder, base = '/', port = 0, host = '127.0.0.1' }) {
  const root = await realpath(folder)
  /** @type {Map<string, Buffer>} */
  const packed = new Map()

  const server = createServer(async (request, response) => {
    try {
      if (request.method !== 'GET' && request.method !== 'HEAD') return answer(response, 405, 'Only GET and HEAD.')
      const url = new URL(request.url ?? '/', 'http://host')
      const wanted = decodeURIComponent(url.pathname)
      if (wanted + '/' === base) return redirect(response, base)
      if (!wanted.startsWith(base) || wanted.includes('\0')) return answer(response, 404, 'Not found.')
      let file = path.join(root, wanted.slice(base.length))
      if ((await stat(file)).isDirectory()) {
        if (!wanted.endsWith('/')) return redirect(response, url.pathname + '/' + url.search)
        file = path.join(file, 'index.html')
      }
      file = await realpath(file)
      if (file !== root && !file.startsWith(root + path.sep)) return answer(response, 404, 'Not found.')
      const body = await readFile(file)
      const extension = path.extname(file)
      const tag = `"${createHash('sha256').update(body).digest('base64url').slice(0, 22)}"`
      response.setHeader('etag', tag)
      response.setHeader('vary', 'accept-encoding')
      // A name that carries its content's hash never changes its content.
      response.setHeader('cache-control', /[-.][0-9A-Za-z]{8,}\.\w+$/.test(file) ? 'public, max-age=31536000, immutable' : 'no-cache')
      if (request.headers['if-none-match'] === tag) return response.writeHead(304).end()
      response.setHeader('content-type', TYPES[extension] ?? 'application/octet-stream')
      let sent = body
      if (PACKED.has(extension) && /\bgzip\b/.test(request.headers['accept-encoding'] ?? '')) {
        if (!packed.has(tag)) packed.set(tag, gzipSync(body, { level: 9 }))
        sent = /** @type {Buffer} */ (packed.get(tag))
        response.setHeader('content-encoding', 'gzip')
      }
      response.setHeader('content-length', sent.length)
      response.end(request.method === 'HEAD' ? undefined : sent)
    } catch (error) {
      const missing = ['ENOENT', 'ENOTDIR', 'ENAMETOOLONG', 'ELOOP'].includes(error?.code) || error instanceof URIError
      if (missing) await lost(root, response)
      else answer(response, 500, 'The server could not read that.')
    }
  })

  await new Promise((resolve, reject) => {
    server.once('error', reject)
    server.listen(port, host, () => resolve(undefined))
  })
  const address = /** @type {import('node:net').AddressInfo} */ (server.address())
  return {
    url: `http://${host}:${address.port}${base}`,
    close: () => new Promise((resolve) => { server.close(() => resolve()); server.closeAllConnections() }),
  }
}

/** As static hosts do: at an address that leads nowhere, the folder's own page for that. */
async function lost(root, response) {
  const page = await readFile(path.join(root, '404.html')).catch(() => null)
  if (!page || response.headersSent) return answer(response, 404, 'Not found.')
  response.writeHead(404, { 'content-type': TYPES['.html'] }).end(page)
}

function answer(response, status, text) {
  if (response.headersSent) return response.destroy()
  response.writeHead(status, { 'content-type': 'text/plain; charset=utf-8' }).end(text + '\n')
}

function redirect(response, location) {
  response.writeHead(308, { location }).end()
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const [folder = 'dist', port] = process.argv.slice(2)
  const first = port === undefined ? 8015 : Number(port)
  if (!Number.isInteger(first) || first < 0 || first > 65535) {
    console.error(`✗ '${port}' is no port: a whole number from 0 to 65535 is.`)
    process.exit(1)
  }
  // Without a wish, the next free port will do.
  for (let at = first; ; at++) {
    try {
      const { url } = await serve({ folder, port: at })
      console.log(`\n  The chapter is at ${url}kalman/   (the cover: ${url})\n  Ctrl-C stops.\n`)
      break
    } catch (error) {
      if (error?.code === 'EADDRINUSE' && port === undefined && at < first + 50) continue
      console.error(`✗ Cannot serve ${folder} on port ${at}: ${error?.message ?? error}`)
      process.exit(1)
    }
  }
}
