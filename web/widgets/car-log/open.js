/** The car's log and its lab, which stands on the log: fetched once for the figure and for what it computes beside. */

import { Run } from '../../figure/run.js'
import { openLab } from '../../figure/open-lab.js'
import { fetchWithPatience } from '../../load/timeouts.js'

/** @typedef {import('../../figure/spec.js').Opened} Opened */

/** @type {Promise<any> | null} */
let known = null

/** A class of labs that are all of the car's log. */
export function carLab() {
  known ??= load().catch((error) => {
    known = null
    throw error
  })
  return known
}

async function load() {
  const [{ loadLab }, { default: address }] = await Promise.all([
    import('../../load/modules.js'),
    import('../../../content/logs/car.csv'),
  ])
  const [loaded, text] = await Promise.all([
    loadLab('car-log'),
    fetchWithPatience(new URL(address, import.meta.url)).then((answer) => answer.text()),
  ])
  if (!loaded.ok) throw new Error(loaded.why)
  const { CarLog } = loaded.module
  return of(CarLog, CarLog.parse(text))
}

/** The class `CarLog` on one log, whose labs are made of a state alone. @param {any} CarLog @param {any} log */
export function of(CarLog, log) {
  const Lab = {
    parameters: () => CarLog.parameters(),
    from: (/** @type {any} */ state) => Object.defineProperty(CarLog.from(log, state), 'constructor', { value: Lab }),
  }
  return Lab
}

/**
 * @param {string} id the figure's
 * @param {string | undefined} given the page's own start, in JSON
 * @param {import('../../figure/spec.js').FigureSpec} spec
 * @returns {Promise<Opened>}
 */
export async function open(id, given, spec) {
  try {
    const { lab, linked, mangled } = openLab({ CarLog: await carLab() }, spec, id, given)
    return { ok: true, run: new Run(linked?.lab ?? lab, spec.pace ?? 2), mangled }
  } catch (error) {
    const lost = error instanceof TypeError || (error instanceof DOMException && error.name === 'AbortError')
    return { ok: false, why: lost ? 'its log could not be fetched' : /** @type {Error} */ (error).message }
  }
}
