// A small static server for dist/, on this machine only: the types a browser needs, gzip, and nothing outside the
// folder. The browser tests use it too, from a sub-path.
import { createServer } from 'node:http'
import { readFile, realpath, stat } from 'node:fs/promises'
import { createHash } from 'node:crypto'
import path from 'node:path'
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
 * The policy of a page's meta element does not bind a worker that is fetched by its address: the answer that brings it
 * does.
 */
export const WORKER_POLICY = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'"
const WORKERS = /^(sw|[\w-]+-worker-\w+)\.js$/

/**
 * @typedef {object} Live what answers addresses of its own and may add to pages
 * @property {(request: import('node:http').IncomingMessage, response: import('node:http').ServerResponse, pathname:
 * string) => boolean} answer
 * @property {(page: Buffer) => Buffer} page
 */

/**
 * Serves `folder` under `base` on loopback.
 * @param {{ folder: string, base?: string, port?: number, host?: string, live?: Live }} options port 0: any free one
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve({ folder, base = '/', port = 0, host = '127.0.0.1', live }) {
  const root = await realpath(folder)
  /** @type {Map<string, Buffer>} */
  const packed = new Map()

  const server = createServer(async (request, response) => {
    try {
      if (request.method !== 'GET' && request.method !== 'HEAD') return answer(response, 405, 'Only GET and HEAD.')
      const url = readAddress(request.url ?? '/')
      if (!url) return answer(response, 400, 'That address cannot be read.')
      const wanted = decodeURIComponent(url.pathname)
      if (live?.answer(request, response, wanted)) return
      if (`${wanted}/` === base) return redirect(response, base)
      if (!wanted.startsWith(base) || wanted.includes('\0')) return answer(response, 404, 'Not found.')
      let file = path.join(root, wanted.slice(base.length))
      if ((await stat(file)).isDirectory()) {
        // One slash in front: a browser reads two as the name of another host.
        if (!wanted.endsWith('/')) return redirect(response, `${url.pathname.replace(/^\/+/, '/')}/${url.search}`)
        file = path.join(file, 'index.html')
      }
      file = await realpath(file)
      if (file !== root && !file.startsWith(root + path.sep)) return answer(response, 404, 'Not found.')
      const extension = path.extname(file)
      const content = await readFile(file)
      const body = live && extension === '.html' ? live.page(content) : content
      const tag = `"${createHash('sha256').update(body).digest('base64url').slice(0, 22)}"`
      response.setHeader('etag', tag)
      // A figure in a sandboxed frame of another page has no origin of its own, and fetches as a stranger.
      response.setHeader('access-control-allow-origin', '*')
      response.setHeader('vary', 'accept-encoding')
      // A name that carries its content's hash never changes its content.
      response.setHeader(
        'cache-control',
        /[-.][0-9A-Za-z]{8,}\.\w+$/.test(file) ? 'public, max-age=31536000, immutable' : 'no-cache',
      )
      if (WORKERS.test(path.basename(file))) response.setHeader('content-security-policy', WORKER_POLICY)
      if (request.headers['if-none-match'] === tag) return response.writeHead(304).end()
      response.setHeader('content-type', TYPES[extension] ?? 'application/octet-stream')
      let sent = body
      if (PACKED.has(extension) && takesGzip(request.headers['accept-encoding'] ?? '')) {
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
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve())
        server.closeAllConnections()
      }),
  }
}

/**
 * A request's address: a path, or a whole address as a proxy writes it; null where it is neither.
 * @param {string} target
 */
function readAddress(target) {
  try {
    return new URL(target.startsWith('/') ? `http://host${target}` : target)
  } catch {
    return null
  }
}

/** Whether an Accept-Encoding header takes gzip: a coding or `*` without `q=0`. @param {string} header */
function takesGzip(header) {
  const weights = new Map(
    header
      .toLowerCase()
      .split(',')
      .map((part) => {
        const [coding, ...parameters] = part.split(';').map((word) => word.trim())
        const weight = parameters.find((word) => word.startsWith('q='))
        return [coding, weight ? Number(weight.slice(2)) : 1]
      }),
  )
  return (weights.get('gzip') ?? weights.get('*') ?? 0) > 0
}

/** As static hosts do: at an address that leads nowhere, the folder's own page for that. */
async function lost(root, response) {
  const page = await readFile(path.join(root, '404.html')).catch(() => null)
  if (!page || response.headersSent) return answer(response, 404, 'Not found.')
  response.writeHead(404, { 'content-type': TYPES['.html'] }).end(page)
}

function answer(response, status, text) {
  if (response.headersSent) return response.destroy()
  response.writeHead(status, { 'content-type': 'text/plain; charset=utf-8' }).end(`${text}\n`)
}

function redirect(response, location) {
  response.writeHead(308, { location }).end()
}
