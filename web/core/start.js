/** A wasm module: fetched once, when first needed, and asked for again only by hand. */

/**
 * @template T
 * @typedef {{ ok: true, module: T } | { ok: false, why: string }} Loaded
 */

/**
 * @template T
 * @param {(from: { module_or_path: URL }) => Promise<unknown>} init the module's own
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
    try {
      await init({ module_or_path: new URL(address, import.meta.url) })
      return { ok: true, module }
    } catch (error) {
      const offline = error instanceof TypeError
      return { ok: false, why: offline ? 'its module could not be fetched' : 'its module could not be started' }
    }
  }
}
