/** The worker that fills the map of a log's likelihood. It fetches its module and nothing else. */

import init, * as estimate from 'estimate-wasm/of/tune'
import address from 'wasm-of/tune'
import { loader } from '../../load/loader.js'
import { serve } from './server.js'

serve(/** @type {any} */ (self), loader(init, estimate, address))
