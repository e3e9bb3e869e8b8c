/** Starts the worker of a log's figure, gives it the log, and waits for the first frame. */

import { readState } from '../../figure/state-in-url.js'
import { fetchWithPatience } from '../../load/timeouts.js'
import { openPort } from '../../load/worker-port.js'
import { RemoteRun } from './remote-run.js'

/** @typedef {import('../../load/worker-port.js').Port} Port */
/** @typedef {{ ok: true, run: RemoteRun, mangled: boolean } | { ok: false, why: string }} Opened */

/**
 * @param {string} log the log's address
 * @param {import('../../figure/spec.js').FigureSpec} spec
 * @param {string} id the figure's
 * @param {string | undefined} given the page's own start, in JSON
 * @returns {Promise<Opened>}
 */
export async function openRun(log, spec, id, given) {
  try {
    const [port, bytes] = await Promise.all([
      start(),
      fetchWithPatience(new URL(log, import.meta.url)).then((answer) => answer.arrayBuffer()),
    ])
    const read = await ask(port, { kind: 'files', files: [new File([bytes], spec.log?.split('/').pop() ?? 'log.csv')] })
    if (read.kind !== 'log') return { ok: false, why: read.why ?? `its log is wrong: ${read.message}` }
    const page = JSON.parse(given ?? '{}')
    const usual = { params: { ...spec.start.params, ...page.params }, step: page.step ?? spec.start.step }
    const linked = readState(location.href, id, spec.name)
    const wish =
      linked === null || linked === 'mangled' ? usual : { ...linked, step: Math.min(linked.step, read.contents.steps) }
    let there = await ask(port, { kind: 'go', id: 0, ...wish })
    const mangled = linked === 'mangled' || there.kind === 'refused'
    if (there.kind === 'refused') there = await ask(port, { kind: 'go', id: 0, ...usual })
    if (there.kind !== 'there') return { ok: false, why: there.why ?? there.message }
    const run = new RemoteRun(port, there.frame, read.parameters, spec.pace ?? 2)
    run.digest = there.digest
    run.contents = read.contents
    return { ok: true, run, mangled }
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError')
      return { ok: false, why: 'the server does not answer' }
    return {
      ok: false,
      why: error instanceof TypeError ? 'its log could not be fetched' : /** @type {Error} */ (error).message,
    }
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

/** @returns {Promise<Port>} */
async function start() {
  const { default: address } = await import('robot-log-worker')
  return openPort(address, async () => {
    const [{ serve }, { loadLab }] = await Promise.all([import('./server.js'), import('../../load/modules.js')])
    return (port) => serve(port, () => loadLab('robot-log'))
  })
}
