/** A wasm module: fetched once, when it is first needed; after a failure, fetched again when the reader asks. */

import { fetchWithPatience } from './timeouts.js'

/**
 * @template T
 * @typedef {{ ok: true, module: T } | { ok: false, why: string }} Loaded
 */

/**
 * @template T
 * @param {(from: { module_or_path: Promise<Response> }) => Promise<unknown>} init the module's own
 * @param {T} module what it exports
 * @param {string} address of its binary, beside this script
 * @returns {() => Promise<Loaded<T>>} never throws: a failure is an answer, and the next call tries again
 */
export function loader(init, module, address) {
  /** @type {Promise<Loaded<T>> | null} */
  let loading = null
  return () => {
    loading ??= load().then((loaded) => {
      if (!loaded.ok) loading = null
      return loaded
    })
    return loading
  }

  /** @returns {Promise<Loaded<T>>} */
  async function load() {
    if (typeof WebAssembly === 'undefined') return { ok: false, why: 'this browser does not run WebAssembly' }
    const binary = fetchWithPatience(new URL(address, import.meta.url))
    try {
      await init({ module_or_path: binary })
      return { ok: true, module }
    } catch (error) {
      if (error instanceof DOMException && error.name === 'AbortError')
        return { ok: false, why: 'the server does not answer' }
      const unreachable = error instanceof TypeError
      return { ok: false, why: unreachable ? 'its module could not be fetched' : 'its module could not be started' }
    }
  }
}
