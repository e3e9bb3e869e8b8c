// Builds the site again when a source changes, and tells the pages that are open. The static server asks it for two
// addresses of its own and lets it add a script to each page it sends.
import { spawn } from 'node:child_process'
import { readdir, stat } from 'node:fs/promises'
import path from 'node:path'

/** What a build reads. A source that a build writes does not belong here: it would build for ever. */
const SOURCES = ['content', 'web', 'crates', 'Cargo.toml', 'Cargo.lock', '.cargo', 'scripts/build', 'scripts/common.sh']
const SKIPPED = new Set(['node_modules', 'target'])
const INTERVAL = 500

const EVENTS = '/.live/events'
const SCRIPT = '/.live/reload.js'
/** Runs in the page: reloads it after a build, and shows on it why a build failed. */
const PAGE = `
const note = document.createElement('pre')
note.setAttribute('role', 'alert')
Object.assign(note.style, { position: 'fixed', inset: 'auto 0 0 0', zIndex: 99, maxHeight: '60vh' })
Object.assign(note.style, { margin: 0, padding: '1rem', overflow: 'auto', background: '#300', color: '#fff' })
Object.assign(note.style, { font: '13px/1.4 monospace', whiteSpace: 'pre-wrap' })
const events = new EventSource('${EVENTS}')
events.addEventListener('built', () => location.reload())
events.addEventListener('failed', (event) => {
  note.textContent = JSON.parse(event.data)
  document.body.append(note)
})
`
/** In place of the book's service worker: keeps nothing, and takes away one from before, whose pages would be old. */
const WORKER = `
addEventListener('install', () => skipWaiting())
addEventListener('activate', (event) => event.waitUntil(registration.unregister()))
`

export class Rebuilder {
  #root
  #open = new Set()

  /** @param {string} root the folder of the sources */
  constructor(root) {
    this.#root = root
  }

  /** Answers what belongs to watching; false where the address is another. */
  answer(_request, response, pathname) {
    if (pathname === EVENTS) {
      response.writeHead(200, { 'content-type': 'text/event-stream', 'cache-control': 'no-store' })
      response.write(': open\n\n')
      this.#open.add(response)
      response.on('close', () => this.#open.delete(response))
      return true
    }
    const script = { [SCRIPT]: PAGE, '/sw.js': WORKER }[pathname]
    if (script === undefined) return false
    response
      .writeHead(200, { 'content-type': 'text/javascript; charset=utf-8', 'cache-control': 'no-store' })
      .end(script)
    return true
  }

  /** A page as it is sent: with the script that waits for the next build. @param {Buffer} page */
  page(page) {
    return Buffer.from(page.toString('utf8').replace('</head>', `<script src="${SCRIPT}" defer></script></head>`))
  }

  /** Looks for changes and builds after each. @param {AbortSignal} [until] for ever where there is none */
  async watch(until) {
    let seen = await this.#look()
    while (!until?.aborted) {
      await new Promise((resolve) => setTimeout(resolve, INTERVAL))
      const now = await this.#look()
      const changed = [...now].filter(([file, mark]) => seen.get(file) !== mark).map(([file]) => file)
      const gone = [...seen.keys()].filter((file) => !now.has(file))
      seen = now
      if (changed.length + gone.length === 0) continue
      console.log(
        `› Changed: ${[...changed, ...gone].slice(0, 5).join(', ')}${changed.length + gone.length > 5 ? ', …' : ''}`,
      )
      const begun = Date.now()
      const fault = await this.#build()
      if (fault === undefined) console.log(`› Built in ${((Date.now() - begun) / 1000).toFixed(1)} s\n`)
      this.#tell(fault === undefined ? 'built' : 'failed', fault ?? '')
    }
  }

  /** Every source with its time and size. @returns {Promise<Map<string, string>>} */
  async #look() {
    const found = new Map()
    const visit = async (name) => {
      const file = path.join(this.#root, name)
      // A file may go between two looks at it.
      const about = await stat(file).catch(() => null)
      if (about?.isDirectory()) {
        const inside = await readdir(file).catch(() => [])
        await Promise.all(inside.filter((one) => !SKIPPED.has(one)).map((one) => visit(path.join(name, one))))
      } else if (about) {
        found.set(name, `${about.mtimeMs} ${about.size}`)
      }
    }
    await Promise.all(SOURCES.map(visit))
    return found
  }

  /** Runs the build; what it said where it failed. @returns {Promise<string | undefined>} */
  #build() {
    return new Promise((resolve) => {
      const build = spawn(path.join(this.#root, 'scripts/build'), {
        cwd: this.#root,
        stdio: ['ignore', 'inherit', 'pipe'],
      })
      let said = ''
      build.stderr.on('data', (part) => {
        process.stderr.write(part)
        said += part
      })
      build.on('error', (error) => resolve(String(error)))
      build.on('close', (status) => resolve(status === 0 ? undefined : said.trim()))
    })
  }

  /** @param {'built' | 'failed'} event @param {string} what */
  #tell(event, what) {
    for (const response of this.#open) response.write(`event: ${event}\ndata: ${JSON.stringify(what)}\n\n`)
  }
}
