/** The wasm module: fetched once, when the first figure needs it, and asked for again only by hand. */

import init, * as estimate from 'estimate-wasm'
import address from 'estimate-wasm/wasm'

/** @typedef {typeof estimate} Estimate */
/** @typedef {{ ok: true, module: Estimate } | { ok: false, why: string }} Loaded */

/** @type {Promise<Loaded> | null} */
let loading = null

/**
 * Never throws: a failure is an answer, and the next call tries again.
 * @returns {Promise<Loaded>}
 */
export function loadModule() {
  loading ??= load().then((loaded) => {
    if (!loaded.ok) loading = null
    return loaded
  })
  return loading
}

/** @returns {Promise<Loaded>} */
async function load() {
  if (typeof WebAssembly === 'undefined') return { ok: false, why: 'this browser does not run WebAssembly' }
  try {
    await init({ module_or_path: new URL(address, import.meta.url) })
    return { ok: true, module: estimate }
  } catch (error) {
    const offline = error instanceof TypeError
    return { ok: false, why: offline ? 'its module could not be fetched' : 'its module could not be started' }
  }
}
