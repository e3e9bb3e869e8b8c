/**
 * Starts a worker, or, where a page may start none (a frame without an origin of its own), the same code in the page
 * itself.
 */

import { PATIENCE_MS } from './timeouts.js'

/** @typedef {{ postMessage: (message: any) => void, onmessage: ((event: MessageEvent) => void) | null }} Port */

/**
 * @param {string} address of the worker's script, beside this one
 * @param {() => Promise<(port: Port) => void>} inPage fetches what serves a port in the page, which computes in chunks
 * as a worker does
 * @returns {Promise<Port>}
 */
export async function openPort(address, inPage) {
  try {
    return await started(new Worker(new URL(address, import.meta.url), { type: 'module' }))
  } catch {
    const { port1, port2 } = new MessageChannel()
    const serve = await inPage()
    serve(port2)
    return port1
  }
}

/** Waits until the worker says that it runs. @param {Worker} worker @returns {Promise<Port>} */
function started(worker) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('its worker does not answer')), 3 * PATIENCE_MS)
    worker.onerror = () => {
      clearTimeout(timer)
      reject(new Error('its worker could not be started'))
    }
    worker.onmessage = () => {
      clearTimeout(timer)
      resolve(worker)
    }
    worker.postMessage({ kind: 'hello' })
  })
}
