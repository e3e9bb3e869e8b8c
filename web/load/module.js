/** The labs of the figures. */

import init, * as estimate from 'estimate-wasm/figures'
import address from 'estimate-wasm/figures/wasm'
import { loader } from './loader.js'

/** @typedef {typeof estimate} Estimate */
/** @typedef {import('./loader.js').Loaded<Estimate>} Loaded */

export const loadModule = loader(init, estimate, address)
