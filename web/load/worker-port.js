/**
 * The way to what computes beside the page: a worker, or, where a page may start none (a frame without an origin of its
 * own), the same code in the page itself.
 */

import { PATIENCE_MS } from './timeouts.js'

/** @typedef {{ postMessage: (message: any) => void, onmessage: ((event: MessageEvent) => void) | null }} Channel */
/** @typedef {{ channel: Channel, end: (() => void) | null }} Line `end` is null where it cannot be ended */

/** What a reader is told of a fault, and of one that comes again. */
const FAULT = 'The program met a fault of its own and was started anew.'
const LOST = 'The program met a fault of its own. Load the page again to go on.'

/**
 * @param {string} address of the worker's script, beside this one
 * @param {() => Promise<(channel: Channel) => void>} inPage fetches what serves a channel in the page, which computes
 * in chunks as a worker does
 */
export async function openPort(address, inPage) {
  /** @returns {Promise<Line>} */
  const start = async () => {
    try {
      const worker = await started(new Worker(new URL(address, import.meta.url), { type: 'module' }))
      return { channel: worker, end: () => worker.terminate() }
    } catch {
      const { port1, port2 } = new MessageChannel()
      const serve = await inPage()
      serve(port2)
      return { channel: port1, end: null }
    }
  }
  return new Port(await start(), start)
}

/**
 * The way to the worker that computes with one figure's lab, or to the same code in the page.
 * @param {Promise<{ default: string }>} worker its script's address, which the build knows
 * @param {string} name the figure's
 * @param {() => Promise<{ serve: (channel: Channel, load: () => Promise<any>) => void }>} server fetches what answers
 */
export async function openWorker(worker, name, server) {
  const { default: address } = await worker
  return openPort(address, async () => {
    const [{ serve }, { loadLab }] = await Promise.all([server(), import('./modules.js')])
    return (channel) => serve(channel, () => loadLab(name))
  })
}

/** Waits until the worker says that it runs. @param {Worker} worker @returns {Promise<Worker>} */
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

/**
 * Each question has one answer, whatever happens: `{ kind: 'ended', message }` where what computes was ended meanwhile.
 * What is told without a question comes to `onmessage`; so does `{ kind: 'ended', message }`, once another has been
 * started that knows nothing of what was before.
 */
export class Port {
  /** @param {Line} line @param {() => Promise<Line>} start starts another */
  constructor(line, start) {
    this.start = start
    /** Null while another is started. @type {Line | null} */
    this.line = null
    /** What is sent once it has been. @type {any[]} */
    this.held = []
    /** Who waits for the answer to a question, by its number. @type {Map<number, (answer: any) => void>} */
    this.waiting = new Map()
    this.asked = 0
    /** Whether the present one has answered a question. */
    this.proved = false
    /** Why nothing is answered any more. */
    this.lost = ''
    /** @type {((message: any) => void) | null} */
    this.onmessage = null
    this.take(line)
  }

  /** @param {Line} line */
  take(line) {
    this.line = line
    line.channel.onmessage = ({ data }) => this.hear(data)
    for (const message of this.held.splice(0)) line.channel.postMessage(message)
  }

  /** @param {any} message */
  post(message) {
    if (this.lost) queueMicrotask(() => this.onmessage?.({ kind: 'ended', message: this.lost }))
    else if (this.line) this.line.channel.postMessage(message)
    else this.held.push(message)
  }

  /** @param {any} message @returns {Promise<any>} */
  ask(message) {
    if (this.lost) return Promise.resolve({ kind: 'ended', message: this.lost })
    const ask = (this.asked += 1)
    return new Promise((resolve) => {
      this.waiting.set(ask, resolve)
      this.post({ ...message, ask })
    })
  }

  /** @param {any} message */
  hear(message) {
    if (message.kind === 'fault') return this.restart(FAULT, true)
    const answer = this.waiting.get(message.ask)
    if (!answer) return this.onmessage?.(message)
    this.waiting.delete(message.ask)
    this.proved = true
    answer(message)
  }

  /**
   * Ends what computes, in the middle of whatever it does, and starts another.
   * @param {string} why for the reader
   * @param {boolean} [fault] whether it ended by a fault: one that met it before it answered anything is the last
   */
  async restart(why, fault = false) {
    const { line } = this
    if (!line) return
    this.line = null
    line.end?.()
    line.channel.onmessage = null
    if (fault && !this.proved) return this.lose()
    this.proved = false
    this.tell(why)
    try {
      this.take(await this.start())
    } catch {
      this.lose()
    }
  }

  lose() {
    this.lost = LOST
    this.held = []
    this.tell(LOST)
  }

  /** Tells everybody that what was under way is lost. @param {string} message */
  tell(message) {
    const waiting = [...this.waiting.values()]
    this.waiting.clear()
    this.onmessage?.({ kind: 'ended', message })
    for (const answer of waiting) answer({ kind: 'ended', message })
  }
}
