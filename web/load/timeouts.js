/** What takes longer than anybody waits counts as failed. */

export const PATIENCE_MS = 9000

/**
 * The result of `promise`, or an error when there is none in time.
 * @template T
 * @param {Promise<T>} promise
 * @returns {Promise<T>}
 */
export function inTime(promise) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error('took too long')), PATIENCE_MS)
    promise.finally(() => clearTimeout(timer)).then(resolve, reject)
  })
}

/**
 * A file, given up when the server is silent for too long: a slow network may take its time as long as something comes.
 * @param {URL} address
 * @returns {Promise<Response>}
 */
export async function fetchWithPatience(address) {
  const giving = new AbortController()
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer
  const wait = () => {
    clearTimeout(timer)
    timer = setTimeout(() => giving.abort(), PATIENCE_MS)
  }
  wait()
  try {
    const { body, ok, status, headers } = await fetch(address, { signal: giving.signal })
    if (!ok || !body) throw new TypeError(`${address.pathname}: ${status}`)
    const heard = new TransformStream({
      transform(bytes, to) {
        wait()
        to.enqueue(bytes)
      },
      flush: () => clearTimeout(timer),
    })
    return new Response(body.pipeThrough(heard), { headers })
  } catch (error) {
    clearTimeout(timer)
    throw error
  }
}
