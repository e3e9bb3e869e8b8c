/** The lab of a system of the reader's own, fetched when its figure comes near. */

import init, * as estimate from 'estimate-wasm/system'
import address from 'estimate-wasm/system/wasm'
import { loader } from '../../load/loader.js'

export const loadSystem = loader(init, estimate, address)
