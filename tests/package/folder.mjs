// An empty folder with the packed package installed in it, and a browser for what is built there.
import { execFile } from 'node:child_process'
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, realpathSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import path from 'node:path'
import { after } from 'node:test'
import { fileURLToPath } from 'node:url'
import { promisify } from 'node:util'
import { serve } from '../../scripts/static-server.mjs'
import { CHROMIUM_FLAGS, chromiumPath, HANGS_MS } from '../browser/places.mjs'

export const root = fileURLToPath(new URL('../..', import.meta.url))
const { chromium } = createRequire(new URL('../browser/package.json', import.meta.url))('playwright-core')
export const run = promisify(execFile)

const packed = path.join(root, 'target/npm')
export const tarball = path.join(
  packed,
  readdirSync(packed).find((name) => name.endsWith('.tgz')) ?? 'nothing: run ./scripts/package',
)
const home = realpathSync(mkdtempSync(path.join(tmpdir(), 'package-')))
after(() => rmSync(home, { recursive: true, force: true }))

/** A new folder of these files (name → text), with the package installed from its tarball and nothing else. */
export async function folder(name, files = {}) {
  const place = path.join(home, name)
  mkdirSync(place)
  for (const [file, text] of Object.entries({ 'package.json': '{ "private": true }', ...files }))
    writeFileSync(path.join(place, file), text)
  await run('npm', ['install', '--offline', '--no-audit', '--no-fund', '--loglevel=error', tarball], { cwd: place })
  return place
}

/** The installed files of the package. */
export const installed = (place) => path.join(place, 'node_modules', NAME)

/** What Node prints when it runs this file. */
export const node = async (place, file) => (await run(process.execPath, [file], { cwd: place })).stdout.trim()

/** The examples of the package's pages and of the book's README: file name → text. */
const readmes = ['crates/estimate-wasm/README.md', 'crates/estimate-wasm/COMING-FROM.md', 'README.md']
  .map((name) => readFileSync(path.join(root, name), 'utf8'))
  .join('\n')
export const EXAMPLES = Object.fromEntries(
  [...readmes.matchAll(/^```\w+ file=(\S+)\n([\s\S]*?)^```$/gm)].map(([, file, text]) => [file, text]),
)
/** The package's name, from the one place where it stands. */
export const NAME = /\[package\.metadata\.npm\]\nname = "(.+)"/.exec(
  readFileSync(path.join(root, 'crates/estimate-wasm/Cargo.toml'), 'utf8'),
)[1]

/**
 * Serves a folder, opens a page of it in Chromium, and answers what the page puts into `window.answer`.
 * @param {RegExp} [expected] faults that the page is to have
 */
export async function answerOf(place, page = 'index.html', expected) {
  const server = await serve({ folder: place })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS, timeout: HANGS_MS })
  try {
    const tab = await browser.newPage()
    tab.setDefaultTimeout(HANGS_MS)
    tab.setDefaultNavigationTimeout(HANGS_MS)
    const faults = []
    tab.on('console', (message) => {
      const fault = ['error', 'warning'].includes(message.type()) && !expected?.test(message.text())
      if (fault) faults.push(message.text())
    })
    tab.on('pageerror', (error) => faults.push(String(error)))
    tab.on('request', (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(server.url)) faults.push(request.url())
    })
    await tab.goto(server.url + page)
    const failed = new Promise((_, reject) => {
      tab.on('pageerror', (error) => reject(error))
    })
    const answered = tab.waitForFunction(() => globalThis.answer).then((handle) => handle.jsonValue())
    const answer = await Promise.race([answered, failed]).catch((error) => {
      throw new Error(`${error.message}\n${faults.join('\n')}`)
    })
    if (faults.length > 0) throw new Error(faults.join('\n'))
    return answer
  } finally {
    await browser.close()
    await server.close()
  }
}
