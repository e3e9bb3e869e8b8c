// Somebody else's page with a figure in a frame.
import assert from 'node:assert/strict'
import { createServer } from 'node:http'
import { once } from 'node:events'
import { HANGS_MS, stage, tagOf, watch } from './harness.mjs'

/**
 * A page around one frame, served from a port of its own. It keeps every message it gets and gives the frame its
 * height.
 *
 * @param {any} t
 * @param {{ src?: string, sandbox?: string, width?: number, markup?: string }} wishes `markup` in place of the others
 */
export async function around(t, { src, sandbox = 'allow-scripts', width = 700, markup }) {
  const frame =
    markup ??
    `<iframe src="${src}" title="A figure" sandbox="${sandbox}" width="${width}" height="300" ` +
      'style="border: 0"></iframe>'
  const html = `<!doctype html><html lang="en"><title>Somebody else's page</title><h1>Somebody else's page</h1>${frame}
    <script>
      messages = []
      addEventListener('message', ({ data, source, origin }) => {
        const frame = document.querySelector('iframe')
        messages.push({ data, origin, ours: source === frame.contentWindow })
        if (source === frame.contentWindow && data.type === 'robot-motion:height') frame.height = data.height
      })
    </script>`
  const server = createServer((request, response) =>
    response
      .writeHead(request.url === '/' ? 200 : 204, { 'content-type': 'text/html' })
      .end(request.url === '/' ? html : undefined),
  )
  server.listen(0, '127.0.0.1')
  await once(server, 'listening')
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address())
  const home = `http://127.0.0.1:${port}/`
  const { browser, site } = await stage()
  const context = await browser.newContext({ viewport: { width: 900, height: 900 }, reducedMotion: 'reduce' })
  const page = await context.newPage()
  const complaints = watch(page, home, site.url)
  t.after(async () => {
    await context.close()
    server.closeAllConnections()
    server.close()
    assert.deepEqual(complaints, [], 'the page complained')
  })
  await page.goto(home)
  return { page, frame: page.frameLocator('iframe'), inner: () => page.frames()[1] }
}

/** The figure in the frame, alive, and its state as it is when nothing is left to compute. */
export async function lively(frame, name) {
  const tag = tagOf(name)
  const it = frame.locator(tag)
  await frame.locator(`${tag}[data-state="live"]`).waitFor()
  return it
}
export const stateOf = (it) =>
  it.evaluate(async (host) => {
    do await new Promise((resolve) => requestAnimationFrame(resolve))
    while (!host.settled)
    return JSON.stringify(host.state)
  })
export async function changes(it, act, what) {
  const before = await stateOf(it)
  await act()
  for (const end = Date.now() + HANGS_MS; (await stateOf(it)) === before; )
    assert.ok(Date.now() < end, `${what} changes nothing`)
}
