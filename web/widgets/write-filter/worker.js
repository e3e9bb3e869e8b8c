/** The worker that counts a program's worlds. It fetches its module and nothing else. */

import init, * as estimate from 'estimate-wasm/of/write-filter'
import address from 'wasm-of/write-filter'
import { loader } from '../../load/loader.js'
import { serve } from './server.js'

serve(/** @type {any} */ (self), loader(init, estimate, address))
