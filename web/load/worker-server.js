/**
 * Connects what computes beside the page with whoever sends the messages: a worker's page, or a page that may not start
 * a worker.
 *
 * A message with a number, `ask`, is a question. Questions are answered one after the other, and each has one answer
 * with its number, whatever fails: `{ kind: 'refused', message }` if nothing else. A fault of the module itself is told
 * as `{ kind: 'fault' }`, and nothing is answered after it: the module is not to be used any more.
 */

/** @typedef {{ take: (message: any) => void, answer?: (message: any) => any }} Server */

/**
 * @param {import('./worker-port.js').Channel} channel
 * @param {() => Promise<import('./loader.js').Loaded<any>>} load fetches the module
 * @param {(module: any, tell: (message: any) => void, soon: (act: () => void) => void) => Server} make makes the
 * server; `soon` calls back once waiting messages have been read
 */
export function attend(channel, load, make) {
  /** @type {Server | null} */
  let server = null
  /** Why there is none. */
  let failed = ''
  let broken = false
  /** @type {any[]} */
  const early = []
  /** The next question waits for this, which is never rejected. @type {Promise<unknown>} */
  let before = Promise.resolve()
  const { port1, port2 } = new MessageChannel()
  /** @type {(() => void)[]} */
  const acts = []
  // Behind the messages that wait already, and without the pause of a timer.
  port1.onmessage = () => safely(acts.shift() ?? (() => {}))
  const soon = (/** @type {() => void} */ act) => {
    acts.push(act)
    port2.postMessage(null)
  }
  const fault = () => {
    broken = true
    channel.postMessage({ kind: 'fault' })
  }
  /** @param {() => void} act */
  const safely = (act) => {
    if (broken) return
    try {
      act()
    } catch (error) {
      if (!isFault(error)) throw error
      fault()
    }
  }
  /** @param {any} message */
  const answer = async (message) => {
    if (broken) return
    try {
      const words = failed ? { kind: 'failed', why: failed } : await server?.answer?.(message)
      channel.postMessage({ ...words, ask: message.ask })
    } catch (error) {
      if (isFault(error)) fault()
      else channel.postMessage({ kind: 'refused', message: wordsOf(error), ask: message.ask })
    }
  }
  /** @param {any} message */
  const take = (message) => {
    if (message.ask !== undefined) before = before.then(() => answer(message))
    else if (failed) channel.postMessage({ kind: 'failed', why: failed })
    else safely(() => server?.take(message))
  }
  const begin = async () => {
    const loaded = await load()
    if (loaded.ok) server = make(loaded.module, (message) => channel.postMessage(message), soon)
    else failed = loaded.why
    for (const message of early.splice(0)) take(message)
  }
  channel.onmessage = ({ data }) => {
    if (data.kind === 'hello') channel.postMessage({ kind: 'hello' })
    else if (server || failed) take(data)
    else early.push(data)
  }
  begin()
}

/** @param {unknown} error */
function isFault(error) {
  return error instanceof WebAssembly.RuntimeError
}

/** What a refusal says. A fault of the module is none, and is thrown on. @param {unknown} error */
export function wordsOf(error) {
  if (isFault(error)) throw error
  return error instanceof Error ? error.message : String(error)
}
