/**
 * Connects what computes beside the page with whoever sends the messages: a worker's page, or a page that may not start
 * a worker.
 */

/** @typedef {{ take: (message: any) => void }} Server */

/**
 * @param {import('./worker-port.js').Port} port
 * @param {() => Promise<import('./loader.js').Loaded<any>>} load fetches the module
 * @param {(module: any, tell: (message: any) => void, soon: (act: () => void) => void) => Server} make makes the
 * server; `soon` calls
 *   back once waiting messages have been read
 */
export function attend(port, load, make) {
  /** @type {Server | null} */
  let server = null
  /** @type {any[]} */
  const waiting = []
  const { port1, port2 } = new MessageChannel()
  /** @type {(() => void)[]} */
  const acts = []
  // Behind the messages that wait already, and without the pause of a timer.
  port1.onmessage = () => acts.shift()?.()
  const soon = (/** @type {() => void} */ act) => {
    acts.push(act)
    port2.postMessage(null)
  }
  const begin = async () => {
    const loaded = await load()
    if (!loaded.ok) return port.postMessage({ kind: 'failed', why: loaded.why })
    server = make(loaded.module, (message) => port.postMessage(message), soon)
    for (const message of waiting.splice(0)) server.take(message)
  }
  port.onmessage = ({ data }) => {
    if (data.kind === 'hello') port.postMessage({ kind: 'hello' })
    else if (server) server.take(data)
    else waiting.push(data)
  }
  begin()
}
