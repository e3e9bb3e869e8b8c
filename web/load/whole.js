/** The module whole: the functions and filters beside the labs, and the checks of the book. */

import init, * as estimate from 'estimate-wasm'
import address from 'estimate-wasm/wasm'
import { loader } from './loader.js'

/** @typedef {typeof estimate} Whole */

export const loadWhole = loader(init, estimate, address)
