/** Starts the worker of a log's figure, gives it the log, and waits for the first frame. */

import { readState } from '../../core/link.js'
import { PATIENCE_MS, fetchWithPatience } from '../../core/patience.js'
import { RemoteRun } from './remote-run.js'

/** @typedef {import('./remote-run.js').Port} Port */
/** @typedef {{ ok: true, run: RemoteRun, mangled: boolean } | { ok: false, why: string }} Opened */

/**
 * @param {string} log the log's address
 * @param {import('../../core/spec.js').FigureSpec} spec
 * @param {string} id the figure's
 * @param {string | undefined} given the page's own start, in JSON
 * @returns {Promise<Opened>}
 */
export async function openRun(log, spec, id, given) {
  try {
    const [port, bytes] = await Promise.all([start(), fetchWithPatience(new URL(log, import.meta.url)).then((answer) => answer.arrayBuffer())])
    const read = await ask(port, { kind: 'log', bytes: new Uint8Array(bytes) })
    if (read.kind !== 'log') return { ok: false, why: read.why ?? `its log is wrong: ${read.message}` }
    const page = JSON.parse(given ?? '{}')
    const usual = { params: { ...spec.start.params, ...page.params }, step: page.step ?? spec.start.step }
    const linked = readState(location.href, id, spec.name)
    const wish = linked === null || linked === 'mangled' ? usual : linked
    let there = await ask(port, { kind: 'go', id: 0, ...wish })
    const mangled = linked === 'mangled' || there.kind === 'refused'
    if (there.kind === 'refused') there = await ask(port, { kind: 'go', id: 0, ...usual })
    if (there.kind !== 'there') return { ok: false, why: there.why ?? there.message }
    const run = new RemoteRun(port, there.frame, read.parameters, spec.pace ?? 2)
    run.digest = there.digest
    return { ok: true, run, mangled }
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return { ok: false, why: 'the server does not answer' }
    return { ok: false, why: error instanceof TypeError ? 'its log could not be fetched' : /** @type {Error} */ (error).message }
  }
}

/** The next answer that is no word of progress. @param {Port} port @param {any} message @returns {Promise<any>} */
function ask(port, message) {
  return new Promise((resolve) => {
    port.onmessage = ({ data }) => {
      if (data.kind !== 'progress') resolve(data)
    }
    port.postMessage(message)
  })
}

/**
 * A worker; where a page may start none (a frame without an origin of its own), the same code in the page itself, which computes in
 * chunks all the same.
 * @returns {Promise<Port>}
 */
async function start() {
  const { default: address } = await import('robot-log-worker')
  try {
    return await started(new Worker(new URL(address, import.meta.url), { type: 'module' }))
  } catch {
    const { port1, port2 } = new MessageChannel()
    const [{ attend }, { loadLog }] = await Promise.all([import('./attend.js'), import('./module.js')])
    attend(port2, loadLog)
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
