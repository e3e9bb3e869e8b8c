// Lighthouse's mobile run of a page, for the test and for whoever wants numbers: `node
// tests/browser/tools/lighthouse.mjs [PAGE] [RUNS]` prints the performance of five runs on the chapter, and the median.
import { createServer } from 'node:net'
import { once } from 'node:events'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'
import lighthouse from 'lighthouse'
import { ProtocolSession } from 'lighthouse/core/gather/session.js'
import { serve } from '../../../scripts/static-server.mjs'
import { BASE, CHROMIUM_FLAGS, chromiumPath, dist, HANGS_MS } from '../places.mjs'

/**
 * Lighthouse gives up an answer of the browser after half a minute, and with it what it was asked for: on a busy one
 * the listeners of the chapter's links take longer. Where it says no time of its own, it waits as the tests do.
 */
Object.assign(ProtocolSession.prototype, {
  hasNextProtocolTimeout: () => true,
  /** @this {{ _nextProtocolTimeout: number | undefined }} */
  getNextProtocolTimeout() {
    return this._nextProtocolTimeout || HANGS_MS
  },
})

/** A served site and a browser that Lighthouse can drive. `run` gives Lighthouse's report on a page. */
export async function tower() {
  const probe = createServer().listen(0, '127.0.0.1')
  await once(probe, 'listening')
  const { port } = /** @type {import('node:net').AddressInfo} */ (probe.address())
  probe.close()
  const site = await serve({ folder: dist, base: BASE })
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: [...CHROMIUM_FLAGS, `--remote-debugging-port=${port}`],
    timeout: HANGS_MS,
  })
  return {
    run: async (at, options = {}) =>
      /** @type {any} */ (
        await lighthouse(site.url + at, {
          port,
          output: 'json',
          logLevel: 'error',
          maxWaitForFcp: HANGS_MS,
          ...options,
        })
      ).lhr,
    close: async () => {
      await browser.close()
      await site.close()
    },
  }
}

/** Performance in hundredths, and what makes it up, in words. */
export function performanceOf({ categories, audits }) {
  const shown = (name, what) => `${what} ${audits[name].displayValue}`
  return {
    score: Math.round((categories.performance.score ?? 0) * 100),
    words: [
      shown('first-contentful-paint', 'first paint'),
      shown('largest-contentful-paint', 'largest'),
      shown('speed-index', 'speed index'),
      shown('total-blocking-time', 'blocking'),
      shown('cumulative-layout-shift', 'shift'),
    ].join(', '),
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  const [at = 'kalman/', runs = '5'] = process.argv.slice(2)
  const { run, close } = await tower()
  const scores = []
  try {
    for (let i = 0; i < Number(runs); i++) {
      const { score, words } = performanceOf(await run(at, { onlyCategories: ['performance'] }))
      scores.push(score)
      console.log(`${score}: ${words}`)
    }
  } finally {
    await close()
  }
  console.log(`/${at}: median ${scores.sort((a, b) => a - b)[Math.floor(scores.length / 2)]} of ${scores.length} runs`)
}
