// What the first view of the chapter costs over the wire: everything fetched until the first figure is alive,
// compressed as a static host sends it. A program prints the table of the README; a test holds it under its bound.
import { gzipSync } from 'node:zlib'
import { readFileSync } from 'node:fs'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, DESKTOP, chromiumPath, dist, root } from '../places.mjs'
import { FIGURES } from '../../../target/figures.js'

/** [kind, bytes][] of the chapter's first view, from an empty cache. */
export async function firstView() {
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: CHROMIUM_FLAGS })
  try {
    // The service worker fetches the rest for later, after the view: it is not part of it.
    const context = await browser.newContext({ viewport: DESKTOP, serviceWorkers: 'block' })
    const page = await context.newPage()
    const wire = await context.newCDPSession(page)
    await wire.send('Network.enable')
    // How far ahead a browser fetches pictures goes with the connection: this is the usual one, without a limit.
    await wire.send('Network.emulateNetworkConditions', {
      offline: false,
      latency: 1,
      downloadThroughput: -1,
      uploadThroughput: -1,
      connectionType: 'cellular4g',
    })
    const names = new Map(),
      sizes = []
    wire.on('Network.responseReceived', ({ requestId, response }) =>
      names.set(requestId, new URL(response.url).pathname),
    )
    wire.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
      // The browser asks for its tab's picture by itself, now before the view is there and now after.
      if (names.has(requestId) && !/\/favicon[^/]*$/.test(names.get(requestId)))
        sizes.push([names.get(requestId), encodedDataLength])
    })
    await page.goto(`${site.url}kalman/`, { waitUntil: 'networkidle' })
    const first = page.locator('.widget').first()
    await first.scrollIntoViewIfNeeded()
    await page.locator('.widget[data-state="live"]').first().waitFor()
    await page.waitForLoadState('networkidle')
    return sizes
  } finally {
    await browser.close()
    await site.close()
  }
}

export function kindOf(name) {
  if (name.endsWith('/')) return 'page'
  return (
    { '.css': 'styles', '.js': 'scripts', '.wasm': 'module', '.woff2': 'fonts', '.json': 'data', '.svg': 'pictures' }[
      path.extname(name)
    ] ?? 'other'
  )
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const sizes = await firstView()
  const kilo = (bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB`
  const kinds = new Map()
  for (const [name, bytes] of sizes) kinds.set(kindOf(name), (kinds.get(kindOf(name)) ?? 0) + bytes)
  console.log('| first view of the chapter, compressed | |\n|---|---:|')
  for (const [kind, bytes] of [...kinds].sort((a, b) => b[1] - a[1])) console.log(`| ${kind} | ${kilo(bytes).trim()} |`)
  console.log(`| **together** | **${kilo(sizes.reduce((sum, [, bytes]) => sum + bytes, 0)).trim()}** |`)
  for (const folder of new Set(['web', ...FIGURES.map(({ build }) => build)])) {
    const binary = readFileSync(path.join(root, 'target/pkg', folder, 'estimate_wasm_bg.wasm'))
    const figures = FIGURES.filter(({ build }) => build === folder).map(({ name }) => name)
    const what = figures.length > 0 ? `The build \`${folder}\`, for ${figures.join(', ')}` : 'The whole module'
    console.log(`\n${what}: ${kilo(gzipSync(binary, { level: 9 }).length).trim()} with gzip -9.`)
  }
  if (process.argv.includes('--files'))
    for (const [name, bytes] of sizes.sort((a, b) => b[1] - a[1])) console.log(kilo(bytes), name)
}
