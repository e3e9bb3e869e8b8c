/** The labs of the figures late in the chapter. */

import init, * as estimate from 'estimate-wasm/late'
import address from 'estimate-wasm/late/wasm'
import { loader } from './loader.js'

export const loadLateModule = loader(init, estimate, address)
