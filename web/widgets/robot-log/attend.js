/** Connects a server of logs with whoever sends the messages: a worker's page, or a page that may not start a worker. */

import { Server } from './server.js'

/**
 * @param {{ postMessage: (message: any) => void, onmessage: ((event: MessageEvent) => void) | null }} port
 * @param {() => Promise<import('../../core/start.js').Loaded<any>>} load
 */
export function attend(port, load) {
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
    server = new Server(loaded.module, (message) => port.postMessage(message), soon)
    for (const message of waiting.splice(0)) server.take(message)
  }
  port.onmessage = ({ data }) => {
    if (data.kind === 'hello') port.postMessage({ kind: 'hello' })
    else if (server) server.take(data)
    else waiting.push(data)
  }
  begin()
}
