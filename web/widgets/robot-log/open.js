/** Starts the worker of a log's figure, gives it the log, and waits for the first frame. */

import { readState } from '../../figure/state-in-url.js'
import { fetchWithPatience } from '../../load/timeouts.js'
import { openWorker } from '../../load/worker-port.js'
import { RemoteRun } from './remote-run.js'

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
      openWorker(import('robot-log-worker'), 'robot-log', () => import('./server.js')),
      fetchWithPatience(new URL(log, import.meta.url)).then((answer) => answer.arrayBuffer()),
    ])
    const run = new RemoteRun(port, spec.pace ?? 2)
    const name = spec.log?.split('/').pop() ?? 'log.csv'
    const read = await run.read({ kind: 'files', files: [new File([bytes], name)] })
    if (read.kind !== 'log') return { ok: false, why: read.why ?? `its log is wrong: ${read.message}` }
    const page = JSON.parse(given ?? '{}')
    const usual = { params: { ...spec.start.params, ...page.params }, step: page.step ?? spec.start.step }
    const linked = readState(location.href, id, spec.name)
    const wish =
      linked === null || linked === 'mangled' ? usual : { ...linked, step: Math.min(linked.step, read.contents.steps) }
    const { refused } = await run.begin(wish)
    const mangled = linked === 'mangled' || refused !== null
    const why = refused === null ? null : (await run.begin(usual)).refused
    if (why !== null) return { ok: false, why }
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
